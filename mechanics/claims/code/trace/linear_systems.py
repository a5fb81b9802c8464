"""Linear systems of traced numbers, in place of those of NumPy and SciPy: A x = b, exactly.

np.linalg.solve, inv, det, pinv, lstsq        scipy.linalg.solve, lu_solve, cho_solve
"""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import sympy

from mechanics.claims.code.trace.explorer import Explorer
from mechanics.claims.code.trace.formulas import leaf
from mechanics.claims.code.trace.tracer import Traced, asked_of, expression_of
from mechanics.claims.demands import asked, of_power
from mechanics.errors import InputError

FEW, LARGEST = 3, 4
"""Unknowns up to which formulas are kept as the code has them, and at all."""

SYMMETRIC = ("sym", "symmetric", "her", "hermitian", "pos", "positive definite")


def solve(a: Any, b: Any) -> np.ndarray:
    """The solution by Cramer's rule, for few unknowns.

    Raises
    ------
    InputError
        For a matrix that is larger, or not square.
    """
    matrix, right = np.asarray(a, dtype=object), np.asarray(b, dtype=object)
    explorer = _explorer([*matrix.flat, *right.flat])
    if explorer is None:
        return np.linalg.solve(np.asarray(a, dtype=float), np.asarray(b, dtype=float))
    left = _square(matrix, explorer)
    if len(matrix) <= FEW:
        return _by_cramer(matrix, right, explorer)
    columns = right.reshape(len(matrix), -1)
    adjugate, determinant = left.adjugate(), left.det(method="berkowitz")
    target = sympy.Matrix(*columns.shape, [expression_of(x, explorer) for x in columns.flat])
    found = adjugate * target / determinant
    own = of_power(determinant, sympy.S.NegativeOne)
    needed = asked(own, *(asked_of(x) for x in (*matrix.flat, *right.flat)))
    entries = [Traced(x, explorer, None, needed) for x in found]
    return np.array(entries, dtype=object).reshape(right.shape)


def _by_cramer(matrix: np.ndarray, right: np.ndarray, explorer: Explorer) -> np.ndarray:
    """The solution in the traced numbers themselves, which keep the names that the code gave."""
    traced = np.array([_traced(x, explorer) for x in matrix.flat], dtype=object)
    rows = traced.reshape(matrix.shape)
    below = _expanded(rows)
    found = np.empty(right.reshape(len(matrix), -1).shape, dtype=object)
    for column in range(found.shape[1]):
        for k in range(len(matrix)):
            with_right = rows.copy()
            with_right[:, k] = right.reshape(len(matrix), -1)[:, column]
            found[k, column] = _expanded(with_right) / below
    return found.reshape(right.shape)


def _traced(number: Any, explorer: Explorer) -> Any:
    value = expression_of(number, explorer)
    return (
        number
        if value is None or isinstance(number, Traced)
        else (Traced(value, explorer, leaf(value), asked_of(number)))
    )


def _expanded(rows: np.ndarray) -> Any:
    """A determinant by its first row."""
    if len(rows) == 1:
        return rows[0, 0]
    minors = (_expanded(np.delete(rows[1:], k, axis=1)) for k in range(len(rows)))
    terms = [_times(entry, minor) for entry, minor in zip(rows[0], minors, strict=True)]
    found = terms[0]
    for k, term in enumerate(terms[1:], 1):
        found = found - term if k % 2 else found + term
    return found


def _times(one: Any, other: Any) -> Any:
    """A product, a sum last: SymPy would carry a sign into one that stands first."""
    return other * one if isinstance(one, Traced) and one.expr.is_Add else one * other


def _square(matrix: np.ndarray, explorer: Explorer) -> sympy.Matrix:
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1]:
        words = " x ".join(map(str, matrix.shape))
        raise InputError(f"a linear system of {words} coefficients: square ones are traced")
    if len(matrix) > LARGEST:
        raise InputError("a linear system of more than four unknowns cannot be traced")
    return sympy.Matrix(*matrix.shape, [expression_of(x, explorer) for x in matrix.flat])


def inverse(a: Any) -> np.ndarray:
    """The inverse, which the one of Moore and Penrose is for a regular matrix, too."""
    return solve(a, np.eye(len(a), dtype=int).astype(object))


def determinant(a: Any) -> Any:
    """The determinant."""
    matrix = np.asarray(a, dtype=object)
    explorer = _explorer(matrix.flat)
    if explorer is None:
        return np.linalg.det(np.asarray(a, dtype=float))
    needed = asked((), *(asked_of(x) for x in matrix.flat))
    return Traced(_square(matrix, explorer).det(method="berkowitz"), explorer, None, needed)


def least_squares(a: Any, b: Any, *_: Any, **__: Any) -> tuple[Any, ...]:
    """What ``lstsq`` returns for as many equations as unknowns."""
    return solve(a, b), np.empty(0), len(a), None


def of_scipy(a: Any, b: Any, lower: bool = False, **options: Any) -> np.ndarray:
    """`scipy.linalg.solve`, which reads one half of a matrix that is said to be symmetric.

    Raises
    ------
    InputError
        For an option that gives the system another meaning.
    """
    kind = options.get("assume_a") or "gen"
    if options.get("transposed") or kind not in ("gen", "general", *SYMMETRIC):
        raise InputError(f"scipy.linalg.solve with {options} is not supported: use its defaults")
    return solve(a if kind.startswith("gen") else _mirrored(a, lower), b)


def _mirrored(a: Any, lower: bool) -> np.ndarray:
    matrix = np.array(a, dtype=object)
    rows, columns = np.triu_indices(len(matrix), 1)
    if lower:
        matrix[rows, columns] = matrix[columns, rows]
    else:
        matrix[columns, rows] = matrix[rows, columns]
    return matrix


def _lu(a: Any, *_: Any, **__: Any) -> tuple[Any, None]:
    return a, None


def _lu_solve(factors: tuple[Any, None], b: Any, trans: int = 0, **_: Any) -> np.ndarray:
    a = np.asarray(factors[0], dtype=object)
    return solve(a.T if trans else a, b)


def _cholesky(a: Any, lower: bool = False, **_: Any) -> tuple[Any, bool]:
    return _mirrored(a, lower), lower


def _cholesky_solve(factors: tuple[Any, bool], b: Any, **_: Any) -> np.ndarray:
    return solve(factors[0], b)


def _explorer(entries: Iterable[Any]) -> Explorer | None:
    return next((x.explorer for x in entries if isinstance(x, Traced)), None)


NUMPY: dict[str, Callable[..., Any]] = {
    "solve": solve, "inv": inverse, "det": determinant, "pinv": inverse, "lstsq": least_squares,
}  # fmt: skip
SCIPY: dict[str, Callable[..., Any]] = {
    "solve": of_scipy, "inv": inverse, "det": determinant, "pinv": inverse,
    "lstsq": least_squares, "lu_factor": _lu, "lu_solve": _lu_solve, "cho_factor": _cholesky,
    "cho_solve": _cholesky_solve,
}  # fmt: skip
