"""The only place that reads a clock.

What it says is shown to people, or is what was asked for: how fast something is. Verdicts, repairs,
forms and the text of code depend on nothing that is measured here.
"""

from collections.abc import Callable, Sequence
from time import perf_counter
from typing import Any, TypeVar

T = TypeVar("T")


class Stopwatch:
    """Runs from when it is made."""

    def __init__(self) -> None:
        self._begin = perf_counter()

    @property
    def seconds(self) -> float:
        """How long it has run."""
        return perf_counter() - self._begin


def timed(work: Callable[[], T]) -> tuple[T, float]:
    """What the work gives, and the seconds that it took."""
    watch = Stopwatch()
    found = work()
    return found, watch.seconds


def side_by_side(
    runs: Sequence[Callable[[], Any]], budget: float, rounds: tuple[int, int]
) -> list[tuple[float, ...]]:
    """Seconds of every run, in rounds over all of them: what disturbs the machine disturbs all.

    Parameters
    ----------
    runs : sequence of callable
        Warm.
    budget : float
        Seconds that all of it may take, beyond the fewest rounds.
    rounds : (int, int)
        Fewest and most.
    """
    found: list[list[float]] = [[] for _ in runs]
    watch = Stopwatch()
    for done in range(rounds[1]):
        if done >= rounds[0] and watch.seconds * (done + 1) / done > budget:
            break
        for run, seconds in zip(runs, found, strict=True):
            seconds.append(timed(run)[1])
    return [tuple(seconds) for seconds in found]
