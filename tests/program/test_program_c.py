"""Programs become C99 that computes the same, by the way that exports take."""

import ctypes
import os
import shutil
import subprocess
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.compiled.c.source import function_source
from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.casadi_printer import print_function
from mechanics.program.casadi_reader import read_routine
from mechanics.program.constants import unit_fraction
from mechanics.program.numpy_domain import Arrays

POINT = {"x": 0.31, "y": -1.27, "z": 1.91}
FLAGS = ("-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-pedantic",
         "-Wno-unused-parameter")  # fmt: skip


def text_of(program: Program, arrays: dict[str, list[str]]) -> str:
    routine = read_routine(print_function(program, "f", arrays))
    return "#include <math.h>\n" + function_source(routine, arrays)


Compiled = Callable[[Program], dict[str, list[float]]]


@pytest.fixture(scope="session")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Compiled:
    """Values of a program at the point by its C, compiled without a warning."""
    compiler = shutil.which("gcc")
    if compiler is None:
        if os.environ.get("MECHANICS_CI") == "1":
            pytest.fail("gcc is missing")
        pytest.skip("gcc is missing")
    folder, count = tmp_path_factory.mktemp("c"), iter(range(10**6))

    def run(program: Program) -> dict[str, list[float]]:
        source = folder / f"f{next(count)}.c"
        library = source.with_suffix(".so")
        names = list(program.inputs)
        source.write_text(text_of(program, {"v": names[:1], "w": names[1:]}))
        command = [compiler, *FLAGS, "-shared", "-fPIC", str(source), "-o", str(library), "-lm"]
        subprocess.run(command, check=True)
        groups = [[POINT[n] for n in names[:1]], [POINT[n] for n in names[1:]]]
        given = [(ctypes.c_double * len(group))(*group) for group in groups]
        outputs = {name: (ctypes.c_double * len(ns))() for name, ns in program.outputs.items()}
        ctypes.CDLL(str(library)).f(*given, *outputs.values())
        return {name: list(values) for name, values in outputs.items()}

    return run


@pytest.mark.campaign
@settings(max_examples=30, deadline=None)
@given(data=st.data())
def test_compiled_code_has_the_values_of_the_program(
    compiled: Compiled, programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = data.draw(programs)
    wanted = interpret(program, Arrays(), POINT)
    for name, values in compiled(program).items():
        np.testing.assert_allclose(
            values, np.array(wanted[name], dtype=float), rtol=1e-9, atol=1e-9
        )


def test_a_truth_value_is_a_number_among_numbers(compiled: Compiled) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    less, more = b.less(y, x), b.less(x, y)
    quotient = less / (2 * less + less)  # integers would make 0 of it
    either = b.call("or", b.call("and", less, more), b.call("not", more))
    outputs = [quotient, less, either.choose(2, 3), b.call("equal", less, more), (x + y).sign()]
    assert compiled(b.program({"f": outputs}))["f"] == [1 / 3, 1.0, 2.0, 0.0, -1.0]


def test_constants_are_rounded_once(compiled: Compiled) -> None:
    b = Builder()
    x = b.input("x")
    outputs = [x / 3, x / -7, x * 2 / 3, b.constant(1) / 3, b.constant(0.1) * x, x * 10**30,
               b.constant(10**25) / 3, b.pi, b.input("y")]  # fmt: skip
    found = compiled(b.program({"f": outputs}))["f"]
    v = POINT["x"]
    assert found == [v / 3, v / -7, v * (2 / 3), 1 / 3, 0.1 * v, v * 1e30, 10**25 / 3, np.pi, -1.27]
    assert unit_fraction(b.constant(1).constant / 3) == 3
    assert unit_fraction(b.constant(1).constant / 4) is None


def test_text_keeps_apart_what_rounds_differently() -> None:
    b = Builder()
    x, y, z = (b.input(name) for name in "xyz")
    texts = {
        "x - (y - z)": x - (y - z), "x - (y + z)": x - (y + z),
        "x / (y / z)": x / (y / z), "x / y / z": x / y / z,
        "x * (y / z)": x * (y / z), "x * y / z": x * y / z,
        "-(x / 3.0)": x * -1 / 3, "y / z - x": y / z - x, "(x - y) / 3.0": (x - y) / 3,
        "x < y ? -x : x": b.less(x, y).choose(-x, x),
    }  # fmt: skip
    for text, node in texts.items():
        written = text_of(b.program({"out": [node]}), {"v": ["x", "y", "z"]})
        assert f"out[0] = {text};" in written


def test_what_double_precision_cannot_hold_is_refused() -> None:
    b = Builder()
    with pytest.raises(ExpressionError, match="not finite"):
        text_of(b.program({"f": [b.input("x") * 10**400]}), {"v": ["x"]})
