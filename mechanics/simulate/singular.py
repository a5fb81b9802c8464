"""Singular configurations: where the accelerations or the rates are not determined.

    regularity = least of  sigma(C A S)^2,  1 / cond(Z^T S M S Z),  1 / cond(R N S),      0 to 1

A u = b are the constraints: sigma is the smallest singular value (squared, as in A A^T, which is
what is inverted), and the columns of Z span the null space, the motions that are left. M is the
inertia d2T/du2, and N takes speeds to rates of the coordinates: the rows that a route has for its
equations do not matter. The diagonal matrices C, S and R give rows and columns unit size at the
start; they stay, because a constraint or an inertia that fades on the way is what is looked for. A
step can jump over a singular configuration without noticing; where the regularity passes through
a valley between steps, its bottom is therefore looked for.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

Array = NDArray[np.float64]
Measure = Callable[[float, Array], float]

# Half of the digits of a double are lost there.
SINGULAR = 1e-7


@dataclass(frozen=True)
class Linear:
    """What is linear in the speeds at a state.

    Attributes
    ----------
    inertia : array, shape (m, m)
        M, symmetric.
    constraints : array, shape (c, m)
        A.
    rates : array, shape (n, m)
        N.
    """

    inertia: Array
    constraints: Array
    rates: Array


@dataclass(frozen=True)
class Watch:
    """Regularity at a time, and the states of the step that led there (None for the start)."""

    time: float
    regularity: float
    state: Callable[[float], Array] | None


def measure_from(linear: Callable[[float, Array], Linear], t: float, start: Array) -> Measure:
    """The regularity as a function of (t, y), in the scales of the start."""
    first = linear(t, start)
    speeds = _reciprocal(np.sqrt(np.abs(np.diag(first.inertia))))
    coordinates = _reciprocal(np.linalg.norm(first.rates * speeds, axis=1))
    constraints = _reciprocal(np.linalg.norm(first.constraints * speeds, axis=1))

    def measure(t: float, state: Array) -> float:
        now = linear(t, state)
        if not all(np.all(np.isfinite(part)) for part in vars(now).values()):
            return 0.0
        kept, motions = _null_space(now.constraints * np.outer(constraints, speeds))
        inertia = motions.T @ (now.inertia * np.outer(speeds, speeds)) @ motions
        turning = now.rates * np.outer(coordinates, speeds)
        return min(kept**2, _ratio(inertia), _ratio(turning))

    return measure


def _null_space(rows: Array) -> tuple[float, Array]:
    """The smallest singular value, at most 1, and a basis, m x (m - c), of what rows leave free."""
    count, size = rows.shape
    if not count:
        return 1.0, np.eye(size)
    _, values, basis = np.linalg.svd(rows)
    return min(1.0, float(values[-1])), basis[count:].T


def _ratio(matrix: Array) -> float:
    """Smallest to largest singular value."""
    values = np.linalg.svd(matrix, compute_uv=False)
    return float(values[-1] / values[0]) if values[0] > 0 else 0.0


def _reciprocal(sizes: Array) -> Array:
    """1 / size, and 1 for what has no size."""
    return 1.0 / np.where(sizes > 0, sizes, 1.0)


def regularity_lost(measure: Measure, watch: Sequence[Watch]) -> float | None:
    """The time at which the regularity falls below `SINGULAR`, or None.

    Parameters
    ----------
    measure : callable
        From `measure_from`.
    watch : sequence of Watch
        The last three ends of steps, or fewer at the start.
    """
    last = watch[-1]
    if last.regularity < SINGULAR:
        return last.time
    if len(watch) < 3 or not watch[0].regularity >= watch[1].regularity < last.regularity:
        return None
    middle = watch[1].time

    def along(t: float) -> float:
        state = watch[1].state if t <= middle else last.state
        return 1.0 if state is None else measure(t, state(t))

    span = last.time - watch[0].time
    bottom = minimize_scalar(
        along,
        bounds=(watch[0].time, last.time),
        method="bounded",
        options={"xatol": 1e-10 * span},
    )
    return float(bottom.x) if bottom.fun < SINGULAR else None
