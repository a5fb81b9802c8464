"""Why a figure is what it is, told from the true value, the computed one, and what happened inside.

An equation whose rows hold to a few roundings has a solution off by at most

    |x^ - x| <= eta epsilon |K^-1| (|K| |x^| + |k|),        eta the backward error

so an error beyond the tolerance with a small backward error is the condition of the equations.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.programs.trace import Events
from mechanics.extremes.cause import Cause
from mechanics.extremes.measure import Errors
from mechanics.extremes.result import PRECISIONS, STABLE, tolerance
from mechanics.extremes.truth import Enclosed


@dataclass(frozen=True, eq=False)
class Case:
    """One point in one form and precision.

    Attributes
    ----------
    given : bool
        Whether every value of the point is zero or a normal number of the precision.
    values : array (n,)
        As computed.
    events : Events
        Of all points of the walk.
    index : int
        Of this point among them.
    """

    found: Enclosed
    given: bool
    values: NDArray[np.float64]
    errors: Errors
    events: Events
    index: int


def cause(case: Case, precision: str) -> Cause:
    """What broke, ACCURATE if nothing did."""
    if case.found.solution is None:
        return Cause.SINGULAR
    if not case.given:
        return Cause.INPUT
    underflow = bool(case.events.underflow[case.index] >= 0)
    if not np.isfinite(case.values).all():
        return _no_number(case, precision, underflow)
    stable = case.errors.backward <= STABLE
    if stable and case.errors.relative <= tolerance(precision):
        return Cause.ACCURATE
    if case.events.broken[case.index] >= 0:
        return Cause.OVERFLOW
    if stable:
        return Cause.CONDITION
    return Cause.UNDERFLOW if underflow else Cause.CANCELLATION


def _no_number(case: Case, precision: str, underflow: bool) -> Cause:
    largest = float(np.finfo(PRECISIONS[precision]).max)
    if any(abs(x) > largest for x in case.found.solution or ()):
        return Cause.RANGE
    if case.events.by_zero[case.index]:
        # A pivot is zero that should not be: its digits were lost in a product or in a difference.
        return Cause.UNDERFLOW if underflow else Cause.CANCELLATION
    return Cause.OVERFLOW
