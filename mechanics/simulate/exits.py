"""Where a motion leaves the domain of its model, or comes back to it.

margin(t*) = 0    on the dense output of the integrator's step

As in SciPy's `solve_ivp` a change of sign over a step is followed by Brent's method on the step's
interpolant. Two changes in one step show no change of sign at its ends: a margin is therefore
looked at inside of the step too, and where it passes through a valley the bottom is looked for.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, minimize_scalar

from mechanics.errors import InputError
from mechanics.scene.conditions import Condition
from mechanics.simulate.domain import Domain
from mechanics.simulate.march import Stretch
from mechanics.simulate.trajectory import Crossing, Ending

Array = NDArray[np.float64]
Margin = Callable[[float], float]

# Looks into each step: its interpolant is a polynomial of degree seven or less.
LOOKS = 9


def watched(
    domain: Domain, start: float, stretches: Iterator[Stretch], beyond: bool
) -> Iterator[Stretch]:
    """The same stretches, with the crossings in each; the last one ends where the model does.

    Parameters
    ----------
    start : float
        Time at which the first stretch begins, in s.
    beyond : bool
        Whether to go on outside of the domain.
    """
    for stretch in stretches:
        found = crossings(domain, stretch.state, start, stretch.end)
        left = next((one for one in found if one.leaving), None)
        if left is not None and not beyond:
            yield replace(stretch, end=left.time, ending=Ending.LEFT_DOMAIN, crossings=(left,))
            return
        yield replace(stretch, crossings=found)
        start = stretch.end


def crossings(
    domain: Domain, state: Callable[[float], Array], begin: float, end: float
) -> tuple[Crossing, ...]:
    """Crossings of the edge within a step, in the order of time."""
    if not domain.conditions or end <= begin:
        return ()
    found: list[Crossing] = []
    for i, condition in enumerate(domain.conditions):
        margin = _margin(domain, state, i)
        for time, leaving in _changes(margin, begin, end, condition.strict):
            found.append(Crossing(condition.name, time, leaving, _sentence(condition, leaving)))
    return tuple(sorted(found, key=lambda one: one.time))


def _margin(domain: Domain, state: Callable[[float], Array], i: int) -> Margin:
    return lambda t: float(domain.margins(t, state(t))[i])


def _sentence(condition: Condition, leaving: bool) -> str:
    if leaving:
        return f"it {condition.otherwise} ({condition.text} no longer holds)"
    return f"{condition.text} holds again"


def _changes(
    margin: Margin, begin: float, end: float, strict: bool
) -> Iterator[tuple[float, bool]]:
    """(time, whether it leaves) for each change between inside and outside."""
    times = _looks(margin, begin, end)
    values = [margin(t) for t in times]
    inside = [value > 0 or (value == 0 and not strict) for value in values]
    for (a, b), (x, y), (was, now) in zip(
        pairwise(times), pairwise(values), pairwise(inside), strict=True
    ):
        if was != now:
            yield (_root(margin, a, b) if x * y < 0 else (a if x == 0 else b)), was


def _root(margin: Margin, a: float, b: float) -> float:
    return float(brentq(margin, a, b, xtol=4 * np.finfo(float).tiny, rtol=4 * np.finfo(float).eps))


def _looks(margin: Margin, begin: float, end: float) -> Sequence[float]:
    """Times at which a margin is looked at: equal distances, and the bottom of each valley."""
    times = np.linspace(begin, end, LOOKS).tolist()
    values = [margin(t) for t in times]
    bottoms = [
        float(minimize_scalar(margin, bounds=(times[k - 1], times[k + 1]), method="bounded").x)
        for k in range(1, LOOKS - 1)
        if 0 < values[k] <= min(values[k - 1], values[k + 1])
    ]
    return sorted({*times, *bottoms})


def at_the_start(name: str, domain: Domain, state: Array, beyond: bool) -> tuple[Crossing, ...]:
    """Conditions that do not hold at t = 0 already, as crossings there.

    Parameters
    ----------
    name : str
        Of the scene.
    state : array
        At the start.
    beyond : bool
        Whether to go on outside of the domain.

    Raises
    ------
    InputError
        If there are any, and going on was not asked for.
    """
    broken = domain.broken(domain.margins(0.0, state))
    outside = tuple(
        Crossing(one.name, 0.0, True, f"it {one.otherwise} ({one.text} does not hold)")
        for one, out in zip(domain.conditions, broken, strict=True)
        if out
    )
    if outside and not beyond:
        raise InputError(
            f"{name}: the motion starts outside of the domain of the model:"
            f" {'; '.join(one.sentence for one in outside)}: start from other values, or ask to go"
            " on beyond the domain"
        )
    return outside
