"""Methods that are no members of `INTEGRATORS`: ours for one motion and for many, and diffrax'.

`mechanics.simulate` puts states back onto the constraints, which no other one does.
"""

import importlib.util
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

import numpy as np

from mechanics.compiled.model import Model
from mechanics.errors import MechanicsError
from mechanics.program import Program, interpret
from mechanics.program.jax_domain import jax_arrays
from mechanics.simulate.ensembles.library import Library
from mechanics.simulate.ensembles.motions import Motions
from mechanics.simulate.ensembles.run import SOURCES, Method, integrated, run_of
from mechanics.simulate.ensembles.settings import task_of
from mechanics.simulate.flow import flow
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import unsound
from mechanics.simulate.march import Tolerance
from mechanics.simulate.samples import sample
from mechanics.simulate.trajectory import Ending


def _any(_problem: Problem, _setting: Setting) -> str:
    return ""


def _simulate(problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    moving = flow(problem.model, problem.p, problem.signals, problem.inputs)
    size = setting.tolerance or 0.0
    by = Tolerance("DOP853", size, size)

    def solve() -> Outcome:
        count = 0

        def rate(t: float, y: np.ndarray) -> np.ndarray:
            nonlocal count
            count += 1
            return moving.rate(t, y)

        counted = replace(moving, rate=rate)
        found = sample(counted, problem.start, problem.times, by)
        ended = "" if found.ending is Ending.COMPLETE else found.ending.value
        return Outcome(found.states, count, ended)

    return solve


def _in_lanes(name: str, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    model, inputs = problem.model, problem.signals(0.0)
    motions = Motions(model, problem.start[None], inputs[None], problem.p[None], problem.times)
    by = Method(name, setting.tolerance or 0.0, problem.budget)
    task, rows = task_of(model, by, problem.times), motions.rows
    library = Library(task.held, task.moving, model.compiler or "", SOURCES[task.method.name])

    def solve() -> Outcome:
        found = integrated(library, task.method, *rows, task.times, 1)
        run = run_of(found, task.method, task.moving)
        reached = int(run.reached[0])
        ended = "" if reached == len(problem.times) else run.status[0].value
        return Outcome(run.states[0, :reached], int(run.evaluations[0]), ended)

    return solve


def _compiled(problem: Problem, _setting: Setting) -> str:
    if problem.model.compiler is None:
        return "no C compiler"
    return unsound(problem)


def _diffrax_absent() -> str:
    return "" if importlib.util.find_spec("diffrax") else "diffrax is not installed"


@lru_cache(maxsize=2)
def _jitted(solver: str, stages: int, model: Model, times: tuple[float, ...], budget: int) -> Any:
    """Of start, inputs and parameters in a row, and tolerance: compiled once for all of these."""
    import diffrax
    import jax

    jax.config.update("jax_enable_x64", True)
    known = model.right_hand_side
    term = diffrax.ODETerm(_in_jax(known.program, known.entries["y"]))

    def run(start: Any, held: Any, tolerance: Any) -> Any:
        return diffrax.diffeqsolve(
            term, getattr(diffrax, solver)(), 0.0, times[-1], None, start, held,
            saveat=diffrax.SaveAt(ts=jax.numpy.asarray(times)), throw=False,
            stepsize_controller=diffrax.PIDController(rtol=tolerance, atol=tolerance),
            max_steps=budget // stages, adjoint=diffrax.ForwardMode(),
        )  # fmt: skip

    return jax.jit(run)


def _diffrax(solver: str, stages: int, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    """Compiled by `jax.jit` before it is timed; stages of all steps count as evaluations."""
    run = _jitted(solver, stages, problem.model, tuple(problem.times.tolist()), problem.budget)
    held = np.concatenate([problem.signals(0.0), problem.p])

    def solve() -> Outcome:
        found = run(problem.start, held, setting.tolerance)
        states = np.asarray(found.ys)
        finite = np.all(np.isfinite(states), axis=1)
        reached = len(states) if finite.all() else int(np.argmin(finite))
        ended = "" if reached == len(states) else "more steps than are allowed, or not finite"
        return Outcome(states[:reached], stages * int(found.stats["num_steps"]), ended)

    solve()
    return solve


def _in_jax(program: Program, state: tuple[str, ...]) -> Callable[[Any, Any, Any], Any]:
    domain = jax_arrays()
    held = [name for name in program.inputs if name not in state]

    def rate(t: Any, y: Any, args: Any) -> Any:
        values = {name: args[i] for i, name in enumerate(held)}
        values |= {name: y[i] for i, name in enumerate(state)}
        if "t" in held:
            values["t"] = t
        (rates,) = interpret(program, domain, values, release=False).values()
        return domain.numpy.stack([domain.numpy.asarray(x, float) for x in rates])

    return rate


def _member(
    name: str, family: str, prepare: Callable[[Problem, Setting], Callable[[], Outcome]],
    suits: Callable[[Problem, Setting], str] = _any, available: Callable[[], str] = str,
) -> Integrator:  # fmt: skip
    return Integrator(name, family, True, available, suits, prepare)


OURS = (
    _member("simulate DOP853", "ours", _simulate),
    _member("ensemble Taylor", "ours", partial(_in_lanes, "taylor"), _compiled),
    _member("ensemble DOP853", "ours", partial(_in_lanes, "dop853"), _compiled),
)
DIFFRAX = tuple(
    _member(f"diffrax {solver}", "diffrax", partial(_diffrax, solver, stages),
            available=_diffrax_absent)
    for solver, stages in (("Tsit5", 6), ("Dopri8", 13))
)  # fmt: skip
OTHERS = ("SciPy RK45", "SciPy DOP853", "SciPy LSODA", "SciPy Radau", "SUNDIALS CVODES",
          "SUNDIALS CVODES Adams", "SUNDIALS IDAS", "heyoka Taylor", "C RK4", "C RK5", "C RK8",
          "C Gauss6")  # fmt: skip
METHODS = (*OURS, *(m for m in INTEGRATORS if m.name in OTHERS), *DIFFRAX)
"""All that run beside each other, ours first."""


def prepared(problem: Problem, setting: Setting) -> Callable[[], Outcome] | str:
    """A call that integrates, or why there is none."""
    member = next(m for m in METHODS if m.name == setting.integrator)
    why = member.available() or member.suits(problem, setting)
    if why:
        return why
    try:
        return member.prepare(problem, setting)
    except MechanicsError as error:
        return str(error)
