"""Simulate to an accuracy: the cheapest choice that is measured to meet it, and an error estimate.

    measure on the first motion --> run with that choice --> compare with a finer setting

The choice is measured against the reference on the very motion that is asked for. The estimate that
is reported is another thing: the difference from a run with a tenth of the tolerance, or half of
the step. Where that is larger than the accuracy, the finer setting becomes the choice.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model
from mechanics.errors import InputError, wanted
from mechanics.simulate import simulate as simulate_plainly
from mechanics.simulate.batch import Initial, initial_states, part
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Problem
from mechanics.simulate.run import Begin, Progress, begin, equal_times, simulate_one, trajectory
from mechanics.simulate.samples import Samples
from mechanics.simulate.trajectory import Ending, Trajectory
from mechanics.trade.case import BUDGET, Case
from mechanics.trade.cheapest import cheapest
from mechanics.trade.choice import Choice
from mechanics.trade.measure import integrator
from mechanics.trade.truth import from_states

Array = NDArray[np.float64]

EPSILON = float(np.finfo(float).eps)
# Evaluations that the run itself may spend.
PATIENT = 100 * BUDGET
# How much finer the second run is: a tenth of the tolerance, half of the step.
FINER = {True: 0.1, False: 0.5}


def simulate(
    model: Model,
    duration: float,
    *,
    initial: Initial = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    samples: int = 501,
    accuracy: float | None = None,
    progress: Progress | None = None,
    beyond_domain: bool = False,
    members: Sequence[Integrator] = INTEGRATORS,
    **options: Any,
) -> Any:
    """Integrate the equations of motion from t = 0, if asked for to an accuracy.

    Parameters
    ----------
    accuracy : float, optional
        Largest error along the way, of coordinates and speeds relative to the largest magnitude of
        each. The cheapest integrator and setting that is measured to meet it is used, and
        `Trajectory.error_estimate` tells what a finer setting finds. Without it, `rtol`, `atol` and
        `method` count.
    members : sequence of Integrator
        To choose from.
    model, duration, initial, parameters, inputs, samples, progress, beyond_domain, **options
        As for `mechanics.simulate.batch.simulate`.

    Returns
    -------
    Trajectory, or tuple of Trajectory for a batch

    Raises
    ------
    InputError
        Beside the reasons there: for an accuracy that is none or that nothing meets, or with
        `rtol`, `atol` or `method` at the same time.
    OverBudget
        If the motion is too fast for a reference over the duration.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(rod_pendulum.scene(), compiler=None)
    >>> motion = simulate(model, 1.0, initial={"theta": 3.0}, inputs={"u": 0}, samples=3)
    >>> print(motion.times, list(motion.coordinates))
    [0.  0.5 1. ] ['theta']
    """
    wanted(model, Model, "simulate", "pass compile(derive(scene, route))")
    given = {"parameters": parameters, "inputs": inputs}
    if accuracy is None:
        options |= {"initial": initial, "samples": samples, "progress": progress, **given}
        return simulate_plainly(model, duration, beyond_domain=beyond_domain, **options)
    if options:
        raise InputError(f"accuracy: it chooses {', '.join(options)}: give one or the other")
    if not (np.isfinite(accuracy) and 0 < accuracy < 1):
        raise InputError(f"accuracy: {accuracy!r} found: a number between 0 and 1 is needed")
    if accuracy < EPSILON:
        raise InputError(
            f"accuracy {accuracy:g}: doubles round to {EPSILON:.1e}: no method can meet it"
        )
    times = equal_times(duration, samples)
    starts = initial_states(initial)
    many = starts if starts is not None else (dict(initial or {}),)  # type: ignore[arg-type]
    inside = times if beyond_domain else _inside(model, times, many[0], given)
    case = Case(
        model.equations, float(inside[-1]), many[0], parameters or {}, inputs or {},
        model.compiler, tuple(inside.tolist()),
    ).with_model(model)  # fmt: skip
    choice = cheapest(case, accuracy, members)
    found = tuple(
        _solved(
            Wanted(case, begin(model, start, **given), times, start, beyond_domain),
            choice, accuracy, part(progress, i, len(many)),
        )
        for i, start in enumerate(many)
    )  # fmt: skip
    return found[0] if starts is None else found


def _inside(
    model: Model, times: Array, initial: Mapping[str, float], given: Mapping[str, Any]
) -> Array:
    """The times at which choices are measured: up to where the motion leaves the model's domain."""
    if not model.equations.scene.conditions:
        return times
    found = simulate_one(
        model, float(times[-1]), initial=initial, samples=2, estimate=False, **given
    )
    if found.ending is not Ending.LEFT_DOMAIN:
        return times
    end = found.crossings[-1].time
    return np.append(times[times < end], end)


