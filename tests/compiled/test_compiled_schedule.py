"""The order of statements: another one, for the same values to the last bit."""

import re
import shutil
import subprocess
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.compiled import compile
from mechanics.compiled.c.schedule import CALLS, LEAST, scheduled
from mechanics.compiled.c.source import function_source
from mechanics.compiled.machine.library import FLAGS
from mechanics.program.casadi_reader import read_routine
from mechanics.program.operations import DIVIDE, INPUT
from mechanics.program.routine import Routine, run
from mechanics.routes.derivation import by_route
from systems import pendulum_chain

STEPS = (
    lambda p, q: p + q,
    lambda p, q: p * q - p,
    lambda p, q: p / (q * q + 1),
    lambda p, q: ca.sin(p - q) + q,
    lambda p, q: ca.cos(p - q) * p,
    lambda p, q: ca.sqrt(p * p + 1) + ca.tan(q),
    lambda p, q: ca.sin(p) * ca.cos(p),
)


def drawn(steps: list[tuple[int, int, int]]) -> Routine:
    s = ca.SX.sym("s", 4)
    values = [s[i] for i in range(4)]
    for operation, left, right in steps:
        values.append(STEPS[operation](values[left % len(values)], values[right % len(values)]))
    return read_routine(ca.Function("f", [s], [ca.vertcat(*values[-5:])], ["s"], ["out"]))


@pytest.fixture(scope="module")
def chain() -> Routine:
    model = compile(by_route("free_body", pendulum_chain.scene(5)), outputs=("forward_dynamics",))
    return model.program("forward_dynamics")


@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 99), st.integers(0, 99)), min_size=6))
def test_every_node_is_there_once_after_its_operands(steps: list[tuple[int, int, int]]) -> None:
    code = drawn(steps)
    other = scheduled(code)
    assert sorted(n.operation for n in other.nodes) == sorted(n.operation for n in code.nodes)
    for k, node in enumerate(other.nodes):
        if node.operands and node.operation != INPUT:
            assert all(i < k for i in node.operands)
    states = [list(np.random.default_rng(0).normal(size=(4, 16)))]
    for found, expected in zip(
        run(other, states, np.float64)[0], run(code, states, np.float64)[0], strict=True
    ):
        np.testing.assert_array_equal(found, expected)


def test_few_calls_need_no_order() -> None:
    s = ca.SX.sym("s", 4)
    few = [ca.sin(s[i]) * ca.cos(s[i]) for i in range(LEAST - 1)]
    code = read_routine(ca.Function("f", [s], [ca.vertcat(*few)], ["s"], ["out"]))
    assert scheduled(code) is code


@pytest.mark.campaign
def test_calls_stand_between_the_rest_and_a_sine_beside_its_cosine(chain: Routine) -> None:
    nodes = scheduled(chain).nodes
    calls = [k for k, node in enumerate(nodes) if node.operation in CALLS]
    pairs = list(zip(calls[::2], calls[1::2], strict=True))
    assert len(pairs) == 5
    for first, second in pairs:
        assert second == first + 1 and nodes[first].operands == nodes[second].operands
    divisions = [k for k, node in enumerate(nodes) if node.operation == DIVIDE]
    assert divisions[0] < calls[-1]


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["gcc", "clang"])
@pytest.mark.parametrize("level", ["-O2", "-O3"])
def test_each_pair_of_sine_and_cosine_is_one_call(
    chain: Routine, tmp_path: Path, name: str, level: str
) -> None:
    compiler, reader = shutil.which(name), shutil.which("objdump")
    if compiler is None or reader is None:
        pytest.skip(f"no {name} or no objdump here")
    entries = {group: tuple(f"{group}{i}" for i in range(size)) for group, size in chain.inputs}
    source, target = tmp_path / "chain.c", tmp_path / "chain.o"
    source.write_text("#include <math.h>\n" + function_source(chain, entries), encoding="ascii")
    command = [compiler, *FLAGS, level, "-c", str(source), "-o", str(target)]
    subprocess.run(command, check=True)
    listing = subprocess.run(
        [reader, "-dr", str(target)], capture_output=True, text=True, check=True
    )
    called = re.findall(r"R_\w+\s+(sin|cos|sincos)\b", listing.stdout)
    if "sincos" not in called:
        pytest.skip("the C library here has no sincos")
    assert called == ["sincos"] * 5
