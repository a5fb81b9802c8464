"""Along a motion, how far inside of its domain the model is.

margin_i(t, q, u) > 0    inside of condition i

Accelerations and reactions are those of the state, so that margins are functions of it and of time.
Reactions are the model's, or the free-body route's where the model does not tell them.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model
from mechanics.compiled.margins import margins, telling
from mechanics.compiled.quantities import Quantity
from mechanics.routes import free_body
from mechanics.scene.conditions import Condition, condition_parameters
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
    model: Model, p: Array, inputs: Mapping[str, Any], parameters: Mapping[str, float]
) -> Domain:
    """The domain of a model.

    Parameters
    ----------
    model : Model
    p : array
        Parameters in the model's order.
    inputs, parameters : mapping
        As they were given; parameters that only conditions use are read here.

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
    graphs = telling(model, free_body.derive)
    known = graphs.quantities
    numbers = model.numbers(p) | own_values(model, parameters)
    symbols = [entry.symbol for entry in known.inputs]
    signals = read_inputs(scene, symbols, inputs)
    state = [ca.SX.sym(g, len(getattr(known, g))) for g in ("q", "u", "inputs")]
    constants = {symbol: ca.SX(value) for symbol, value in numbers.items()}
    call = Call(state, margins(graphs, state, constants))
    n = len(scene.q)
    return Domain(scene.conditions, lambda t, y: call(y[:n], y[n:], signals(t, y))[0][:, 0])


def own_values(model: Model, parameters: Mapping[str, float]) -> dict[Any, float]:
    """Values of the parameters that only conditions use."""
    own = condition_parameters(model.equations.scene)
    given = {s.name: parameters[s.name] for s in own if s.name in parameters}
    entries = tuple(Quantity(s, getattr(s, "unit", "")) for s in own)
    return dict(zip(own, read_parameters(entries, {}, given).tolist(), strict=True))
