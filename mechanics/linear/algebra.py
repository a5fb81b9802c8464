"""Small exact matrices: zero tests, null spaces and signs without tolerance.

A G = 0,  G with the identity on the free columns
"""

from collections.abc import Sequence

from sympy import (
    Expr,
    Matrix,
    S,
    Symbol,
    cancel,
    cos,
    factor,
    fraction,
    sin,
    sympify,
    together,
    zeros,
)  # fmt: skip

from mechanics.errors import ExpressionError
from mechanics.symbolic import is_zero as decide_zero
from mechanics.symbolic import operations, tidy


def reduced(expr: Expr) -> Expr:
    """A rational function with common factors cancelled."""
    return cancel(sympify(expr))


def written(expr: Expr) -> Expr:
    """`reduced`, or the same with products of sines and cosines cancelled where that is shorter."""
    plain = reduced(expr)
    if not plain.has(sin, cos):
        return plain
    return min(plain, reduced(tidy(plain)), key=operations)


def is_zero(expr: Expr) -> bool:
    """Whether an expression vanishes identically.

    Raises
    ------
    ExpressionError
        If that can be neither shown nor refuted.
    """
    known = decide_zero(expr)
    if known is None:
        raise ExpressionError(f"it is undecided whether {str(expr)[:80]} is zero")
    return known


def null_space(matrix: Matrix) -> tuple[Matrix, tuple[int, ...]]:
    """Basis G (as columns) of the null space, and the free columns on which G is the identity."""
    echelon, pivots = matrix.rref(iszerofunc=is_zero, simplify=reduced)
    free = tuple(j for j in range(matrix.cols) if j not in pivots)
    basis = zeros(matrix.cols, len(free))
    for column, j in enumerate(free):
        basis[j, column] = S.One
        for row, pivot in enumerate(pivots):
            basis[pivot, column] = reduced(-echelon[row, j])
    return basis, free


def independent_rows(matrix: Matrix) -> tuple[int, ...]:
    """Indices of rows that span the row space, the first that do."""
    return tuple(matrix.T.rref(iszerofunc=is_zero, simplify=reduced)[1])


def inverse(matrix: Matrix) -> Matrix:
    """Inverse of a small regular matrix, by cofactors, entries reduced."""
    determinant = matrix.det(method="berkowitz")
    return matrix.adjugate(method="berkowitz").applyfunc(lambda e: reduced(e / determinant))


def sign(expr: Expr) -> int | None:
    """Sign of an expression for all admissible values of its symbols: 1, 0, -1, or None.

    Exact: a factored sum of positive terms is positive; None where the declared signs of the
    parameters do not settle it.
    """
    factored = factor(reduced(expr))
    if is_zero(factored):
        return 0
    if factored.is_positive:
        return 1
    return -1 if factored.is_negative else None


def numerator(expr: Expr) -> Expr:
    """Numerator over the common denominator: a polynomial where the denominator holds constants."""
    return fraction(together(expr))[0]


def coefficients(polynomial: Expr, symbol: Symbol) -> list[Expr]:
    """Coefficients of a polynomial in one symbol, constant term first."""
    from_top: Sequence[Expr] = polynomial.expand().as_poly(symbol).all_coeffs()
    return [reduced(entry) for entry in reversed(from_top)]
