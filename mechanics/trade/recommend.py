"""The cheapest choice that meets a target, and why.

A choice meets a target when the bound over the family of states does (`mechanics.trade.train`). Of
those that do, the cheapest is taken; of those that cost the same within the spread of the times, an
adaptive method, then the plain model. Nothing in a method with a fixed step notices a state that is
harder than those it was tuned on, so it is taken only where adaptive ones cost twice as much.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.family import Family
from mechanics.trade.measure import Measurement
from mechanics.trade.train import CONFIDENCE, COVERAGE, Trained, train

WORTH = 2.0
"""How much more an adaptive method may cost than one with a fixed step."""


@dataclass(frozen=True, eq=False)
class Recommendation:
    """What to take for a target.

    Attributes
    ----------
    target : float
        Largest error along the way, in the stated norm.
    choice : Choice or None
        None where no choice was shown to meet it.
    bound : float
        What the error is expected to stay below over the family of states; without a choice, the
        smallest bound that there is.
    measurement : Measurement or None
        Of the choice, on the motion from the example.
    reason : str
        In a sentence.
    """

    target: float
    choice: Choice | None
    bound: float
    measurement: Measurement | None
    reason: str


def pareto(measurements: Sequence[Measurement], alike: float = 0.0) -> tuple[int, ...]:
    """Places of those that no other beats in both time and error, by rising time.

    Parameters
    ----------
    measurements : sequence of Measurement
    alike : float
        Share of an error by which a slower one has to be below it, to be more than the same.
    """
    order = sorted(range(len(measurements)), key=lambda i: measurements[i].time)
    best, front = float("inf"), []
    for i in order:
        if measurements[i].error_largest < best * (1 - alike):
            best = measurements[i].error_largest
            front.append(i)
    return tuple(front)


def recommend(
    case: Case,
    target: float,
    measurements: Sequence[Measurement],
    tried: dict[Choice, Trained],
    around: Family,
) -> Recommendation:
    """The pick for a target.

    Parameters
    ----------
    case : Case
    target : float
    measurements : sequence of Measurement
    tried : dict of Choice to Trained
        On a few states of the family. A pick is confirmed on all of them, which is written down
        here; if it does not meet the target there, the next one is.
    around : Family
    """
    of = {m.choice: m for m in measurements}
    able = [choice for choice in tried if choice.variant.careful]
    while meeting := [tried[c] for c in able if tried[c].bound <= target]:
        pick = _picked(meeting, of)
        if len(pick.errors) == len(around.starts):
            refused = _refused([tried[c] for c in able], of, target, of[pick.choice])
            reason = _reason(target, case.horizon, pick, of[pick.choice], refused)
            return Recommendation(target, pick.choice, pick.bound, of[pick.choice], reason)
        (tried[pick.choice],) = train(case, [pick.choice], around, len(around.starts))
    best = min((tried[c] for c in able), key=lambda t: t.bound)
    reason = (
        f"for {target:.0e} over {case.horizon:g} s: no choice is shown to stay below it; the"
        f" nearest is {best.choice.words}, which is expected to stay below {best.bound:.1e}"
    )
    return Recommendation(target, None, best.bound, None, reason)


def _picked(meeting: Sequence[Trained], of: dict[Choice, Measurement]) -> Trained:
    def time(t: Trained) -> float:
        return of[t.choice].time

    cheapest = min(meeting, key=time)
    adaptive = [t for t in meeting if t.choice.setting.tolerance is not None]
    if cheapest.choice.setting.tolerance is None and adaptive:
        other = min(adaptive, key=time)
        if time(other) <= WORTH * time(cheapest):
            cheapest = other
    limit = of[cheapest.choice].spread[1]
    alike = [t for t in meeting if time(t) <= limit or t is cheapest]
    return min(alike, key=lambda t: (*_complexity(t.choice), time(t)))


def _complexity(choice: Choice) -> tuple[bool, bool]:
    return choice.setting.tolerance is None, not choice.variant.plain


def _refused(
    able: Sequence[Trained], of: dict[Choice, Measurement], target: float, pick: Measurement
) -> str:
    """Why what is cheaper was not taken."""
    cheaper = [t for t in able if of[t.choice].time < pick.time and t.bound > target]
    if not cheaper:
        return ""
    near = min(cheaper, key=lambda t: t.bound)
    return f"; {near.choice.words} is cheaper, but was only shown to stay below {near.bound:.1e}"


def _reason(target: float, horizon: float, pick: Trained, found: Measurement, refused: str) -> str:
    low, high = found.spread
    return (
        f"for {target:.0e} over {horizon:g} s: {pick.choice.words}:"
        f" {milliseconds(found.time * horizon)} ({milliseconds(low * horizon)} to"
        f" {milliseconds(high * horizon)}), error {found.error_largest:.1e} on the example,"
        f" at most {pick.largest:.1e} on {len(pick.errors)} states around it; {COVERAGE:.1%} of"
        f" these are expected to stay below {pick.bound:.1e} (confidence {CONFIDENCE:.0%}){refused}"
    )


def milliseconds(seconds: float) -> str:
    """A time with two digits."""
    if seconds < 9.95e-4:
        return f"{seconds * 1e6:.2g} us" if seconds < 9.95e-5 else f"{seconds * 1e3:.2f} ms"
    return f"{seconds * 1e3:.3g} ms" if seconds < 0.9995 else f"{seconds:.2f} s"
