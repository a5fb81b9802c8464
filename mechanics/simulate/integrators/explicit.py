"""Explicit Runge-Kutta methods with fixed steps in the generated C.

The step is the graph of `mechanics.compiled.step`, the one that `write_c` exports for RK4; the loop
over steps is C, too. Without a compiler the graph runs on CasADi's virtual machine.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.right_hand_side import Compiled
from mechanics.compiled.step import Tableau
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.simulate.integrators.compiled_loop import call_inner, compiled_march
from mechanics.simulate.integrators.loop import march, refused
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.stiffness import unstable

Array = NDArray[np.float64]

BODY = """
    for (long long i = 0; i < count; ++i) {{
        TIME(t + (@)i * h);
        {call};
    }}
    return count * {stages};"""


def _suits(tableau: Tableau, problem: Problem, setting: Setting) -> str:
    why = refused(problem, setting, len(tableau.a))
    return why or unstable(tableau, problem, setting.step)


def _prepare(tableau: Tableau, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    name, stages = f"C {tableau.name}", len(tableau.a)
    code = problem.model.right_hand_side.steps[tableau.name].compiled
    if problem.model.compiler is None:
        return march(name, problem, setting, _virtual(problem, setting.kind, code), stages)
    call = call_inner(code.routine, y="y", inputs="inputs", p="p", h="&h", y_next="y")
    return compiled_march(name, problem, setting, code, BODY.format(call=call, stages=stages))


def _virtual(
    problem: Problem, kind: type[np.floating], code: Compiled
) -> Callable[[Array, float, float], Array]:
    """The step on CasADi's virtual machine, or in NumPy where that has no such precision."""
    model = problem.model
    given = (problem.start, problem.signals(0.0), problem.p, [0.0])
    arrays = [np.array(array, dtype=kind) for array in given]
    after = np.zeros_like(arrays[0])
    run = code.kernel(kind).bound(arrays, [after])
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
