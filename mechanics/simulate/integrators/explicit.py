"""Explicit Runge-Kutta methods with fixed steps in the generated C.

The step is the graph of `mechanics.compiled.step`, the one that `write_c` exports for RK4; the loop
over steps is C, too. Without a compiler the graph runs on CasADi's virtual machine.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.evaluator import evaluator
from mechanics.compiled.model import Model
from mechanics.compiled.step import Rate, Tableau, runge_kutta
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import Routine
from mechanics.simulate.integrators.compiled_loop import call_inner, compiled_march
from mechanics.simulate.integrators.loop import march, refused
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import rate_entries, rate_function
from mechanics.simulate.integrators.stiffness import unstable

Array = NDArray[np.float64]

_steps: WeakKeyDictionary[Model, dict[str, tuple[ca.Function, Routine]]] = WeakKeyDictionary()

BODY = """
    for (long long i = 0; i < count; ++i) {{
        TIME(t + (@)i * h);
        {call};
    }}
    return count * {stages};"""


def step_function(model: Model, tableau: Tableau) -> ca.Function:
    """``step(y, inputs, p, h) -> y_next``."""
    y, w, p = rate_function(model).sx_in()
    h = ca.SX.sym("h")
    after = runge_kutta(tableau, _moved(model, w, p, h), y, h)
    return ca.Function("step", [y, w, p, h], ca.cse([after]), ["y", "inputs", "p", "h"], ["y_next"])


def _step(model: Model, tableau: Tableau) -> tuple[ca.Function, Routine]:
    """The step and its instructions, kept with the model."""
    known = _steps.setdefault(model, {})
    if tableau.name not in known:
        function = step_function(model, tableau)
        known[tableau.name] = function, read_routine(function)
    return known[tableau.name]


def _moved(model: Model, w: ca.SX, p: ca.SX, h: ca.SX) -> Rate:
    """The right-hand side with inputs held, but for time."""
    rate, names = rate_function(model), model.entries["inputs"]

    def at(y: ca.SX, share: Fraction | float) -> ca.SX:
        held = ca.SX(w)
        if "t" in names:
            held[names.index("t")] += float(share) * h
        return rate(y, held, p)

    return at


def _suits(tableau: Tableau, problem: Problem, setting: Setting) -> str:
    why = refused(problem, setting, len(tableau.a))
    return why or unstable(tableau, problem, setting.step)


def _prepare(tableau: Tableau, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    name, stages = f"C {tableau.name}", len(tableau.a)
    function, code = _step(problem.model, tableau)
    if problem.model.compiler is None:
        return march(name, problem, setting, _virtual(problem, setting.kind, function), stages)
    call = call_inner(code, y="y", inputs="inputs", p="p", h="&h", y_next="y")
    return compiled_march(name, problem, setting, code, BODY.format(call=call, stages=stages))


def _virtual(
    problem: Problem, kind: type[np.floating], function: ca.Function
) -> Callable[[Array, float, float], Array]:
    """The step on CasADi's virtual machine, or in NumPy where that has no such precision."""
    model = problem.model
    given = (problem.start, problem.signals(0.0), problem.p, [0.0])
    arrays = [np.array(array, dtype=kind) for array in given]
    after = np.zeros_like(arrays[0])
    entries = {**rate_entries(model), "h": ("h",)}
    run = evaluator(function, read_routine(function), entries, kind, None).bound(arrays, [after])
    time = model.entries["inputs"].index("t") if "t" in problem.varying else None

    def step(y: Array, t: float, h: float) -> Array:
        arrays[0][:], arrays[3][0] = y, h
        if time is not None:
            arrays[1][time] = t
        run()
        return after.astype(float)

    return step


def _member(tableau: Tableau) -> Integrator:
    return Integrator(
        f"C {tableau.name}",
        "C",
        False,
        str,
        partial(_suits, tableau),
        partial(_prepare, tableau),
    )


MEMBERS = tuple(_member(tableau) for tableau in TABLEAUX)
