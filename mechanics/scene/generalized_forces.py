"""Generalized forces of loads that a scene declares as forces and torques: F . dr/dq, T . w."""

from sympy import Expr, Matrix, S, zeros

from mechanics.scene.bodies import RigidBody
from mechanics.scene.loads import Force, Gravity, Spring, Torque
from mechanics.scene.scene import Scene
from mechanics.symbolic import is_zero, operations

LARGEST = 200
"""Operations of a generalized force that is looked at."""


def from_potential(scene: Scene) -> bool:
    """Whether all loads come from a potential, of places and of what inputs move.

    An input that is a force by itself has none in the energy that people write.
    """
    every: list[Expr] = [S.Zero for _ in scene.q]
    for load in scene.loads:
        if isinstance(load, Gravity | Spring):
            continue
        if not isinstance(load, Force | Torque):
            return False
        vector = scene.vector(load.vector, load.name)
        every = [Q + vector.dot(arm) for Q, arm in zip(every, arms(scene, load), strict=True)]
    if any(operations(Q) > LARGEST for Q in every):
        return False
    held = set().union(*(Q.free_symbols for Q in every))
    if held - {*scene.q, *scene.parameters, *scene.input_symbols}:
        return False
    slopes = [Q.diff(u) for Q in every for u in scene.input_symbols]
    here = dict.fromkeys(scene.q, S.Zero)
    numbers = [(slope, slope.subs(here)) for slope in slopes]  # sin^2 + cos^2 of a torque is 1
    if any(n.is_number and n != 0 and is_zero(slope - n) for slope, n in numbers):
        return False
    pairs = ((i, j) for i in range(len(every)) for j in range(i))
    return all(is_zero(every[i].diff(scene.q[j]) - every[j].diff(scene.q[i])) for i, j in pairs)


def arms(scene: Scene, load: Force | Torque) -> list[Matrix]:
    """What times the load is its generalized force, for each coordinate."""
    if isinstance(load, Torque):
        on, by = turning(scene, load.on), turning(scene, load.by)
    else:
        place = scene.position(load.at)
        moving = [place.diff(q) for q in scene.q]
        on = _carried(scene, load.on, place) if load.on else moving
        by = _carried(scene, load.by, place)
    return [one - other for one, other in zip(on, by, strict=True)]


def turning(scene: Scene, name: str | None) -> list[Matrix]:
    """Partial angular velocities of a body, of W = dR/dq R^T; zero for the ground."""
    body = None if name is None else scene.body(name)
    if not isinstance(body, RigidBody):
        return [zeros(3, 1)] * len(scene.q)
    rotation = scene.rotation(body.frame)
    turns = [rotation.diff(q) * rotation.T for q in scene.q]
    return [Matrix([W[2, 1], W[0, 2], W[1, 0]]) for W in turns]


def _carried(scene: Scene, name: str | None, place: Matrix) -> list[Matrix]:
    """Partial velocities of the point of a body that is at a place; zero for the ground."""
    if name is None:
        return [zeros(3, 1)] * len(scene.q)
    centre = scene.position(scene.body(name).centre)
    turns = zip(scene.q, turning(scene, name), strict=True)
    return [centre.diff(q) + turn.cross(place - centre) for q, turn in turns]
