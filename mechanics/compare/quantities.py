"""What is compared, and how a quantity is seen by somebody who reads a scene otherwise.

    mass_matrix            f(q, v)            (n, n)
    bias                   f(q, v)            (n,)       forces that give a = 0
    inverse_dynamics       f(q, v, a)         (n,)
    forward_dynamics       f(q, v, forces)    (n,)
    kinetic_energy         f(q, v)            ()
    potential_energy       f(q, v)            ()         up to a constant
    momentum_matrix        f(q, v)            (6, n)     momentum over that about the mass centre
    momentum_matrix_rate   f(q, v)            (6, n)
    jacobian NAME          f(q, v)            (6, n)     velocity of its origin over the angular one
    velocity NAME          f(q, v)            (6,)
    force on NAME          f(q, v, wrench)    (n,)       of a force and a couple at the origin

NAME is a body that a joint carries: its frame is that of the joint. Vectors are in the inertial
frame. Coordinates and speeds are those of the scene, in its order.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from mechanics.compare.change import NOTHING, Array, Change
from mechanics.compare.ours import Ours
from mechanics.compare.states import States
from mechanics.errors import InputError

MASS, BIAS, INVERSE, FORWARD = "mass_matrix", "bias", "inverse_dynamics", "forward_dynamics"
KINETIC, POTENTIAL = "kinetic_energy", "potential_energy"
JACOBIAN, VELOCITY, FORCE = "jacobian ", "velocity ", "force on "
MOMENTUM, MOMENTUM_RATE = "momentum_matrix", "momentum_matrix_rate"
PLAIN = (MASS, BIAS, INVERSE, FORWARD, KINETIC, POTENTIAL, MOMENTUM, MOMENTUM_RATE)
NAMED = (JACOBIAN, VELOCITY, FORCE)
FORCES = (MASS, BIAS, INVERSE, FORWARD)
"""From which amounts are fitted: linear in masses, inertias, gravity, armature and damping."""
UNITS = {
    MASS: "", BIAS: "N m", INVERSE: "N m", FORWARD: "N m", KINETIC: "J", POTENTIAL: "J",
    MOMENTUM: "", MOMENTUM_RATE: "", JACOBIAN: "", VELOCITY: "m/s", FORCE: "N m",
}  # fmt: skip

Answer = Callable[..., Any]


@dataclass(frozen=True, eq=False)
class Reading:
    """A way to take a scene, its arguments and its results.

    Attributes
    ----------
    change : Change
        Of the scene.
    arguments : callable, optional
        From the states that are meant to those that are taken.
    values : callable, optional
        From the name of a quantity, its values and the states that are meant to the values that
        are told.
    only : tuple of str, optional
        The quantities that are read so; others are read as the scene means them.
    shorter : bool
        Whether what belongs to locked speeds is left out of the results.
    """

    change: Change = NOTHING
    arguments: Callable[[States], States] | None = None
    values: Callable[[str, Array, States], Array] | None = None
    only: tuple[str, ...] | None = None
    shorter: bool = False


AS_MEANT = Reading()


def kind_of(quantity: str) -> str:
    """``"jacobian "`` of ``"jacobian tool"``."""
    return next((kind for kind in NAMED if quantity.startswith(kind)), quantity)


def checked(ours: Ours, answers: Mapping[str, Answer]) -> tuple[str, ...]:
    """The quantities of an adapter, in the order of this table.

    Raises
    ------
    InputError
        For what is no quantity, a frame that the scene does not have, and for none.
    """
    for quantity in answers:
        kind = kind_of(quantity)
        if kind not in (*PLAIN, *NAMED):
            raise InputError(
                f"{quantity!r} is no quantity: they are {', '.join(PLAIN)}, and 'jacobian NAME',"
                " 'velocity NAME', 'force on NAME'"
            )
        if kind in NAMED and (name := quantity.removeprefix(kind)) not in ours.frames:
            raise InputError(
                f"{quantity!r}: there is no frame {name!r}: they are {', '.join(ours.frames)}"
            )
    if not answers:
        raise InputError("there is nothing to compare: give at least one quantity")
    order = (*PLAIN, *NAMED)
    return tuple(sorted(answers, key=lambda quantity: order.index(kind_of(quantity))))


def observed(quantity: str, answer: Answer, states: States) -> Array:
    """What somebody answers at the states, a row each.

    Raises
    ------
    InputError
        When it is no array of numbers, or fails.
    """
    kind, found = kind_of(quantity), []
    for q, v, a, f, wrench in states.rows:
        more = {INVERSE: (a,), FORWARD: (f,), FORCE: (wrench,)}.get(kind, ())
        given = (x.copy() for x in (q, v, *more))
        try:
            found.append(np.array(answer(*given), dtype=float))
        except Exception as error:
            words = " ".join(str(error).split())
            raise InputError(f"{quantity}: {type(error).__name__}: {words}") from error
    if len({row.shape for row in found}) != 1 or not all(np.isfinite(row).all() for row in found):
        raise InputError(f"{quantity}: the answers are no arrays of finite numbers of one shape")
    return np.stack(found)


def predicted(ours: Ours, quantity: str, states: States, reading: Reading = AS_MEANT) -> Array:
    """Our numbers for a quantity, read so."""
    if reading.only is not None and quantity not in reading.only:
        reading = AS_MEANT
    change, kind = reading.change, kind_of(quantity)
    taken = states if reading.arguments is None else reading.arguments(states)
    if change.locked:
        taken = _held(ours, taken, change)
    q, v, name = taken.q, taken.v, quantity.removeprefix(kind)
    if kind == MASS:
        found = ours.mass_matrix(q, change)
    elif kind == BIAS:
        found = ours.forces(q, v, np.zeros_like(v), change)
    elif kind == INVERSE:
        found = ours.forces(q, v, taken.a, change)
    elif kind == FORWARD:
        found = ours.accelerations(q, v, taken.f, change)
    elif kind in (KINETIC, POTENTIAL):
        found = ours.energies(q, v, change)[kind == POTENTIAL]
    elif kind in (MOMENTUM, MOMENTUM_RATE):
        found = ours.momentum_matrices(q, v, change)[kind == MOMENTUM_RATE]
    else:
        jacobian = ours.jacobians(q)[name]
        if kind == JACOBIAN:
            found = jacobian
        elif kind == VELOCITY:
            found = np.einsum("nij,nj->ni", jacobian, v)
        else:
            found = np.einsum("nij,ni->nj", jacobian, taken.wrench[:, : jacobian.shape[1]])
    if reading.values is not None:
        found = reading.values(quantity, found, states)
    return _without(kind, found, tuple(change.locked)) if reading.shorter else found


def _held(ours: Ours, states: States, change: Change) -> States:
    q, v, a = states.q.copy(), states.v.copy(), states.a.copy()
    for speed, value in change.locked.items():
        q[:, ours.coordinate(speed)] = value
        v[:, speed] = a[:, speed] = 0.0
    return States(q, v, a, states.f, states.wrench)


def _without(kind: str, values: Array, speeds: tuple[int, ...]) -> Array:
    if kind == MASS:
        values = np.delete(values, speeds, axis=1)
    if kind in (KINETIC, POTENTIAL, VELOCITY):
        return values
    return np.delete(values, speeds, axis=-1)
