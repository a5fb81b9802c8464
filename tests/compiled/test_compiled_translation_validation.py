"""The step is that of Runge and Kutta for the rates; a binary is what its text says, or refuted."""

import shutil
from dataclasses import replace
from math import isfinite

import numpy as np
import pytest
from flint import arb
from sympy import Symbol

from mechanics.compiled import compile
from mechanics.compiled.translation_validation.binary import compare
from mechanics.compiled.translation_validation.build import Built, building
from mechanics.compiled.translation_validation.code import EVERY, code_of
from mechanics.compiled.translation_validation.derived import derived
from mechanics.compiled.translation_validation.graph import prove_derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.rounding import RoundedBalls
from mechanics.compiled.translation_validation.states import FINITE, states
from mechanics.compiled.translation_validation.text import VALUES, Text, read_text
from mechanics.compiled.translation_validation.truth import truth
from mechanics.kernel import Verdict
from mechanics.kernel.balls import precision
from mechanics.program import Program
from mechanics.program.c.parse import parse
from mechanics.program.operations import INPUT
from mechanics.program.routine import Node, routine
from mechanics.routes.derivation import by_route
from systems import elastic_pendulum

SYMBOLS = {"x": [Symbol("x0", real=True), Symbol("x1", positive=True)]}


@pytest.fixture(scope="module")
def gcc() -> str:
    found = shutil.which("gcc")
    if found is None:
        pytest.skip("no gcc here")
    return found


@pytest.fixture(scope="module")
def graphs():
    return compile(by_route("free_body", elastic_pendulum.scene())).casadi


def test_the_step_is_that_of_the_rates(graphs) -> None:
    known, rates = derived(graphs), code_of(*graphs.exact_rates())
    step = code_of(*graphs.exact("step"))
    assert prove_derived("rates", rates, known).shown
    assert prove_derived("step", step, known, rates).verdict is Verdict.CERTIFIED


def test_a_changed_weight_of_the_step_is_refuted(graphs) -> None:
    known, rates = derived(graphs), code_of(*graphs.exact_rates())
    step = code_of(*graphs.exact("step"))
    places = [k for k, node in enumerate(step.routine.nodes) if node.constant == 6]
    assert places
    was, nodes = step.routine, list(step.routine.nodes)
    nodes[places[0]] = nodes[places[0]]._replace(constant=nodes[places[0]].constant + 1)
    changed = routine(was.name, nodes, was.outputs, was.inputs, was.shapes)
    finding = prove_derived("step", replace(step, routine=changed), known, rates)
    assert finding.verdict is Verdict.REFUTED and finding.witness is not None
    assert finding.evidence.startswith(("q_next[", "u_next["))


def text(body: str, kind: str = "double") -> tuple[Text, str]:
    """A C function of x[0] and x[1] > 0 that returns a status, and its source."""
    source = f"""#include <math.h>
int f(const {kind} x[2], {kind} y[1])
{{
    {body}
    return isfinite(y[0]) ? 0 : 2;
}}
"""
    kernel = Kernel("f", "f", "f.c", kind)
    return read_text(kernel, parse(source, "f.c"), (("x", 2),), (("y", 1),)), source


def written(read: Text) -> Program:
    """The text itself, as what it was printed from."""
    outputs = read.program.outputs
    return replace(read.program, outputs={"y": outputs[VALUES], EVERY: outputs[EVERY]})


@pytest.mark.parametrize("vain", ["(x[0] + 0x1p200) - 0x1p200", "x[0] * 0x1p600 * 0x1p-600",
                                  "x[0] * 0x1p-600 * 0x1p-600 * 0x1p600 * 0x1p600"])  # fmt: skip
def test_a_text_that_is_right_over_the_real_numbers_only(gcc: str, vain: str) -> None:
    plain, _ = text("y[0] = x[0];")
    read, source = text(f"y[0] = {vain};")
    finding, _ = compare(truth(read, SYMBOLS, written(plain)), binary(source, gcc))
    assert not finding.shown and "of the graph" in finding.evidence


