"""Leading minors as sums of terms of one sign.

    m_i = det K[i:, i:]            M + m - M c^2   ->   m + M s^2

Of s^2 + c^2 = 1 every angle uses the side that leaves fewer terms which can be negative where the
parameters are positive; with none left, no rounding error is amplified in the sum.
"""

from collections.abc import Sequence

import sympy
from flint import fmpq_mpoly
from sympy import Expr, Matrix, Symbol

from mechanics.kernel.ring import Ring
from mechanics.symbolic.canonical_back import Writer, circles, generator_expression
from mechanics.symbolic.canonical_poly import reader

MOST = 3
"""Unknowns up to which minors are written out."""


def trailing_minors(matrix: Matrix) -> tuple[Expr, ...]:
    """m_0, ..., m_(n-1), and m_n = 1: minors of the last rows and columns.

    Raises
    ------
    TooLarge
        If the normal form of a minor is.
    """
    n = matrix.rows
    minors = [matrix[i:, i:].det(method="berkowitz") for i in range(n)]
    return (*(without_subtraction(minor) for minor in minors), sympy.S.One)


def without_subtraction(expr: Expr) -> Expr:
    """An expression with the fewest terms that can be negative, else the fewest terms."""
    result, (polynomial,) = reader([expr])
    ring = result.ring
    best = ring.reduced(polynomial)
    for circle in circles(ring):
        other = _swapped(ring, best, circle)
        best = min(best, other, key=lambda p: (_negative(ring, p), len(p)))
    return Writer(ring).write(best)


def _swapped(ring: Ring, polynomial: fmpq_mpoly, circle: tuple[int, int]) -> fmpq_mpoly:
    """The polynomial with c**2 = 1 - s**2 in place of s**2 = 1 - c**2."""
    c, s = circle
    sin, cos = ring.gen(s), ring.gen(c)
    exchange = [sin if i == c else cos if i == s else ring.gen(i) for i in range(ring.capacity)]
    return (polynomial.compose(*exchange) % (sin**2 + cos**2 - 1)).compose(*exchange)


def _negative(ring: Ring, polynomial: fmpq_mpoly) -> int:
    """How many terms can differ in sign from the first."""
    terms = list(polynomial.terms())
    sign = terms[0][1] > 0 if terms else True
    return sum((value > 0) != sign or _may_change_sign(ring, powers) for powers, value in terms)


def _may_change_sign(ring: Ring, powers: Sequence[int]) -> bool:
    odd = (place for place, power in enumerate(powers) if power % 2)
    return any(not _positive(generator_expression(ring, place)) for place in odd)


def _positive(generator: Expr) -> bool:
    return bool(isinstance(generator, Symbol) and generator.is_positive)
