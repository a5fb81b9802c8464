"""Settings that just meet a target: tolerances and steps are solved for, then confirmed.

    log bound(amount) ~ a + s log amount        between two amounts, and beyond them

`bound` is `mechanics.trade.train.Trained.bound`, with its factor of safety. Each line, a method
with an arithmetic and a variant, has bounds from a ladder of decades; regula falsi finds the amount
whose bound is the target on a few states. The cheapest of the lines is confirmed on all states,
where its amount is corrected by the same slope; if it costs more then than another one, that one is
tried, until the cheapest is a confirmed one.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.family import Family
from mechanics.trade.measure import Measurement, times_side_by_side
from mechanics.trade.survey import NEAR, Survey
from mechanics.trade.train import Trained, train
from mechanics.trade.truth import Truth

Price = Callable[[Choice], float]
CLOSE = 1.3
"""A bound is solved for when the target is at most so many times as large."""
ROUNDS, CORRECTIONS = 8, 5
STEEPEST, FLATTEST, SLOPE = 12.0, 0.25, 1.0
"""Slopes that are believed, and the one that is taken where none is known."""
COMPARING = 1.5
"""Seconds to compare the settings of a target."""


@dataclass(frozen=True, eq=False)
class Solved:
    """A setting that meets a target: on all states of the family where it is confirmed.

    Attributes
    ----------
    slope : float
        By which the logarithm of the bound grows with that of the amount.
    """

    trained: Trained
    measurement: Measurement
    slope: float


def lines(trained: Iterable[Trained]) -> list[list[Trained]]:
    """Those of one method, arithmetic and variant, the coarsest first."""
    groups: dict[Choice, list[Trained]] = {}
    for one in trained:
        if one.choice.variant.careful:
            groups.setdefault(one.choice.with_amount(1.0), []).append(one)
    return [sorted(group, key=lambda t: -t.choice.amount) for group in groups.values()]


def cheapest_that_meets(
    case: Case, truth: Truth, found: Survey, trained: Sequence[Trained], around: Family,
    target: float, few: int, price: Price | None = None,
) -> Solved | None:  # fmt: skip
    """The least price among settings whose bound over all states is within the target.

    Parameters
    ----------
    truth : Truth
        Of the example.
    found : Survey
        What is measured is added to it.
    trained : sequence of Trained
        The ladders, on the first `few` states.
    price : callable, optional
        Of a choice, infinite for one that is not wanted; by default the time on the example.
    """
    wanted = [t for t in trained if price is None or price(t.choice) < np.inf]
    solved = [_solved(case, line, around, target, few) for line in lines(wanted)]

    def worth(one: Solved) -> float:
        return one.measurement.time if price is None else price(one.trained.choice)

    near = NEAR if price is None else np.inf
    left = _timed(case, truth, found, [s for s in solved if s is not None], near)

    while left:
        best = min(left, key=worth)
        if len(best.trained.errors) == len(around.starts):
            return best
        left.remove(best)
        sure = _confirmed(case, best, around, target)
        if sure is not None:
            left += _timed(case, truth, found, [sure], near)
    return None


def _solved(
    case: Case, line: Sequence[Trained], around: Family, target: float, few: int
) -> tuple[Trained, float] | None:
    """The coarsest setting of a line that meets the target on a few states, and the slope there."""
    able = [t for t in line if t.bound <= target]
    if not able:
        return None
    fine = able[0]
    coarse = next((t for t in reversed(line) if t.choice.amount > fine.choice.amount), None)
    slope = SLOPE if coarse is None else _slope(fine, coarse)
    for _ in range(ROUNDS):
        if fine.bound * CLOSE >= target:
            break
        amount = fine.choice.amount * (target / np.sqrt(CLOSE) / fine.bound) ** (1 / slope)
        if coarse is not None:
            amount = min(amount, np.sqrt(fine.choice.amount * coarse.choice.amount) * 1.5)
        choice = _with(case, fine.choice, amount)
        if choice.amount in (fine.choice.amount, coarse and coarse.choice.amount):
            break
        (one,) = train(case, [choice], around, few)
        if one.bound <= target:
            slope, fine = _slope(fine, one), one
        else:
            slope, coarse = _slope(fine, one), one
    return fine, slope


def _confirmed(
    case: Case, solved: Solved, around: Family, target: float
) -> tuple[Trained, float] | None:
    """The same line on all states, its amount corrected until the bound is close to the target."""
    choice, slope, best = solved.trained.choice, solved.slope, None
    for _ in range(CORRECTIONS):
        (one,) = train(case, [choice], around, len(around.starts))
        if one.bound <= target:
            best = one
            if one.bound * CLOSE >= target:
                break
        factor = (target / np.sqrt(CLOSE) / one.bound) ** (1 / slope)
        nearby = float(np.clip(factor, 0.1, 10.0)) if np.isfinite(factor) and factor > 0 else 0.1
        other = _with(case, one.choice, one.choice.amount * nearby)
        if best is not None and other.amount <= best.choice.amount:
            break
        choice = other
    return None if best is None else (best, slope)


def _slope(fine: Trained, coarse: Trained) -> float:
    rise = np.log(coarse.bound / fine.bound) if np.isfinite(coarse.bound) else np.inf
    run = np.log(coarse.choice.amount / fine.choice.amount)
    return float(np.clip(rise / run, FLATTEST, STEEPEST)) if run else SLOPE


def _with(case: Case, choice: Choice, amount: float) -> Choice:
    """The choice with another amount; a step is at most the whole motion."""
    step = choice.setting.tolerance is None
    return choice.with_amount(min(float(amount), case.horizon) if step else float(amount))


def _timed(
    case: Case, truth: Truth, found: Survey, solved: Sequence[tuple[Trained, float]], near: float
) -> list[Solved]:
    """Measured side by side on the example; what is many times slower is dropped."""
    able = [(t, s) for t, s in solved if found.add(case, t.choice, truth) is not None]
    if not able:
        return []
    least = min(found.of(t.choice).time for t, _ in able)
    able = [(t, s) for t, s in able if found.of(t.choice).time <= near * least]
    runs = [found.runs[t.choice] for t, _ in able]
    for (one, _), seconds in zip(
        able, times_side_by_side(runs, case.horizon, COMPARING), strict=True
    ):
        found.replace(replace(found.of(one.choice), seconds=seconds))
    return [Solved(t, found.of(t.choice), s) for t, s in able]
