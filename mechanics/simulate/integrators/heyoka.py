"""Taylor's method with adaptive order and step, compiled by heyoka: an optional extra.

Biscani and Izzo, Revisiting high-order Taylor methods for astrodynamics and celestial mechanics,
MNRAS 504 (2021). The model's instructions become heyoka's expressions, and these, derivatives
included, machine code. A step of order n is counted as n evaluations of the right-hand side.
"""

import importlib.util
import math
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mechanics.program import Program, interpret
from mechanics.simulate.integrators.loop import stopped
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting

NAME = "heyoka Taylor"
# Programs longer than this are compiled as loops: straight code would take a minute.
LONG = 250

FUNCTIONS = (
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh",
    "asinh", "acosh", "atanh", "erf",
)  # fmt: skip
ARITHMETIC = {
    "add": operator.add, "subtract": operator.sub, "multiply": operator.mul,
    "divide": operator.truediv, "negate": operator.neg, "power": operator.pow,
}  # fmt: skip


@dataclass(frozen=True)
class Expressions:
    """The domain of heyoka's expressions.

    Attributes
    ----------
    kind : callable
        The precision of constants, from a whole number.
    """

    kind: Callable[[int], Any] = float

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """Those that heyoka has."""
        import heyoka

        return {**ARITHMETIC, **{name: getattr(heyoka, name) for name in FUNCTIONS}}

    def constant(self, value: Fraction) -> Any:
        """The nearest number of the precision, by one division."""
        import heyoka

        return heyoka.expression(self.kind(value.numerator) / self.kind(value.denominator))

    def pi(self) -> Any:
        """The nearest double to pi."""
        return self.constant(Fraction(math.pi))


def _available() -> str:
    if importlib.util.find_spec("heyoka") is None:
        return "heyoka is not installed: pip install 'mechanics[taylor]'"
    return ""


def _suits(problem: Problem, setting: Setting) -> str:
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        return f"inputs are numbers for heyoka, and {', '.join(moved)} is a function of time"
    unknown = set(problem.model.right_hand_side.program.counts()) - {*FUNCTIONS, *ARITHMETIC}
    if unknown:
        return f"heyoka has no operation {', '.join(sorted(unknown))}"
    finest = float(np.finfo(setting.kind).eps)
    if setting.tolerance is None or not finest <= setting.tolerance < 1:
        return f"a tolerance from {finest:.1g} to 1 is needed, {setting.tolerance} found"
    return ""


def _prepare(problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    import heyoka

    kind: Any = np.float32 if setting.arithmetic == "single" else float
    solver = _solver(problem, setting, kind)
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
    """The compiled integrator; every call sets the time, the state and the parameters anew.

    What was compiled before in this process heyoka does not compile again.
    """
    import heyoka

    known = problem.model.right_hand_side
    return heyoka.taylor_adaptive(
        equations(known.program, known.entries["y"]),
        np.array(problem.start, dtype=kind),
        time=kind(0),
        tol=kind(setting.tolerance),
        fp_type=kind,
        compact_mode=known.program.count > LONG,
    )


def equations(
    program: Program, state: Sequence[str], kind: Callable[[int], Any] = float
) -> list[tuple[Any, Any]]:
    """Pairs (state, rate) of heyoka's expressions.

    Parameters
    ----------
    program : Program
        Rates of the state. An input ``"t"`` is the time; all others are heyoka's parameters, in a
        row.
    state : sequence of str
        The inputs that move.
    kind : callable
        The precision of constants, from a whole number.
    """
    import heyoka

    variables = [heyoka.expression(f"y{i}") for i in range(len(state))]
    held = [name for name in program.inputs if name not in state]
    given = {name: heyoka.par[i] for i, name in enumerate(held)}
    given |= dict(zip(state, variables, strict=True))
    if "t" in held:
        given["t"] = heyoka.time
    (rates,) = interpret(program, Expressions(kind), given).values()
    return list(zip(variables, rates, strict=True))


def _why(heyoka: Any, outcome: Any, limit: int) -> str:
    if outcome == heyoka.taylor_outcome.step_limit:
        return f"more than {limit} steps, which the budget does not allow"
    return "the state is not finite: the motion is singular there"


MEMBERS = (Integrator(NAME, "heyoka", True, _available, _suits, _prepare),)
