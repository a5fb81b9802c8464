"""Singular configurations: where the accelerations are not determined.

    regularity = 1 / cond(S K S'),   K = [[M, -B], [A, 0]],   0 to 1

K is what is solved for the accelerations and the multipliers; the diagonal matrices S and S' bring
its rows and columns to unit size, so that units and the sizes of the bodies do not matter. A step
can jump over a singular configuration without noticing; where the regularity passes through a
valley between steps, its bottom is therefore looked for.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

Array = NDArray[np.float64]

# Half of the digits of a double are lost there.
SINGULAR = 1e-7


@dataclass(frozen=True)
class Watch:
    """Regularity at a time, and the states of the step that led there (None for the start)."""

    time: float
    regularity: float
    state: Callable[[float], Array] | None


def regularity(matrix: Array) -> float:
    """One over the condition number of a matrix after its rows and columns are scaled.

    Parameters
    ----------
    matrix : array, shape (k, k)

    Returns
    -------
    float
        Between 0, singular, and 1; 0 where an entry is not finite.
    """
    if not np.all(np.isfinite(matrix)):
        return 0.0
    scaled = matrix
    # Ruiz's equilibration: a few rounds of dividing by the roots of the largest magnitudes.
    for _ in range(5):
        rows, columns = (np.max(np.abs(scaled), axis=axis, initial=0.0) for axis in (1, 0))
        if not (rows.all() and columns.all()):
            return 0.0
        scaled = scaled / np.sqrt(rows)[:, None] / np.sqrt(columns)[None, :]
    values = np.linalg.svd(scaled, compute_uv=False)
    return float(values[-1] / values[0])


def regularity_lost(
    measure: Callable[[float, Array], float], watch: Sequence[Watch]
) -> float | None:
    """The time at which the regularity falls below `SINGULAR`, or None.

    Parameters
    ----------
    measure : callable
        Regularity of (t, y).
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
