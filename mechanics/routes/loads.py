"""Loads and reactions as wrenches on bodies, inertial components.

spring    tension = k (d - l),  d = along . (r_2 - r_1)  or  |r_2 - r_1|
damper    tension = c d'
friction  -mu N sign(v) along the direction of sliding, N the reaction that presses
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from mechanics.kinematics.motion import Motions, Poses
from mechanics.mechanism import GROUND, Friction, Line, Mechanism
from mechanics.program.builder import Node
from mechanics.program.vectors import Vector, add, cross, dot, scale, subtract, zeros


@dataclass(frozen=True)
class Wrench:
    """A force at a position and a couple, on one body; in N and N m."""

    name: str
    body: int
    at: Vector
    force: Vector
    couple: Vector

    def moment(self, about: Vector) -> Vector:
        """(r - r_B) x F + couple."""
        if all(entry.is_zero for entry in self.force):
            return self.couple
        return add(cross(subtract(self.at, about), self.force), self.couple)


def applied(mechanism: Mechanism, motions: Motions) -> list[Wrench]:
    """Every load that depends on no reaction."""
    return [*conservative(mechanism, motions.poses), *other(mechanism, motions)]


def conservative(mechanism: Mechanism, where: Poses) -> list[Wrench]:
    """Gravity, springs and torsion springs."""
    none = zeros(mechanism.builder)
    found: list[Wrench] = []
    for load in mechanism.fields:
        pull = where.vector(load.acceleration)
        for i, body in enumerate(mechanism.bodies):
            if not body.mass.is_zero:
                at = where.positions[body.centre]
                found.append(Wrench(load.name, i, at, scale(body.mass, pull), none))
    for line in mechanism.lines:
        if not line.stiffness.is_zero:
            distance, direction = elongation(where, line)
            found += _pulls(line, where, line.stiffness * (distance - line.length), direction, none)
    for torsion in mechanism.torsions:
        couple = scale(-(torsion.stiffness * torsion.angle), where.vector(torsion.axis))
        found += _pair(torsion.name, torsion.on, torsion.by, none, none, couple)
    return found


def other(mechanism: Mechanism, motions: Motions) -> list[Wrench]:
    """Dampers, forces and couples."""
    none, where = zeros(mechanism.builder), motions.poses
    found: list[Wrench] = []
    for line in mechanism.lines:
        if not line.coefficient.is_zero:
            _, direction = elongation(where, line)
            ends = (motions.points[line.second].velocity, motions.points[line.first].velocity)
            rate = dot(direction, subtract(*ends))
            found += _pulls(line, where, line.coefficient * rate, direction, none)
    for push in mechanism.pushes:
        vector = where.vector(push.vector) if push.vector else none
        if push.at is None:
            found += _pair(push.name, push.on, push.by, none, none, vector)
        else:
            found += _pair(push.name, push.on, push.by, where.positions[push.at], vector, none)
    return found


def unit_reactions(mechanism: Mechanism, where: Poses) -> list[list[Wrench]]:
    """For each reaction the wrenches of a unit of it, one for each body."""
    none = zeros(mechanism.builder)
    table = []
    for reaction in mechanism.reactions:
        found: list[Wrench] = []
        for own in reaction.actions:
            along = where.vector(own.along)
            if own.at is None:
                found += _pair(own.name, own.on, own.by, none, none, along)
            else:
                found += _pair(own.name, own.on, own.by, where.positions[own.at], along, none)
        bodies = dict.fromkeys(wrench.body for wrench in found)
        table.append([together([w for w in found if w.body == body]) for body in bodies])
    return table


def balanced(every: Sequence[Wrench], inside: Sequence[Wrench]) -> bool:
    """Whether what a reaction does inside a free body is equal and opposite.

    So are its only two wrenches; a single one is the ground's, and so may be some of a rope.
    """
    return len(inside) == len(every) == 2 and all(
        -x == y for x, y in zip(every[0].force, every[1].force, strict=True)
    )


def together(wrenches: Sequence[Wrench]) -> Wrench:
    """The sum of some, at the point of the first and on its body."""
    first, *others = wrenches
    if not others:
        return first
    force = add(first.force, *(other.force for other in others))
    couple = add(first.couple, *(other.moment(first.at) for other in others))
    return replace(first, force=force, couple=couple)


def acting_reactions(mechanism: Mechanism, where: Poses) -> list[list[Wrench]]:
    """The same with the friction that a unit brings.

    A pressing reaction with friction is one force that leans against the sliding.
    """
    table = unit_reactions(mechanism, where)
    for load in mechanism.frictions:
        rubbing = friction(where, load, table[load.reaction])
        table[load.reaction] = [
            replace(unit, force=add(unit.force, rub.force))
            for unit, rub in zip(table[load.reaction], rubbing, strict=True)
        ]
    return table


def friction(where: Poses, load: Friction, units: Sequence[Wrench]) -> list[Wrench]:
    """What friction adds to each unit of the reaction that presses."""
    size = load.coefficient * load.sliding.sign()
    rubbing = scale(-size, where.vector(load.along))
    return [
        replace(unit, name=load.name, force=scale(sign, rubbing))
        for unit, sign in zip(units, (1, -1), strict=False)
    ]


def potential(mechanism: Mechanism, where: Poses) -> Node:
    """Potential energy of the conservative loads, in J.

    gravity -m field . r, spring k (d - l)^2 / 2, torsion spring k angle^2 / 2
    """
    total, half = mechanism.builder.zero, mechanism.builder.one / 2
    for load in mechanism.fields:
        pull = where.vector(load.acceleration)
        for body in mechanism.bodies:
            total = total - body.mass * dot(pull, where.positions[body.centre])
    for line in mechanism.lines:
        if not line.stiffness.is_zero:
            distance, _ = elongation(where, line)
            stretch = distance - line.length
            total = total + half * line.stiffness * (stretch * stretch)
    for torsion in mechanism.torsions:
        total = total + half * torsion.stiffness * (torsion.angle * torsion.angle)
    return total


def elongation(where: Poses, line: Line) -> tuple[Node, Vector]:
    """Distance of the ends of a spring or damper, and the unit direction from first to second."""
    span = subtract(where.positions[line.second], where.positions[line.first])
    if line.along is not None:
        direction = where.vector(line.along)
        return dot(span, direction), direction
    distance = dot(span, span).sqrt()
    return distance, tuple(entry / distance for entry in span)


def by_body(mechanism: Mechanism, wrenches: Iterable[Wrench]) -> list[list[Wrench]]:
    """Wrenches grouped by the body they act on."""
    groups: list[list[Wrench]] = [[] for _ in mechanism.bodies]
    for wrench in wrenches:
        groups[wrench.body].append(wrench)
    return groups


def _pulls(
    line: Line, where: Poses, tension: Node, direction: Vector, none: Vector
) -> list[Wrench]:
    ends = ((line.first, line.by, tension), (line.second, line.on, -tension))
    return [
        Wrench(line.name, body, where.positions[point], scale(pull, direction), none)
        for point, body, pull in ends
        if body != GROUND
    ]


def _pair(name: str, on: int, by: int, at: Vector, force: Vector, couple: Vector) -> list[Wrench]:
    own = [Wrench(name, on, at, force, couple)] if on != GROUND else []
    if by == GROUND:
        return own
    opposite = Wrench(name, by, at, tuple(-x for x in force), tuple(-x for x in couple))
    return [*own, opposite]
