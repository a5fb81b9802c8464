"""Random states put onto the constraints of their scene, many at once.

    q <- q - Phi_q^T (Phi_q Phi_q^T)^-1 Phi(q)       Newton's method, the shortest correction
    u <- u - A^T (A A^T)^-1 (A u - b)

The same steps as in `mechanics.simulate.manifold`, for states that have parameters of their own.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.compiled.sampling import States, sample
from mechanics.program import Program, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.simulate.constraints import constraint_programs

Array = NDArray[np.float64]

NEWTON_STEPS, REFINED = 20, 2
CLOSED = 16 * float(np.finfo(float).eps)
"""Residual at which a constraint holds, of the size of its terms."""
DECADES = 1.0
"""Sizes are drawn from 10**-DECADES to 10**DECADES: loops of lengths farther apart do not close."""
REACH = 1.0
"""In rad. All around there are states where coordinates are singular, and no digit is kept."""
ROUNDS = 8
"""How often as many states as are wanted are drawn."""


def states_on_manifold(model: Model, count: int, seed: int) -> States:
    """At most `count` random states that satisfy the constraints of the model's scene.

    Parameters
    ----------
    seed : int
        The same one gives the same states.

    Returns
    -------
    States
        Fewer where Newton's method takes less than one in `ROUNDS` of the states that are drawn
        onto the constraints; none where these hold what the equations of motion do not.
    """
    known, programs = model.quantities, constraint_programs(model.equations.scene)
    given = {e.name for group in (known.q, known.u, known.inputs, known.p) for e in group}
    found = [sample(known, 0, seed)]
    if given.issuperset(name for program in programs for name in program.inputs):
        for number in range(ROUNDS):
            if sum(map(len, found)) < count:
                found.append(_closed(model, *programs, count, seed + number))
    groups = zip(*(one.groups for one in found), strict=True)
    return States(*(np.concatenate(group)[:count] for group in groups))


def _closed(model: Model, position: Program, speed: Program, count: int, seed: int) -> States:
    """Of `count` states that are drawn those that are taken onto the constraints."""
    drawn = sample(model.quantities, count, seed, DECADES)
    u, inputs, p = drawn.u, drawn.inputs, drawn.p
    q = _near_the_example(model, drawn.q, np.random.default_rng(seed))
    known = model.quantities
    names = [e.name for e in (*known.q, *known.u, *known.inputs, *known.p)]

    def at(program: Program) -> tuple[Array, Array]:
        columns = dict(zip(names, (*q.T, *u.T, *inputs.T, *p.T), strict=True))
        return _evaluated(program, columns, q.shape if program is position else u.shape)

    with np.errstate(all="ignore"):
        for _ in range(NEWTON_STEPS):
            q = q - _shortest(*at(position))
        for _ in range(REFINED):
            u = u - _shortest(*at(speed))
        closed = _holds(*at(position), q)
        holds = np.flatnonzero(closed & _holds(*at(speed), u))
    return States(q[holds], u[holds], inputs[holds], p[holds])


def _near_the_example(model: Model, q: Array, random: np.random.Generator) -> Array:
    """Coordinates with angles within `REACH` of those of the scene's example."""
    example, near = model.equations.scene.example, q.copy()
    for i, entry in enumerate(model.quantities.q):
        if entry.unit == "rad":
            near[:, i] = example.get(entry.name, 0.0) + random.uniform(-REACH, REACH, len(q))
    return near


def _evaluated(
    program: Program, columns: Mapping[str, Array], shape: tuple[int, ...]
) -> tuple[Array, Array]:
    """Values, shape (N, c), and derivatives, shape (N, c, n), for variables of shape (N, n)."""
    found = interpret(program, Arrays(), columns)
    value, slope = (np.empty((shape[0], len(entries))) for entries in found.values())
    for rows, entries in zip((value, slope), found.values(), strict=True):
        for k, entry in enumerate(entries):
            rows[:, k] = entry
    return value, slope.reshape(shape[0], value.shape[1], shape[1])


def _shortest(off: Array, jacobian: Array) -> Array:
    """Shortest d with jacobian d = off, shape (N, n); nothing where a value is not finite."""
    numbers = np.isfinite(off).all(axis=1) & np.isfinite(jacobian).all(axis=(1, 2))
    finite: NDArray[np.bool_] = np.atleast_1d(numbers)
    jacobian = np.where(finite[:, None, None], jacobian, 0.0)
    gram = jacobian @ jacobian.transpose(0, 2, 1)
    # A matrix that is singular is made regular: Newton's method leaves such a state by itself.
    size = np.trace(gram, axis1=1, axis2=2) * np.finfo(float).eps + np.finfo(float).tiny
    regular = gram + np.multiply.outer(size, np.eye(gram.shape[1]))
    wanted = np.where(np.broadcast_to(finite[:, None], off.shape), off, 0.0)
    factors = np.linalg.solve(regular, wanted[..., None])
    return np.asarray((jacobian.transpose(0, 2, 1) @ factors)[..., 0], dtype=np.float64)


def _holds(off: Array, jacobian: Array, values: Array) -> NDArray[np.bool_]:
    """Whether every constraint is zero, judged by the size of its terms."""
    size = np.einsum("ncm,nm->nc", np.abs(jacobian), np.maximum(np.abs(values), 1.0))
    return np.asarray(np.all(np.abs(off) <= CLOSED * size, axis=1))
