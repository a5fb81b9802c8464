"""Several quotients by one divisor: one division, and a bound for what it costs."""

from fractions import Fraction

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.compiled import compile
from mechanics.compiled.programs.reciprocals import with_reciprocals
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import Routine, run

x, y, d = ca.SX.sym("x"), ca.SX.sym("y"), ca.SX.sym("d")


def read(*outputs: ca.SX) -> Routine:
    graph = ca.Function("f", [ca.vertcat(x, y, d)], [ca.vertcat(*outputs)], ["s"], ["out"])
    return read_routine(graph)


def values(code: Routine, numbers: tuple[float, ...], kind: type) -> list[float]:
    (found,) = run(code, [[kind(n) for n in numbers]], kind)
    return [float(n) for n in found]


def test_one_division_is_left() -> None:
    code = read(x / d, y / d, 1 / d, (x + y) / (d + 1))
    shorter = with_reciprocals(code)
    assert (code.divisions, shorter.divisions) == (4, 2)
    # A product more for each quotient, but for the reciprocal itself.
    assert shorter.operations == code.operations - code.divisions + shorter.divisions + 2


def test_a_single_quotient_and_numbers_stay_quotients() -> None:
    code = read(x / d, x / 3, y / 3)
    assert with_reciprocals(code) == code


def test_with_the_least_of_one_every_quotient_is_a_product() -> None:
    assert with_reciprocals(read(x / d, y / (d + 1)), least=1).divisions == 2
    assert with_reciprocals(read(x / d / d), least=1).divisions == 1


numbers = st.floats(1e-3, 1e3).flatmap(lambda n: st.sampled_from([n, -n]))


@pytest.mark.parametrize(("kind", "u"), [(np.float64, 2.0**-53), (np.float32, 2.0**-24)])
@given(above=numbers, other=numbers, below=numbers)
def test_products_are_off_by_at_most_two_roundings(
    kind: type, u: float, above: float, other: float, below: float
) -> None:
    given_numbers = tuple(float(kind(n)) for n in (above, other, below))
    exact = [Fraction(n) / Fraction(given_numbers[2]) for n in given_numbers[:2]]
    for code, roundings in (
        (read(x / d, y / d), 1),
        (with_reciprocals(read(x / d, y / d)), 2),
    ):
        for found, true in zip(values(code, given_numbers, kind), exact, strict=True):
            assert abs(Fraction(found) - true) <= (1 + Fraction(u)) * roundings * Fraction(u) * abs(
                true
            )


@given(above=numbers, other=numbers, power=st.integers(-30, 30))
def test_powers_of_two_lose_nothing(above: float, other: float, power: int) -> None:
    code = read(x / d, y / d)
    given_numbers = (above, other, 2.0**power)
    shorter = with_reciprocals(code)
    assert values(code, given_numbers, np.float64) == values(shorter, given_numbers, np.float64)


@pytest.mark.campaign
def test_it_can_be_switched_off(derived) -> None:
    equations = derived("rolling_disc", "kane")
    plain = compile(equations, reciprocals=False).program("forward_dynamics")
    shorter = compile(equations).program("forward_dynamics")
    assert shorter.divisions < plain.divisions
