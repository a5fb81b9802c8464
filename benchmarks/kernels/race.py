"""Kernels timed in turn, in one process, after each has been shown to compute the same.

    ns a state = median over the rounds of (time of some passes / (passes * states))

A kernel that gives other accelerations is an error, not a row of the table.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter

import numpy as np

from benchmarks.kernels.case import Array, Case

SHORTEST = 2e-3
"""Seconds that one measurement takes at least."""
AGREEMENT = 1e-9
"""Largest difference, relative to the largest acceleration; peers round in other orders."""


@dataclass(frozen=True, eq=False)
class Lap:
    """One pass of a kernel over the states of a case.

    Attributes
    ----------
    run : callable
    states : int
        How many states one run evaluates.
    result : callable
        Accelerations (links + 1, states) of the last run.
    together : int
        How many passes one run makes.
    """

    run: Callable[[], None]
    states: int
    result: Callable[[], Array]
    together: int = 1


@dataclass(frozen=True)
class Contender:
    """A kernel in the race.

    Attributes
    ----------
    name : str
    absent : callable
        Why it cannot run here; empty if it can.
    prepare : callable
        From a case to a lap.
    agreement : float
        How far its accelerations may be from the others', relative to the largest.
    """

    name: str
    absent: Callable[[], str]
    prepare: Callable[[Case], Lap]
    agreement: float = AGREEMENT


class DisagreementError(ValueError):
    """A kernel computes something else."""


def race(case: Case, contenders: Sequence[Contender], rounds: int) -> dict[str, float]:
    """Median ns a state of each contender that is present, measured in turn.

    Raises
    ------
    DisagreementError
        If the accelerations of one differ from those expected.
    """
    laps = {c.name: _checked(c, case) for c in contenders if not c.absent()}
    passes = {name: _passes(lap) for name, lap in laps.items()}
    times: dict[str, list[float]] = {name: [] for name in laps}
    for _ in range(rounds):
        for name, lap in laps.items():
            times[name].append(_timed(lap, passes[name]))
    return {name: median(found) for name, found in times.items()}


def _checked(contender: Contender, case: Case) -> Lap:
    lap = contender.prepare(case)
    lap.run()
    found, expected = lap.result(), case.expected[:, : lap.states]
    worst = float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))
    if not worst < contender.agreement:
        raise DisagreementError(
            f"{contender.name}, {case.links} links: accelerations differ by {worst:.1e} of the"
            " largest: it computes something else"
        )
    return lap


def _passes(lap: Lap) -> int:
    """So many that one measurement is long enough for the clock."""
    once = _timed(lap, 1) * lap.states * lap.together * 1e-9
    return max(1, round(SHORTEST / max(once, 1e-9)))


def _timed(lap: Lap, passes: int) -> float:
    start = perf_counter()
    for _ in range(passes):
        lap.run()
    return (perf_counter() - start) / (passes * lap.together * lap.states) * 1e9
