"""Errors of computed accelerations against enclosed ones.

    forward     max_i |x^_i - x_i| / ulp(x_i)             ulp: spacing of the numbers at x_i
    relative    max_i |x^_i - x_i| / |x_i|
    backward    max_r |K x^ - k|_r / (|K| |x^| + |k|)_r / epsilon

|K| and |k| are sums of the magnitudes of terms. Upper ends of enclosures are given.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np
from flint import arb

from mechanics.extremes.truth import Enclosed
from mechanics.kernel.balls import precision


@dataclass(frozen=True)
class Errors:
    """Errors at one point; infinite where a computed value is no number."""

    forward: float
    relative: float
    backward: float


LOST = Errors(inf, inf, inf)


def measure(found: Enclosed, computed: Sequence[float], kind: type[np.floating]) -> Errors:
    """Errors of computed values of all unknowns.

    Parameters
    ----------
    found : Enclosed
        At the point that they were computed for.
    computed : sequence of float
        Numbers of the precision `kind`.
    """
    if found.solution is None or not all(map(isfinite, computed)):
        return LOST
    limits = np.finfo(kind)
    with precision(found.bits):
        values = [arb(value) for value in computed]
        forward = relative = 0.0
        for value, true in zip(values, found.solution, strict=True):
            error = abs(value - true)
            if error.is_zero():
                continue
            forward = max(forward, _upper(error / spacing(true, limits)))
            relative = max(relative, inf if true.contains(0) else _upper(error / abs(true)))
        backward = max(
            _row(row, sizes, values) for row, sizes in zip(found.rows, found.sizes, strict=True)
        )
    return Errors(forward, relative, backward / float(limits.eps))


def spacing(true: arb, limits: np.finfo) -> arb:
    """The distance of neighbouring numbers of a precision at a value."""
    least = int(limits.minexp) - int(limits.nmant)
    if true.is_zero():
        return arb((1, least))
    mantissa, exponent = true.mid().man_exp()
    size = int(mantissa).bit_length() + int(exponent)
    return arb((1, max(size - int(limits.nmant) - 1, least)))


def _row(row: Sequence[arb], sizes: Sequence[arb], values: Sequence[arb]) -> float:
    residual, size = -row[-1], sizes[-1]
    for entry, magnitude, value in zip(row, sizes, values, strict=False):
        residual += entry * value
        size += magnitude * abs(value)
    return 0.0 if residual.is_zero() else _upper(abs(residual) / size)


def _upper(ball: arb) -> float:
    """A number not below the ball, to within its rounding; infinite where the ball is no number."""
    return float(ball.upper()) if ball.is_finite() else inf
