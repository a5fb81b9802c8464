"""The right-hand side of y' = f(t, y), y = (q, u), from a compiled model.

q' = N u + n,    u' = forward dynamics (q, u, inputs(t), p)
"""

from collections.abc import Callable, Mapping
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.graphs import STATE
from mechanics.compiled.model import Model
from mechanics.simulate.constraints import manifold
from mechanics.simulate.graph_call import Call
from mechanics.simulate.manifold import Manifold
from mechanics.simulate.march import Flow
from mechanics.simulate.singular import Linear
from mechanics.simulate.values import Signals

Array = NDArray[np.float64]


def flow(model: Model, p: Array, signals: Signals, inputs: Mapping[str, Any]) -> Flow:
    """Everything that the integrator asks for, with numbers bound.

    Parameters
    ----------
    p : array
        Parameters in the model's order.
    signals : Signals
        Of the model's inputs.
    inputs : mapping
        What the signals were read from: constraints may need other rates of it.
    """
    scene, n = model.equations.scene, len(model.quantities.q)
    numbers = model.numbers(p)
    calls = [model.buffer("coordinate_rates"), model.buffer("forward_dynamics")]
    for call in calls:
        call.inputs["p"][:] = p
    rates, accelerations = calls[0].outputs["qd"], calls[1].outputs["ud"]

    def rate(t: float, state: Array) -> Array:
        given = signals(t, state)
        for call in calls:
            call.inputs["q"][:] = state[:n]
            call.inputs["u"][:] = state[n:]
            call.inputs["inputs"][:] = given
            call.run()
        return np.concatenate([rates, accelerations])

    constraints = manifold(scene, numbers, inputs)
    return Flow(rate, _linear(model, p, signals, constraints), constraints)


def _linear(
    model: Model, p: Array, signals: Signals, constraints: Manifold
) -> Callable[[float, Array], Linear]:
    """M = d2T/du2, A, and N = dq'/du as functions of (t, y), by CasADi's differentiation."""
    n = len(model.quantities.q)
    groups = [ca.SX.sym(name, len(getattr(model.quantities, name))) for name in STATE[:3]]
    bound, u = ca.SX(ca.DM(p)), groups[1]
    kinetic, *_ = model.casadi["energy"](*groups, bound)
    rates = model.casadi["coordinate_rates"](*groups, bound)
    slopes = [ca.densify(ca.hessian(kinetic, u)[0]), ca.densify(ca.jacobian(rates, u))]
    call = Call(ca.Function("linear", groups, slopes))

    def linear(t: float, state: Array) -> Linear:
        q, u = state[:n], state[n:]
        inertia, turning = call(q, u, signals(t, state))
        return Linear(inertia, constraints.speed(t, q, u)[1], turning)

    return linear
