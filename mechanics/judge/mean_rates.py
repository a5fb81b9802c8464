"""Rates of the state by compiled equations: at a state, or the mean ones over a step from there.

euler                  f(y)
semi-implicit euler    u' = f_u(q, u), then q' = f_q(q, u + h u')
rk4                    (k1 + 2 k2 + 2 k3 + k4) / 6
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model

State = Mapping[str, float]
"""Coordinates, speeds, inputs and parameters by plain name."""

Array = NDArray[np.float64]


def mean_rates(model: Model, state: State, step: float, integrator: str) -> Array:
    """(y(t + h) - y(t)) / h for y = (q, u), in the order of the scene; y' itself where h is 0.

    Parameters
    ----------
    model : Model
        Without constraints.
    state : mapping of str to float
    step : float
        h, in s.
    integrator : str
        One of `mechanics.claims.code.black_box.INTEGRATORS`.

    Raises
    ------
    SingularError
        Where the equations do not determine the accelerations.
    """
    if not step or integrator == "euler":
        return _rates(model, state)
    first = _rates(model, state)
    if integrator == "semi-implicit euler":
        held = len(model.equations.scene.q)
        faster = np.concatenate([np.zeros(held), first[held:]])
        after = _rates(model, _moved(model, state, faster, step))
        return np.concatenate([after[:held], first[held:]])
    second = _rates(model, _moved(model, state, first, step / 2))
    third = _rates(model, _moved(model, state, second, step / 2))
    fourth = _rates(model, _moved(model, state, third, step))
    return (first + 2 * second + 2 * third + fourth) / 6


def _rates(model: Model, state: State) -> Array:
    scene = model.equations.scene
    q, u, inputs = (
        [state[s.name] for s in group] for group in (scene.q, scene.u, scene.input_symbols)
    )
    given = {symbol.name: state[symbol.name] for symbol in scene.parameters}
    qd = model.coordinate_rates(q, u, given, inputs=inputs or None)
    ud = model.forward_dynamics(q, u, given, inputs=inputs or None)
    return np.concatenate([np.asarray(qd).reshape(-1), np.asarray(ud).reshape(-1)])


def _moved(model: Model, state: State, rates: Array, time: float) -> State:
    scene = model.equations.scene
    names = [symbol.name for symbol in (*scene.q, *scene.u)]
    return {**state, **{n: state[n] + time * r for n, r in zip(names, rates, strict=True)}}