def binary(source: str, compiler: str, *flags: str) -> Built:
    with building({"f.c": source}, ["f.c"], [compiler], [flags]) as collected:
        return collected()[0]


BODIES = [
    "y[0] = x[0] * x[0] - x[1] / 3.0;",
    "y[0] = sin(x[0]) * sqrt(x[1]);",
    "y[0] = (x[0] + 1.0) - x[0];",
    "y[0] = exp(-x[1]) + tanh(x[0]);",
    "y[0] = x[0] * x[1] / 3.0 - x[1] / 3.0 * x[0];",  # nothing, but for roundings
]


@pytest.mark.sample(2)
@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("kind", ["double", "float"])
def test_a_binary_is_within_what_roundings_can_give(gcc: str, body: str, kind: str) -> None:
    if kind == "float":
        body = body.replace("sin(", "sinf(").replace("sqrt(", "sqrtf(").replace("exp(", "expf(")
        body = body.replace("tanh(", "tanhf(").replace(".0", ".0f")
    read, source = text(body, kind)
    finding, measured = compare(truth(read, SYMBOLS, written(read)), binary(source, gcc, "-O2"))
    assert finding.verdict is Verdict.SUPPORTED, finding
    assert measured is not None and measured.states > 20 and measured.ulp_terms < 4
    assert isfinite(measured.ulp)


WRONG = [
    ("y[0] = x[0] * x[0] - x[1] / 3.0;", "3.0", "3.0000000000000013"),
    ("y[0] = x[0] + x[1];", "+ x[1]", "+ x[1] * 1.000000000000001"),
    ("y[0] = x[0] * x[1];", "x[0] *", "(float)x[0] *"),
    ("y[0] = x[0] * x[1];", "? 0 : 2", "? 0 : 1"),
]


@pytest.mark.parametrize(("body", "old", "new"), WRONG)
def test_a_binary_of_another_text_is_refuted(gcc: str, body: str, old: str, new: str) -> None:
    read, source = text(body)
    finding, _ = compare(truth(read, SYMBOLS, written(read)), binary(source.replace(old, new), gcc))
    assert finding.verdict is Verdict.REFUTED and finding.witness is not None


def test_what_does_not_compile_is_undecided(gcc: str) -> None:
    read, source = text("y[0] = x[0];")
    finding, measured = compare(truth(read, SYMBOLS, written(read)), binary(source + "}", gcc))
    assert finding.verdict is Verdict.UNDECIDED and "error" in finding.evidence
    assert measured is None


def test_roundings_grow_a_ball() -> None:
    with precision(200):
        rounded = RoundedBalls("double").operations
        third = rounded["divide"](arb(1), arb(3))
        assert third.contains(1 / 3) and not third.contains(1 / 3 + 2.0**-53)
        assert float(rounded["add"](arb(1), arb(2)).rad()) < 2.0**-51


def test_states_are_the_same_every_time_and_of_every_kind() -> None:
    one, two = (states([("x", 2), ("c", 1)], SYMBOLS, "double", 8) for _ in range(2))
    assert all(np.array_equal(one.columns[n], two.columns[n], equal_nan=True) for n in "xc")
    finite = one.stratum < FINITE
    assert np.isfinite(one.columns["x"][finite]).all()
    assert (one.columns["x"][finite][:, 1] >= 0).all() and (one.columns["x"][finite] == 0).any()
    assert not np.isfinite(one.columns["x"][~finite]).all()
    assert np.abs(one.columns["x"][finite]).max() > 1e100


def test_code_is_what_its_nodes_are(graphs) -> None:
    code = code_of(*graphs.exact("coordinate_rates"))
    nodes = code.routine.nodes
    assert [node.operation for node in nodes] == [INPUT] * 2 and not code.constants
    assert nodes[0] == Node(INPUT, (1, 0))
