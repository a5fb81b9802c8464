"""Linear algebra over fractions of polynomials: x_j = det A_j / det A.

Explicit determinants grow quickly, so this is for few unknowns; the limits of the ring stop it
otherwise, and the field, where elimination costs nothing, decides.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

from mechanics.exact.normal_number import Quotient
from mechanics.exact.signals import SingularHere, TooLarge

if TYPE_CHECKING:
    from mechanics.exact.normal import NormalArithmetic

MOST_UNKNOWNS = 6


def solve(
    a: NormalArithmetic, rows: Sequence[Sequence[Quotient]], rhs: Sequence[Quotient]
) -> list[Quotient]:
    """Return the solution of a square system.

    Raises
    ------
    SingularHere
        If the determinant is identically zero.
    TooLarge
        If there are more than a few unknowns.
    ValueError
        If the shapes do not fit.
    """
    size = len(rows)
    if len(rhs) != size or any(len(row) != size for row in rows):
        raise ValueError(f"square system expected: {size} rows, {len(rhs)} right sides found")
    if size > MOST_UNKNOWNS:
        raise TooLarge(f"{size} unknowns")
    full = [[a.rational(0) + entry for entry in (*row, rhs[i])] for i, row in enumerate(rows)]

    @cache
    def minor(top: int, columns: tuple[int, ...]) -> Quotient:
        """Determinant of the rows from `top` on, by the first of them (Laplace)."""
        total = a.rational(0 if columns else 1)
        for position, column in enumerate(columns):
            if not a.is_zero(full[top][column]):
                rest = columns[:position] + columns[position + 1 :]
                total = total + (-1) ** position * full[top][column] * minor(top + 1, rest)
        return total

    determinant = minor(0, tuple(range(size)))
    if a.is_zero(determinant):
        raise SingularHere("singular matrix")
    replaced = (tuple(size if c == j else c for c in range(size)) for j in range(size))
    inverse = determinant.inverse()
    return [minor(0, columns) * inverse for columns in replaced]


def rank(a: NormalArithmetic, rows: Sequence[Sequence[Quotient]]) -> int:
    """Return the rank by elimination without divisions."""
    left = [[a.rational(0) + entry for entry in row] for row in rows]
    count = 0
    for column in range(len(left[0]) if left else 0):
        found = next((i for i in range(count, len(left)) if not a.is_zero(left[i][column])), None)
        if found is None:
            continue
        left[count], left[found] = left[found], left[count]
        lead = left[count]
        for i in range(count + 1, len(left)):
            factor = left[i][column]
            left[i] = [lead[column] * x - factor * y for x, y in zip(left[i], lead, strict=True)]
        count += 1
    return count
