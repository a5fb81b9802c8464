"""How far the linearized model is enough.

    error(a) = largest |y_linear - y| / scale along the motion that starts at rest, displaced by a

from an equilibrium in one coordinate. The amplitude at which it is 1 % is found by bisection. About
an unstable equilibrium the deviation grows, and what counts is for how long.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import MechanicsError
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.dropping import ENOUGH
from mechanics.trade.linearized import Equilibrium, as_equations, is_linear
from mechanics.trade.measure import prepared
from mechanics.trade.truth import Truth, from_states

Array = NDArray[np.float64]

# Amplitudes are sought from 1 (m or rad) down to this by factors of 2, and up to LARGEST.
TINY, LARGEST, BISECTIONS = 1e-22, 1e3, 8
# Beside a coordinate that is not zero a deviation has so many digits less.
ROUNDED = 1e-9
# Times of e-fold growth in which the end of the linear motion is looked for.
LOOK = 10.0
# Amplitudes around the one that is found, for the plot.
CURVE = tuple(2.0 ** (k / 2) for k in range(-8, 5))


@dataclass(frozen=True, eq=False)
class Amplitude:
    """How far the linear equations are enough in one coordinate.

    Attributes
    ----------
    place : str
        The equilibrium.
    limit : float
        Largest amplitude at which the error is 1 %; infinite where no amplitude is too large, zero
        where none is small enough.
    curve : tuple of (float, float)
        Amplitude and error.
    words : str
        In a sentence.
    """

    coordinate: str
    unit: str
    place: str
    limit: float
    curve: tuple[tuple[float, float], ...]
    words: str


def amplitudes(case: Case, at: Equilibrium, choice: Choice) -> tuple[Amplitude, ...]:
    """One for every coordinate of the scene.

    Parameters
    ----------
    choice : Choice
        How to integrate, with an error well below `ENOUGH`: a fixed step, which takes no notice of
        how small a motion is.
    """
    pair = Pair(case, replace(case, equations=as_equations(at.linear), _models={}), choice, at)
    return tuple(_along(pair, i) for i in range(len(case.equations.scene.q)))


@dataclass(frozen=True, eq=False)
class Pair:
    """Nonlinear and linear equations about one equilibrium, integrated in the same way."""

    whole: Case
    small: Case
    choice: Choice
    at: Equilibrium

    @cached_property
    def rest(self) -> Array:
        """The equilibrium as a state."""
        scene = self.whole.equations.scene
        return np.array(
            [*(float(self.at.linear.point[q]) for q in scene.q), *(0.0 for _ in scene.u)]
        )

    def deviations(self, index: int, amplitude: float) -> tuple[Array, Array] | None:
        """Nonlinear and linear motion about the equilibrium; None where one of them fails."""
        start = self.rest.copy()
        start[index] += amplitude
        try:
            outcomes = [prepared(c, self.choice, start)() for c in (self.whole, self.small)]
        except MechanicsError:
            return None
        states = [outcome.states for outcome in outcomes]
        if min(map(len, states)) < len(self.whole.times) or not np.all(np.isfinite(states)):
            return None
        return states[0] - self.rest, states[1] - self.rest

    def error(self, index: int, amplitude: float) -> float:
        """Largest error of the linear motion."""
        found = self.deviations(index, amplitude)
        if found is None:
            return np.inf
        return float(np.max(_truth(found[0], amplitude).errors(found[1])))

    def lasts(self, index: int, amplitude: float) -> float:
        """Time in s until which the error is small enough; 0 where it is not at all."""
        found = self.deviations(index, amplitude)
        if found is None:
            return 0.0
        enough = 0.0
        for k in range(1, len(self.whole.times)):
            errors = _truth(found[0][: k + 1], amplitude).errors(found[1][: k + 1])
            if np.max(errors) > ENOUGH:
                break
            enough = float(self.whole.times[k])
        return enough


def _truth(motion: Array, amplitude: float) -> Truth:
    """The nonlinear motion; what does not move but for rounding has no scale of its own."""
    truth = from_states(motion)
    return replace(truth, scale=np.maximum(truth.scale, ROUNDED * amplitude))


def _along(pair: Pair, index: int) -> Amplitude:
    entry = pair.whole.names[index]
    unit, place = pair.whole.units[index], pair.at.place
    if is_linear(pair.whole.equations):
        words = f"{entry}: exact at any amplitude, since the equations are linear"
        return Amplitude(entry, unit, place, np.inf, (), words)
    smallest = TINY if pair.rest[index] == 0 else ROUNDED * abs(pair.rest[index])
    limit = _limit(lambda a: pair.error(index, a), smallest)
    curve: tuple[tuple[float, float], ...] = ()
    if 0 < limit < np.inf:
        curve = tuple((limit * c, pair.error(index, limit * c)) for c in CURVE)
    return Amplitude(entry, unit, place, limit, curve, _words(pair, index, limit))


def _limit(error: Callable[[float], float], smallest: float) -> float:
    """The amplitude at which the error is 1 %: bracketed by factors of 2, then bisected."""
    high = 1.0
    while error(high) <= ENOUGH:
        high *= 2
        if high > LARGEST:
            return np.inf
    low = high / 2
    while error(low) > ENOUGH:
        high, low = low, low / 2
        if low < smallest:
            return 0.0
    for _ in range(BISECTIONS):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if error(middle) <= ENOUGH else (low, middle)
    return float(low)


def _words(pair: Pair, index: int, limit: float) -> str:
    name, unit, horizon = pair.whole.names[index], pair.whole.units[index], pair.whole.horizon
    percent = f"within {ENOUGH:.0%}".replace("%", " %")
    if limit == np.inf:
        tried = f"up to {LARGEST:g} {unit}, the largest that was tried"
        return f"{name}: {percent} {tried}, for {horizon:g} s"
    words = f"{name}: {percent} up to {limit:.2g} {unit} for {horizon:g} s"
    if limit == 0.0:
        words = f"{name}: not {percent} for {horizon:g} s at any amplitude that doubles resolve"
    if pair.at.stable:
        return words
    begins = abs(float(pair.whole.start[index] - pair.rest[index]))
    fold = 1 / pair.at.growth
    words += f", because a deviation grows e-fold in {fold:.2g} s"
    if begins > 0:
        # Long enough to see when it ends: a few times what the deviation needs to grow by e.
        short = replace(
            pair, whole=pair.whole.until(LOOK * fold), small=pair.small.until(LOOK * fold)
        )
        words += f"; from {begins:.2g} {unit} for {short.lasts(index, begins):.2g} s"
    return words