@dataclass(frozen=True, eq=False)
class Wanted:
    """One motion that is wanted: the case, where it starts, and when it is sampled."""

    case: Case
    start: Begin
    times: Array
    initial: Mapping[str, float]
    beyond_domain: bool = False

    def trajectory(self, choice: Choice, progress: Progress | None = None) -> Trajectory:
        """The motion by a choice; SciPy's methods are watched and put back onto constraints.

        Raises
        ------
        InputError
            If the method gives up.
        """
        name = choice.setting.integrator
        if name.startswith("SciPy "):
            return simulate_one(
                self.start.model,
                float(self.times[-1]),
                initial=self.initial,
                parameters=self.case.parameters,
                inputs=self.case.inputs,
                samples=len(self.times),
                rtol=choice.amount,
                atol=choice.amount,
                method=name.removeprefix("SciPy "),
                progress=progress,
                beyond_domain=self.beyond_domain,
                estimate=False,
            )
        model, start = self.start.model, self.start
        problem = Problem(model, start.p, start.inputs, start.state, self.times, PATIENT)
        outcome = integrator(name).prepare(problem, choice.setting)()
        if outcome.failure:
            raise InputError(f"{model.equations.scene.name}: {outcome.failure}: ask for another")
        drift = np.zeros(len(start.moving.manifold.names))
        end = float(self.times[-1])
        found = Samples(outcome.states, drift, Ending.COMPLETE, end)
        return trajectory(start, self.times, found)


def states_of(found: Trajectory) -> Array:
    """Coordinates and speeds, shape (K, n + m)."""
    return np.column_stack([*found.coordinates.values(), *found.speeds.values()])


def _solved(
    wanted: Wanted, choice: Choice, accuracy: float, progress: Progress | None
) -> Trajectory:
    """The motion by a choice, or by finer settings until the estimate is within the accuracy."""
    motion = wanted.trajectory(choice, part(progress, 0, 2))
    while True:
        finer = _finer(wanted, choice)
        if _refused(wanted, finer):
            raise InputError(
                f"accuracy {accuracy:g}: {choice.words} is the most accurate choice, and its error"
                " is not shown to be within it: ask for less, or for a shorter duration"
            )
        better = wanted.trajectory(finer, part(progress, 1, 2))
        estimate = _difference(motion, better)
        if estimate <= accuracy or motion.ending is not Ending.COMPLETE:
            return replace(motion, solved_by=choice.words, error_estimate=estimate)
        motion, choice = better, finer


def _finer(wanted: Wanted, choice: Choice) -> Choice:
    adaptive = choice.setting.tolerance is not None
    # Steps end at the samples, so a longer one than their distance is not taken.
    taken = choice.amount if adaptive else min(choice.amount, float(wanted.times[1]))
    return choice.with_amount(FINER[adaptive] * taken)


def _refused(wanted: Wanted, choice: Choice) -> str:
    start = wanted.start
    problem = Problem(start.model, start.p, start.inputs, start.state, wanted.times, PATIENT)
    return integrator(choice.setting.integrator).suits(problem, choice.setting)


def _difference(motion: Trajectory, better: Trajectory) -> float:
    """Largest difference along the way in the stated norm."""
    one, other = states_of(motion), states_of(better)
    count = min(len(one), len(other))
    return float(np.max(from_states(other[:count]).errors(one[:count])))
