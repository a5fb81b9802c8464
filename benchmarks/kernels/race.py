"""Kernels timed in turn, in one process, after each has been shown to compute the same.

    ns a state = processor time of some passes / (passes * states)        a number a round

A kernel that gives other accelerations is an error, not a row of the table.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from time import process_time

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


Times = dict[str, list[float]]
"""Processor time of each contender, ns a state, by round: one thread each."""


def ratio(times: Times, ours: str, peer: str) -> float:
    """Median over the rounds: what disturbs a round disturbs both."""
    return median(a / b for a, b in zip(times[ours], times[peer], strict=True))


def race(case: Case, contenders: Sequence[Contender], rounds: int) -> Times:
    """Times of each contender that is present, measured in turn.

    Raises
    ------
    DisagreementError
        If the accelerations of one differ from those expected.
    """
    laps = {c.name: _checked(c, case) for c in contenders if not c.absent()}
    passes = {name: _passes(lap) for name, lap in laps.items()}
    times: Times = {name: [] for name in laps}
    for _ in range(rounds):
        for name, lap in laps.items():
            times[name].append(_timed(lap, passes[name]))
    return times


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
    start = process_time()
    for _ in range(passes):
        lap.run()
    return (process_time() - start) / (passes * lap.together * lap.states) * 1e9
