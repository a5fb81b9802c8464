"""Linear systems solved by expressions, without a branch.

    symmetric:  P M P^T = L D L^T        general:  Gaussian elimination along given pivots
    minors:     elimination with pivots m_i / m_(i+1)

LDL^T of a positive definite matrix needs no pivoting: |L| D |L|^T is bounded by the diagonal, so
each row's residual stays within a few roundings of its own terms, whatever the units of the rows.
Structural zeros cost nothing: CasADi drops products with zero. What is computed of numbers alone is
exact: a quotient of two numbers is no double.
"""

from collections.abc import Sequence
from typing import Any

import casadi as ca

from mechanics.program.casadi_printer import ExactGraphs

Pivots = Sequence[tuple[int, int]]


def solve_symmetric(matrix: ca.SX, rhs: ca.SX, exact: ExactGraphs) -> ca.SX:
    """Solve M X = B for symmetric positive definite M, n x n, by L^T D L; B is n x m.

    The last unknown is eliminated first: in tree order those are the leaves, and what does not
    depend on each other stays zero (Featherstone, Rigid Body Dynamics Algorithms, 6.5).
    """
    n, rows = matrix.shape[0], _Rows(exact)
    a, b = rows.of(matrix), rows.of(rhs)
    factor: list[list[Any]] = [[0] * n for _ in range(n)]
    for k in reversed(range(n)):
        for i in range(k):
            factor[k][i] = rows.divide(a[k][i], a[k][k])
        for i in range(k):
            for j in range(i + 1):
                a[i][j] = rows.less(a[i][j], factor[k][i], a[k][j])
            b[i] = rows.row_less(b[i], factor[k][i], b[k])
    x: list[list[Any]] = []
    for k in range(n):
        total = [rows.divide(entry, a[k][k]) for entry in b[k]]
        for i in range(k):
            total = rows.row_less(total, factor[k][i], x[i])
        x.append(total)
    return rows.graph(x)


def solve_general(
    matrix: ca.SX, rhs: ca.SX, pivots: Pivots, exact: ExactGraphs, minors: Sequence[ca.SX] = ()
) -> ca.SX:
    """Solve A X = B, n x n, eliminating along `pivots`, (row, column) in turn; B is n x m.

    Parameters
    ----------
    minors : sequence of ca.SX
        m_i = det A[i:, i:] where they are known, m_n = 1: eliminating from the last unknown, the
        pivot of step i is m_i / m_(i+1). What they spell out need not be found by subtraction.
    """
    n, rows = matrix.shape[0], _Rows(exact)
    a, b = rows.of(matrix), rows.of(rhs)
    m = [exact.value(minor) for minor in minors]
    left, columns = set(range(n)), set(range(n))
    for row, column in pivots:
        left.remove(row)
        columns.remove(column)
        if m:
            a[row][column] = rows.divide(m[row], m[row + 1])
        for i in left:
            factor = rows.divide(a[i][column], a[row][column])
            for j in columns:
                a[i][j] = rows.less(a[i][j], factor, a[row][j])
            b[i] = rows.row_less(b[i], factor, b[row])
    x: list[list[Any]] = [[]] * n
    known: list[int] = []
    for row, column in reversed(pivots):
        total = b[row]
        for j in known:
            total = rows.row_less(total, a[row][j], x[j])
        x[column] = [rows.divide(entry, a[row][column]) for entry in total]
        known.append(column)
    return rows.graph(x)


class _Rows:
    """Rows of graphs and exact numbers."""

    def __init__(self, exact: ExactGraphs) -> None:
        self._exact, operations = exact, exact.operations
        self._minus, self._times = operations["subtract"], operations["multiply"]
        self.divide = operations["divide"]

    def of(self, matrix: ca.SX) -> list[list[Any]]:
        """Entries of a matrix."""
        whole, (n, m) = ca.densify(matrix), matrix.shape
        return [[self._exact.value(whole[i, j]) for j in range(m)] for i in range(n)]

    def less(self, x: Any, factor: Any, y: Any) -> Any:
        """x - factor y."""
        return self._minus(x, self._times(factor, y))

    def row_less(self, x: Sequence[Any], factor: Any, y: Sequence[Any]) -> list[Any]:
        """The same for every entry of two rows."""
        return [self.less(one, factor, other) for one, other in zip(x, y, strict=True)]

    def graph(self, rows: Sequence[Sequence[Any]]) -> ca.SX:
        """Rows as a matrix."""
        return ca.vertcat(*(ca.horzcat(*map(self._exact.graph, row)) for row in rows))
