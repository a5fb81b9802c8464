"""The bound of every value holds against fifty digits."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.program import OPERATIONS, Builder, Node, Program, interpret
from mechanics.program.interpret import Domain
from mechanics.program.running_error_domain import Near, RunningErrors, enclose

DIGITS = 50
PRECISIONS = (np.float64, np.longdouble)


def exactly(number: Any) -> Any:
    fraction = Fraction(*np.longdouble(number).as_integer_ratio())
    return mpmath.mpf(fraction.numerator) / fraction.denominator


def distance(near: Near, true: Any) -> tuple[Any, float]:
    """How far a value is off in units of its bound, and the bound itself."""
    near = near.absolute
    away = abs(exactly(near.value) - true)
    if near.error is None:
        return (0 if away == 0 else mpmath.inf), 0.0
    if not np.isfinite(near.error):
        return 0, float("inf")
    return away / exactly(near.error) if away else 0, float(near.error)


@pytest.mark.campaign
@settings(max_examples=100, deadline=None)
@given(data=st.data(), precision=st.sampled_from(PRECISIONS))
def test_bounds_of_random_programs_hold(
    programs: SearchStrategy[Program],
    multiple_precision: Domain,
    data: st.DataObject,
    precision: type,
) -> None:
    program = data.draw(programs)
    values = st.floats(-2, 2, allow_subnormal=False)
    point = {name: data.draw(values) for name in program.inputs}
    found = enclose(program, point, precision)
    with mpmath.workdps(DIGITS):
        true = interpret(program, multiple_precision, {n: mpmath.mpf(v) for n, v in point.items()})
        for name, nears in found.items():
            for near, value in zip(nears, true[name], strict=True):
                assert distance(near, mpmath.mpf(value))[0] <= 1


@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_bounds_hold_for_inputs_that_are_off(
    programs: SearchStrategy[Program], multiple_precision: Domain, data: st.DataObject
) -> None:
    program = data.draw(programs)
    point, true = {}, {}
    with mpmath.workdps(DIGITS):
        for name in program.inputs:
            value = data.draw(st.floats(-2, 2, allow_subnormal=False))
            error = data.draw(st.sampled_from([1e-12, 1e-6, 1e-3, 0.1]))
            share = data.draw(st.sampled_from([-1, -0.3, 0.5, 1]))
            point[name] = Near(np.longdouble(value), np.longdouble(error))
            true[name] = mpmath.mpf(value) + mpmath.mpf(error) * share
        found = enclose(program, point)
        for name, values in interpret(program, multiple_precision, true).items():
            for near, value in zip(found[name], values, strict=True):
                assert distance(near, mpmath.mpf(value))[0] <= 1


STARTS = {"acosh": 1.7, "log": 0.7, "sqrt": 0.7, "asin": 0.6, "acos": 0.6, "atanh": 0.6}


@pytest.mark.parametrize("name", [row.name for row in OPERATIONS if row.arity and row.numpy])
def test_bounds_of_every_operation_hold_and_are_not_idle(
    name: str, multiple_precision: Domain
) -> None:
    row = next(row for row in OPERATIONS if row.name == name)
    b = Builder()
    operands = [b.input(f"x{k}") for k in range(row.arity)]
    program = b.program({"f": [b.call(name, *operands)]})
    rng = np.random.default_rng(1)
    with mpmath.workdps(DIGITS):
        for error in (1e-15, 1e-6, 1e-2):
            for _ in range(12):
                start = STARTS.get(name, rng.uniform(0.1, 1.3))
                values = [start + rng.uniform(-0.05, 0.05) + k for k in range(row.arity)]
                given_ = {
                    f"x{k}": Near(np.longdouble(v), np.longdouble(error))
                    for k, v in enumerate(values)
                }
                shares = rng.choice([-1, 1, 0.5], row.arity)
                true = interpret(program, multiple_precision, {
                    f"x{k}": mpmath.mpf(v) + mpmath.mpf(error) * float(share)
                    for k, (v, share) in enumerate(zip(values, shares, strict=True))
                })["f"][0]  # fmt: skip
                (near,) = enclose(program, given_)["f"]
                away, bound = distance(near, mpmath.mpf(true))
                assert away <= 1
                jumps = row.boolean or name in ("sign", "floor", "select")
                assert jumps or bound < 60 * error


def solution(build: Callable[[Builder], list[Node]], **point: Any) -> tuple[Near, ...]:
    b = Builder()
    return enclose(b.program({"x": build(b)}), point)["x"]


def test_solutions_of_linear_systems_have_bounds(multiple_precision: Domain) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    matrix = [[x, y, b.one], [y.sin(), x * y, b.zero], [b.one, x, 2 + y]]
    program = b.program({"f": b.solve(matrix, [x, y, x * y])})
    columns = {"x": np.linspace(0.5, 2, 7), "y": np.linspace(1, 3, 7)}
    for precision, factor in ((np.float64, 1e-12), (np.longdouble, 1e-16)):
        found = enclose(program, columns, precision)["f"]
        with mpmath.workdps(DIGITS):
            for k in range(7):
                point = {name: mpmath.mpf(float(v[k])) for name, v in columns.items()}
                true = interpret(program, multiple_precision, point)["f"]
                for near, value in zip(found, true, strict=True):
                    away, bound = distance(Near(near.value[k], near.absolute.error[k]), value)
                    assert away <= 1
                    assert bound < factor


def test_a_singular_system_has_no_bound() -> None:
    singular = solution(
        lambda b: list(b.solve([[b.input("x"), b.one], [b.one, b.input("x")]], [b.one, b.zero])),
        x=np.array([1.0, 2.0, np.nan]),
    )
    assert np.isinf(singular[0].absolute.error).tolist() == [True, False, True]


def test_what_is_exact_has_no_error() -> None:
    (near,) = solution(lambda b: [abs(-b.input("x"))], x=1.5)
    assert near.exact
    (near,) = solution(lambda b: [b.input("x") * 0.75 + b.constant(Fraction(1, 3))], x=1.5)
    assert 0 < near.absolute.error < 1e-18


def test_where_nothing_is_known_the_bound_is_infinite() -> None:
    off = Near(np.longdouble(1e-3), np.longdouble(1e-2))
    for build in (
        lambda b: [1 / b.input("x")],
        lambda b: [b.input("x").sqrt()],
        lambda b: [b.input("x").log()],
        lambda b: [b.input("x").power(Fraction(1, 3))],
        lambda b: [b.call("atan2", b.input("x"), -b.input("x"))],
        lambda b: [b.call("acosh", 1 + b.input("x"))],
        lambda b: [b.call("asin", 1 - b.input("x"))],
    ):
        (near,) = solution(build, x=off)
        assert np.isinf(near.absolute.error)
    (near,) = solution(lambda b: [b.less(b.input("x"), 0)], x=off)
    assert near.error >= 1


def test_the_domain_has_a_bound_for_every_operation() -> None:
    names = {row.name for row in OPERATIONS if row.arity and row.name != "entry"}
    assert set(RunningErrors().operations) | {"erf"} == names | {"erf"}


def test_what_underflows_has_an_absolute_bound(multiple_precision: Domain) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"f": [x * x * y * y * 3]})
    point = {"x": 1e-170, "y": 1e160}
    with mpmath.workdps(DIGITS):
        true = interpret(program, multiple_precision, {n: mpmath.mpf(v) for n, v in point.items()})
        for precision in PRECISIONS:
            (near,) = enclose(program, {n: np.array([v]) for n, v in point.items()}, precision)["f"]
            near = Near(near.value[0], near.absolute.error[0])
            assert distance(near, true["f"][0])[0] <= 1
            assert (near.value == 0) == (precision is np.float64)


def test_what_is_no_double_is_lost_in_erf_and_counted() -> None:
    (near,) = solution(lambda b: [b.call("erf", b.input("x"))], x=np.longdouble("1e-400"))
    assert near.absolute.error > 1.2e-400


def test_products_carry_one_number_for_their_error() -> None:
    (near,) = solution(lambda b: [(b.input("x") / 3 * b.input("x").sin()).sqrt()], x=np.ones(5))
    assert near.error is None
    assert 0 < near.relative < 20 * np.finfo(np.longdouble).eps


@pytest.mark.parametrize("name", ["less", "not_greater", "equal"])
@pytest.mark.parametrize(
    ("x", "y", "errors", "known"),
    [
        (1.0, 1.5, (0.125, 0.125), True),
        (1.0, 1.5, (0.25, 0.25), False),  # both may be 1.25
        (1.0, 1.5, (0.375, 0.25), False),
        (1.5, 1.0, (0.25, 0.375), False),
        (1.5, 1.0, (0.375, 0.0625), True),
    ],
)
def test_a_comparison_is_known_where_the_sides_cannot_meet(
    name: str, x: float, y: float, errors: tuple[float, float], known: bool
) -> None:
    b = Builder()
    program = b.program({"f": [b.call(name, b.input("x"), b.input("y"))]})
    near = (Near(np.float64(v), np.float64(e)) for v, e in zip((x, y), errors, strict=True))
    (found,) = enclose(program, dict(zip("xy", near, strict=True)), np.float64)["f"]
    assert bool(found.absolute.error == 0) is known


CONVEX = {"asin": 0.9, "acos": 0.9, "atanh": 0.9, "acosh": 1.1, "log": 0.2, "sqrt": 0.1, "exp": 2.0,
          "tan": 1.2, "sinh": 2.0, "cosh": 2.0}  # fmt: skip


@pytest.mark.parametrize("name", CONVEX)
def test_bounds_are_near_what_the_ends_do(name: str, multiple_precision: Domain) -> None:
    """Within the product of the error and the largest slope, a root within twice that."""
    b = Builder()
    program = b.program({"f": [b.call(name, b.input("x"))]})
    (found,) = enclose(program, {"x": Near(np.float64(CONVEX[name]), np.float64(0.01))})["f"]
    with mpmath.workdps(DIGITS):

        def at(x: Any) -> Any:
            return interpret(program, multiple_precision, {"x": x})["f"][0]

        low, high = (mpmath.mpf(CONVEX[name]) + sign * mpmath.mpf("0.01") for sign in (-1, 1))
        step = mpmath.mpf(10) ** -20
        slopes = [abs(at(end + step) - at(end - step)) / (2 * step) for end in (low, high)]
        room = 2 if name == "sqrt" else 1.05
        assert float(found.absolute.error) <= float(max(slopes)) * 0.01 * room
