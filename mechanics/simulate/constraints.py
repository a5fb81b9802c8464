"""The constraints of a scene as programs and fast functions.

    Phi(q, t)  and  Phi_q,      c(q, u, t) = A u - b  and  A = c_u

where c are the nonholonomic constraints and the rates of the holonomic ones. The norms of
quaternions are in Phi; their rates are zero at all speeds.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Symbol, cos, sin

from mechanics.program import Builder, Program
from mechanics.program.casadi_printer import print_function
from mechanics.program.forward import tangent
from mechanics.program.sympy_reader import read
from mechanics.scene import Scene
from mechanics.scene.rates import TIME, rate, rate_table
from mechanics.scene.symbols import DOTS
from mechanics.simulate.graph_call import Call
from mechanics.simulate.manifold import Manifold
from mechanics.simulate.values import read_inputs

Array = NDArray[np.float64]


def manifold(
    scene: Scene, parameters: Mapping[Symbol, float], inputs: Mapping[str, Any]
) -> Manifold:
    """The constraints with parameters and inputs bound."""
    return manifolds(scene)(parameters, inputs)


def manifolds(
    scene: Scene,
) -> Callable[[Mapping[Symbol, float], Mapping[str, Any]], Manifold]:
    """`manifold` of one scene, for many parameters and inputs: a binding takes microseconds."""
    names = [c.name for c in scene.constraints if c.holonomic]
    names += [f"norm of {rotation.name}" for rotation in scene.rotations]
    names += [f"rate of {c.name}" if c.holonomic else c.name for c in scene.constraints]
    phi, c = constraint_programs(scene)
    functions = _function(scene, phi, len(scene.q)), _function(scene, c, len(scene.u))
    rest = np.zeros(len(scene.u))

    def bind(parameters: Mapping[Symbol, float], inputs: Mapping[str, Any]) -> Manifold:
        position, speed = (_bound(scene, each, parameters, inputs) for each in functions)
        return Manifold(len(scene.q), tuple(names), lambda t, q: position(t, q, rest), speed)

    return bind


def constraint_programs(scene: Scene) -> tuple[Program, Program]:
    """Phi and Phi_q, then c and c_u: outputs ``"value"`` and ``"slope"``, this row by row.

    Inputs are q, u, parameters, inputs and their rates, by name.
    """
    plain = [scene.plain(c.expression, c.name) for c in scene.constraints]
    holonomic = [c.holonomic for c in scene.constraints]
    table = rate_table(scene)
    positions = [each for each, held in zip(plain, holonomic, strict=True) if held]
    speeds = [
        rate(each, table) if held else each for each, held in zip(plain, holonomic, strict=True)
    ]
    return _with_slope([*positions, *scene.norms], scene.q), _with_slope(speeds, scene.u)


def periodic(scene: Scene) -> tuple[bool, ...]:
    """For each coordinate whether it stands in the holonomic constraints only as sin q and cos q.

    Then a full turn of it changes nothing there.
    """
    expressions = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    expressions += scene.norms
    circular = {f(q): 0 for q in scene.q for f in (sin, cos)}
    bare = {s for e in expressions for s in e.xreplace(circular).free_symbols}
    return tuple(q not in bare for q in scene.q)


def _with_slope(expressions: Sequence[Expr], by: Sequence[Symbol]) -> Program:
    """Expressions and their derivatives."""
    builder = Builder()
    values = read(builder, expressions)
    columns = [tangent(values, {builder.input(x.name): builder.one}) for x in by]
    rows = zip(*columns, strict=True)
    return builder.program({"value": values, "slope": [entry for row in rows for entry in row]})


class _Function(NamedTuple):
    """A function of q, u, inputs and parameters, and names of the latter two."""

    graph: ca.Function
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]


def _function(scene: Scene, program: Program, columns: int) -> _Function:
    q, u = (tuple(s.name for s in group) for group in (scene.q, scene.u))
    given = {TIME.name, *(s.name + dots for s in scene.input_symbols for dots in DOTS)}
    inputs = tuple(name for name in program.inputs if name in given)
    parameters = tuple(n for n in program.inputs if n not in {*q, *u, *inputs})
    groups = {"q": q, "u": u, "inputs": inputs, "p": parameters}
    shapes = {"slope": (len(program.outputs["value"]), columns)}
    graph = print_function(program, "constraints", groups, shapes)
    return _Function(graph, inputs, parameters)


def _bound(
    scene: Scene,
    function: _Function,
    parameters: Mapping[Symbol, float],
    inputs: Mapping[str, Any],
) -> Callable[[float, Array, Array], tuple[Array, Array]]:
    """Values, shape (k,), and derivatives, shape (k, n), as a function of (t, q, u)."""
    numbers = {symbol.name: value for symbol, value in parameters.items()}
    p = np.array([numbers[name] for name in function.parameters], dtype=float)
    symbols = [TIME if n == TIME.name else Symbol(n, real=True) for n in function.inputs]
    signals, call = read_inputs(scene, symbols, inputs), Call(function.graph)

    def values(t: float, q: Array, u: Array) -> tuple[Array, Array]:
        value, slope = call(q, u, signals(t), p)
        return value[:, 0], slope

    return values
