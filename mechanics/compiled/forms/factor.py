"""Linear systems solved by expressions, without a branch.

    symmetric:  P M P^T = L D L^T        general:  Gaussian elimination along given pivots
    minors:     elimination with pivots m_i / m_(i+1)

LDL^T of a positive definite matrix needs no pivoting: |L| D |L|^T is bounded by the diagonal, so
each row's residual stays within a few roundings of its own terms, whatever the units of the rows.
Structural zeros cost nothing: CasADi drops products with zero.
"""

from collections.abc import Sequence

import casadi as ca

Pivots = Sequence[tuple[int, int]]


def solve_symmetric(matrix: ca.SX, rhs: ca.SX) -> ca.SX:
    """Solve M X = B for symmetric positive definite M, n x n, by L^T D L; B is n x m.

    The last unknown is eliminated first: in tree order those are the leaves, and what does not
    depend on each other stays zero (Featherstone, Rigid Body Dynamics Algorithms, 6.5).
    """
    n = matrix.shape[0]
    a = [[matrix[i, j] for j in range(n)] for i in range(n)]
    b = [rhs[i, :] for i in range(n)]
    factor = [[ca.SX(0)] * n for _ in range(n)]
    for k in reversed(range(n)):
        for i in range(k):
            factor[k][i] = a[k][i] / a[k][k]
        for i in range(k):
            for j in range(i + 1):
                a[i][j] = a[i][j] - factor[k][i] * a[k][j]
            b[i] = b[i] - factor[k][i] * b[k]
    x: list[ca.SX] = []
    for k in range(n):
        total = b[k] / a[k][k]
        for i in range(k):
            total = total - factor[k][i] * x[i]
        x.append(total)
    return ca.vertcat(*x)


def solve_general(matrix: ca.SX, rhs: ca.SX, pivots: Pivots) -> ca.SX:
    """Solve A X = B, n x n, eliminating along `pivots`, (row, column) in turn; B is n x m."""
    n = matrix.shape[0]
    a = [[matrix[i, j] for j in range(n)] for i in range(n)]
    b = [rhs[i, :] for i in range(n)]
    rows, columns = set(range(n)), set(range(n))
    for row, column in pivots:
        rows.remove(row)
        columns.remove(column)
        for i in rows:
            factor = a[i][column] / a[row][column]
            for j in columns:
                a[i][j] = a[i][j] - factor * a[row][j]
            b[i] = b[i] - factor * b[row]
    x: list[ca.SX] = [ca.SX(0)] * n
    known: list[int] = []
    for row, column in reversed(pivots):
        total = b[row]
        for j in known:
            total = total - a[row][j] * x[j]
        x[column] = total / a[row][column]
        known.append(column)
    return ca.vertcat(*x)


def solve_with_pivots(matrix: ca.SX, rhs: ca.SX, minors: Sequence[ca.SX]) -> ca.SX:
    """Solve A X = B, n x n, where the minors m_i = det A[i:, i:] are known, m_n = 1.

    Eliminating from the last unknown, the pivot of step i is m_i / m_(i+1): what the minors spell
    out need not be found by subtraction.
    """
    n = matrix.shape[0]
    a = [[matrix[i, j] for j in range(n)] for i in range(n)]
    b = [rhs[i, :] for i in range(n)]
    for k in reversed(range(n)):
        a[k][k] = minors[k] / minors[k + 1]
        for i in range(k):
            factor = a[i][k] / a[k][k]
            for j in range(k):
                if j != i:
                    a[i][j] = a[i][j] - factor * a[k][j]
            b[i] = b[i] - factor * b[k]
    x: list[ca.SX] = []
    for k in range(n):
        total = b[k]
        for i in range(k):
            total = total - a[k][i] * x[i]
        x.append(total / a[k][k])
    return ca.vertcat(*x)
