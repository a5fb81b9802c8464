"""States at the times that are wanted, picked from the steps of the integrator."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.domain import EVERYWHERE, Domain
from mechanics.simulate.exits import watched
from mechanics.simulate.march import Flow, Tolerance, march
from mechanics.simulate.trajectory import Crossing, Ending

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Samples:
    """What was reached.

    Attributes
    ----------
    states : array, shape (K, n + m)
        On the constraints, at the first K of the times.
    drift : array
        Largest residual of each constraint before states were projected.
    ending : Ending
    time : float
        When it ended, in s.
    crossings : tuple of Crossing
        Of the edge of the domain.
    steps : int
        That the integrator took.
    """

    states: Array
    drift: Array
    ending: Ending
    time: float
    crossings: tuple[Crossing, ...] = ()
    steps: int = 0


@dataclass(frozen=True)
class Watching:
    """The domain that is watched, and whether to go on outside of it."""

    domain: Domain = EVERYWHERE
    beyond: bool = False


def sample(
    flow: Flow,
    start: Array,
    times: Array,
    by: Tolerance,
    progress: Callable[[float], None] | None = None,
    watch: Watching = Watching(),
    first: float | None = None,
    enough: Callable[[int, Array], bool] = lambda index, state: False,
) -> Samples:
    """Integrate from ``times[0]`` to ``times[-1]`` and sample the motion.

    Parameters
    ----------
    start : array, shape (n + m,)
        On the constraints.
    times : array, shape (N,)
        Increasing.
    progress : callable, optional
        Told the share that is done, after every step.
    watch : Watching
        The domain of the model, and whether to go on outside of it.
    first : float, optional
        The first step, in s, where it is not the integrator's to find.
    enough : callable
        Of the index of a sample and its state: whether no later one is needed.
    """
    states = [start]
    drift = flow.manifold.residual(times[0], start)
    ending, end = Ending.COMPLETE, float(times[0])
    crossed: list[Crossing] = []
    steps = march(flow, start, (float(times[0]), float(times[-1])), by, first)
    taken = 0
    for stretch in watched(watch.domain, end, steps, watch.beyond):
        taken += 1
        crossed += stretch.crossings
        due = times[len(states) :]
        for time in due[due <= stretch.end]:
            states.append(flow.manifold.project(time, stretch.state(time)))
            if enough(len(states) - 1, states[-1]):
                return Samples(np.array(states), drift, ending, time, tuple(crossed), taken)
        end = stretch.end
        if progress is not None:
            progress(end / float(times[-1]))
        drift = np.maximum(drift, flow.manifold.residual(end, stretch.state(end)))
        ending = stretch.ending or ending
    return Samples(np.array(states), drift, ending, end, tuple(crossed), taken)
