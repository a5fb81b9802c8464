"""One method over its settings on one problem: errors, work, and processor time.

scd   = -log10 max_i |y_i - z_i| / |z_i|                 at the end
mescd = -log10 max_i |y_i - z_i| / (1 + |z_i|)           with equal tolerances
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from statistics import median
from time import process_time

import numpy as np
from numpy.typing import NDArray

from benchmarks.work_precision.methods import prepared
from benchmarks.work_precision.problems import ENERGY, MIXED, Problem
from mechanics import derive
from mechanics.errors import MechanicsError
from mechanics.simulate.integrators import Integrator, Outcome, Setting
from mechanics.simulate.reference import reference
from mechanics.trade.case import Case

Array = NDArray[np.float64]
TOLERANCES = tuple(10.0**-k for k in range(3, 15))
STEPS = tuple(2.0**-k for k in range(5, 20))
"""Of the duration."""
LONGEST = 1.0
"""Seconds of processor time after which no finer setting is tried."""
STUCK = 2
"""Finer settings without a gain after which a method has arrived."""
ROUNDS = 5
DIGITS = 25


@dataclass(frozen=True, eq=False)
class Point:
    """A setting of a method, and what became of it.

    Attributes
    ----------
    setting : Setting
    scd, mescd : float
    energy : float
        Largest error along the way, in J; NaN where it is not conserved.
    constraint : float
        Largest residual of a constraint of the coordinates along the way; NaN without.
    evaluations, jacobians : int
    seconds : float
        Of processor time, of the whole run.
    run : callable
    """

    setting: Setting
    scd: float
    mescd: float
    energy: float
    constraint: float
    evaluations: int
    jacobians: int
    seconds: float
    run: Callable[[], Outcome]

    def reaches(self, problem: Problem, level: float) -> bool:
        """Whether it is as accurate as a level of the problem."""
        return self.energy <= level if problem.measure == ENERGY else self.digits(problem) >= level

    def digits(self, problem: Problem) -> float:
        """Correct digits at the end, as the problem counts them."""
        return self.mescd if problem.measure == MIXED else self.scd


@dataclass(frozen=True, eq=False)
class Posed:
    """A problem with its model, and its solution at the end; `doubt` says what that rests on."""

    problem: Problem
    case: Case
    end: Array
    doubt: str

    def energy(self, states: Array) -> float:
        """Largest change of the energy, in J."""
        if self.problem.energy is not None:
            total = self.problem.energy(states)
        else:
            parts = self.case.energy(states)
            total = parts["kinetic"] + parts["potential"]
        return float(np.max(np.abs(total - total[0])))

    def rows(self) -> list[int]:
        """Entries of the state that are compared."""
        wanted = self.problem.compared or self.case.names
        return [i for i, name in enumerate(self.case.names) if name in wanted]


def posed(problem: Problem) -> Posed:
    """The model of a problem, and its solution at the end with many digits."""
    case = Case(derive(problem.scene()), problem.duration, problem.initial, problem.parameters,
                through=True)  # fmt: skip
    if problem.solution is not None:
        return Posed(problem, case, problem.solution(case.times)[-1], "one freedom, by itself")
    ends = case.problem()
    ends = replace(ends, times=ends.times[[0, -1]])
    try:
        found = reference(ends, DIGITS)
    except MechanicsError as error:
        return Posed(problem, case, np.full(len(case.start), np.nan), f"none: {error}")
    words = f"{np.min(found.digits):.0f} digits"
    if problem.published:
        known = dict(zip(case.names, found.states[-1], strict=True))
        off = max(abs(known[name] / value - 1) if value else abs(known[name])
                  for name, value in problem.published.items())  # fmt: skip
        words += f", within {off:.0e} of the published ones"
    return Posed(problem, case, found.states[-1], words)


def points(of: Posed, member: Integrator) -> Iterator[Point] | str:
    """A method from coarse to fine settings, or why it cannot be used."""
    sizes = TOLERANCES if member.adaptive else [of.problem.duration * share for share in STEPS]
    able, why, best, stuck = [], "", np.inf, 0
    for size in sizes:
        adaptive = member.adaptive
        setting = Setting(member.name, size if adaptive else None, None if adaptive else size)
        run = prepared(of.case.problem(), setting)
        if isinstance(run, str):
            why = run
            continue
        point = _point(of, setting, run)
        if isinstance(point, str):
            why = point
            continue
        able.append(point)
        error = point.energy if of.problem.measure == ENERGY else 10 ** -point.digits(of.problem)
        small = point.reaches(of.problem, of.problem.levels[0])
        stuck = 0 if error < best / 2 or not small else stuck + 1
        best = min(best, error)
        if point.seconds > LONGEST or stuck >= STUCK:
            break
    return iter(able) if able else why


def _point(of: Posed, setting: Setting, run: Callable[[], Outcome]) -> Point | str:
    run_once = process_time()
    outcome = run()
    seconds = process_time() - run_once
    states, times = outcome.states, of.case.times
    if outcome.failure or len(states) < len(times) or not np.all(np.isfinite(states)):
        return outcome.failure or "the state is not finite"
    rows = of.rows()
    off, end = np.abs(states[-1] - of.end)[rows], np.abs(of.end)[rows]
    with np.errstate(divide="ignore", invalid="ignore"):
        relative = off / np.where(end > 0, end, 1.0)
        scd, mescd = (float(-np.log10(np.max(x))) for x in (relative, off / (1 + end)))
    manifold, size = of.case.manifold, len(of.case.equations.scene.q)
    residuals = [manifold.position(t, y[:size])[0] for t, y in zip(times, states, strict=True)]
    constraint = float(np.max(np.abs(residuals))) if np.size(residuals) else np.nan
    energy = of.energy(states) if of.problem.measure == ENERGY else np.nan
    return Point(setting, min(scd, 16.0), min(mescd, 16.0), energy, constraint,
                 outcome.evaluations, outcome.jacobians, seconds, run)  # fmt: skip


def timed(able: list[Point]) -> list[Point]:
    """Processor times again, one point after the other, round after round: medians."""
    seconds: list[list[float]] = [[] for _ in able]
    for _ in range(ROUNDS):
        for point, found in zip(able, seconds, strict=True):
            if found and found[-1] > 0.3:
                continue
            before = process_time()
            point.run()
            found.append(process_time() - before)
    return [replace(p, seconds=median(s)) for p, s in zip(able, seconds, strict=True)]
