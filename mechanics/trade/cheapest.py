"""The cheapest choice that is measured to meet an accuracy, on the very motion that is asked for.

for each integrator: settings from coarse to fine, until error < SHARE accuracy
of those the fastest, timed side by side
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from mechanics.errors import InputError
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Setting
from mechanics.simulate.march import METHODS, PATIENCE
from mechanics.trade.case import TIMES, Case
from mechanics.trade.choice import Choice, Variant
from mechanics.trade.measure import Measurement, prepared, times_side_by_side
from mechanics.trade.survey import LONGEST, Survey, ladder
from mechanics.trade.truth import Truth, at_rows, from_states
from mechanics.trade.yardstick import yardstick

# The measured error has to be below this share of the accuracy: the estimate, by another setting,
# scatters about it.
SHARE = 0.5
# An integrator is given up when it takes so many times what the best one so far needs.
WORSE = 3.0
# Seconds to compare the candidates.
COMPARING = 1.0
# Digits of the reference behind those of the accuracy.
MORE = 6
# What errors are measured against where inputs are functions.
FINEST = Choice(Variant(), Setting("SciPy DOP853", tolerance=1e-13))


def cheapest(case: Case, accuracy: float, members: Sequence[Integrator] = INTEGRATORS) -> Choice:
    """The fastest choice whose measured error is within the accuracy.

    In a scene with constraints or conditions only methods are used whose steps are watched, and put
    back onto the constraints, and which lose nothing by that.

    Raises
    ------
    InputError
        If doubles cannot tell the motion that long, or no choice meets the accuracy.
    """
    truth = _truth(case, accuracy)
    if guarded(case):
        one_step = set(METHODS) - set(PATIENCE)
        members = [m for m in members if m.name.removeprefix("SciPy ") in one_step]
    found = Survey()
    # The fast ones come last in the list; they end the search among the others early.
    meeting: list[Measurement] = []
    for member in reversed(members):
        if not member.available():
            meeting += _first(case, truth, found, member, accuracy, meeting)
    if not meeting:
        nearest = min(found.measurements, key=lambda m: m.error_largest)
        raise InputError(
            f"accuracy {accuracy:g}: no choice meets it; the best is {nearest.choice.words} with"
            f" an error of {nearest.error_largest:.1e}: ask for less, or for a shorter duration"
        )
    runs = [found.runs[m.choice] for m in meeting]
    times = times_side_by_side(runs, case.horizon, COMPARING)
    timed = [replace(m, seconds=s) for m, s in zip(meeting, times, strict=True)]
    return min(timed, key=lambda m: m.time).choice


def _truth(case: Case, accuracy: float) -> Truth:
    if any(callable(value) for value in case.inputs.values()):
        # Of functions only doubles are known, so that the finest run has to do.
        return from_states(prepared(case, FINEST)().states)
    # The reference is made at some of the samples only.
    last = len(case.times) - 1
    rows = np.unique(np.linspace(0, last, min(TIMES, last + 1)).astype(int))
    some = replace(case, grid=tuple(case.times[rows].tolist()))
    shorter, stick, notes = yardstick(some, int(np.ceil(-np.log10(accuracy))) + MORE)
    if shorter.horizon < case.horizon:
        raise InputError(f"accuracy {accuracy:g}: {notes[0]}: take a shorter duration")
    return at_rows(stick.truth, rows)


def guarded(case: Case) -> bool:
    """Whether steps have to be watched as they are taken."""
    scene = case.equations.scene
    return bool(scene.constraints or scene.conditions)


def _first(
    case: Case,
    truth: Truth,
    found: Survey,
    member: Integrator,
    accuracy: float,
    meeting: Sequence[Measurement],
) -> list[Measurement]:
    """The coarsest setting of an integrator that meets the accuracy, unless others are faster."""
    best = min((m.time for m in meeting), default=np.inf)
    for choice in ladder(case, truth, member):
        one = found.add(case, choice, truth)
        if one is None:
            continue
        if one.error_largest <= SHARE * accuracy:
            return [one]
        if one.time > WORSE * best or one.time * case.horizon > 4 * LONGEST:
            return []
    return []
