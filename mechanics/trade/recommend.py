"""The cheapest choice that meets a target, and why.

A choice meets a target when its bound over the family of states does, with a factor of safety
(`mechanics.trade.train`). Of those that do, the one with the least time on the example is taken:
nothing else counts (`mechanics.trade.solve`).
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.trade.choice import Choice
from mechanics.trade.measure import Measurement
from mechanics.trade.solve import Solved
from mechanics.trade.train import SAFETY, Trained


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


def recommend(
    target: float,
    horizon: float,
    pick: Solved | None,
    trained: Sequence[Trained],
    doubt: float = 0.0,
) -> Recommendation:
    """The pick for a target, in words.

    Parameters
    ----------
    pick : Solved or None
        What is the cheapest.
    trained : sequence of Trained
        What else was tried.
    doubt : float
        By which the two most accurate choices differ on these states: no error is told below.
    """
    if pick is None:
        best = min((t for t in trained if t.choice.variant.careful), key=lambda t: t.bound)
        reason = (
            f"for {target:.0e} over {horizon:g} s: no choice is shown to stay below it; the"
            f" nearest is {best.choice.words}, which is expected to stay below {best.bound:.1e}"
        )
        if SAFETY * doubt > target:
            reason += (
                f"; the two most accurate choices differ by {doubt:.1e} on the states around the"
                " start, so no error below that can be shown in doubles"
            )
        return Recommendation(target, None, best.bound, None, reason)
    one, found = pick.trained, pick.measurement
    low, high = found.spread
    noise = ", which is noise of this machine" if found.noisy else ""
    reason = (
        f"for {target:.0e} over {horizon:g} s: {one.choice.words}:"
        f" {milliseconds(found.time * horizon)} ({milliseconds(low * horizon)} to"
        f" {milliseconds(high * horizon)}{noise}), error {found.error_largest:.1e} on the example,"
        f" at most {one.largest:.1e} on {len(one.errors)} states around it; with a factor of safety"
        f" of {SAFETY:g} others are expected to stay below {one.bound:.1e}"
    )
    return Recommendation(target, one.choice, one.bound, found, reason)


def milliseconds(seconds: float) -> str:
    """A time with two digits."""
    if seconds < 9.95e-4:
        return f"{seconds * 1e6:.2g} us" if seconds < 9.95e-5 else f"{seconds * 1e3:.2f} ms"
    return f"{seconds * 1e3:.3g} ms" if seconds < 0.9995 else f"{seconds:.2f} s"
