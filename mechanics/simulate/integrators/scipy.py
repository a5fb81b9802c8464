"""SciPy's methods, stepped one by one; the right-hand side they call is the compiled one.

RK45 and DOP853 are explicit Runge-Kutta pairs of Dormand and Prince, Radau IIA of order 5 is
implicit (Hairer, Norsett and Wanner, I and II), LSODA switches between Adams and BDF (Petzold).
Implicit methods are given the compiled Jacobian.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, LSODA, RK45, OdeSolver, Radau

from mechanics.simulate.feedback import Feedback
from mechanics.simulate.integrators.problem import (
    Cause,
    Integrator,
    Outcome,
    OverBudget,
    Problem,
    Setting,
)
from mechanics.simulate.integrators.rate import Rate
from mechanics.simulate.integrators.stiffness import too_stiff

Array = NDArray[np.float64]

# The solvers raise a smaller relative tolerance to this without being asked.
FINEST = 100 * float(np.finfo(float).eps)
IMPLICIT, EXPLICIT = (Radau, LSODA), (RK45, DOP853)


def _suits(method: type[OdeSolver], problem: Problem, setting: Setting) -> str:
    if setting.tolerance is None or not FINEST <= setting.tolerance < 1:
        return f"SciPy takes tolerances from {FINEST:.2g} to 1, {setting.tolerance} found"
    return too_stiff(problem) if method in EXPLICIT else ""


def _prepare(method: type[OdeSolver], problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    rate = Rate(problem, setting.kind)
    options: dict[str, Any] = {"rtol": setting.tolerance, "atol": setting.tolerance}
    fed_back = any(isinstance(value, Feedback) for value in problem.inputs.values())
    # The compiled Jacobian holds inputs; where they follow the state, SciPy takes differences.
    if method in IMPLICIT and not fed_back:
        options["jac"] = rate.jacobian
        rate.jacobian(0.0, problem.start)

    def solve() -> Outcome:
        rate.evaluations = rate.jacobians = 0
        states = [problem.start]
        failure, cause = _march(method, rate, problem, options, states)
        return Outcome(np.array(states), rate.evaluations, failure, rate.jacobians, cause)

    return solve


def _march(
    method: type[OdeSolver],
    rate: Rate,
    problem: Problem,
    options: dict[str, Any],
    states: list[Array],
) -> tuple[str, Cause | None]:
    """Append the states at the times; why that ended early, in words and by kind."""
    times, name = problem.times, f"SciPy {method.__name__}"
    try:
        solver = method(rate, 0.0, problem.start, float(times[-1]), **options)
        # A step that is tried and overflows is rejected: no news for the user.
        with np.errstate(all="ignore"):
            while solver.status == "running":
                words = solver.step()
                if solver.status == "failed":
                    return f"{name} stopped at t = {solver.t:.6g} s: {words}", Cause.NO_STEP
                _sample(solver, times, states)
    except OverBudget as error:
        return f"{name} gave up: {error}", Cause.BUDGET
    return "", None


def _sample(solver: OdeSolver, times: Array, states: list[Array]) -> None:
    due = times[len(states) :]
    due = due[due <= solver.t]
    if not due.size:
        return
    state = solver.dense_output() if due[0] < solver.t else None
    states.extend(
        solver.y.copy() if state is None or time == solver.t else state(time) for time in due
    )


def _member(method: type[OdeSolver]) -> Integrator:
    return Integrator(
        f"SciPy {method.__name__}",
        "SciPy",
        True,
        str,
        partial(_suits, method),
        partial(_prepare, method),
    )


MEMBERS = tuple(_member(method) for method in (RK45, DOP853, Radau, LSODA))
