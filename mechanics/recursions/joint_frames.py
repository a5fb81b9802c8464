"""Frames of joints: a link has the fixed frame in which the next joint's axis is a coordinate axis.

    L --R_y(q)--> B --R_y(a)--> S --R_z(p)--> H     ->     L --R_y(q + a)--> S --R_z(p)--> H
                                                                              S --R_y(-a)--> B

A tilted steering axis, a twist of Denavit and Hartenberg: what lies farther out passes one turn in
the place of two, and what is given in B is moved once for all, being fixed.
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.mechanism import Frame, Mechanism, Mixed, Reaction, inputs_of
from mechanics.program.vectors import product, transpose

AXES = range(3)


def joint_frames(mechanism: Mechanism) -> Mechanism:
    """The same mechanism with frames exchanged where that is possible."""
    for place in range(1, len(mechanism.frames)):
        if _serves(mechanism.frames, place):
            mechanism = _exchanged(mechanism, place)
    return mechanism


def _serves(frames: Sequence[Frame], place: int) -> bool:
    """Whether a fixed turn about the axis of the turn before it leads to another axis."""
    own = frames[place]
    if own.parent <= 0 or own.turn is not None or own.spin is not None:
        return False
    outer = frames[own.parent].turn
    fixed = not inputs_of([entry for row in own.rotation for entry in row])
    if outer is None or not fixed or not inputs_of([outer.angle]):
        return False
    along = next(k for k in AXES if not outer.axis[k].is_zero)
    if own.rotation[along][along] != outer.axis[0].builder.one:
        return False
    beside = [frame for frame in frames if frame.parent == own.parent and frame is not own]
    beyond = [frame.turn for frame in frames if frame.parent == place]
    if any(turn is None or not turn.axis[along].is_zero for turn in beyond) or not beyond:
        return False
    # Parents stand first, and a turn about another axis would pass two turns in its place.
    return all(
        frames.index(frame) > place and (frame.turn is None or not frame.turn.axis[along].is_zero)
        for frame in beside
    )


def _exchanged(mechanism: Mechanism, place: int) -> Mechanism:
    """The frame at a place and its parent take each other's place."""
    own, parent = mechanism.frames[place], mechanism.frames[place].parent
    outer = mechanism.frames[parent]
    other = {place: parent, parent: place}

    def number(frame: int) -> int:
        return other.get(frame, frame)

    def mixed(vector: Mixed) -> Mixed:
        return tuple((number(frame), column) for frame, column in vector)

    def reaction(old: Reaction) -> Reaction:
        return replace(old, along=mixed(old.along), parts=tuple(map(reaction, old.parts)))

    frames = [replace(frame, parent=number(frame.parent)) for frame in mechanism.frames]
    # The angle counts by its rate alone; the rotation says where it begins.
    rotation = product(outer.rotation, own.rotation)
    frames[parent] = replace(outer, name=own.name, rotation=rotation)
    frames[place] = replace(own, name=outer.name, parent=parent, rotation=transpose(own.rotation))
    lines = [
        line if line.along is None else replace(line, along=mixed(line.along))
        for line in mechanism.lines
    ]
    return replace(
        mechanism,
        frames=tuple(frames),
        points=tuple(replace(point, step=mixed(point.step)) for point in mechanism.points),
        bodies=tuple(
            body if body.frame is None else replace(body, frame=number(body.frame))
            for body in mechanism.bodies
        ),
        fields=tuple(replace(f, acceleration=mixed(f.acceleration)) for f in mechanism.fields),
        lines=tuple(lines),
        pushes=tuple(replace(push, vector=mixed(push.vector)) for push in mechanism.pushes),
        torsions=tuple(replace(spring, axis=mixed(spring.axis)) for spring in mechanism.torsions),
        reactions=tuple(map(reaction, mechanism.reactions)),
    )
