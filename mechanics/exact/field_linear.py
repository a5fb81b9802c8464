"""Linear systems in the field, with Cramer's bounds: x_j = det A_j / det A.

Row i times its common denominator has entries of degree at most r_i (right side included), so every
determinant has degree at most sum r_i, and by Hadamard's trivial bound n! prod 2**h_i a height of
at most sum (h_i + log2 n). All x_j share one denominator, det A.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log2
from typing import TYPE_CHECKING

from mechanics.exact.field_number import FieldNumber
from mechanics.exact.signals import SingularHere

if TYPE_CHECKING:
    from mechanics.exact.field import FieldArithmetic

Row = Sequence[FieldNumber]


def solve(a: FieldArithmetic, rows: Sequence[Row], rhs: Row) -> list[FieldNumber]:
    """Return the solution of a square system.

    Raises
    ------
    SingularHere
        If the matrix is singular modulo this prime at this point.
    ValueError
        If the shapes do not fit.
    """
    size = len(rows)
    if len(rhs) != size or any(len(row) != size for row in rows):
        raise ValueError(f"square system expected: {size} rows, {len(rhs)} right sides found")
    augmented = [[a.rational(0) + entry for entry in (*row, rhs[i])] for i, row in enumerate(rows)]
    residues, pivots = echelon([[entry.residue for entry in row] for row in augmented], a.prime)
    if pivots != list(range(size)):
        raise SingularHere("singular matrix")
    degree, height = _determinant_size(augmented)
    token = a.new_token() if degree else 0
    return [FieldNumber(a, row[size], degree, degree, height, token) for row in residues]


def rank(a: FieldArithmetic, rows: Sequence[Row]) -> int:
    """Return the rank modulo the prime; the largest minor may vanish by chance: counted."""
    numbers = [[a.rational(0) + entry for entry in row] for row in rows]
    if not numbers:
        return 0
    a.count_branch(*_determinant_size(numbers))
    return len(echelon([[entry.residue for entry in row] for row in numbers], a.prime)[1])


def _determinant_size(rows: Sequence[Row]) -> tuple[float, float]:
    """Return degree and log2 height bounds of every minor of the rows, denominators cleared."""
    sizes = [_row_size(row) for row in rows]
    spread = log2(len(rows)) if rows else 0.0
    return sum(d for d, _ in sizes), sum(h + spread for _, h in sizes)


def _row_size(row: Row) -> tuple[float, float]:
    """Return degree and height of a row times the product of its different denominators."""
    denominators = {entry.token: entry.denominator for entry in row}
    common = sum(denominators.values())
    degree = max(entry.numerator - entry.denominator for entry in row) + common
    return max(degree, common, 0.0), sum(entry.height for entry in row)


def echelon(rows: list[list[int]], p: int) -> tuple[list[list[int]], list[int]]:
    """Return the reduced echelon form of residues modulo p, and its pivot columns."""
    pivots: list[int] = []
    for column in range(len(rows[0]) if rows else 0):
        top = len(pivots)
        found = next((i for i in range(top, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[top], rows[found] = rows[found], rows[top]
        inverse = pow(rows[top][column], -1, p)
        lead = rows[top] = [entry * inverse % p for entry in rows[top]]
        for i, row in enumerate(rows):
            factor = row[column]
            if i != top and factor:
                rows[i] = [(x - factor * y) % p for x, y in zip(row, lead, strict=True)]
        pivots.append(column)
        if len(pivots) == len(rows):
            break
    return rows, pivots
