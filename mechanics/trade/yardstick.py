"""The reference that errors are measured against, and how long it means anything.

Doubles round at every operation. Where that has grown to 1 % of the motion, two right methods no
longer give the same motion, and the horizon is shortened to that time.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from mechanics.clock import timed
from mechanics.errors import InputError
from mechanics.simulate.integrators import INTEGRATORS, Outcome, Setting
from mechanics.simulate.reference import reference
from mechanics.simulate.reference_growth import LOST, growth
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice, Variant
from mechanics.trade.family import SPREAD, family
from mechanics.trade.measure import prepared
from mechanics.trade.truth import NORM, Truth, from_reference, from_states

Array = NDArray[np.float64]

DIGITS = 30
# A first look at the motion, for its scales.
LOOK = Choice(Variant(), Setting("SciPy DOP853", tolerance=1e-9))
EXACT = 1e-12
"""An error, in the stated norm, that is nothing but rounding."""
ROUNDED = 1e-9
"""Share of what is largest in the same unit, below which an entry moves by rounding alone."""


@dataclass(frozen=True, eq=False)
class Yardstick:
    """What errors were measured against.

    Attributes
    ----------
    scale : mapping of str to (float, str)
        Largest magnitude along the reference and its unit, by name: the units of the errors.
    digits : float
        Fewest correct digits of the reference, relative to the scale.
    verified_by : tuple of str
        How that is known.
    growth : str
        What becomes of small errors, in a sentence.
    growth_factor : float
        By how much an error of the start has grown at the end.
    meaningful_until : float
        Time in s until which doubles can tell the motion; may be infinite.
    seconds : float
        What the reference took.
    end : tuple of str
        The state at the end in decimals, by entry.
    norm : str
        How an error is made a number.
    """

    scale: dict[str, tuple[float, str]]
    digits: float
    verified_by: tuple[str, ...]
    growth: str
    growth_factor: float
    meaningful_until: float
    seconds: float
    end: tuple[str, ...]
    truth: Truth = field(repr=False)
    norm: str = NORM


def with_informative_start(case: Case) -> tuple[Case, tuple[str, ...]]:
    """The case, from a state beside its start where one step is exact, and a note that says so.

    No choice is told from another there, though beside this motion, a steady one or a free fall,
    the same system may oscillate fast.
    """
    truth = from_states(_look(case).states)
    moved = _moved(case, truth.scale)
    outcome = prepared(case, Choice(Variant(), Setting("C RK4", step=case.horizon)))()
    errors = replace(truth, scale=np.where(moved, truth.scale, np.inf)).errors(outcome.states)
    if len(errors) < len(case.times) or np.max(errors) > EXACT:
        return case, ()
    note = (
        "one step of order 4 is exact on the motion from the start that was given, and no choice is"
        f" told from another: what is measured starts beside it, off by up to {SPREAD:.0%} of what"
        " this motion runs through"
    )
    scale = np.where(moved, truth.scale, 1.0)
    return case.starting(family(case, scale, 1)[0]), (note,)


def _moved(case: Case, scale: Array) -> NDArray[np.bool_]:
    """Entries that move by more than rounding beside what is largest in the same unit."""
    units = np.array(case.units)
    like = np.array([np.max(scale[units == unit]) for unit in units])
    return np.asarray(scale > ROUNDED * like)


def yardstick(case: Case, digits: int = DIGITS) -> tuple[Case, Yardstick, tuple[str, ...]]:
    """The case over a time in which doubles mean something, its reference, and notes.

    Parameters
    ----------
    digits : int
        That the reference has at least.

    Raises
    ------
    InputError
        If the motion cannot be integrated at all.
    """
    case, until, notes = _comparable(case)
    found, seconds = timed(lambda: reference(case.problem(), digits))
    scale = zip(found.scale.tolist(), case.units, strict=True)
    known = found.growth.factor[: found.growth.known]
    stick = Yardstick(
        scale=dict(zip(case.names, scale, strict=True)),
        digits=float(np.min(found.digits)),
        verified_by=found.verified_by,
        growth=found.growth.words,
        growth_factor=float(np.max(known)),
        meaningful_until=until,
        seconds=seconds,
        end=found.text(len(found.times) - 1),
        truth=from_reference(found),
    )
    return case, stick, notes


def _look(case: Case) -> Outcome:
    """A first look at the motion."""
    member = next(m for m in INTEGRATORS if m.name == LOOK.setting.integrator)
    if why := member.suits(case.problem(), LOOK.setting):
        raise InputError(f"{case.equations.scene.name}: {why}")
    outcome = prepared(case, LOOK)()
    if outcome.failure:
        raise InputError(
            f"{case.equations.scene.name}: the motion cannot be integrated over"
            f" {case.horizon:g} s: {outcome.failure}: take a shorter horizon or another start"
        )
    return outcome


def _comparable(case: Case) -> tuple[Case, float, tuple[str, ...]]:
    """The case, shortened where a rounding grows to 1 % of the motion before its end."""
    outcome = _look(case)
    grown = growth(case.problem(), from_states(outcome.states).scale)
    until = grown.meaningful_until
    if not np.isfinite(until):
        return case, until, ()
    note = (
        f"{grown.words}: the reference is still accurate, but a rounding error of the start has"
        f" grown to {LOST:.0%} of it, so errors are compared until {until:g} s only,"
        f" not {case.horizon:g} s"
    )
    return case.until(until), until, (note,)
