"""Steps of an integrator over y' = f(t, y), kept on the constraints.

    y = (q, u)

After a step the state is projected back onto the constraints, and the solver starts anew from there
when the correction is larger than the error that it was allowed: a Runge-Kutta method loses one
evaluation by that, a multistep method more, and is given more patience.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import BDF, DOP853, LSODA, RK45, OdeSolver, Radau

from mechanics.simulate.manifold import Manifold
from mechanics.simulate.singular import Linear, Measure, Watch, measure_from, regularity_lost
from mechanics.simulate.trajectory import Crossing, Ending

Array = NDArray[np.float64]

METHODS: dict[str, type[OdeSolver]] = {
    "DOP853": DOP853,
    "RK45": RK45,
    "Radau": Radau,
    "BDF": BDF,
    "LSODA": LSODA,
}
# By how many errors of a step the state may leave the constraints before the solver starts anew:
# a multistep method begins again at first order then.
PATIENCE = {"BDF": 100.0, "LSODA": 100.0}
MAX_STEPS = 100_000
# How far ahead, in s, to look for the reason when no step succeeds.
AHEAD = 1e-6


@dataclass(frozen=True)
class Flow:
    """What is integrated.

    Attributes
    ----------
    rate : callable
        f(t, y), shape (n + m,).
    linear : callable
        Of (t, y): the matrices that have to stay regular.
    manifold : Manifold
        The constraints.
    """

    rate: Callable[[float, Array], Array]
    linear: Callable[[float, Array], Linear]
    manifold: Manifold


@dataclass(frozen=True)
class Tolerance:
    """Method of integration, and the relative and absolute error it may make in a step."""

    method: str
    rtol: float
    atol: float


@dataclass(frozen=True)
class Stretch:
    """The motion over one step, up to `end`; the last one says why it is the last."""

    state: Callable[[float], Array]
    end: float
    ending: Ending | None = None
    crossings: tuple[Crossing, ...] = ()


def march(
    flow: Flow, start: Array, span: tuple[float, float], by: Tolerance, first: float | None = None
) -> Iterator[Stretch]:
    """Steps from ``span[0]`` to ``span[1]``, or to where the motion ends for another reason."""
    measure = measure_from(flow.linear, span[0], start)
    refused = _refused(flow, measure, span[0], start)
    if refused is not None:
        yield Stretch(_still(start), span[0], refused)
        return
    solver = _solver(flow, start, span, by, first)
    watch = [Watch(span[0], measure(span[0], start), None)]
    for _ in range(MAX_STEPS):
        before = solver.t
        solver.step()
        if solver.status == "failed":
            yield Stretch(_still(solver.y), before, _stalled(flow, measure, before, solver.y))
            return
        state = solver.dense_output()
        watch = [*watch[-2:], Watch(solver.t, measure(solver.t, solver.y), state)]
        lost = regularity_lost(measure, watch)
        if lost is not None:
            yield Stretch(state, lost, Ending.SINGULAR)
            return
        corrected = flow.manifold.project(solver.t, solver.y)
        if not np.all(np.isfinite(corrected)):
            yield Stretch(state, before, Ending.APART)
            return
        yield Stretch(state, solver.t, Ending.COMPLETE if solver.status == "finished" else None)
        if solver.status == "finished":
            return
        allowed = by.atol + by.rtol * np.abs(solver.y)
        if np.any(np.abs(corrected - solver.y) > PATIENCE.get(by.method, 1.0) * allowed):
            solver = _solver(flow, corrected, (solver.t, span[1]), by, solver.step_size)
    yield Stretch(_still(solver.y), solver.t, Ending.TOO_LONG)


def _solver(
    flow: Flow, start: Array, span: tuple[float, float], by: Tolerance, step: float | None = None
) -> OdeSolver:
    """A solver of SciPy at the start of a span; `step` is the size of its first step."""
    first = None if step is None else min(step, span[1] - span[0])
    return METHODS[by.method](
        flow.rate, span[0], start, span[1], rtol=by.rtol, atol=by.atol, first_step=first
    )


def _still(state: Array) -> Callable[[float], Array]:
    return lambda t: state


def _stalled(flow: Flow, measure: Measure, t: float, state: Array) -> Ending:
    """Why no step succeeds: for a reason in the state, or in one just ahead."""
    ahead = state + AHEAD * flow.rate(t, state)
    return (
        _refused(flow, measure, t, state)
        or _refused(flow, measure, t + AHEAD, ahead)
        or Ending.STALLED
    )


def _refused(flow: Flow, measure: Measure, t: float, state: Array) -> Ending | None:
    """Why there is no going on from a state, as far as the state itself shows it."""
    if not np.all(np.isfinite(flow.rate(t, state))):
        return Ending.NOT_FINITE
    if regularity_lost(measure, [Watch(t, measure(t, state), None)]) is not None:
        return Ending.SINGULAR
    return None
