"""Integrators that CasADi brings: SUNDIALS' CVODES and IDAS, fixed-step Runge-Kutta and Gauss.

They call the right-hand side, and its Jacobian, as functions of a shared library that is compiled
from CasADi's own C; calls are counted there. Without a compiler it is CasADi's virtual machine.
Hindmarsh et al., SUNDIALS, ACM TOMS 31 (2005): variable order and step; BDF is for stiff problems.

Whether the equations of Gauss's steps are solved shows when the rates are integrated, too:

    y(t) - y(0) - sum_i h b_i f(v_i) = 0    as the polynomials through v_i have the slopes f(v_i)
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import casadi as ca
import numpy as np

from mechanics.compiled.step import RK4
from mechanics.simulate.integrators.external import Counters, external
from mechanics.simulate.integrators.loop import plan, refused
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.stiffness import unstable


@dataclass(frozen=True)
class Plugin:
    """One of CasADi's integrators.

    Attributes
    ----------
    name : str
        Of the member.
    plugin : str
        What CasADi calls it.
    options : mapping
    stages : int
        Evaluations of a fixed step, about; 0 for methods that choose their steps.
    """

    name: str
    family: str
    plugin: str
    options: dict[str, Any] = field(default_factory=dict)
    stages: int = 0


SOLVED = 1e-12
"""Residual below which the equations of a step count as solved."""

PLUGINS = (
    Plugin("SUNDIALS CVODES", "SUNDIALS", "cvodes", {"linear_multistep_method": "bdf"}),
    Plugin(
        "SUNDIALS CVODES Adams",
        "SUNDIALS",
        "cvodes",
        {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"},
    ),
    Plugin("SUNDIALS IDAS", "SUNDIALS", "idas"),
    Plugin("CasADi RK4", "CasADi", "rk", {}, 4),
    Plugin(
        "CasADi Gauss6",
        "CasADi",
        "collocation",
        {
            "collocation_scheme": "legendre",
            "interpolation_order": 3,
            # An error of the root finder would print its arguments: `_unsolved` tells instead.
            "rootfinder_options": {
                "show_eval_warnings": False,
                "error_on_fail": False,
                "abstol": SOLVED,
                "max_iter": 20,
            },
        },
        12,
    ),
)


def _suits(plugin: Plugin, problem: Problem, setting: Setting) -> str:
    if setting.arithmetic != "double":
        return "CasADi computes in double precision only"
    if plugin.stages:
        if why := refused(problem, setting, plugin.stages):
            return why
        if plugin.plugin == "rk" and (why := unstable(RK4, problem, setting.step)):
            return why
        if problem.model.compiler is None and plugin.plugin == "collocation":
            return "without a C compiler its evaluations cannot be counted"
        return ""
    if setting.tolerance is None or not 0 < setting.tolerance < 1:
        return f"a tolerance between 0 and 1 is needed, {setting.tolerance} found"
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        return f"inputs are numbers for CasADi, and {', '.join(moved)} is a function of time"
    return ""


def _prepare(plugin: Plugin, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    rate, counters = external(problem.model)
    y, t = ca.MX.sym("y", len(problem.start)), ca.MX.sym("t")
    w, p = ca.MX(ca.DM(problem.signals(0.0))), ca.MX.sym("p", len(problem.p))
    if "t" in problem.varying:
        w[problem.model.entries["inputs"].index("t")] = t
    options = {**plugin.options, **_accuracy(plugin, problem, setting), "show_eval_warnings": False}
    dae = {"x": y, "t": t, "p": p, "ode": rate(y, w, p)}
    times = problem.times.tolist()
    solver = ca.integrator("solver", plugin.plugin, dae, times[0], times[1:], options)
    unsolved = ""
    if plugin.plugin == "collocation":
        dae["quad"] = dae["ode"]
        both = ca.integrator("solver", plugin.plugin, dae, times[0], times[1:], options)
        unsolved = _unsolved(both, problem, options["number_of_finite_elements"])

    def solve() -> Outcome:
        before = counters()
        if unsolved:
            return Outcome(problem.start[None, :], 0, f"{plugin.name} stopped: {unsolved}")
        try:
            found = solver(x0=problem.start, p=problem.p)["xf"]
        except RuntimeError as error:
            spent = _spent(plugin, solver, counters, before)
            words = f"{plugin.name} stopped: {_reason(error)}"
            return Outcome(problem.start[None, :], *spent[:1], words, *spent[1:])
        states = np.vstack([problem.start, np.array(found).T])
        spent = _spent(plugin, solver, counters, before)
        finite = np.all(np.isfinite(states), axis=1)
        if not finite.all():
            reached = int(np.argmin(finite))
            words = f"{plugin.name} stopped before t = {times[reached]:.6g} s: not finite"
            return Outcome(states[:reached], spent[0], words, spent[1])
        return Outcome(states, spent[0], "", spent[1])

    return solve


def _unsolved(both: ca.Function, problem: Problem, steps: int) -> str:
    """Whether the equations of some step are not solved; the steps are those of the solver.

    Parameters
    ----------
    both : ca.Function
        The solver, with the integrals of the rates as quadratures.
    """
    found = both(x0=problem.start, p=problem.p)
    states, slopes = np.array(found["xf"]), np.array(found["qf"])
    left = np.abs(states - problem.start[:, None] - slopes)
    size = np.abs(states) + np.abs(slopes) + np.abs(problem.start[:, None])
    limit = steps * (10 * SOLVED + 100 * np.finfo(float).eps * size)
    bad = ~np.all(left <= limit, axis=0)
    if not bad.any():
        return ""
    reached = problem.times[1:][int(np.argmax(bad))]
    return f"the equations of a step before t = {reached:.6g} s cannot be solved: it is too long"


def _accuracy(plugin: Plugin, problem: Problem, setting: Setting) -> dict[str, Any]:
    if plugin.stages:
        steps = plan(problem.times, setting.step or 0.0)
        total = sum(count for count, _ in steps)
        # CasADi rounds up in every span: one less keeps a rounding from adding a step to each.
        return {"number_of_finite_elements": total - (len(steps) > 1)}
    return {
        "reltol": setting.tolerance,
        "abstol": setting.tolerance,
        # For each of the times; a step takes one evaluation or more.
        "max_num_steps": max(100, problem.budget // (len(problem.times) - 1)),
        "disable_internal_warnings": True,
    }


def _spent(
    plugin: Plugin, solver: ca.Function, counters: Counters, before: tuple[int, int]
) -> tuple[int, int]:
    """Evaluations of the right-hand side and of its Jacobian."""
    if counters.counted:
        after = counters()
        return after[0] - before[0], after[1] - before[1]
    stats = solver.stats()
    if plugin.stages:
        return plugin.stages * int(stats["n_call_step"]), 0
    return int(stats["nfevals"]), int(stats["n_call_jacF"])


def _reason(error: RuntimeError) -> str:
    """What SUNDIALS says, on one line."""
    text = str(error)
    for code, words in REASONS.items():
        if code in text:
            return words
    return text.strip().splitlines()[-1].strip()


REASONS = {
    "CV_FIRST_RHSFUNC_ERR": "the rates are not finite at the start",
    "CV_UNREC_RHSFUNC_ERR": "the rates are not finite on the way",
    "CV_REPTD_RHSFUNC_ERR": "the rates are not finite on the way",
    "IDA_RES_FAIL": "the rates are not finite on the way",
    "IDA_REP_RES_ERR": "the rates are not finite on the way",
    "CV_TOO_MUCH_WORK": "more steps between two of the times than the budget allows",
    "IDA_TOO_MUCH_WORK": "more steps between two of the times than the budget allows",
    "CV_TOO_MUCH_ACC": "the tolerance is finer than double precision can meet",
    "IDA_TOO_MUCH_ACC": "the tolerance is finer than double precision can meet",
    "CV_ERR_FAILURE": "no step meets the tolerance",
    "IDA_ERR_FAIL": "no step meets the tolerance",
    "CV_CONV_FAILURE": "the equations of a step cannot be solved",
    "IDA_CONV_FAIL": "the equations of a step cannot be solved",
}


def _member(plugin: Plugin) -> Integrator:
    return Integrator(
        plugin.name,
        plugin.family,
        not plugin.stages,
        str,
        partial(_suits, plugin),
        partial(_prepare, plugin),
    )


MEMBERS = tuple(_member(plugin) for plugin in PLUGINS)
