"""How long the internal steps of co-simulation may be: measured on the unit's own motion.

    e(h) = |x_h(t + h) - x_(h/2)(t + h)|    grows as h^(p + 1), p the order of the method

One long step is compared with two short ones along the motion from the start values. Where they
differ by more than is allowed, the step is shortened by the power law, and the motion begun anew. A
small error that then falls by less than the law says is not the step's: it is the rounding of the
model near a singular configuration, and shorter steps would not help.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.step import Tableau
from mechanics.errors import InputError

Array = NDArray[np.float64]
Rates = Callable[[Array], Array]
"""x' from all that is given: time, states, and so on."""

# The error that a step may make, relative to 1 + |x|: what mechanics.simulate allows its steps.
ALLOWED = 1e-10
# A bit less than the law says, so that the next try succeeds.
SAFETY = 0.8
# What an error has to be divided by at least when the step is halved, and above which, in units of
# what is allowed, it is no rounding.
FALLING, CLEARLY = 2.0, 1e4
LONGEST_SHARE, SHORTEST_SHARE = 1e-2, 1e-6
# Steps along which errors are looked at: a second of computation.
LOOKED_AT = 10_000


def step_size(rates: Rates, start: Array, states: int, tableau: Tableau, duration: float) -> float:
    """The longest step whose error stays within what is allowed, in s, rounded to two digits.

    Parameters
    ----------
    rates : callable
    start : array
        All that is given, at the start.
    states : int
        Number of states, which stand behind time.
    duration : float
        In s; the motion is followed so long, or as long as it is regular.

    Raises
    ------
    InputError
        When millions of steps would be needed.
    """
    # A step that is too long may overflow, and is made shorter then.
    with np.errstate(all="ignore"):
        return _rounded_down(_accurate(rates, start, states, tableau, duration))


def _accurate(rates: Rates, start: Array, states: int, tableau: Tableau, duration: float) -> float:
    h, before = LONGEST_SHARE * duration, np.inf
    while (worst := _worst(rates, start, states, tableau, h, duration)) > 1:
        if before / FALLING < worst < CLEARLY:
            return h
        h *= min(0.5, SAFETY * worst ** (-1 / (tableau.order + 1)))
        before = worst
        if h < SHORTEST_SHARE * duration:
            raise InputError(
                f"internal steps of {h:.1e} s are needed, and {duration:g} s are simulated: the"
                " motion is too stiff for equal explicit steps: give step=..., or use model"
                " exchange with an implicit integrator"
            )
    return h


def _worst(
    rates: Rates, start: Array, states: int, tableau: Tableau, h: float, duration: float
) -> float:
    """Largest error along the motion, in units of what is allowed; stops where it is too large."""
    given, worst = start.copy(), 0.0
    for _ in range(min(LOOKED_AT, round(duration / h))):
        long = _stepped(rates, given, states, tableau, h)
        half = _stepped(rates, given, states, tableau, h / 2)
        given = _stepped(rates, half, states, tableau, h / 2)
        error = np.abs(long - given)[1 : states + 1] / (1 + np.abs(given[1 : states + 1]))
        if not np.all(np.isfinite(error)):
            # At the start this is the step's fault; later on the motion itself may end.
            return worst or np.inf
        worst = max(worst, float(error.max()) / ALLOWED)
        if worst > CLEARLY:
            break
    return worst


def _stepped(rates: Rates, given: Array, states: int, tableau: Tableau, h: float) -> Array:
    slopes = np.zeros((len(tableau.b), states))
    x, tried = given[1 : states + 1], given.copy()
    for i, row in enumerate(tableau.a):
        weights = np.array([float(a) for a in row])
        tried[0] = given[0] + h * float(weights.sum())
        tried[1 : states + 1] = x + h * (weights @ slopes[:i])
        slopes[i] = rates(tried)
    tried[0] = given[0] + h
    tried[1 : states + 1] = x + h * (np.array([float(b) for b in tableau.b]) @ slopes)
    return tried


def _rounded_down(h: float) -> float:
    """To one of 1, 2, 5 times a power of ten: steps that people know."""
    power = int(np.floor(np.log10(h)))
    steps = (float(f"{digit}e{power + more}") for more in (-1, 0) for digit in (1, 2, 5))
    return max(step for step in steps if step <= h)
