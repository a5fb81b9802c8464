"""Linear equations have an exact solution, and Arb encloses it.

y' = A y + b        (y, 1)(t) = exp(t [[A, b], [0, 0]]) (y, 1)(0)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import arb, arb_mat
from numpy.typing import NDArray

from mechanics.kernel.balls import ball, enclose, precision
from mechanics.program import Builder
from mechanics.program.forward import tangent
from mechanics.program.interpret import include
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
    builder, size = Builder(), len(given.start)
    rates = include(builder, given.program)["yd"]
    state = [builder.input(name) for name in given.start]
    slopes = [tangent(rates, {entry: builder.one}) for entry in state]
    matrix = builder.program({"A": [row for column in zip(*slopes, strict=True) for row in column]})
    if set(matrix.inputs) & set(given.start):
        return None
    at_zero = include(builder, given.program, dict.fromkeys(given.start, builder.zero))["yd"]
    values = enclose(builder.program({"b": at_zero}), given.held, BITS)
    values |= enclose(matrix, given.held, BITS)
    with precision(BITS):
        generator = arb_mat(size + 1, size + 1)
        for i in range(size):
            for j in range(size):
                generator[i, j] = values["A"][size * i + j]
            generator[i, size] = values["b"][i]
        start = arb_mat([[ball(number)] for number in (*given.start.values(), Fraction(1))])
        return Enclosure(tuple(_moved(generator, start, time) for time in times))


def _moved(generator: arb_mat, start: arb_mat, time: float) -> tuple[arb, ...]:
    moved = (generator * ball(Fraction(float(time)))).exp() * start
    return tuple(moved.entries()[:-1])
