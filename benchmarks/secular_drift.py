"""Energy, momentum and phase over very many periods: bounded, or a secular drift and its rate.

    shift  tau = <y - z, f> / <f, f>        phase error: by how much y is late on the motion z

Errors are sampled in windows spread evenly over the run; Hairer, Lubich and Wanner, Geometric
Numerical Integration, IX and X. The motion z itself is a run of order 8 with short steps.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from benchmarks.drift import Drift, drift
from mechanics.clock import timed
from mechanics.errors import InputError
from mechanics.simulate.integrators import INTEGRATORS
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import Rate

Array = NDArray[np.float64]

WINDOWS, SAMPLES, WIDTH = 12, 24, 3.0
# Steps of the motion that errors are measured against, in each period.
FINE = 200
# A momentum that varies by less than this share in the fine run is conserved.
CONSERVED = 1e-8
# Beyond this share of the motion, an error is not told by its phase any more.
LARGE = 0.3
ENDLESS = 10**15


@dataclass(frozen=True)
class LongRun:
    """One integrator over many periods.

    Attributes
    ----------
    periods : int
        How many were integrated; fewer than wanted where more would take too long.
    energy : Drift
        Relative to the range of kinetic and potential energy.
    momenta : tuple of (str, Drift)
        Of the components that the motion conserves, relative to their value.
    phase : Drift
        In periods.
    followed : int
        Periods up to which errors are small enough to be told by a phase.
    seconds : float
        What it took.
    failure : str
        Why it ended early; then the figures are those of what was reached.
    """

    setting: Setting
    periods: int
    wanted: int
    energy: Drift
    momenta: tuple[tuple[str, Drift], ...]
    phase: Drift
    followed: int
    seconds: float
    failure: str = ""

    @property
    def phase_words(self) -> str:
        """The phase, as far as the run could be followed by it."""
        if self.followed >= self.periods - WIDTH:
            return self.phase.words
        if not math.isfinite(self.phase.power):
            return "lost at once: the error is another motion at the second look"
        return f"{self.phase.words} in {self.followed} periods, another motion then"

    @property
    def note(self) -> str:
        """What was not integrated, in a sentence; empty when all was."""
        if self.failure:
            return self.failure
        if self.periods == self.wanted:
            return ""
        text = f"{self.periods} periods, {self.wanted} would have taken too long"
        later = self.energy.after(self.wanted / self.periods)
        return f"{text}: an energy error of {later:.1e} if it goes on like this"


def natural_period(problem: Problem) -> float:
    """Longest period of small oscillations about q = 0, in s.

    Raises
    ------
    InputError
        If q = 0 is no equilibrium about which anything oscillates.
    """
    rate, rest = Rate(problem), np.zeros_like(problem.start)
    still = np.all(np.abs(rate(0.0, rest)) < 1e-12 * (1 + np.abs(rate(0.0, problem.start))))
    values = np.linalg.eigvals(rate.jacobian(0.0, rest)).astype(complex)
    turning = np.abs(values.imag[np.abs(values.imag) > 1e-6 * np.max(np.abs(values))])
    if not still or not turning.size:
        raise InputError("there is no oscillation about q = 0: give the period to count by")
    return float(2 * np.pi / np.min(turning))


def long_runs(
    problem: Problem,
    settings: Sequence[Setting],
    *,
    periods: int = 100_000,
    period: float | None = None,
    seconds: float = 10.0,
) -> tuple[LongRun, ...]:
    """Integrate over many periods with several settings.

    Parameters
    ----------
    problem : Problem
        Gives everything but the times.
    period : float, optional
        In s; by default the longest of the small oscillations.
    seconds : float
        What one run may take; slower ones get a tenth, a hundredth ... of the periods, and say so.

    Raises
    ------
    InputError
        If there is no natural period, or no such integrator.
    """
    length = period or natural_period(problem)
    free = replace(problem, budget=ENDLESS)
    known: dict[int, _Motion] = {}
    found = []
    for setting in settings:
        count = _affordable(free, setting, periods, length, seconds)
        if count not in known:
            known[count] = _motion(replace(free, times=_windows(count * length, length)), length)
        found.append(_measured(known[count], setting, count, periods, length))
    return tuple(found)


def _windows(duration: float, period: float) -> Array:
    """Times: 0, and windows of a few periods spread evenly, the last one ending the run."""
    width = min(WIDTH * period, duration / WINDOWS)
    inside = np.linspace(0.0, width, SAMPLES, endpoint=False)
    begins = np.linspace(0.0, duration - width, WINDOWS)
    return np.array([begin + t for begin in begins for t in inside])


@dataclass(frozen=True, eq=False)
class _Motion:
    """The fine run: its states, their rates, and what it conserves."""

    problem: Problem
    states: Array
    rates: Array
    scale: Array
    energy: Array
    conserved: tuple[tuple[str, int, float], ...]


def _motion(problem: Problem, period: float) -> _Motion:
    setting = Setting("C RK8", None, period / FINE)
    states = _prepared(problem, setting)().states
    if len(states) < len(problem.times):
        raise InputError("the motion cannot be followed over so many periods: it is singular")
    rate = Rate(problem)
    rates = np.array([rate(t, y) for t, y in zip(problem.times, states, strict=True)])
    scale = np.max(np.abs(states), axis=0)
    momenta = _momenta(problem, states)
    conserved = []
    for i, name in enumerate(("P_x", "P_y", "P_z", "H_x", "H_y", "H_z")):
        size = float(np.max(np.abs(momenta[:, i])))
        if size > 0 and np.ptp(momenta[:, i]) < CONSERVED * size:
            conserved.append((name, i, size))
    return _Motion(
        problem,
        states,
        rates,
        np.where(scale > 0, scale, 1.0),
        _energy(problem, states),
        tuple(conserved),
    )


def _prepared(problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    member = _named(setting.integrator)
    why = member.available() or member.suits(problem, setting)
    if why:
        return lambda: Outcome(problem.start[None, :], 0, f"{member.name}: {why}")
    return member.prepare(problem, setting)


def _named(name: str) -> Integrator:
    for member in INTEGRATORS:
        if member.name == name:
            return member
    raise InputError(
        f"integrator {name!r}: there are {', '.join(member.name for member in INTEGRATORS)}"
    )


def _affordable(
    problem: Problem, setting: Setting, periods: int, period: float, seconds: float
) -> int:
    """Periods that fit into the seconds: all of them, or a tenth, a hundredth ..."""
    trial = min(100, periods)
    solve = _prepared(replace(problem, times=_windows(trial * period, period)), setting)
    solve()
    needed = timed(solve)[1] * periods / trial
    decades = max(0, math.ceil(math.log10(needed / seconds)))
    return max(trial, periods // 10**decades)


def _measured(motion: _Motion, setting: Setting, count: int, wanted: int, period: float) -> LongRun:
    problem = motion.problem
    solve = _prepared(problem, setting)
    outcome, seconds = timed(solve)
    states = outcome.states
    reached, times = len(states), problem.times[: len(states)] / period
    change = _energy(problem, states)
    energy = (change[:, 0] - change[0, 0]) / motion.energy[0, 1]
    momenta = _momenta(problem, states)
    drifts = [
        (name, drift(times, (momenta[:, i] - momenta[0, i]) / size, SAMPLES))
        for name, i, size in motion.conserved
    ]
    at, shift = _phase(motion, states, times, reached, period)
    return LongRun(
        setting,
        round(float(times[-1])) if outcome.failure else count,
        wanted,
        drift(times, energy, SAMPLES),
        tuple(drifts),
        drift(at, shift, SAMPLES),
        round(float(at[-1])) if len(at) else 0,
        seconds,
        outcome.failure,
    )


def _phase(
    motion: _Motion, states: Array, times: Array, reached: int, period: float
) -> tuple[Array, Array]:
    """Shifts in periods, up to where the error is no small shift any more."""
    off = (states - motion.states[:reached]) / motion.scale
    flow = motion.rates[:reached] / motion.scale
    near = np.max(np.abs(off), axis=1) < LARGE
    last = reached if near.all() else int(np.argmin(near))
    shift = np.sum(off * flow, axis=1) / np.sum(flow * flow, axis=1) / period
    return times[:last], shift[:last]


def _given(problem: Problem, states: Array) -> Array:
    """Inputs at the times of the states, a row each."""
    times = problem.times[: len(states)]
    return np.array([problem.signals(*at) for at in zip(times, states, strict=True)])


def _energy(problem: Problem, states: Array) -> Array:
    """Columns: total energy, and the range that its parts run through."""
    n = len(problem.model.quantities.q)
    given = _given(problem, states)
    found = problem.model.energy(states[:, :n], states[:, n:], inputs=given, p=problem.p)
    span = max(float(np.max(found["kinetic"])), float(np.ptp(found["potential"])))
    return np.stack([found["total"], np.full(len(states), span)], axis=1)


def _momenta(problem: Problem, states: Array) -> Array:
    """Linear and angular momentum, shape (N, 6)."""
    n = len(problem.model.quantities.q)
    given = _given(problem, states)
    found = problem.model.evaluate(
        "momenta", q=states[:, :n], u=states[:, n:], inputs=given, p=problem.p
    )
    return np.hstack([found["linear"], found["angular"]])
