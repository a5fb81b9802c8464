"""Taylor coefficients are derivatives over factorials, in every domain of numbers."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import factorial
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.errors import ExpressionError
from mechanics.program import OPERATIONS, Builder, Node, Program, interpret
from mechanics.program.forward import tangent
from mechanics.program.interpret import Domain, include
from mechanics.program.numpy_domain import Arrays
from mechanics.program.taylor import JUMPING, Kind, expand, recurrences

ORDER = 6


def series(
    program: Program, numbers: Domain, start: dict[str, Any], rates: dict[str, Any], order: int
) -> list[list[Any]]:
    """Coefficients of the outputs along x_0 + x_1 t: those of v with v' = f(x), x' = x_1."""
    b = Builder()
    outputs = [node for nodes in include(b, program).values() for node in nodes]
    moved = [b.input(f"rate of {name}") for name in rates]
    state = (*rates, *(f"v{k}" for k in range(len(outputs))))
    held = [name for name in start if name not in rates]
    inputs = (*state, *held, *(f"rate of {name}" for name in rates))
    rules = recurrences(b.program({"rates": [*moved, *outputs]}, inputs), state)
    zero = numbers.constant(Fraction(0))
    fixed = {name: start[name] for name in held}
    fixed |= {f"rate of {name}": rate for name, rate in rates.items()}
    constants = interpret(rules.constants, numbers, fixed)["constants"]
    values = {name: start.get(name, zero) for name in state}
    values |= {f"c{k}": value for k, value in enumerate(constants)}
    first = interpret(rules.first, numbers, values)["first"]
    step = numbers.constant(Fraction(1))
    found = expand(rules, numbers, first, constants, step, order + 1)
    return [[x * (j + 1) for j, x in enumerate(entry[1:])] for entry in found[len(rates) :]]


def along(program: Program, numbers: Domain, start: Any) -> list[Any]:
    """Coefficients of the one output along x_0 + t."""
    (found,) = series(program, numbers, {"x": start}, {"x": numbers.constant(Fraction(1))}, ORDER)
    return found


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_coefficients_are_derivatives_along_the_direction(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    """x(t) = x_0 + x_1 t for every input; d/dt k times, by forward derivatives."""
    program = data.draw(programs)
    assume(not any(OPERATIONS[code].name in JUMPING or OPERATIONS[code].boolean
                   for code in program.operations))  # fmt: skip
    point, rates = {"x": 0.31, "y": -1.27, "z": 1.91}, {"x": 0.7, "y": -0.4, "z": 0.2}
    order = 3
    found = series(program, Arrays(), point, rates, order)
    b = Builder()
    directions = {b.input(name): b.constant(rate) for name, rate in rates.items()}
    nodes = [node for outputs in include(b, program).values() for node in outputs]
    for k in range(order + 1):
        values = interpret(b.program({"d": nodes}, tuple(point)), Arrays(), point)["d"]
        wanted = np.array(values, dtype=float) / factorial(k)
        scale = 1e-7 * (1 + np.abs(wanted))
        assert (np.abs(np.array([s[k] for s in found], dtype=float) - wanted) <= scale).all()
        nodes = tangent(nodes, directions)


SMOOTH = {
    "sqrt": 1.3, "exp": 0.4, "log": 1.7, "sin": 0.9, "cos": 0.9, "tan": 0.6, "asin": 0.4,
    "acos": 0.4, "atan": 1.1, "sinh": 0.8, "cosh": 0.8, "tanh": 0.8, "asinh": 1.2, "acosh": 2.3,
    "atanh": 0.3, "erf": 0.5,
}  # fmt: skip


def close(found: Sequence[Any], wanted: Sequence[Any]) -> bool:
    """Whether all coefficients agree."""
    pairs = zip(found, wanted, strict=True)
    return all(mpmath.almosteq(left, right, 1e-15, 1e-15) for left, right in pairs)


@pytest.mark.parametrize("name", SMOOTH)
def test_every_function_has_the_coefficients_of_mpmath(
    name: str, multiple_precision: Domain
) -> None:
    b = Builder()
    program = b.program({"f": [b.call(name, b.input("x"))]})
    with mpmath.workdps(40):
        start = mpmath.mpf(SMOOTH[name])
        wanted = mpmath.taylor(getattr(mpmath, name), start, ORDER)
        assert close(along(program, multiple_precision, start), wanted)


def test_all_smooth_rows_are_tried_above() -> None:
    rows = {row.name for row in OPERATIONS if row.arity == 1 and not row.boolean}
    assert rows - JUMPING - {"negate", "entry"} == set(SMOOTH)


@pytest.mark.parametrize(
    "build",
    [
        lambda b, x: x.power(b.constant(Fraction(7, 3))),
        lambda b, x: x.power(x.sin()),
        lambda b, x: b.constant(2).power(x),
        lambda b, x: b.call("atan2", x.sin(), x * x - 2),
        lambda b, x: b.call("atan2", x.sin(), b.constant(3)),
        lambda b, x: b.solve([[2 + x, x * x], [x.cos(), b.constant(3)]], [x, x.exp()])[1],
        lambda b, x: 1 / (x - x * x * x),
        lambda b, x: x.sin() * (b.pi * x.sin()) - x / b.pi,
    ],
)
def test_functions_of_two_operands_too(
    build: Callable[[Builder, Node], Node], multiple_precision: Domain
) -> None:
    b = Builder()
    program = b.program({"f": [build(b, b.input("x"))]})
    with mpmath.workdps(50):
        start = mpmath.mpf("0.8")

        def value(x: Any) -> Any:
            return interpret(program, multiple_precision, {"x": x})["f"][0]

        wanted = mpmath.taylor(value, start, ORDER)
        assert close(along(program, multiple_precision, start), wanted)


def test_many_points_at_once() -> None:
    b = Builder()
    program = b.program({"f": [b.input("x").sin()]})
    x = np.linspace(-1, 1, 5)
    np.testing.assert_allclose(along(program, Arrays(), x)[3], -np.cos(x) / 6)


def test_what_does_not_move_is_computed_once() -> None:
    """x' = sin(p) / (2 + |p|) + x p: a constant that is added, and one that x is multiplied by."""
    b = Builder()
    x, p = b.input("x"), b.input("p")
    rules = recurrences(b.program({"f": [p.sin() / (2 + abs(p)) + x * p]}), ["x"])
    assert rules.constants.count == 4 and rules.first.count == 2
    assert [step.kind for step in rules.steps] == [Kind.TIMES, Kind.COPY]


def test_a_square_in_disguise_is_one() -> None:
    b = Builder()
    x, p = b.input("x"), b.input("p")
    assert recurrences(b.program({"f": [x * (p * x)]}), ["x"]).convolutions == 0.5


@pytest.mark.parametrize("name", [*sorted(JUMPING - {"select"}), "less"])
def test_what_jumps_has_no_series_where_it_moves(name: str) -> None:
    b = Builder()
    x, p = b.input("x"), b.input("p")
    arity = 2 if name == "less" else 1
    for moving in ((x, p), (p, x))[:arity]:
        with pytest.raises(ExpressionError, match=f"operation {name} has no Taylor series"):
            recurrences(b.program({"f": [b.call(name, *moving[:arity])]}), ["x"])
    held = b.call(name, *(p, 2 * p)[:arity])
    assert recurrences(b.program({"f": [held * x]}), ["x"]).rates == (1,)


def test_every_entry_of_the_state_has_a_rate() -> None:
    b = Builder()
    with pytest.raises(ValueError, match="1 rates for 2 entries"):
        recurrences(b.program({"f": [b.input("x")]}, ("x", "y")), ["x", "y"])
