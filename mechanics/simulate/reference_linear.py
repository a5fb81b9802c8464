"""Linear equations have an exact solution, and Arb encloses it.

y' = A y + b        (y, 1)(t) = exp(t [[A, b], [0, 0]]) (y, 1)(0)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import casadi as ca
import numpy as np
from flint import arb, arb_mat, fmpq
from numpy.typing import NDArray

from mechanics.exact.balls import Ball, BallArithmetic, State, ball, precision
from mechanics.simulate.reference_taylor import Exact

Array = NDArray[np.float64]

BITS = 512


@dataclass(frozen=True, eq=False)
class Enclosure:
    """Balls around the solution at each time."""

    balls: tuple[tuple[arb, ...], ...]

    def compared(self, values: Sequence[Sequence[Fraction]]) -> str:
        """Where a solution lies, in a sentence."""
        with precision(BITS):
            distances = [
                float((ball(x) - enclosure).abs_upper() / (1 + enclosure.abs_upper()))
                for row, enclosures in zip(values, self.balls, strict=True)
                for x, enclosure in zip(row, enclosures, strict=True)
            ]
        return f"the matrix exponential in balls: at most {max(distances):.0e} away from it"


def linear_solution(given: Exact, times: Array) -> Enclosure | None:
    """The enclosed solution at the times; None where the equations are not linear in y."""
    y, *rest = given.rate.sx_in()
    slope = ca.densify(ca.jacobian(given.rate(y, *rest), y))
    if ca.depends_on(slope, y):
        return None
    function = ca.Function("linear", [y, *rest], [slope, given.rate(y, *rest)])
    size = len(given.start)
    with precision(BITS):
        held = [[Ball(_ball(number)) for number in group] for group in given.held]
        still = [Ball(arb(0))] * size
        entries, offset = BallArithmetic(State({})).graph(function, [still, *held])
        generator = arb_mat(size + 1, size + 1)
        for i in range(size):
            for j in range(size):
                generator[i, j] = _arb(entries[j * size + i])
            generator[i, size] = _arb(offset[i])
        start = arb_mat([[ball(number)] for number in (*given.start, Fraction(1))])
        return Enclosure(tuple(_moved(generator, start, time) for time in times))


def _moved(generator: arb_mat, start: arb_mat, time: float) -> tuple[arb, ...]:
    exact_time = Fraction(float(time))
    moved = (generator * arb(fmpq(exact_time.numerator, exact_time.denominator))).exp() * start
    return tuple(moved.entries()[:-1])


def _ball(number: object) -> arb:
    a = BallArithmetic(State({}))
    return _arb(a.value(number)) if not isinstance(number, Fraction) else ball(number)


def _arb(number: object) -> arb:
    return number.arb if isinstance(number, Ball) else ball(number)
