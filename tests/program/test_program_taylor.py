"""Taylor coefficients are derivatives over factorials, in every domain of numbers."""

from collections.abc import Callable
from fractions import Fraction
from math import factorial
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.program import OPERATIONS, Builder, Node, Program, interpret, tangent
from mechanics.program.interpret import Domain, Nodes, include
from mechanics.program.numpy_domain import Arrays
from mechanics.program.taylor_domain import TaylorSeries

ORDER = 6


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_coefficients_are_derivatives_along_the_direction(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    """x(t) = x_0 + x_1 t for every input; d/dt k times, by forward derivatives."""
    program = data.draw(programs)
    point, rates = {"x": 0.31, "y": -1.27, "z": 1.91}, {"x": 0.7, "y": -0.4, "z": 0.2}
    inputs = {name: (point[name], rates[name]) for name in point}
    order = 3
    found = interpret(program, TaylorSeries(Arrays(), order), inputs)
    b = Builder()
    directions = {b.input(name): b.constant(rate) for name, rate in rates.items()}
    nodes = list(include(b, program)["first"])
    for k in range(order + 1):
        values = interpret(b.program({"d": nodes}, tuple(point)), Arrays(), point)["d"]
        series = [s[k] if k < len(s) else 0.0 for s in found["first"]]
        wanted = np.array(values, dtype=float) / factorial(k)
        scale = 1e-7 * (1 + np.abs(wanted))
        assert (np.abs(np.array(series, dtype=float) - wanted) <= scale).all()
        nodes = tangent(nodes, directions)


SMOOTH = {
    "sqrt": 1.3, "exp": 0.4, "log": 1.7, "sin": 0.9, "cos": 0.9, "tan": 0.6, "asin": 0.4,
    "acos": 0.4, "atan": 1.1, "sinh": 0.8, "cosh": 0.8, "tanh": 0.8, "asinh": 1.2, "acosh": 2.3,
    "atanh": 0.3, "erf": 0.5, "abs": -0.7,
}  # fmt: skip


@pytest.mark.parametrize("name", SMOOTH)
def test_every_function_has_the_coefficients_of_mpmath(
    name: str, multiple_precision: Domain
) -> None:
    b = Builder()
    program = b.program({"f": [b.call(name, b.input("x"))]})
    with mpmath.workdps(40):
        start = mpmath.mpf(SMOOTH[name])
        domain = TaylorSeries(multiple_precision, ORDER)
        (found,) = interpret(program, domain, {"x": (start, mpmath.mpf(1))})["f"]
        if name == "abs":
            wanted = [abs(start), -1, 0, 0, 0, 0, 0]
            found = (*found, *[0] * (ORDER + 1 - len(found)))
        else:
            wanted = mpmath.taylor(getattr(mpmath, name), start, ORDER)
        for left, right in zip(found, wanted, strict=True):
            assert mpmath.almosteq(left, right, 1e-15, 1e-15)


def test_all_smooth_rows_are_tried_above() -> None:
    jumps = {"sign", "floor"}
    binary = {"power", "atan2", "entry"}
    rows = {row.name for row in OPERATIONS if row.arity == 1 and not row.boolean}
    assert rows - jumps - binary - {"negate"} == set(SMOOTH)


@pytest.mark.parametrize(
    "build",
    [
        lambda b, x: x.power(b.constant(Fraction(7, 3))),
        lambda b, x: x.power(x.sin()),
        lambda b, x: b.constant(2).power(x),
        lambda b, x: b.call("atan2", x.sin(), x * x - 2),
        lambda b, x: b.solve([[2 + x, x * x], [x.cos(), b.constant(3)]], [x, x.exp()])[1],
        lambda b, x: 1 / (x - x * x * x),
    ],
)
def test_functions_of_two_operands_too(
    build: Callable[[Builder, Node], Node], multiple_precision: Domain
) -> None:
    b = Builder()
    program = b.program({"f": [build(b, b.input("x"))]})
    with mpmath.workdps(50):
        start = mpmath.mpf("0.8")
        domain = TaylorSeries(multiple_precision, ORDER)
        (found,) = interpret(program, domain, {"x": (start, mpmath.mpf(1))})["f"]

        def value(x: Any) -> Any:
            return interpret(program, multiple_precision, {"x": x})["f"][0]

        for left, right in zip(found, mpmath.taylor(value, start, ORDER), strict=True):
            assert mpmath.almosteq(left, right, 1e-15, 1e-15)


def test_many_points_at_once() -> None:
    b = Builder()
    program = b.program({"f": [b.input("x").sin()]})
    x = np.linspace(-1, 1, 5)
    (found,) = interpret(program, TaylorSeries(Arrays(), 3), {"x": (x, 1.0)})["f"]
    np.testing.assert_allclose(found[3], -np.cos(x) / 6)


def test_nodes_have_series_too() -> None:
    b = Builder()
    x = b.input("x")
    program = b.program({"f": [x * x * x]})
    (found,) = interpret(program, TaylorSeries(Nodes(b), 2), {"x": (x, b.one)})["f"]
    assert found[0] == x * x * x
    values = interpret(b.program({"c": found}), Arrays(), {"x": 2.0})["c"]
    assert values == (8.0, 12.0, 6.0)


def test_what_does_not_move_has_one_coefficient() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"f": [x.sin() / (2 + x.exp()), b.less(x, y), x * y]})
    found = interpret(program, TaylorSeries(Arrays(), 4), {"x": (0.5,), "y": (1.0, 1.0)})["f"]
    assert [len(series) for series in found] == [1, 1, 2]


def test_at_a_kink_there_is_no_slope() -> None:
    b = Builder()
    program = b.program({"f": [abs(b.input("x"))]})
    with np.errstate(invalid="ignore"):
        (found,) = interpret(program, TaylorSeries(Arrays(), 1), {"x": (np.float64(0), 1.0)})["f"]
    assert found[0] == 0
    assert np.isnan(found[1])
