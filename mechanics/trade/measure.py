"""Run a choice and measure what it loses; time many of them side by side.

Times are of whole runs in this process, one choice after the other, round after round, so that what
disturbs the machine disturbs all of them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
from numpy.typing import NDArray

from mechanics.clock import side_by_side, timed
from mechanics.errors import MechanicsError
from mechanics.simulate.conservative import conservative
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Outcome
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.truth import Truth

Array = NDArray[np.float64]

ROUNDS = (3, 25)
"""Fewest and most rounds of timing."""
APART, AGAIN = 2.0, 2
"""Quartiles farther apart are measured again, so many times; then they are told to be noise."""


@dataclass(frozen=True, eq=False)
class Measurement:
    """What a choice costs and what it loses on the motion from the example.

    Attributes
    ----------
    choice : Choice
    error_end, error_largest : float
        At the end, and the largest along the way, in the stated norm.
    evaluations, jacobians : int
        Of the right-hand side and of its Jacobian, in the whole run.
    energy_drift : float or None
        Largest change of the energy, relative to the range that it runs through; None where it is
        not conserved.
    seconds : tuple of float
        Time of computing for a second of motion, one for each repetition.
    failure : str
        Why it did not reach the end; empty when it did.
    """

    choice: Choice
    error_end: float
    error_largest: float
    evaluations: int
    jacobians: int
    energy_drift: float | None
    seconds: tuple[float, ...]
    failure: str = ""

    @property
    def time(self) -> float:
        """Median of the times, in s for a second of motion."""
        return median(self.seconds)

    @property
    def spread(self) -> tuple[float, float]:
        """Quartiles of the times."""
        low, high = np.quantile(self.seconds, [0.25, 0.75])
        return float(low), float(high)

    @property
    def noisy(self) -> bool:
        """Whether the quartiles are so far apart that the median tells little."""
        return self.spread[1] > APART * self.spread[0]


def integrator(name: str) -> Integrator:
    """The integrator of a name."""
    return next(member for member in INTEGRATORS if member.name == name)


def unsuited(case: Case, choice: Choice) -> str:
    """Why a choice cannot be used for a case; empty where it can."""
    member = integrator(choice.setting.integrator)
    why = member.available()
    if why:
        return why
    try:
        return member.suits(case.problem(choice.variant), choice.setting)
    except MechanicsError as error:
        return str(error)


def prepared(case: Case, choice: Choice, start: Array | None = None) -> Callable[[], Outcome]:
    """The run of a choice, ready to be timed."""
    member = integrator(choice.setting.integrator)
    return member.prepare(case.problem(choice.variant, start), choice.setting)


def measured(
    case: Case, choice: Choice, truth: Truth, run: Callable[[], Outcome]
) -> tuple[Measurement, Array]:
    """One run of a choice: what it loses, a first time, and its states."""
    outcome, seconds = timed(run)
    errors = truth.errors(outcome.states)
    complete = not outcome.failure and len(outcome.states) == len(case.times)
    found = Measurement(
        choice,
        float(errors[-1]) if complete else np.inf,
        float(np.max(errors)) if complete else np.inf,
        outcome.evaluations,
        outcome.jacobians,
        energy_drift(case, outcome.states),
        (seconds / case.horizon,),
        outcome.failure,
    )
    return found, outcome.states


def energy_drift(case: Case, states: Array) -> float | None:
    """Largest |E - E(0)| relative to what the energies run through; None if not conserved."""
    if not conservative(case.equations.scene, case.inputs) or not np.all(np.isfinite(states)):
        return None
    energy = case.energy(states)
    total = energy["kinetic"] + energy["potential"]
    scale = max(float(np.max(energy["kinetic"])), float(np.ptp(energy["potential"])))
    change = float(np.max(np.abs(total - total[0])))
    return change / scale if scale > 0 else change


def times_side_by_side(
    runs: Sequence[Callable[[], Outcome]],
    horizon: float,
    budget: float,
    rounds: tuple[int, int] = ROUNDS,
) -> list[tuple[float, ...]]:
    """Seconds for a second of motion of every run, in rounds over all of them.

    Parameters
    ----------
    runs : sequence of callable
        Warm.
    horizon : float
        Length of the motion in s.
    budget : float
        Seconds that all of it may take, beyond the fewest rounds.
    """
    found = [list(seconds) for seconds in side_by_side(runs, budget, rounds)]
    for _ in range(AGAIN):
        noisy = [i for i, seconds in enumerate(found) if _apart(seconds)]
        again = side_by_side([runs[i] for i in noisy], budget / 2, rounds) if noisy else ()
        for i, seconds in zip(noisy, again, strict=True):
            # A quieter round stands for itself; the others are what disturbed the machine.
            found[i] = min(found[i], [*seconds], key=lambda one: np.quantile(one, 0.75))
    return [tuple(one / horizon for one in seconds) for seconds in found]


def _apart(seconds: Sequence[float]) -> bool:
    low, high = np.quantile(seconds, [0.25, 0.75])
    return bool(high > APART * low)
