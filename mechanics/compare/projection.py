"""States projected onto the constraints of a scene.

q + N(q) u:  C u = -gap, by Newton's method        C v = 0,  C a + c = 0, by least squares
"""

import numpy as np

from mechanics.compare.ours import Ours
from mechanics.compare.states import States
from mechanics.errors import InputError

NEWTON = 20
CLOSED = 1e-12


def admitted(ours: Ours, states: States) -> States:
    """The states on the constraints, without those for which this fails.

    Raises
    ------
    InputError
        When none is left.
    """
    constraints = ours.mechanism.constraints
    if not constraints:
        return states
    q, still = states.q.copy(), np.zeros_like(states.v)
    places = [i for i, constraint in enumerate(constraints) if constraint.holonomic]
    for _ in range(NEWTON if places else 0):
        slope = ours.constraints(q, still)[0][:, places]
        q = ours.moved(q, -(np.linalg.pinv(slope) @ ours.gap(q)[..., None])[..., 0])
    kept = np.all(np.abs(ours.gap(q)) < CLOSED, axis=1)
    if not kept.any():
        raise InputError(
            f"{ours.scene.name}: no drawn state meets the constraints: pass states= that do"
        )
    q, v, a = q[kept], states.v[kept], states.a[kept]
    matrix, _ = ours.constraints(q, v)
    back = np.linalg.pinv(matrix)
    v = v - (back @ matrix @ v[..., None])[..., 0]
    _, closing = ours.constraints(q, v)
    a = a - (back @ (matrix @ a[..., None] + closing[..., None]))[..., 0]
    return States(q, v, a, states.f[kept], states.wrench[kept])
