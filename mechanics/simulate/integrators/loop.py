"""Fixed steps from one wanted time to the next, or through the times.

h_i = (t_(i+1) - t_i) / ceil((t_(i+1) - t_i) / h)        so that steps end at the times
t_i = k h + r_i,   0 <= r_i < h                          a step of r_i from the end of step k
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.integrators.problem import Cause, Outcome, Problem, Setting

Array = NDArray[np.float64]

NOT_FINITE = "the state is not finite: the step is too long, or the motion singular"


def plan(times: Array, step: float) -> list[tuple[int, float]]:
    """Number and length of the steps between the times."""
    spans = np.diff(times)
    # A span that is a whole number of steps but for rounding is not given one more.
    counts = [max(1, math.ceil(span / step * (1 - 1e-12))) for span in spans]
    return [(count, float(span) / count) for count, span in zip(counts, spans, strict=True)]


@dataclass(frozen=True)
class Span:
    """Steps up to a wanted time.

    Attributes
    ----------
    begin : float
        Where the first one begins, in s.
    step : float
        Length of each, in s.
    rest : float
        From the end of the last one to the wanted time: 0, or a step beside the others.
    """

    begin: float
    count: int
    step: float
    rest: float = 0.0


def spans(problem: Problem, step: float) -> list[Span]:
    """The steps up to each of the times of a problem."""
    times = problem.times
    if not problem.through:
        begins = times[:-1].tolist()
        return [Span(t, n, h) for t, (n, h) in zip(begins, plan(times, step), strict=True)]
    ends = np.floor(times / step * (1 + 1e-12))
    rests = times[1:] - ends[1:] * step
    rests[rests < 1e-12 * times[1:]] = 0.0
    rows = zip(ends[:-1], np.diff(ends), rests, strict=True)
    return [Span(float(end * step), int(n), step, float(rest)) for end, n, rest in rows]


def refused(problem: Problem, setting: Setting, stages: int) -> str:
    """Why fixed steps do not suit: no step, inputs that change within it, or too many."""
    step = setting.step
    if step is None or not 0 < step < math.inf:
        return f"a fixed step in s is needed, {step} found"
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        return f"inputs are held over a step, and {', '.join(moved)} is a function of time"
    needed = stages * sum(span.count for span in spans(problem, step))
    if needed > problem.budget:
        return f"{needed:.2g} evaluations are needed, {problem.budget:.2g} allowed"
    return ""


def stopped(name: str, t: float, why: str) -> str:
    """The sentence of an outcome that ended early."""
    return f"{name} stopped after t = {t:.6g} s: {why}"


def march(
    name: str,
    problem: Problem,
    setting: Setting,
    step: Callable[[Array, float, float], Array],
    stages: int,
) -> Callable[[], Outcome]:
    """A call that integrates with steps that are taken from Python.

    Parameters
    ----------
    step : callable
        Of (y, t, h), to y(t + h).
    """
    steps = spans(problem, setting.step or 0.0)

    def solve() -> Outcome:
        y, states, taken = problem.start, [problem.start], 0
        for span in steps:
            for i in range(span.count):
                y = step(y, span.begin + i * span.step, span.step)
            taken += span.count
            end = span.begin + span.count * span.step
            at = step(y, end, span.rest) if span.rest else y
            if not np.all(np.isfinite(at)):
                words = stopped(name, span.begin, NOT_FINITE)
                return Outcome(np.array(states), taken * stages, words, cause=Cause.NOT_FINITE)
            states.append(at)
        return Outcome(np.array(states), taken * stages)

    return solve
