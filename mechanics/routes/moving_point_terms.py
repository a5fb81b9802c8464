"""What each body and each load contributes to a moment about a moving point, for people.

    axis . (dH_C/dt + BC x m a_C + (v_C - v_B) x m v_C) + axis . (v_B x m v_C) + along . m a_C
    axis . (Br x F + couple) + along . F

Sums of these over the bodies of a free body and its loads are a balance of `moving_point`.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.vectors import Vector, add, cross, dot, scale, subtract, times
from mechanics.routes.moving_point import Balance, Candidates


@dataclass(frozen=True)
class BodyTerms:
    """What one body contributes.

    Attributes
    ----------
    turning, moving, linear : Node
        Of dH_B/dt, of v_B x P, and of dP/dt.
    carried : Node
        axis . (BC x m a_B), which is a part of the first.
    """

    body: int
    turning: Node
    moving: Node
    linear: Node
    carried: Node


def body_terms(mechanism: Mechanism, found: Candidates, balance: Balance) -> Iterator[BodyTerms]:
    """Rates of the bodies of a free body."""
    axis, along = balance.principle.axis, balance.principle.along
    centre = moment_centre(found, balance)
    gain = tuple(tangent(balance.velocity, mechanism.rates))
    for index in mechanism.subtree(balance.principle.root):
        mass, motion = mechanism.bodies[index].mass, found.bodies[index]
        place = motion.centre
        momentum, push = scale(mass, place.velocity), scale(mass, place.acceleration)
        arm, slip = subtract(place.position, centre), subtract(place.velocity, balance.velocity)
        rate = add(cross(arm, push), cross(slip, momentum))
        if motion.turning is not None and motion.inertia is not None:
            spin = times(motion.inertia, motion.turning.omega)
            rate = add(rate, tangent(spin, mechanism.rates))
        yield BodyTerms(
            index,
            dot(axis, rate),
            dot(axis, cross(balance.velocity, momentum)),
            dot(along, push),
            dot(axis, cross(arm, scale(mass, gain))),
        )


def load_terms(
    mechanism: Mechanism, found: Candidates, balance: Balance
) -> Iterator[tuple[str, int, Node]]:
    """The name of each load, the body that it acts on, and its moment or force."""
    axis, along = balance.principle.axis, balance.principle.along
    centre = moment_centre(found, balance)
    for index in mechanism.subtree(balance.principle.root):
        for load in found.loads[index]:
            yield load.name, index, dot(axis, load.moment(centre)) + dot(along, load.force)


def moment_centre(found: Candidates, balance: Balance) -> Vector:
    """Where the moving point is."""
    point = found.subtrees[balance.principle.root].point
    return add(found.motions.points[point].position, balance.principle.offset)
