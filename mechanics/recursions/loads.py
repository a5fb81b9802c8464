"""Loads other than gravity as forces at points and couples on frames, each in its own frame.

    spring    tension = k (d - l),  d = along . (r_2 - r_1)  or  |r_2 - r_1|
    damper    tension = c d'
    friction  -mu N sign(v) along the direction of sliding, N the reaction that presses

Unknown reactions that stay (of constraints, and those that friction depends on) are loads of the
size of their inputs.
"""

from dataclasses import dataclass

from mechanics.mechanism import GROUND, Line, Mechanism, Mixed, inputs_of
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.vectors import Vector, cross, dot, scale
from mechanics.recursions.frames import collect, common, express, negated


@dataclass(frozen=True)
class Force:
    """A force on what is fixed to a point, components in a frame, N."""

    point: int
    frame: int
    vector: Vector


@dataclass(frozen=True)
class Couple:
    """A couple on frame `on`, the opposite on frame `by` (GROUND: none), in `frame`, N m."""

    on: int
    by: int
    frame: int
    vector: Vector


def loads(mechanism: Mechanism) -> tuple[list[Force], list[Couple]]:
    """Every load but gravity."""
    forces: list[Force] = []
    couples: list[Couple] = []
    for line in mechanism.lines:
        frame, pull = _pull(mechanism, line)
        _at(mechanism, forces, couples, line.by, line.first, ((frame, pull),))
        _at(mechanism, forces, couples, line.on, line.second, ((frame, negated(pull)),))
    for torsion in mechanism.torsions:
        size = -(torsion.stiffness * torsion.angle)
        _couple(mechanism, couples, torsion.on, torsion.by, _scaled(size, torsion.axis))
    for push in mechanism.pushes:
        _pair(mechanism, forces, couples, push.on, push.by, push.at, push.vector)
    for index, size in unknown_reactions(mechanism).items():
        for own in mechanism.reactions[index].actions:
            along = own.along
            for friction in mechanism.frictions:
                if friction.reaction == index:
                    lean = -(friction.coefficient * friction.sliding.sign())
                    along = (*along, *_scaled(lean, friction.along))
            vector = _scaled(size, along)
            _pair(mechanism, forces, couples, own.on, own.by, own.at, vector)
    return forces, couples


def unknown_reactions(mechanism: Mechanism) -> dict[int, Node]:
    """Reactions that stay as unknowns, as inputs of their names."""
    pressing = [load.reaction for load in mechanism.frictions]
    return {
        index: mechanism.builder.input(mechanism.reactions[index].name)
        for index in dict.fromkeys((*mechanism.multipliers, *pressing))
    }


def _scaled(size: Node, mixed: Mixed) -> Mixed:
    return tuple((frame, scale(size, column)) for frame, column in mixed)


def span(mechanism: Mechanism, first: int, second: int) -> Mixed:
    """The way from one point to another along the steps."""

    def up(point: int) -> list[int]:
        found = [point]
        while mechanism.points[found[-1]].parent != GROUND:
            found.append(mechanism.points[found[-1]].parent)
        return found

    one, two = up(first), up(second)
    steps: list[tuple[int, Vector]] = []
    for point in two:
        if point not in one:
            steps += mechanism.points[point].step
    for point in one:
        if point not in two:
            steps += [(frame, negated(column)) for frame, column in mechanism.points[point].step]
    return tuple(steps)


def _pull(mechanism: Mechanism, line: Line) -> tuple[int, Vector]:
    """Tension times the unit direction from first to second, and the frame of its components."""
    way = span(mechanism, line.first, line.second)
    frame = common(mechanism, [f for f, _ in way]) if way and line.along is None else 0
    between = collect(mechanism, way, frame)
    if line.along is None:
        distance = dot(between, between).sqrt()
        direction: Vector = tuple(entry / distance for entry in between)
    else:
        direction = collect(mechanism, line.along, frame)
        distance = dot(between, direction)
    tension = line.stiffness * (distance - line.length)
    if not line.coefficient.is_zero:
        (rate,) = tangent([distance], mechanism.rates)
        tension = tension + line.coefficient * rate
    return frame, scale(tension, direction)


def _pair(
    mechanism: Mechanism,
    forces: list[Force],
    couples: list[Couple],
    on: int,
    by: int,
    at: int | None,
    vector: Mixed,
) -> None:
    if at is None:
        _couple(mechanism, couples, on, by, vector)
        return
    _at(mechanism, forces, couples, on, at, vector)
    opposite = tuple((frame, negated(column)) for frame, column in vector)
    _at(mechanism, forces, couples, by, at, opposite)


def _couple(mechanism: Mechanism, couples: list[Couple], on: int, by: int, vector: Mixed) -> None:
    frames = [GROUND if body == GROUND else mechanism.bodies[body].frame for body in (on, by)]
    first, second = (GROUND if frame is None else frame for frame in frames)
    couples += [Couple(first, second, frame, column) for frame, column in vector]


def _at(
    mechanism: Mechanism,
    forces: list[Force],
    couples: list[Couple],
    body: int,
    point: int,
    vector: Mixed,
) -> None:
    """A force on a body: at the point where that is fixed in the body, else at its mass centre."""
    if body == GROUND:
        return
    own = mechanism.bodies[body]
    way = span(mechanism, own.centre, point)
    moving = set(mechanism.rates)
    fixed = all(frame == own.frame and not inputs_of(c) & moving for frame, c in way)
    if fixed:
        forces += [Force(point, frame, column) for frame, column in vector]
        return
    forces += [Force(own.centre, frame, column) for frame, column in vector]
    if own.frame is None:
        return
    for frame, arm in way:
        for source, column in vector:
            moment = cross(arm, express(mechanism, column, source, frame))
            couples.append(Couple(own.frame, GROUND, frame, moment))
