"""Many motions of one model: names and numbers, some of them arrays, read into rows.

{"theta": [2.5, 2.6], "x": 0.1}        two motions, with the same x
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Rational, Symbol, sympify

from mechanics.compiled.model import Model
from mechanics.compiled.quantities import typical_value
from mechanics.errors import InputError
from mechanics.program import Builder, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.sympy_reader import read
from mechanics.simulate.consistent import consistent_coordinates, consistent_speeds
from mechanics.simulate.constraints import manifolds, periodic
from mechanics.simulate.manifold import Manifold
from mechanics.simulate.values import (
    for_equations,
    read_initial,
    read_inputs,
    read_parameters,
)

Array = NDArray[np.float64]
Given = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class Motions:
    """What is integrated.

    Attributes
    ----------
    start : array, shape (batch, n + m)
        (q, u) at t = 0; on the constraints.
    inputs : array, shape (batch, k)
        In the model's order; the time, where it is among them, is zero.
    p : array, shape (batch, np)
        Parameters in the model's order.
    times : array, shape (N,)
        In s, increasing from 0.
    """

    model: Model
    start: Array
    inputs: Array
    p: Array
    times: Array

    def __len__(self) -> int:
        return len(self.start)

    @property
    def rows(self) -> tuple[Array, Array]:
        """States, with the time as the last entry if the equations hold it; and what is held."""
        start, inputs = self.start, self.inputs
        if self.model.right_hand_side.timed:
            at_time = self.model.entries["inputs"].index("t")
            start = np.column_stack([start, inputs[:, at_time]])
            inputs = np.delete(inputs, at_time, axis=1)
        return np.ascontiguousarray(start), np.ascontiguousarray(np.hstack([inputs, self.p]))


def read_motions(
    model: Model, times: Array, initial: Given, parameters: Given, inputs: Given
) -> Motions:
    """Names and values, numbers or arrays of one length; see `mechanics.ensemble`.

    Raises
    ------
    InputError
        For a name that does not exist, a value that is no number or out of range, arrays that
        differ in length, an input that is a function, or values that no configuration satisfies.
    ValueMissingError
        For a parameter that has no value.
    """
    groups = {"initial value": initial, "parameter": parameters, "input": inputs}
    given = {kind: _numbers(kind, values) for kind, values in groups.items()}
    count = _count(given)
    scene, known = model.equations.scene, model.quantities
    start, p, w = given.values()
    # The scalar readers judge names, and what is shared.
    ones = [{name: float(a.flat[0]) if a.size else 1.0 for name, a in group.items()}
            for group in (start, p, w)]  # fmt: skip
    suggested = read_initial(scene, ones[0])
    signals = read_inputs(scene, [entry.symbol for entry in known.inputs], ones[2])
    own = for_equations(scene, ones[1])
    motions = Motions(
        model,
        _columns([*suggested[0].names, *suggested[1].names], start,
                 np.concatenate([s.values for s in suggested]), count),
        _columns([e.name for e in known.inputs], w, signals(0.0), count),
        _parameters(model, {name: p[name] for name in own}, own, count),
        times,
    )  # fmt: skip
    return _consistent(motions, start) if scene.constraints or scene.rotations else motions


def _numbers(kind: str, values: Given) -> dict[str, Array]:
    if not isinstance(values, Mapping):
        raise InputError(
            f"{kind}s: {type(values).__name__} found: give a mapping of names to numbers or arrays"
        )
    found = {}
    for name, value in values.items():
        if callable(value):
            raise InputError(
                f"{kind} {name}: a function of time is found: an ensemble takes numbers; simulate"
                " the motions one by one"
            )
        try:
            array = np.asarray(value, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"{kind} {name}: {value!r} holds what is no number") from None
        if array.ndim > 1:
            raise InputError(
                f"{kind} {name}: shape {array.shape} found: give a number, or one for each motion"
            )
        wrong = np.flatnonzero(~np.isfinite(array))
        if wrong.size:
            raise InputError(f"{kind} {name}: {array.flat[wrong[0]]} is not finite")
        found[name] = array
    return found


def _count(given: Mapping[str, Mapping[str, Array]]) -> int:
    """Number of motions."""
    lengths = {f"{kind} {name}": len(a) for kind, group in given.items()
               for name, a in group.items() if a.ndim}  # fmt: skip
    if len(set(lengths.values())) > 1:
        words = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise InputError(f"arrays of one length are needed: {words} found")
    return next(iter(lengths.values()), 1)


def _columns(names: Sequence[str], given: Mapping[str, Array], rest: Array, count: int) -> Array:
    """One row a motion."""
    found = np.empty((count, len(names)))
    for k, (name, value) in enumerate(zip(names, rest, strict=True)):
        found[:, k] = given.get(name, value)
    return found


def _parameters(
    model: Model, given: Mapping[str, Any], one: Mapping[str, float], count: int
) -> Array:
    """Parameters of every motion; what is defined by others follows them."""
    known = model.quantities
    first = read_parameters(known.p, known.definitions, one)
    found = np.tile(first, (count, 1))
    many = {name: array for name, array in given.items() if array.ndim}
    symbols = {s.name: s for s in _symbols(model)}
    for name, array in many.items():
        if symbols[name].is_positive and np.any(array < 0):
            raise InputError(
                f"parameter {name}: {array.min():g} is negative: it is declared positive"
            )
    numbers = {symbols[name]: Rational(v) for name, v in one.items() if name not in many}
    table = {s: e for s, e in known.definitions.items() if s.name not in given} | numbers
    for k, entry in enumerate(known.p):
        if entry.name in many:
            found[:, k] = many[entry.name]
        elif entry.symbol in known.definitions and entry.name not in given:
            expression = _expanded(entry.symbol, table, set(many))
            if {s.name for s in expression.free_symbols} & set(many):
                found[:, k] = _evaluated(expression, many, count)
    return found


def _symbols(model: Model) -> set[Symbol]:
    known = model.quantities
    free = {s for e in known.definitions.values() for s in sympify(e).free_symbols}
    return {e.symbol for e in known.p} | set(known.definitions) | free


def _expanded(symbol: Symbol, table: Mapping[Symbol, Expr], many: set[str]) -> Expr:
    """The value of a parameter in terms of those that are arrays."""
    if symbol.name in many:
        return symbol
    if symbol not in table:
        return Rational(typical_value(symbol, {}))
    expression = sympify(table[symbol])
    free = expression.free_symbols
    return expression.xreplace({s: _expanded(s, table, many) for s in free})


def _evaluated(expression: Expr, many: Mapping[str, Array], count: int) -> Array:
    builder = Builder()
    program = builder.program({"value": read(builder, [expression])})
    columns = {name: many[name] for name in program.inputs}
    (value,) = interpret(program, Arrays(), columns)["value"]
    return np.broadcast_to(value, count)


def _consistent(motions: Motions, given: Mapping[str, Array]) -> Motions:
    """The same on the constraints, motion by motion."""
    model, scene = motions.model, motions.model.equations.scene
    start, n, bind = motions.start.copy(), len(scene.q), manifolds(scene)
    names = [e.name for e in model.quantities.inputs]

    @lru_cache(maxsize=1)
    def closed_by(p: tuple[float, ...], inputs: tuple[float, ...]) -> Manifold:
        held = dict(zip(names, inputs, strict=True))
        held.pop("t", None)
        return bind(model.numbers(p), held)

    for i in range(len(motions)):
        own = {name: float(np.broadcast_to(a, len(motions))[i]) for name, a in given.items()}
        closed = closed_by(tuple(motions.p[i].tolist()), tuple(motions.inputs[i].tolist()))
        q, u = read_initial(scene, own)
        start[i, :n], _ = consistent_coordinates(closed, 0.0, q, periodic(scene))
        start[i, n:] = consistent_speeds(closed, 0.0, start[i, :n], u)
    return Motions(model, start, motions.inputs, motions.p, motions.times)
