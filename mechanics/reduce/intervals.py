"""Intervals of doubles, many at a time, each operation rounded outward.

    [a, b] + [c, d] = [down(a + c), up(b + d)]

What IEEE 754 rounds correctly (sums, products, quotients, roots) is moved by one unit in the last
place; every other function is Arb's, interval by interval. What has no value, such as a quotient by
an interval that holds 0, is the whole line.

Moore, Kearfott, Cloud, Introduction to Interval Analysis, SIAM 2009.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from mechanics.kernel.balls import Balls, precision

Array = NDArray[np.float64]
INFINITE = np.inf
BITS = 64


class Interval(NamedTuple):
    """Lower and upper ends, arrays of one shape; or two numbers."""

    low: Any
    high: Any

    @property
    def size(self) -> Any:
        """Largest absolute value."""
        return np.maximum(-self.low, self.high)


ZERO = Interval(0.0, 0.0)


def number(value: Fraction) -> Interval:
    """The doubles around a rational."""
    nearest = float(value)
    if Fraction(nearest) == value:
        return Interval(nearest, nearest)
    return Interval(float(np.nextafter(nearest, -INFINITE)), float(np.nextafter(nearest, INFINITE)))


def between(low: Fraction, high: Fraction) -> Interval:
    """The doubles around a range of rationals."""
    return Interval(number(low).low, number(high).high)


def outward(low: Any, high: Any) -> Interval:
    """One unit in the last place further out; the whole line where there is no number."""
    low, high = np.nextafter(low, -INFINITE), np.nextafter(high, INFINITE)
    wild = np.isnan(low) | np.isnan(high)
    if np.any(wild):
        low, high = np.where(wild, -INFINITE, low), np.where(wild, INFINITE, high)
    return Interval(low, high)


def add(x: Interval, y: Interval) -> Interval:
    """x + y."""
    if x is ZERO or y is ZERO:
        return y if x is ZERO else x
    return outward(x.low + y.low, x.high + y.high)


def negate(x: Interval) -> Interval:
    """-x."""
    return x if x is ZERO else Interval(-x.high, -x.low)


def subtract(x: Interval, y: Interval) -> Interval:
    """x - y."""
    return add(x, negate(y))


def multiply(x: Interval, y: Interval) -> Interval:
    """x y."""
    if x is ZERO or y is ZERO:
        return ZERO
    products = [a * b for a in x for b in y]
    return outward(np.minimum.reduce(products), np.maximum.reduce(products))


def square(x: Interval) -> Interval:
    """x x, which is not negative."""
    a, b = x.low * x.low, x.high * x.high
    least = np.where((x.low <= 0) & (x.high >= 0), 0.0, np.minimum(a, b))
    return Interval(
        np.maximum(np.nextafter(least, -INFINITE), 0.0), outward(a, np.maximum(a, b))[1]
    )


def divide(x: Interval, y: Interval) -> Interval:
    """x / y."""
    if x is ZERO:
        return ZERO
    holds_zero = (y.low <= 0) & (y.high >= 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        quotients = [np.divide(a, b) for a in x for b in y]
    low, high = np.minimum.reduce(quotients), np.maximum.reduce(quotients)
    return outward(np.where(holds_zero, -INFINITE, low), np.where(holds_zero, INFINITE, high))


def sqrt(x: Interval) -> Interval:
    """The principal root; the whole line where part of x is negative."""
    negative = x.low < 0
    low, high = outward(np.sqrt(np.maximum(x.low, 0.0)), np.sqrt(np.maximum(x.high, 0.0)))
    return Interval(
        np.where(negative, -INFINITE, np.maximum(low, 0.0)), np.where(negative, INFINITE, high)
    )


def hull(x: Interval, y: Interval) -> Interval:
    """The least interval around both."""
    return Interval(np.minimum(x.low, y.low), np.maximum(x.high, y.high))


def meet(x: Interval, y: Interval) -> Interval:
    """What is in both, where both hold the same value."""
    return Interval(np.maximum(x.low, y.low), np.minimum(x.high, y.high))


def hypotenuse(x: Interval, y: Interval) -> Interval:
    """What bounds c x + s y for all c and s with c c + s s = 1."""
    root = sqrt(add(square(x), square(y))).high
    return Interval(-root, root)


def sine(x: Interval, quarter: int = 0) -> Interval:
    """sin x, or cos x with a quarter of a turn more."""
    function = Balls.operations["cos" if quarter else "sin"]
    low, high = (
        by_balls(function, Interval(x.low, x.low)),
        by_balls(function, Interval(x.high, x.high)),
    )
    ends = hull(low, high)
    # A crest or trough in between, and a little to be sure; beyond 1e6 rad anything may be.
    turns = [(end / np.pi + quarter / 2) / 2 for end in x]
    with np.errstate(invalid="ignore"):
        crest, trough = (
            np.floor(turns[1] - at + 1e-9) > np.floor(turns[0] - at - 1e-9) for at in (0.25, 0.75)
        )
        wild = np.logical_not((x.low >= -1e6) & (x.high <= 1e6))
    return Interval(
        np.where(trough | wild, -1.0, np.maximum(ends.low, -1.0)),
        np.where(crest | wild, 1.0, np.minimum(ends.high, 1.0)),
    )


PI = Interval(float(np.nextafter(np.pi, 0)), float(np.nextafter(np.pi, 4)))
"""The doubles around pi; the nearest one is below it."""


def by_balls(function: Callable[..., arb], *operands: Interval) -> Interval:
    """Any function by Arb, one interval after the other; equal ones once."""
    shape = np.broadcast_shapes(*(np.shape(end) for x in operands for end in x))
    columns = [np.broadcast_to(end, shape).ravel() for x in operands for end in x]
    rows, places = np.unique(np.stack(columns, axis=1), axis=0, return_inverse=True)
    found = np.array([_by_ball(function, row) for row in rows]).reshape(-1, 2)[places.ravel()]
    return outward(found[:, 0].reshape(shape), found[:, 1].reshape(shape))


def _by_ball(function: Callable[..., arb], ends: Array) -> tuple[float, float]:
    if not np.isfinite(ends).all():
        return -INFINITE, INFINITE
    with precision(BITS):
        balls = [ball_of(Interval(a, b)) for a, b in zip(ends[::2], ends[1::2], strict=True)]
        value = function(*balls)
        if not value.is_finite():
            return -INFINITE, INFINITE
        return float(value.lower()), float(value.upper())


def ball_of(x: Interval) -> arb:
    """A ball around an interval of finite numbers."""
    return arb(float(x.low)).union(arb(float(x.high)))
