"""Programs become C99 that computes the same, each operation rounded as written."""

import ctypes
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.c_printer import print_c
from mechanics.program.constants import unit_fraction
from mechanics.program.numpy_domain import Arrays

GOLDEN = Path(__file__).parent / "golden" / "double_pendulum.c"
POINT = {"x": 0.31, "y": -1.27, "z": 1.91}
FLAGS = ("-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-pedantic",
         "-Wno-unused-parameter")  # fmt: skip

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
        source.write_text(print_c(program, "f", {"v": names[:1], "w": names[1:]}))
        command = [compiler, *FLAGS, "-shared", "-fPIC", str(source), "-o", str(library), "-lm"]
        subprocess.run(command, check=True)
        groups = [[POINT[n] for n in names[:1]], [POINT[n] for n in names[1:]]]
        given = [(ctypes.c_double * len(group))(*group) for group in groups]
        outputs = {name: (ctypes.c_double * len(ns))() for name, ns in program.outputs.items()}
        ctypes.CDLL(str(library)).f(*given, *outputs.values())
        return {name: list(values) for name, values in outputs.items()}

    return run


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


@settings(max_examples=30, deadline=None)
@given(st.lists(st.tuples(*[st.integers(0, 30)] * 3), min_size=1, max_size=12))
def test_operations_are_rounded_in_the_order_of_the_program(
    compiled: Compiled, steps: list[tuple[int, int, int]]
) -> None:
    """Bit for bit: sums, differences, products, quotients and roots are rounded correctly."""
    b = Builder()
    nodes = [b.input(name) for name in POINT]
    for kind, i, j in steps:
        x, y = nodes[i % len(nodes)], nodes[j % len(nodes)]
        nodes.append((x + y, x - y, x * y, x / (1 + y * y), -x, (x * x).sqrt())[kind % 6])
    program = b.program({"f": nodes[-4:]}, inputs=tuple(POINT))
    wanted = interpret(program, Arrays(), {name: np.float64(v) for name, v in POINT.items()})
    assert compiled(program)["f"] == [float(value) for value in wanted["f"]]


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
        "x - (y - z)": x - (y - z), "x - (z + y)": x - (y + z),
        "x / (y / z)": x / (y / z), "x / y / z": x / y / z,
        "-(x / 3.0)": x * -1 / 3, "y / z - x": y / z - x, "x * (2.0 / 3.0)": x * 2 / 3,
        "(x - y) / 3.0": (x - y) / 3,
        "sin(x - y)": (x - y).sin(), "x < y ? -x : x": b.less(x, y).choose(-x, x),
    }  # fmt: skip
    for text, node in texts.items():
        written = print_c(b.program({"f": [node]}), "g")
        assert f"f[0] = {text};" in written


def double_pendulum() -> Program:
    b = Builder()
    names = ("m1", "m2", "l1", "l2", "g", "theta1", "theta2", "omega1", "omega2")
    m1, m2, l1, l2, g, theta1, theta2, omega1, omega2 = (b.input(name) for name in names)
    c, s = (theta1 - theta2).cos(), (theta1 - theta2).sin()
    coupling = m2 * l1 * l2 * c
    matrix = [[(m1 + m2) * l1**2, coupling], [coupling, m2 * l2**2]]
    right = [
        -m2 * l1 * l2 * s * omega2**2 - (m1 + m2) * g * l1 * theta1.sin(),
        m2 * l1 * l2 * s * omega1**2 - m2 * g * l2 * theta2.sin(),
    ]
    return b.program({"alpha": b.solve(matrix, right, symmetric=True)}, inputs=names)


def test_golden_file() -> None:
    """Set UPDATE_GOLDEN=1 to write it anew."""
    text = print_c(
        double_pendulum(), "double_pendulum",
        {"q": ["theta1", "theta2"], "u": ["omega1", "omega2"],
         "p": ["m1", "m2", "l1", "l2", "g"]},
    )  # fmt: skip
    if os.environ.get("UPDATE_GOLDEN") == "1":
        GOLDEN.parent.mkdir(exist_ok=True)
        GOLDEN.write_text(text, encoding="utf-8")
    assert text == GOLDEN.read_text(encoding="utf-8"), "UPDATE_GOLDEN=1 pytest tests/program"


@pytest.mark.parametrize(
    ("name", "arrays", "message"),
    [
        ("sin", {"v": ["x", "double"]}, "'sin' cannot be a name in C"),
        ("f g", {"v": ["x", "double"]}, "'f g' cannot"),
        ("g", None, "'double' cannot"),
        ("g", {"f": ["x", "double"]}, "'f' names two things"),
        ("g", {"v": ["x"]}, "double stands in no array"),
        ("g", {"v": ["x"], "w": ["x"]}, "x stands in two arrays"),
    ],
)
def test_names_that_c_does_not_take_are_refused(
    name: str, arrays: dict[str, list[str]] | None, message: str
) -> None:
    b = Builder()
    program = b.program({"f": [b.input("x") * b.input("double")]})
    with pytest.raises(ExpressionError, match=message):
        print_c(program, name, arrays)


def test_temporaries_are_not_called_as_arguments_are() -> None:
    b = Builder()
    x = b.input("t2")
    root = x.sin()
    written = print_c(b.program({"t7": [root * root + x]}), "f")
    assert "const double t_1 = sin(t2);" in written


def test_what_double_precision_cannot_hold_is_refused() -> None:
    b = Builder()
    with pytest.raises(ExpressionError, match="beyond double precision"):
        print_c(b.program({"f": [b.input("x") * 10**400]}), "f")
