"""Along a motion, how far inside of its domain the model is.

margin_i(t, q, u) > 0    inside of condition i

Accelerations and reactions are those of the state, so that margins are functions of it and of time.
Reactions are the model's, or the free-body route's where the model does not tell them.

Friction is that of sliding, so that a motion in which something slides ends where that comes to
rest: whether it sticks there or slides back is not in the model.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model
from mechanics.compiled.margins import margins, slidings, telling
from mechanics.compiled.quantities import Quantity
from mechanics.routes.derivation import by_route
from mechanics.scene import Coulomb
from mechanics.scene.actions import frictions
from mechanics.scene.conditions import Condition
from mechanics.scene.validity import condition_parameters
from mechanics.simulate.graph_call import Call
from mechanics.simulate.values import read_inputs, read_parameters

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Domain:
    """The conditions of a scene with numbers bound.

    Attributes
    ----------
    conditions : tuple of Condition
    margins : callable
        Of (t, y): how far inside, shape (number of conditions,); in the units of the conditions.
    """

    conditions: tuple[Condition, ...]
    margins: Callable[[float, Array], Array]

    def broken(self, margins: Array) -> NDArray[np.bool_]:
        """Which conditions do not hold."""
        edge = np.array([condition.strict for condition in self.conditions], dtype=bool)
        return np.where(edge, margins <= 0, margins < 0)


EVERYWHERE = Domain((), lambda t, state: np.zeros(0))


def domain(
    model: Model,
    p: Array,
    inputs: Mapping[str, Any],
    parameters: Mapping[str, float],
    start: Array,
) -> Domain:
    """The domain of a model in a motion.

    Parameters
    ----------
    p : array
        Parameters in the model's order.
    inputs, parameters : mapping
        As they were given; parameters that only conditions use are read here.
    start : array, shape (n + m,)
        State in which the motion begins.

    Raises
    ------
    ValueMissingError
        For a parameter of a condition that has no value.
    InputError
        For a value that is no number or out of range.
    """
    scene = model.equations.scene
    if not scene.conditions:
        return EVERYWHERE
    graphs = telling(model, partial(by_route, "free_body"))
    known = graphs.quantities
    numbers = model.numbers(p) | own_values(model, parameters)
    symbols = [entry.symbol for entry in known.inputs]
    signals = read_inputs(scene, symbols, inputs)
    state = [ca.SX.sym(g, len(getattr(known, g))) for g in ("q", "u", "inputs")]
    constants = {symbol: ca.SX(value) for symbol, value in numbers.items()}
    n = len(scene.q)

    def along(graph: ca.SX) -> Callable[[float, Array], Array]:
        call = Call(ca.Function("along", state, [graph]))
        return lambda t, y: call(y[:n], y[n:], signals(t, y))[0][:, 0]

    inside = along(margins(graphs, state, constants))
    if not frictions(scene):
        return Domain(scene.conditions, inside)
    speeds = along(slidings(graphs, state, constants))
    sides = np.sign(speeds(0.0, start))
    kept = tuple(_sliding(load, side) for load, side in zip(frictions(scene), sides, strict=True))
    return Domain(
        (*scene.conditions, *kept),
        lambda t, y: np.concatenate([inside(t, y), sides * speeds(t, y)]),
    )


def _sliding(load: Coulomb, side: float) -> Condition:
    """That a friction goes on as it began."""
    relation = load.sliding < 0 if side < 0 else load.sliding > 0
    words = f"comes to rest where load {load.name} rubs, and sticking is not modelled"
    return Condition(f"sliding of {load.name}", relation, words)


def own_values(model: Model, parameters: Mapping[str, float]) -> dict[Any, float]:
    """Values of the parameters that only conditions use."""
    own = condition_parameters(model.equations.scene)
    given = {s.name: parameters[s.name] for s in own if s.name in parameters}
    entries = tuple(Quantity(s, getattr(s, "unit", "")) for s in own)
    return dict(zip(own, read_parameters(entries, {}, given).tolist(), strict=True))
