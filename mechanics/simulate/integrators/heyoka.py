"""Taylor's method with adaptive order and step, compiled by heyoka: an optional extra.

Biscani and Izzo, Revisiting high-order Taylor methods for astrodynamics and celestial mechanics,
MNRAS 504 (2021). The model's instructions become heyoka's expressions, and these, derivatives
included, machine code. A step of order n is counted as n evaluations of the right-hand side.
"""

import functools
import importlib.util
from collections.abc import Callable, Sequence
from typing import Any
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np

from mechanics.compiled.model import Model
from mechanics.compiled.programs.program import Program
from mechanics.simulate.integrators.loop import stopped
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import rate_program

NAME = "heyoka Taylor"
_solvers: WeakKeyDictionary[Model, dict[Setting, Any]] = WeakKeyDictionary()
# Programs longer than this are compiled as loops: straight code would take a minute.
LONG = 250

UNARY = {
    ca.OP_SQRT: "sqrt", ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TAN: "tan",
    ca.OP_ASIN: "asin", ca.OP_ACOS: "acos", ca.OP_ATAN: "atan",
    ca.OP_SINH: "sinh", ca.OP_COSH: "cosh", ca.OP_TANH: "tanh",
    ca.OP_ASINH: "asinh", ca.OP_ACOSH: "acosh", ca.OP_ATANH: "atanh",
    ca.OP_EXP: "exp", ca.OP_LOG: "log", ca.OP_ERF: "erf",
}  # fmt: skip

ALGEBRA: dict[int, Callable[..., Any]] = {
    ca.OP_ASSIGN: lambda x: x,
    ca.OP_ADD: lambda x, y: x + y,
    ca.OP_SUB: lambda x, y: x - y,
    ca.OP_MUL: lambda x, y: x * y,
    ca.OP_DIV: lambda x, y: x / y,
    ca.OP_NEG: lambda x: -x,
    ca.OP_SQ: lambda x: x * x,
    ca.OP_TWICE: lambda x: 2.0 * x,
    ca.OP_INV: lambda x: 1.0 / x,
    ca.OP_POW: lambda x, y: x**y,
    ca.OP_CONSTPOW: lambda x, y: x**y,
}
KNOWN = frozenset((*UNARY, *ALGEBRA, ca.OP_INPUT, ca.OP_CONST))


def _available() -> str:
    if importlib.util.find_spec("heyoka") is None:
        return "heyoka is not installed: pip install 'mechanics[taylor]'"
    return ""


def _suits(problem: Problem, setting: Setting) -> str:
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        return f"inputs are numbers for heyoka, and {', '.join(moved)} is a function of time"
    unknown = {node.operation for node in rate_program(problem.model).nodes} - KNOWN
    if unknown:
        return f"heyoka has no CasADi operation {', '.join(map(str, sorted(unknown)))}"
    finest = float(np.finfo(setting.kind).eps)
    if setting.tolerance is None or not finest <= setting.tolerance < 1:
        return f"a tolerance from {finest:.1g} to 1 is needed, {setting.tolerance} found"
    return ""


def _prepare(problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    import heyoka

    kind: Any = np.float32 if setting.arithmetic == "single" else float
    known = _solvers.setdefault(problem.model, {})
    if setting not in known:
        known[setting] = _solver(problem, setting, kind)
    solver = known[setting]
    start = np.array(problem.start, dtype=kind)
    held = np.concatenate([problem.signals(0.0), problem.p]).astype(kind)
    times = problem.times.astype(kind)
    limit = max(1, problem.budget // solver.order)

    def solve() -> Outcome:
        solver.time, solver.state[:] = kind(0), start
        # Heyoka counts parameters up to the last that occurs: a form may do without some.
        solver.pars[:] = held[: len(solver.pars)]
        result = solver.propagate_grid(times, max_steps=limit)
        states = np.vstack([problem.start, np.asarray(result[5], dtype=float)[1:]])
        finite = np.all(np.isfinite(states), axis=1)
        reached = len(states) if finite.all() else int(np.argmin(finite))
        words = ""
        if reached < len(times):
            words = stopped(NAME, float(times[reached - 1]), _why(heyoka, result[0], limit))
        return Outcome(states[:reached], int(result[3]) * solver.order, words)

    return solve


def _solver(problem: Problem, setting: Setting, kind: Any) -> Any:
    """The compiled integrator; kept with the model, because compiling takes longer than using it.

    Every call sets the time, the state and the parameters anew.
    """
    import heyoka

    names, code = problem.model.entries["inputs"], rate_program(problem.model)
    return heyoka.taylor_adaptive(
        equations(code, names.index("t") if "t" in names else None),
        np.array(problem.start, dtype=kind),
        time=kind(0),
        tol=kind(setting.tolerance),
        fp_type=kind,
        compact_mode=code.operations > LONG,
    )


def equations(code: Program, time: int | None) -> list[tuple[Any, Any]]:
    """Pairs (state, rate) of heyoka's expressions.

    Parameters
    ----------
    code : Program
        ``rate(y, inputs, p, ...)``.
    time : int or None
        Which of the inputs is the time; all else but y are heyoka's parameters, in a row.
    """
    import heyoka

    state = heyoka.make_vars(*(f"y{i}" for i in range(code.inputs[0][1])))
    state = state if isinstance(state, list | tuple) else [state]
    given: list[list[Any]] = [list(state)]
    start = 0
    for _, size in code.inputs[1:]:
        given.append([heyoka.par[i] for i in range(start, start + size)])
        start += size
    if time is not None:
        given[1][time] = heyoka.time
    return list(zip(state, expressions(code, given)[0], strict=True))


def expressions(code: Program, given: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """Outputs of a program as heyoka's expressions, by output, from those of its inputs."""
    import heyoka

    values: list[Any] = []
    for operation, operands, constant in code.nodes:
        if constant is not None:
            values.append(heyoka.expression(constant))
        elif operation == ca.OP_INPUT:
            values.append(given[operands[0]][operands[1]])
        else:
            values.append(_function(heyoka, operation)(*(values[k] for k in operands)))
    return [[values[k] for k in nodes] for nodes in code.outputs]


def _function(heyoka: Any, operation: int) -> Callable[..., Any]:
    if operation in ALGEBRA:
        return ALGEBRA[operation]
    return functools.partial(getattr(heyoka, UNARY[operation]))


def _why(heyoka: Any, outcome: Any, limit: int) -> str:
    if outcome == heyoka.taylor_outcome.step_limit:
        return f"more than {limit} steps, which the budget does not allow"
    return "the state is not finite: the motion is singular there"


MEMBERS = (Integrator(NAME, "heyoka", True, _available, _suits, _prepare),)
