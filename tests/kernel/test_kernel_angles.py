"""Rewriting in base angles: the same values, and nothing but base angles."""

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.kernel.angles import Forms, base_angles, is_truth, turns_of
from mechanics.program import OPERATIONS, Builder, Node, Program, interpret
from mechanics.program.numpy_domain import Arrays

POINT = {"x": 0.37, "y": -0.9, "z": 1.7}
BASES = {"sin", "cos", "exp"}

CASES: dict[str, Callable[..., Node]] = {
    "multiple": lambda B, x, y, z: (2 * x).sin() + (-3 * x).cos(),
    "sum": lambda B, x, y, z: (x / 2 - 3 * y).cos() - (y * 3 - x / 2).sin(),
    "products": lambda B, x, y, z: ((x + y) * z).cos() + (x * z).sin(),
    "quotients": lambda B, x, y, z: ((x + y) / z).sin() + (x / (y * z)).cos(),
    "whole": lambda B, x, y, z: (x / (y + z)).sin() * (2 * x / (y + z)).cos(),
    "turns": lambda B, x, y, z: (x + B.pi * Fraction(5, 6)).cos() + (y - B.pi / 4).sin(),
    "quarters": lambda B, x, y, z: sum(
        ((x + B.pi * Fraction(k, 4)).cos() * k + (x - B.pi * Fraction(k, 4)).sin()
         for k in range(9)), B.zero),
    "seventh": lambda B, x, y, z: (B.pi * Fraction(2, 7) + x).cos()
    + (B.pi * Fraction(-9, 7)).sin(),
    "constants": lambda B, x, y, z: (x + 1).sin() + (x - Fraction(1, 3)).cos(),
    "tangent": lambda B, x, y, z: B.call("tan", x + 1) + B.call("tan", y),
    "exponential": lambda B, x, y, z: (x - y / 2 + 1).exp() + (-x).exp(),
    "hyperbolic": lambda B, x, y, z: (x / 3).cosh() + (x - y).sinh() + B.call("tanh", 2 * y),
    "arcs": lambda B, x, y, z: B.call("atan2", x, y).sin() + (2 * B.call("asin", x / 5)).cos()
    + B.call("acos", x / 3).sin() * B.call("atan", x * y).cos() + B.call("acos", x).cos(),
    "windings": lambda B, x, y, z: (x - 2 * B.pi * B.call("floor", (x + B.pi) / (2 * B.pi))).sin()
    + (y + 4 * B.pi * z.sign() * B.less(x, y)).cos(),
    "half windings": lambda B, x, y, z: (x + B.pi * B.call("floor", 3 * z)).sin(),
    "cases": lambda B, x, y, z: B.less(x, y).choose(x - 2 * B.pi, x).sin(),
    "truths": lambda B, x, y, z: B.call("select", x, y, z) + B.call("and", x, y) * 2
    + B.call("or", x - x.cos() * 0, 0) + B.call("not", z),
    "doubles": lambda B, x, y, z: (B.constant(0.25) * x).cos() + (x * Fraction(1, 3)).sin(),
}  # fmt: skip


def built(case: Callable[..., Node]) -> object:
    b = Builder()
    nodes = [b.input(name) for name in POINT]
    return b.program({"value": [case(b, *nodes)]}, inputs=list(POINT))


def value(program: object) -> float:
    return float(interpret(program, Arrays(np.longdouble), POINT)["value"][0])


@pytest.mark.parametrize("name", CASES)
def test_the_value_stays_the_same(name: str) -> None:
    program = built(CASES[name])
    assert value(base_angles(program)) == pytest.approx(value(program), abs=1e-12)


def test_what_has_base_angles_only_is_left_as_it_is() -> None:
    program = built(lambda B, x, y, z: x.sin() + z.log().sin() + x.cos().exp())
    assert base_angles(program) == program
    other = built(lambda B, x, y, z: B.call("asin", x / 3).sin() + B.pi.cos())
    assert not {"asin", "sin", "cos"} & set(base_angles(other).counts())


