"""The right-hand side y' = f(y, inputs, p), y = (q, u), as one graph, compiled once.

    q' = N u + n,    u' = forward dynamics (q, u, inputs, p)

One function and one call: what both halves need is computed once.
"""

from collections.abc import Callable
from typing import Any
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.graphs import Graphs
from mechanics.compiled.machine.evaluator import evaluator
from mechanics.compiled.model import Model
from mechanics.program import Builder
from mechanics.program import Program as Straight
from mechanics.program.casadi_reader import read, read_routine
from mechanics.program.routine import Routine
from mechanics.simulate.integrators.problem import OverBudget, Problem

Array = NDArray[np.float64]

NEEDED = ("forward_dynamics", "coordinate_rates")

_functions: WeakKeyDictionary[Model, dict[str, ca.Function]] = WeakKeyDictionary()
_kernels: WeakKeyDictionary[Model, dict[Any, Any]] = WeakKeyDictionary()


def rate_function(model: Model) -> ca.Function:
    """``rate(y, inputs, p) -> yd``: CasADi graph, dense columns."""
    return _functions_of(model)["rate"]


def jacobian_function(model: Model) -> ca.Function:
    """``rate_jacobian(y, inputs, p) -> slope``: df/dy, (n + m) x (n + m), column by column."""
    known = _functions_of(model)
    if "rate_jacobian" not in known:
        y, w, p = (ca.SX.sym(name, size) for name, size in rate_program(model).inputs)
        slope = ca.densify(ca.jacobian(rate_function(model)(y, w, p), y))
        known["rate_jacobian"] = ca.Function(
            "rate_jacobian", [y, w, p], ca.cse([slope]), ["y", "inputs", "p"], ["slope"]
        )
    return known["rate_jacobian"]


def rate_program(model: Model) -> Routine:
    """Instructions of the right-hand side."""
    return read_routine(rate_function(model))


def motion_program(model: Model) -> Straight:
    """``yd`` of inputs by name; constants are the doubles of the graph."""
    function, names, builder = rate_function(model), rate_entries(model), Builder()
    arguments = {group: [*map(builder.input, entries)] for group, entries in names.items()}
    order = [entry for entries in names.values() for entry in entries]
    return builder.program(read(builder, function, arguments), order)


def rate_entries(model: Model) -> dict[str, tuple[str, ...]]:
    """Names of the entries of the inputs of the right-hand side."""
    known = model.entries
    return {"y": (*known["q"], *known["u"]), "inputs": known["inputs"], "p": known["p"]}


def motion_graphs(model: Model, form: str | None = None) -> Graphs:
    """The model's graphs, with what a motion needs even where the model is not asked for it.

    Parameters
    ----------
    form : str, optional
        Of forward dynamics, when it should be another than the model's.
    """
    missing = [name for name in NEEDED if name not in tuple(model.casadi)]
    if form is None and not missing:
        return model.casadi
    known = model.casadi
    return Graphs(known.derived, form or model.form, known.fixed, (*known, *missing))


def _functions_of(model: Model) -> dict[str, ca.Function]:
    if model not in _functions:
        _functions[model] = {"rate": _build(model)}
    return _functions[model]


def _build(model: Model) -> ca.Function:
    sizes = {group: len(getattr(model.quantities, group)) for group in ("q", "u", "inputs", "p")}
    y = ca.SX.sym("y", sizes["q"] + sizes["u"])
    w, p = (ca.SX.sym(group, sizes[group]) for group in ("inputs", "p"))
    state = (y[: sizes["q"]], y[sizes["q"] :], w, p)
    graphs = motion_graphs(model)
    rates = graphs["coordinate_rates"](*state)
    accelerations, _ = graphs["forward_dynamics"](*state)
    yd = ca.densify(ca.vertcat(rates, accelerations))
    return ca.Function("rate", [y, w, p], ca.cse([yd]), ["y", "inputs", "p"], ["yd"])


def _bound(
    model: Model, function: ca.Function, kind: type[np.floating], arrays: list[Any]
) -> Callable[[], None]:
    known = _kernels.setdefault(model, {})
    if (function.name(), kind) not in known:
        known[function.name(), kind] = evaluator(
            function, read_routine(function), rate_entries(model), kind, model.compiler, model.flags
        )
    call: Callable[[], None] = known[function.name(), kind].bound(arrays[:-1], arrays[-1:])
    return call


class Rate:
    """f(t, y) of a problem for integrators that are called from Python; counts its calls.

    Parameters
    ----------
    problem : Problem
    kind : numpy.float64 or numpy.float32
        The precision of the compiled right-hand side.

    Raises
    ------
    OverBudget
        When called more often than the problem allows.
    """

    def __init__(self, problem: Problem, kind: type[np.floating] = np.float64) -> None:
        model, size = problem.model, len(problem.start)
        self.evaluations = self.jacobians = 0
        self._problem, self._kind = problem, kind
        self._y, self._yd = np.zeros(size, kind), np.zeros(size, kind)
        self._w = np.asarray(problem.signals(0.0, problem.start), dtype=kind)
        self._p = np.asarray(problem.p, dtype=kind)
        arrays = [self._y, self._w, self._p, self._yd]
        self._run = _bound(model, rate_function(model), kind, arrays)
        self._varying, self._signals = bool(problem.varying), problem.signals
        self._slope = np.zeros(size * size, kind)
        self._run_slope: Callable[[], None] | None = None

    def __call__(self, t: float, y: Array) -> Array:
        """y', shape (n + m,), in double precision whatever computed it."""
        if self.evaluations >= self._problem.budget:
            raise OverBudget(f"{self.evaluations} evaluations are used up at t = {t:.6g} s")
        self.evaluations += 1
        self._y[:] = y
        if self._varying:
            self._w[:] = self._signals(t, y)
        self._run()
        return self._yd.astype(float)

    def jacobian(self, t: float, y: Array) -> Array:
        """df/dy, shape (n + m, n + m)."""
        if self._run_slope is None:
            arrays = [self._y, self._w, self._p, self._slope]
            function = jacobian_function(self._problem.model)
            self._run_slope = _bound(self._problem.model, function, self._kind, arrays)
        self.jacobians += 1
        self._y[:] = y
        if self._varying:
            self._w[:] = self._signals(t, y)
        self._run_slope()
        size = len(self._y)
        return self._slope.astype(float).reshape(size, size).T


def unsound(problem: Problem) -> str:
    """Why no motion starts there, or empty: a number or a rate that is not finite is named."""
    model = problem.model
    names = (*model.entries["q"], *model.entries["u"])
    given = [*zip(names, problem.start, strict=True)]
    given += [*zip(model.entries["p"], problem.p, strict=True)]
    given += [*zip(model.entries["inputs"], problem.signals(0.0, problem.start), strict=True)]
    for name, value in given:
        if not np.isfinite(value):
            return f"{name} is {value}: a finite number is needed"
    for name, value in zip(names, Rate(problem)(0.0, problem.start), strict=True):
        if not np.isfinite(value):
            return f"the rate of {name} is not finite at the start: the motion is singular there"
    return ""
