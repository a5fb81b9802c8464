"""Which choices are measured: integrators over tolerances or steps, then one axis at a time.

    tolerances 1e-3, 1e-4, ...        steps tau, tau/sqrt 2, ...,  tau = min_i scale_i / |y_i'|

A ladder ends where errors stop falling or a run takes too long: rounding has been reached, or
nobody would choose it.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.graphs import form_names
from mechanics.compiled.machine.evaluator import FLAGS
from mechanics.errors import MechanicsError
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Outcome, Setting
from mechanics.simulate.integrators.loop import plan
from mechanics.simulate.integrators.rate import Rate
from mechanics.trade.case import Case
from mechanics.trade.choice import LINEARIZED, Choice, Variant
from mechanics.trade.measure import (
    Measurement,
    measured,
    prepared,
    times_side_by_side,
    unsuited,
)
from mechanics.trade.truth import Truth

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

TOLERANCES = tuple(10.0**-k for k in range(3, 16))
HALVINGS = range(-2, 26)
# A run that takes longer, in s, is the last one of its ladder.
LONGEST = 0.25
# Rungs without halving the best error after which a ladder ends, once the error is a small one: a
# large tolerance may be met by luck.
PATIENCE, SMALL = 3, 1e-2
# Tolerances that are finer than single precision are not asked of it.
SINGLE = 1e-7
# Seconds for the comparison of variants, and for the times of everything.
COMPARING, TIMING = 3.0, 12.0
# Errors within this factor are alike: roundings differ, and with them steps.
ALIKE = 2.0
# Choices that cost up to so many times what the front costs at their error are trained.
NEAR = 2.5


@dataclass(frozen=True, eq=False)
class Survey:
    """What was measured, with the runs to be timed again.

    Attributes
    ----------
    runs : dict of Choice to callable
    states : dict of Choice to array
        Of every choice at the case's times.
    left_out : dict of str to str
        Why an integrator or variant was not measured.
    """

    measurements: list[Measurement] = field(default_factory=list)
    runs: dict[Choice, Callable[[], Outcome]] = field(default_factory=dict, repr=False)
    states: dict[Choice, Array] = field(default_factory=dict, repr=False)
    left_out: dict[str, str] = field(default_factory=dict)

    def of(self, choice: Choice) -> Measurement:
        """The measurement of a choice."""
        return next(m for m in self.measurements if m.choice == choice)

    def replace(self, measurement: Measurement) -> None:
        """Put a measurement in place of the one of the same choice."""
        at = self.measurements.index(self.of(measurement.choice))
        self.measurements[at] = measurement

    def add(self, case: Case, choice: Choice, truth: Truth) -> Measurement | None:
        """Measure a choice, unless it is unsuited, which is written down."""
        if choice in self.runs:
            return self.of(choice)
        why = unsuited(case, choice)
        if why:
            if not any(_short(c) == _short(choice) for c in self.runs):
                self.left_out[_short(choice)] = why
            return None
        try:
            run = prepared(case, choice)
        except MechanicsError as error:
            self.left_out[_short(choice)] = str(error)
            return None
        found, states = measured(case, choice, truth, run)
        if found.time * case.horizon < LONGEST and not found.failure:
            # The first run may have compiled or allocated.
            found, states = measured(case, choice, truth, run)
        self.left_out.pop(_short(choice), None)
        self.measurements.append(found)
        self.runs[choice], self.states[choice] = run, states
        return found


def survey(
    case: Case,
    truth: Truth,
    members: tuple[Integrator, ...] = INTEGRATORS,
    progress: Progress | None = None,
) -> Survey:
    """Every integrator over its ladder, with the plain model in double precision."""
    found = Survey()
    for i, member in enumerate(members):
        if progress is not None:
            progress(member.name, i / len(members))
        why = member.available()
        if why:
            found.left_out[member.name] = why
            continue
        climb(case, truth, found, ladder(case, truth, member))
    return found


def climb(case: Case, truth: Truth, found: Survey, choices: Iterator[Choice]) -> None:
    """Measure a ladder from its coarse end until it stops being worth it."""
    best, stuck = np.inf, 0
    for choice in choices:
        one = found.add(case, choice, truth)
        if one is None:
            continue
        better = one.error_largest < best / 2
        best = min(best, one.error_largest)
        stuck = 0 if better or best > SMALL else stuck + 1
        if stuck >= PATIENCE or one.time * case.horizon > LONGEST:
            return


def ladder(
    case: Case, truth: Truth, member: Integrator, arithmetic: str = "double"
) -> Iterator[Choice]:
    """Settings of an integrator, coarse ones first."""
    for amount in TOLERANCES if member.adaptive else steps(case, truth):
        if arithmetic == "single" and member.adaptive and amount < SINGLE:
            return
        setting = Setting(
            member.name,
            tolerance=amount if member.adaptive else None,
            step=None if member.adaptive else amount,
            arithmetic=arithmetic,
        )
        yield Choice(Variant(), setting)


def steps(case: Case, truth: Truth) -> tuple[float, ...]:
    """Steps from twice the shortest time in which an entry runs through its scale, downwards."""
    rate = Rate(case.problem())
    slope = np.abs(rate(0.0, case.start))
    size = len(case.equations.scene.q)
    # The speeds tell how fast coordinates run through their scale, over the whole motion.
    slope[:size] = np.maximum(slope[:size], truth.scale[size:].max() * (slope[:size] > 0))
    moving = slope > 0
    tau = float(np.min(truth.scale[moving] / slope[moving])) if moving.any() else case.horizon
    lengths = (min(tau * 2.0 ** (-k / 2), case.horizon) for k in HALVINGS)
    if not case.through:
        # As they are taken: several end at the same sample in equally many steps.
        lengths = (length for h in lengths for _, length in plan(case.times[:2], h))
    return tuple(dict.fromkeys(lengths))


def vary(case: Case, truth: Truth, found: Survey, base: Choice) -> Variant:
    """One axis at a time around the best: arithmetic, form, compiler settings, model.

    Returns
    -------
    Variant
        The fastest one that loses no more than the plain one; the plain one where none is faster
        by more than what the times scatter.
    """
    member = next(m for m in INTEGRATORS if m.name == base.setting.integrator)
    climb(case, truth, found, ladder(case, truth, member, "single"))
    tried = [base.with_variant(v) for v in variants(case)]
    tried = [base, *(c for c in tried if found.add(case, c, truth) is not None)]
    times = times_side_by_side([found.runs[c] for c in tried], case.horizon, COMPARING)
    for choice, seconds in zip(tried, times, strict=True):
        found.replace(replace(found.of(choice), seconds=seconds))
    plain = found.of(base)
    able = [found.of(c) for c in tried if c.variant.careful]
    able = [m for m in able if m.error_largest <= ALIKE * plain.error_largest]
    fastest = min(able, key=lambda m: m.time)
    return fastest.choice.variant if fastest.spread[1] < plain.spread[0] else Variant()


def variants(case: Case) -> list[Variant]:
    """Variants that differ from the plain one in one respect."""
    plain = Variant()
    names = form_names(case.equations)
    forms = [replace(plain, form=name) for name in names if name != case.model().form]
    settings = [replace(plain, flags=f) for f in FLAGS[1:] if case.model().compiler is not None]
    return [*forms, *settings, replace(plain, model=LINEARIZED)]


def best_for(measurements: Sequence[Measurement], target: float) -> Choice:
    """The fastest plain choice that meets a target on the example; the most accurate if none."""
    plain = [m for m in measurements if m.choice.variant.plain]
    meeting = [m for m in plain if m.error_largest <= target]
    if meeting:
        return min(meeting, key=lambda m: m.time).choice
    return min(plain, key=lambda m: m.error_largest).choice


def finest(measurements: Sequence[Measurement]) -> tuple[Measurement, Measurement]:
    """The most accurate plain choice, and the most accurate one by another integrator."""
    plain = [m for m in measurements if m.choice.variant.plain]
    order = sorted(plain, key=lambda m: m.error_largest)
    name = order[0].choice.setting.integrator
    other = next((m for m in order if m.choice.setting.integrator != name), order[-1])
    return order[0], other


def near_front(
    measurements: Sequence[Measurement], price: Callable[[Measurement], float] = lambda m: m.time
) -> list[Choice]:
    """Choices that cost at most `NEAR` times the cheapest that is as accurate.

    Parameters
    ----------
    price : callable
        Infinite for what is not wanted.
    """
    usable = [m for m in measurements if m.choice.variant.careful and not m.failure]
    rows = [(m, price(m)) for m in usable if price(m) < np.inf]
    least = [min(cost for f, cost in rows if f.error_largest <= m.error_largest) for m, _ in rows]
    return [m.choice for (m, cost), best in zip(rows, least, strict=True) if cost <= NEAR * best]


def timed(case: Case, found: Survey, near: Sequence[Choice]) -> tuple[Measurement, ...]:
    """All measurements with times side by side, those near the front in more rounds.

    Runs that failed, or were too long to be taken, are not repeated.
    """
    others = [m.choice for m in found.measurements if m.choice not in near]
    others = [c for c in others if found.of(c).time * case.horizon < LONGEST]
    others = [c for c in others if not found.of(c).failure]
    for group, rounds in ((list(dict.fromkeys(near)), (7, 31)), (others, (3, 5))):
        runs = [found.runs[choice] for choice in group]
        times = times_side_by_side(runs, case.horizon, TIMING / 2, rounds)
        for choice, seconds in zip(group, times, strict=True):
            found.replace(replace(found.of(choice), seconds=seconds))
    return tuple(found.measurements)


def _short(choice: Choice) -> str:
    words = choice.variant.words
    return f"{choice.setting.integrator}{', ' if words else ''}{words}"