def has_truths(program: Program) -> bool:
    """Whether all that stands for a condition is 0 or 1."""
    counts = {"select": 1, "not": 1, "and": 2, "or": 2}
    return all(
        is_truth(program, operand)
        for number, code in enumerate(program.operations)
        for operand in program.operands_of(number)[: counts.get(OPERATIONS[code].name, 0)]
    )


@pytest.mark.parametrize("name", CASES)
def test_only_base_angles_are_left_and_once_is_enough(name: str) -> None:
    program = base_angles(built(CASES[name]))
    assert not {"tan", "sinh", "cosh", "tanh"} & set(program.counts())
    assert has_truths(program)
    again = base_angles(program)
    assert value(again) == pytest.approx(value(program), abs=1e-12)


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.tuples(st.fractions(-3, 3, max_denominator=6), st.sampled_from("xyz")), max_size=4),
    st.fractions(-4, 4, max_denominator=24),
)
def test_sums_of_multiples(terms: list[tuple[Fraction, str]], turns: Fraction) -> None:
    def case(B: Builder, *nodes: Node) -> Node:
        total = B.pi * turns
        for factor, name in terms:
            total = total + B.input(name) * factor
        return total.sin() + 2 * total.cos() + total.exp() / 100

    program = built(case)
    # Doubles, with an exponential that may be large.
    assert value(base_angles(program)) == pytest.approx(value(program), abs=1e-9, rel=1e-12)


def test_a_program_in_base_angles_is_returned_as_it_is() -> None:
    plain = built(lambda B, x, y, z: x.sin() * y.cos() + z.exp() * x)
    assert base_angles(plain) is plain
    program = built(lambda B, x, y, z: x.sin() * y.cos() + z.exp() * x + B.less(x, y).choose(x, 1))
    assert base_angles(program) == program
    other = built(lambda B, x, y, z: (x / 2).exp())
    assert "exp" in base_angles(other).counts()
    for case in ("multiple", "turns", "tangent", "exponential", "truths", "arcs"):
        assert base_angles(built(CASES[case])) != built(CASES[case])


def test_windings_fall_out_and_half_windings_do_not() -> None:
    assert "floor" not in base_angles(built(CASES["windings"])).counts()
    assert "floor" in base_angles(built(CASES["half windings"])).counts()


def test_turns_are_read_off() -> None:
    program = base_angles(built(CASES["seventh"]))
    assert turns_of(program) == (Fraction(3, 14),)
    assert turns_of(base_angles(built(CASES["quarters"]))) == ()


def test_sums_share_their_beginnings() -> None:
    """Angles q1, q1 + q2, ... of a chain: one rotation for each more."""

    def count(n: int) -> int:
        b = Builder()
        total, values = b.zero, []
        for k in range(n):
            total = total + b.input(f"q{k:03}")
            values += [total.sin(), total.cos()]
        return base_angles(b.program({"value": values})).count

    assert count(40) - count(39) == 8


def test_forms_are_polynomials_in_what_has_none() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    forms = Forms(b)
    form = forms.of(((x + y) * (x - y) / (2 * x)).number)
    assert form == {
        ((x.number, 1),): Fraction(1, 2),
        ((x.number, -1), (y.number, 2)): Fraction(-1, 2),
    }
    assert forms.of((x * y - y * x).number) == {}
    root = x.sqrt()
    assert forms.of((3 * root).number) == {((root.number, 1),): 3}
    # Too many terms: the node as a whole.
    long = b.one
    for k in range(12):
        long = long * (b.input(f"a{k}") + 1)
    assert len(forms.of(long.number)) < 1100
    assert is_truth(b, b.less(x, y).number)
    assert not is_truth(b, x.number)
    assert is_truth(b, b.one.number)
    assert not is_truth(b, b.constant(2).number)
