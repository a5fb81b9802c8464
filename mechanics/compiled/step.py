"""One step of an explicit Runge-Kutta method, as a graph.

    k_i = f(y + h sum_j a_ij k_j)        y(t + h) = y + h sum_i b_i k_i

Unrolled, so that what all stages share (sums of parameters, for example) is computed once. Inputs
are held over the step; time, where the equations hold it, is not.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import casadi as ca

Rate = Callable[[ca.SX, Fraction | float], ca.SX]
"""f as a function of the state and c, the share of the step that has passed."""


@dataclass(frozen=True)
class Tableau:
    """Coefficients of an explicit Runge-Kutta method.

    Attributes
    ----------
    a : tuple of tuple
        Row i holds what stage i takes from the stages before it.
    b : tuple
    """

    name: str
    order: int
    a: tuple[tuple[Fraction | float, ...], ...]
    b: tuple[Fraction | float, ...]


_HALF, _SIXTH, _THIRD = Fraction(1, 2), Fraction(1, 6), Fraction(1, 3)
RK4 = Tableau(
    "RK4", 4, ((), (_HALF,), (0, _HALF), (0, 0, Fraction(1))), (_SIXTH, _THIRD, _THIRD, _SIXTH)
)


def runge_kutta(tableau: Tableau, rate: Rate, y: ca.SX, h: ca.SX) -> ca.SX:
    """y(t + h), a dense column."""
    slopes: list[ca.SX] = []
    for row in tableau.a:
        share = sum(row)
        slopes.append(rate(y + h * _combined(row, slopes), share))
    return ca.densify(y + h * _combined(tableau.b, slopes))


def _combined(factors: Sequence[Fraction | float], slopes: Sequence[ca.SX]) -> ca.SX:
    """Weighted sum; fractions are brought to one denominator, whose reciprocal is no double."""
    pairs = [(factor, slope) for factor, slope in zip(factors, slopes, strict=True) if factor]
    if not pairs:
        return ca.SX(0)
    below = math.lcm(*(f.denominator for f, _ in pairs if isinstance(f, Fraction)))
    terms = [
        slope if factor * below == 1 else float(factor * below) * slope for factor, slope in pairs
    ]
    total = sum(terms[1:], terms[0])
    return total / below if below != 1 else total
