"""Quotients by one divisor that are added: one quotient, of the same value."""

import operator
from fractions import Fraction

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.compiled.programs.common_denominators import gathered
from mechanics.program.casadi_reader import read_routine
from mechanics.program.operations import ADD, DIVIDE, INPUT, MULTIPLY, NEGATE, SUBTRACT
from mechanics.program.routine import Routine, run

x, y, z, d, e = (ca.SX.sym(name) for name in "xyzde")


def read(*outputs: ca.SX) -> Routine:
    graph = ca.Function("f", [ca.vertcat(x, y, z, d, e)], [ca.vertcat(*outputs)], ["s"], ["out"])
    return read_routine(graph)


GATHERED = (
    (x / d + y / d, 1),
    (x / d * y - z / d, 1),
    (z * (x / d) + y * (y / d), 1),
    (-(x / d) - y / d, 1),
    (x / d + y / d + z / d, 1),
    ((x / d + y / d) * z - z * x / d, 1),
    ((x + y / d) / e + z / e, 2),
    ((x / d + y / d) / e + z / e, 2),
)
KEPT = (
    x / d + y / e,
    x / d + y,
    x / d * (y / d) + z / d,
    x / 3 + y / 3,
    d / x + d / y,
    ca.sin(x / d) + ca.cos(y / d),
)


@pytest.mark.parametrize(("graph", "left"), GATHERED, ids=lambda x: str(x))
def test_one_division_is_left_and_the_value_is_the_same(graph: ca.SX, left: int) -> None:
    code = read(graph)
    shorter = gathered(code)
    assert shorter.divisions == left < code.divisions
    assert shorter.operations == code.operations - (code.divisions - left)
    numbers = [Fraction(n) for n in ("3/7", "-5/3", "11/2", "13/9", "-2/5")]
    assert exact(shorter, numbers) == exact(code, numbers)


MEANING = {
    ADD: operator.add, SUBTRACT: operator.sub, MULTIPLY: operator.mul, DIVIDE: operator.truediv,
    NEGATE: operator.neg,
}  # fmt: skip


def exact(code: Routine, numbers: list[Fraction]) -> list[Fraction]:
    """The outputs in fractions."""
    values: list[Fraction] = []
    for node in code.nodes:
        if node.operation == INPUT:
            values.append(numbers[node.operands[1]])
            continue
        if node.constant is not None:
            values.append(node.constant)
            continue
        values.append(MEANING[node.operation](*(values[i] for i in node.operands)))
    return [values[k] for k in code.outputs[0]]


@pytest.mark.parametrize("graph", KEPT, ids=str)
def test_what_has_no_common_divisor_stays(graph: ca.SX) -> None:
    code = read(graph)
    assert gathered(code) == code


def test_what_is_used_twice_stays() -> None:
    quotient = x / d
    code = read(quotient + y / d, quotient)
    assert gathered(code) == code


@given(st.lists(st.floats(0.1, 10), min_size=5, max_size=5))
def test_it_rounds_as_well(numbers: list[float]) -> None:
    code = read(x / d * y + z / d)
    exactly = exact(code, [Fraction(n) for n in numbers])[0]
    (found,) = run(gathered(code), [numbers], np.float64)
    # A product, a sum and a quotient, of positive numbers.
    assert abs(Fraction(float(found[0])) - exactly) <= 4 * Fraction(2) ** -53 * exactly
