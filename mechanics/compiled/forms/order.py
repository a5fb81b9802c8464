"""The order in which Gaussian elimination takes its pivots, chosen once for a set of equations.

    eta = max_i |A x - b|_i / (|A| |x| + |b|)_i        (row-wise backward error)

A compiled function cannot look for pivots while it runs. So each candidate order is tried in double
precision at random states beforehand, and the first one whose backward error is a few roundings
everywhere is taken, or else the one that fails least often. The rows of a route may be any
full-rank combination; which order suits them depends on the structure of the combination, hardly on
the state.
"""

from collections.abc import Iterator
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import SingularError

Array = NDArray[np.float64]
Order = tuple[tuple[int, int], ...]

GOOD = 4.0  # roundings for each unknown; LDL^T of a well scaled system needs no more
ALL_ORDERS_UP_TO = 3


def pivot_order(matrices: Array, rhs: Array) -> Order:
    """Choose pivots (row, column) for systems sampled at S states.

    Parameters
    ----------
    matrices : array, S x n x n
    rhs : array, S x n

    Raises
    ------
    SingularError
        When no order solves the system at any of the states.
    """
    n = matrices.shape[1]
    good = GOOD * n
    tried: list[tuple[float, float, Order]] = []
    for order in candidates(matrices):
        errors = backward_errors(matrices, rhs, order)
        if errors.max(initial=0.0) < good:
            return order
        tried.append((float(np.mean(errors >= good)), float(np.median(errors)), order))
    share, median, best = min(tried)
    if not np.isfinite(median):
        raise SingularError(
            f"the {n} equations cannot be solved for the accelerations: the system is singular at"
            f" {share:.0%} of the sampled states; look for a body without mass or redundant"
            " constraints"
        )
    return best


def candidates(matrices: Array) -> Iterator[Order]:
    """Orders worth trying, the most natural first; all of them for small systems."""
    n = matrices.shape[1]
    forward = tuple(range(n))
    backward = forward[::-1]
    yield tuple(zip(backward, backward, strict=True))
    yield tuple(zip(forward, forward, strict=True))
    if n <= ALL_ORDERS_UP_TO:
        for rows in permutations(range(n)):
            for columns in permutations(range(n)):
                yield tuple(zip(rows, columns, strict=True))
        return
    partners = matching(matrices)
    yield tuple((partners[j], j) for j in backward)
    yield tuple((partners[j], j) for j in forward)
    yield greedy(matrices)


def matching(matrices: Array) -> list[int]:
    """For each column the row with which the product of the (scaled) pivots is largest."""
    # Imported here: it takes longer than compiling a small system, which does not need it.
    from scipy.optimize import linear_sum_assignment

    _, columns = linear_sum_assignment(-np.log(_relative(matrices) + 1e-300))
    rows = [0] * len(columns)
    for row, column in enumerate(columns):
        rows[column] = row
    return rows


def greedy(matrices: Array) -> Order:
    """Eliminate with, at each step, the pivot that is largest in its row and column."""
    a = matrices.copy()
    n = a.shape[1]
    rows, columns = list(range(n)), list(range(n))
    order = []
    for _ in range(n):
        scaled = _relative(a[:, rows][:, :, columns])
        i, j = np.unravel_index(np.argmax(scaled), scaled.shape)
        row, column = rows.pop(int(i)), columns.pop(int(j))
        order.append((row, column))
        with np.errstate(all="ignore"):
            factor = a[:, rows, column] / a[:, row, column, None]
            a[:, rows] -= factor[:, :, None] * a[:, None, row, :]
    return tuple(order)


def _relative(matrices: Array) -> Array:
    """Typical |a_ij| against the largest of its row and column: n x n, free of units."""
    size = np.abs(matrices)
    with np.errstate(all="ignore"):
        scaled = size / np.sqrt(size.max(axis=2, keepdims=True) * size.max(axis=1, keepdims=True))
    return np.quantile(np.nan_to_num(scaled), 0.1, axis=0)


def backward_errors(matrices: Array, rhs: Array, order: Order) -> Array:
    """The largest row-wise backward error at each state, in roundings; inf where none is finite."""
    with np.errstate(all="ignore"):
        x = solve(matrices, rhs, order).astype(np.longdouble)
        a, b = matrices.astype(np.longdouble), rhs.astype(np.longdouble)
        residual = np.abs(np.einsum("sij,sj->si", a, x) - b)
        scale = np.einsum("sij,sj->si", np.abs(a), np.abs(x)) + np.abs(b)
        ratio = np.where(residual == 0, 0, residual / scale).max(axis=1) / np.finfo(float).eps
    return np.where(np.isfinite(ratio), ratio, np.inf).astype(float)


def solve(matrices: Array, rhs: Array, order: Order) -> Array:
    """What `factor.solve_general` computes, at S states at once."""
    a, b = matrices.copy(), rhs.copy()
    rows = list(range(a.shape[1]))
    for row, column in order:
        rows.remove(row)
        factor = a[:, rows, column] / a[:, row, column, None]
        a[:, rows] -= factor[:, :, None] * a[:, None, row, :]
        b[:, rows] -= factor * b[:, row, None]
    x = np.zeros_like(b)
    known: list[int] = []
    for row, column in reversed(order):
        total = b[:, row] - np.einsum("sj,sj->s", a[:, row][:, known], x[:, known])
        x[:, column] = total / a[:, row, column]
        known.append(column)
    return x
