"""Intervals, deviations and harmonics hold what they enclose; a false bound is not proved."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.kernel import Verdict
from mechanics.program import Builder, Program
from mechanics.program import operations as op
from mechanics.reduce import intervals as on
from mechanics.reduce.edits import Kind
from mechanics.reduce.harmonics import Polynomials
from mechanics.reduce.intervals import Interval
from mechanics.reduce.proof import bound

numbers = st.floats(-20, 20, allow_subnormal=False)
shares = st.floats(0, 1)


def inside(low: float, width: float, share: float) -> float:
    return min(max(low + share * abs(width), low), low + abs(width))


@settings(max_examples=50, deadline=None)
@given(numbers, numbers, shares, numbers, numbers, shares)
def test_results_of_operations_lie_in_those_of_intervals(
    a: float, u: float, s: float, b: float, v: float, t: float
) -> None:
    x, y = Interval(a, a + abs(u)), Interval(b, b + abs(v))
    p, q = inside(a, u, s), inside(b, v, t)
    exact = Fraction(p), Fraction(q)
    found = {
        on.add: exact[0] + exact[1], on.subtract: exact[0] - exact[1],
        on.multiply: exact[0] * exact[1],
    }  # fmt: skip
    if q != 0:
        found[on.divide] = exact[0] / exact[1]
    for function, value in found.items():
        low, high = map(float, function(x, y))
        assert low <= value <= high
    for quarter, function in enumerate((math.sin, math.cos)):
        low, high = on.sine(x, quarter)
        assert low - 1e-15 <= function(p) <= high + 1e-15
    low, high = on.square(x)
    assert low <= exact[0] ** 2 <= high


def test_a_sine_is_as_wide_as_it_has_to_be() -> None:
    low, high = on.sine(Interval(0.0, 3.0))
    assert low == 0 or -1e-300 < low < 1e-15
    assert high == 1.0
    low, high = on.sine(Interval(0.1, 0.2))
    assert high - low == pytest.approx(math.sin(0.2) - math.sin(0.1), abs=1e-15)


def pendulum() -> tuple[Program, int, int]:
    """sin(a) + b cos(a), and its sine and product."""
    build = Builder()
    a, b = build.input("a"), build.input("b")
    program = build.program({"y": [a.sin() + b * a.cos()]})
    codes = [program.operations[k] for k in range(len(program))]
    return program, codes.index(op.SIN), codes.index(op.MULTIPLY)


BOX = {"a": (Fraction(-1), Fraction(1)), "b": (Fraction(0), Fraction(1, 10))}


def test_small_angles_are_bounded_by_what_is_beyond_the_sine() -> None:
    program, sine, _ = pendulum()
    most = Fraction(1) - Fraction(math.sin(1))
    edits = {sine: Kind.ANGLE}
    assert bound("x", program, BOX, edits, [most * Fraction("1.000001")]).finding.shown
    short = bound("x", program, BOX, edits, [most * Fraction("0.999999")], boxes=500)
    assert short.finding.verdict is Verdict.UNDECIDED


def test_a_false_bound_is_not_proved_however_many_parts() -> None:
    program, _, product = pendulum()
    edits = {product: Kind.ZERO}
    assert bound("x", program, BOX, edits, [Fraction("0.1001")]).finding.shown
    assert not bound("x", program, BOX, edits, [Fraction("0.0999")], boxes=2000).finding.shown


def test_a_divisor_that_may_be_zero_is_told() -> None:
    build = Builder()
    a, b = build.input("a"), build.input("b")
    program = build.program({"y": [(1 + b) / a]})
    (root,) = program.roots
    top = program.operands_of(root)[0]
    found = bound("x", program, BOX, {top: Kind.FIRST}, [Fraction(1)], boxes=64)
    assert found.finding.verdict is Verdict.UNDECIDED
    assert "a divisor may be 0" in found.finding.evidence


def test_what_arrives_twice_with_opposite_signs_is_gone() -> None:
    build = Builder()
    a, b, c = (build.input(name) for name in "abc")
    term = b * c
    program = build.program({"y": [(a + term) * 3 - (c + term * 3)]})
    (product,) = (
        k for k in range(len(program))
        if [program.operations[j] for j in program.operands_of(k)] == [op.INPUT] * 2
        and program.operations[k] == op.MULTIPLY
    )  # fmt: skip
    box = {name: (Fraction(-5), Fraction(5)) for name in "abc"}
    assert bound("x", program, box, {product: Kind.ZERO}, [Fraction(1, 10**9)]).finding.shown


def test_harmonics_bound_a_rotation_by_the_length_of_the_vector() -> None:
    build = Builder()
    a, u, v = (build.input(name) for name in "auv")
    along = a.cos() * u + a.sin() * v
    program = build.program({"y": [along * along * 2 + u]})
    box = {"a": (Fraction(-9), Fraction(9)), "u": (Fraction(-3), Fraction(3)),
           "v": (Fraction(-4), Fraction(4))}  # fmt: skip
    (root,) = program.roots
    edit = {root: Kind.ZERO}
    found = Polynomials(program, box, {}).bounds(edit)
    assert found is not None
    draws = np.random.default_rng(0)
    angle, x, y = draws.uniform(-9, 9, 5000), draws.uniform(-3, 3, 5000), draws.uniform(-4, 4, 5000)
    size = np.abs(2 * (np.cos(angle) * x + np.sin(angle) * y) ** 2 + x).max()
    assert size <= found[0] <= 2 * size
