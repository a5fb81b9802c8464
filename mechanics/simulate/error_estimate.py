"""How large the error of a motion is likely to be: a second run by a tolerance that is coarser.

    e(t) = |y(t) - y_coarse(t)| r,    r = fine tolerance / coarse tolerance

Errors of a method that controls its steps are about proportional to its tolerance, so that the
coarse run, which costs less than a third, shows how a motion makes errors grow. Where it has lost
the motion, at t1, it ends, and the growth before is gone on with, by the law that fits it better:

    e(t) = e(t1) exp(k (t - t1)),    e(t) = e(t1) (t / t1)^n

What is called the error is relative to the largest magnitude of each coordinate or speed, as in
`mechanics.trade`. An estimate, no bound: it is of the integration, not of the model.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.march import Flow, Tolerance
from mechanics.simulate.samples import Samples, sample

Array = NDArray[np.float64]

COARSER = {"DOP853": 1e5}
"""Its second tolerance is so much coarser: steps of eighth order are four times as long."""
USUALLY = 1e3
"""By how much it is for methods of lower order, or of an order that changes."""
LONGER = 2.0
"""Mean steps that such a second run begins with: its start counts where it is short."""
COARSEST = 1e-5
"""Beyond it errors are no longer proportional to the tolerance."""
LEAST = 30
"""By how much it has to be coarser, or the difference would be of two errors alike."""
FINER = 1e-2
"""What a tolerance that leaves no room above is compared with instead."""
ROUNDINGS = 10 * float(np.finfo(float).eps)
"""A step is never more accurate."""
LOST = 0.1
"""Difference from which two runs are of different motions."""
DECADES = 1e-4
"""Of what is lost: from there on its growth is looked at."""
NOISE = 1e3
"""Times the absolute tolerance: what stays below is not resolved, and compared with this."""
COMPARED = 50
"""Samples, at most, at which runs are compared."""


@dataclass(frozen=True)
class ErrorEstimate:
    """What is likely to be wrong with the samples of a motion.

    Attributes
    ----------
    error : float
        The largest along the way, relative to the largest magnitude of each coordinate or speed; 1
        where nothing is right.
    tenfold : float or None
        Seconds in which errors grow tenfold, where they were seen to grow exponentially.
    horizon : float or None
        Time in s from which nothing of the motion is right, where it ends later.
    """

    error: float
    tenfold: float | None = None
    horizon: float | None = None


def error_estimate(
    flow: Flow, start: Array, times: Array, by: Tolerance, found: Samples
) -> ErrorEstimate | None:
    """Of samples, from a second run; None where there are too few or the second run gives up.

    Parameters
    ----------
    start : array, shape (n + m,)
    times : array, shape (N,)
        Of the samples that were asked for.
    by : Tolerance
        That the samples were computed with.
    found : Samples
        At the first K of the times.
    """
    reached = len(found.states)
    rows = np.unique(np.linspace(0, reached - 1, min(reached, COMPARED + 1)).astype(int))
    if len(rows) < 2:
        return None
    factor = min(COARSER.get(by.method, USUALLY), COARSEST / by.rtol)
    coarse = factor >= LEAST
    factor = factor if coarse else FINER
    other = replace(by, rtol=factor * by.rtol, atol=factor * by.atol)
    first = None
    if coarse and by.method in COARSER:
        first = LONGER * float(times[rows[-1]] - times[0]) / found.steps
    right = found.states[rows]
    scale = np.maximum(np.max(np.abs(right), axis=0), NOISE * by.atol)

    def lost(row: int, state: Array) -> bool:
        """Whether the coarse run shows nothing more: what follows is another motion."""
        return coarse and bool(np.max(np.abs(right[row] - state) / scale) >= LOST)

    states = sample(flow, start, times[rows], other, first=first, enough=lost).states
    count = len(states)
    if count < len(rows) and not lost(count - 1, states[-1]):
        return None
    gaps = np.maximum.accumulate(np.max(np.abs(right[:count] - states) / scale, axis=1))
    if not coarse:
        return ErrorEstimate(min(1.0, float(gaps[-1])))
    ratio = max(by.rtol, ROUNDINGS) / other.rtol
    return _extrapolated(times[rows], gaps, ratio)


def _extrapolated(times: Array, gaps: Array, ratio: float) -> ErrorEstimate:
    """The error at the end; growth is followed from where the coarse run has lost the motion.

    There the gaps end, before the times do.
    """
    end = float(times[-1])
    if gaps[-1] < LOST:
        return ErrorEstimate(ratio * float(gaps[-1]))
    lost = max(int(np.argmax(gaps >= LOST)), 1)
    t, error = float(times[lost]), ratio * float(min(gaps[lost], 1.0))
    seen = slice(max(1, min(int(np.argmax(gaps >= DECADES * LOST)), lost - 1)), lost + 1)
    exponential, rate = _line(times[seen], np.log(gaps[seen]))
    algebraic, power = _line(np.log(times[seen]), np.log(gaps[seen]))
    if algebraic < exponential / 2 or rate <= 0:
        return ErrorEstimate(min(1.0, error * (end / t) ** max(power, 1.0)))
    horizon = t - float(np.log(error)) / rate
    if horizon < end:
        return ErrorEstimate(1.0, float(np.log(10)) / rate, horizon)
    return ErrorEstimate(error * float(np.exp(rate * (end - t))), float(np.log(10)) / rate)


def _line(x: Array, y: Array) -> tuple[float, float]:
    """Sum of squares that a line through points leaves, and its slope."""
    x, y = x - np.mean(x), y - np.mean(y)
    slope = float(x @ y / (x @ x)) if len(x) > 1 else 0.0
    return float(np.sum((y - slope * x) ** 2)), slope
