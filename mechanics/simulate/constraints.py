"""The constraints of a scene as fast functions, with numbers bound.

    Phi(q, t)  and  Phi_q,      c(q, u, t) = A u - b  and  A = c_u

where c are the nonholonomic constraints and the rates of the holonomic ones. The Jacobians come
from CasADi's automatic differentiation.
"""

from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Symbol, cos, sin

from mechanics.compiled.translate import Translator
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table
from mechanics.simulate.graph_call import Call
from mechanics.simulate.manifold import Manifold
from mechanics.simulate.values import read_inputs

Array = NDArray[np.float64]


def manifold(
    scene: Scene, parameters: Mapping[Symbol, float], inputs: Mapping[str, Any]
) -> Manifold:
    """The constraints with parameters and inputs bound."""
    positions = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    table = rate_table(scene)
    speeds = [
        rate(plain, table) if constraint.holonomic else plain
        for constraint in scene.constraints
        for plain in [scene.plain(constraint.expression, constraint.name)]
    ]
    names = [c.name for c in scene.constraints if c.holonomic] + [
        f"rate of {c.name}" if c.holonomic else c.name for c in scene.constraints
    ]
    phi = _Bound(scene, positions, parameters, inputs)
    c = _Bound(scene, speeds, parameters, inputs)
    at, rest = len(scene.q), np.zeros(len(scene.u))
    return Manifold(
        at,
        tuple(names),
        lambda t, q: phi.with_jacobian(t, q, rest, "q"),
        lambda t, q, u: c.with_jacobian(t, q, u, "u"),
    )


def periodic(scene: Scene) -> tuple[bool, ...]:
    """For each coordinate whether it stands in the holonomic constraints only as sin q and cos q.

    Then a full turn of it changes nothing there.
    """
    expressions = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    circular = {f(q): 0 for q in scene.q for f in (sin, cos)}
    bare = {s for e in expressions for s in e.xreplace(circular).free_symbols}
    return tuple(q not in bare for q in scene.q)


class _Bound:
    """Expressions in q, u, inputs and parameters, of which only t, q and u are left open."""

    def __init__(
        self,
        scene: Scene,
        expressions: list[Expr],
        parameters: Mapping[Symbol, float],
        inputs: Mapping[str, Any],
    ) -> None:
        given = {*scene.q, *scene.u, *parameters}
        free = {s for e in expressions for s in e.free_symbols} - given
        signals = sorted(free, key=lambda symbol: symbol.name)
        self._signals = read_inputs(scene, signals, inputs)
        graphs = {symbol: ca.SX.sym(symbol.name) for symbol in (*scene.q, *scene.u, *signals)}
        graphs |= {symbol: ca.SX(value) for symbol, value in parameters.items()}
        translate = Translator(graphs)
        column = translate.column(expressions)
        if translate.constants:
            bound = [ca.SX(float(number.evalf(40))) for number in translate.constants]
            column = ca.substitute(
                column, ca.vertcat(*translate.constants.values()), ca.vertcat(*bound)
            )
        q, u, w = (
            ca.vertcat(*(graphs[s] for s in group)) if group else ca.SX(0, 1)
            for group in (scene.q, scene.u, signals)
        )
        self._jacobians = {
            name: Call([q, u, w], column, ca.densify(ca.jacobian(column, to)))
            for name, to in (("q", q), ("u", u))
        }

    def with_jacobian(self, t: float, q: Array, u: Array, by: str) -> tuple[Array, Array]:
        """Values, shape (k,), and their derivatives by ``"q"`` or ``"u"``, shape (k, n)."""
        value, jacobian = self._jacobians[by](q, u, self._signals(t))
        return value[:, 0], jacobian
