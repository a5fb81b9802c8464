"""Bounded or secular: how an error behaves that oscillates while it grows.

What drifts has moved, from the first window of samples to the last, by more than it varies within
the first.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Drift:
    """How an error behaves.

    Attributes
    ----------
    largest : float
        Largest magnitude of the error.
    rate : float
        Slope of the error, for a period; of its mean over windows.
    power : float
        Of time, that a secular error grows with: 1 for energy, 2 for the phase that follows.
    secular : bool
        Whether it has left the band in which it varies; otherwise it is bounded so far.
    """

    largest: float
    rate: float
    power: float
    secular: bool

    def after(self, factor: float) -> float:
        """Largest error over a motion that is so many times longer, if it goes on like this."""
        growing = self.secular and math.isfinite(self.power)
        return self.largest * factor**self.power if growing else self.largest

    @property
    def words(self) -> str:
        """The drift in a few words."""
        if self.secular:
            grows = f" with t^{self.power:.1f}" if math.isfinite(self.power) else ""
            return f"secular, {self.rate:+.1e} a period, grows{grows} to {self.largest:.1e}"
        return f"bounded, at most {self.largest:.1e}"


def drift(times: Array, error: Array, size: int) -> Drift:
    """Behaviour of an error at times, sampled in windows of so many samples.

    Parameters
    ----------
    times : array, shape (N,)
        In periods.
    error : array, shape (N,)
    """
    count, largest = len(error) // size, float(np.max(np.abs(error), initial=0.0))
    if count < 3:
        rate = float(np.polyfit(times, error, 1)[0]) if len(error) > 1 else math.nan
        return Drift(largest, rate, math.nan, True)
    windows = error[: count * size].reshape(count, size)
    means, at = windows.mean(axis=1), times[: count * size : size]
    rate = float(np.polyfit(at, means, 1)[0])
    # The band of the first window: in a later one the drift itself may show.
    moved, secular = np.abs(means[1:] - means[0]), abs(means[-1] - means[0]) > np.ptp(windows[0])
    grown = secular and bool(np.all(moved > 0))
    power = float(np.polyfit(np.log(at[1:]), np.log(moved), 1)[0]) if grown else math.nan
    return Drift(largest, rate, power, bool(secular))
