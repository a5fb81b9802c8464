"""Fixed steps from one wanted time to the next.

h_i = (t_(i+1) - t_i) / ceil((t_(i+1) - t_i) / h)        so that steps end at the times
"""

import math
from collections.abc import Callable

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


def refused(problem: Problem, setting: Setting, stages: int) -> str:
    """Why fixed steps do not suit: no step, inputs that change within it, or too many."""
    step = setting.step
    if step is None or not 0 < step < math.inf:
        return f"a fixed step in s is needed, {step} found"
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        return f"inputs are held over a step, and {', '.join(moved)} is a function of time"
    needed = stages * sum(count for count, _ in plan(problem.times, step))
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
    steps = plan(problem.times, setting.step or 0.0)
    begins = problem.times[:-1].tolist()

    def solve() -> Outcome:
        y, states, taken = problem.start, [problem.start], 0
        for t, (count, h) in zip(begins, steps, strict=True):
            for i in range(count):
                y = step(y, t + i * h, h)
            taken += count
            if not np.all(np.isfinite(y)):
                words = stopped(name, t, NOT_FINITE)
                return Outcome(np.array(states), taken * stages, words, cause=Cause.NOT_FINITE)
            states.append(y)
        return Outcome(np.array(states), taken * stages)

    return solve
