"""The right-hand side of y' = f(t, y), y = (q, u), from a compiled model.

q' = N u + n,    u' = forward dynamics (q, u, inputs(t), p)
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.simulate.constraints import manifold, system_matrix
from mechanics.simulate.march import Flow
from mechanics.simulate.singular import regularity
from mechanics.simulate.values import Signals

Array = NDArray[np.float64]


def flow(model: Model, p: Array, signals: Signals, inputs: Mapping[str, Any]) -> Flow:
    """Everything that the integrator asks for, with numbers bound.

    Parameters
    ----------
    model : Model
    p : array
        Parameters in the model's order.
    signals : Signals
        Of the model's inputs.
    inputs : mapping
        What the signals were read from: constraints may need other rates of it.
    """
    scene, n = model.equations.scene, len(model.quantities.q)
    numbers = {e.symbol: float(v) for e, v in zip(model.quantities.p, p, strict=True)}
    calls = [model.buffer("coordinate_rates"), model.buffer("forward_dynamics")]
    for call in calls:
        call.inputs["p"][:] = p
    rates, accelerations = calls[0].outputs["qd"], calls[1].outputs["ud"]

    def rate(t: float, state: Array) -> Array:
        given = signals(t)
        for call in calls:
            call.inputs["q"][:] = state[:n]
            call.inputs["u"][:] = state[n:]
            call.inputs["inputs"][:] = given
            call.run()
        return np.concatenate([rates, accelerations])

    matrix = system_matrix(model.equations, numbers, inputs)
    return Flow(
        rate, lambda t, state: regularity(matrix(t, state)), manifold(scene, numbers, inputs)
    )
