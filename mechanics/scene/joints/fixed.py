"""What a kind of joint fixes in the bodies that it joins: an axis, or a whole frame.

    d_B = R^T d          constant where d is fixed in the body B

A hinge wants its axis fixed in both bodies, but not the frame in which the axis is written: with
an axis of the ground its angle is an absolute one. What does not turn wants the frame.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from sympy.physics.vector import ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.attachment import frame_of, turned_by, turning
from mechanics.scene.declaration import Declaration
from mechanics.scene.joints.axes import along_axes
from mechanics.scene.joints.joint import Joint
from mechanics.scene.symbols import name_of

AXIS = {"pin": "axis", "cylindrical": "axis", "planar": "frame", "universal": "frame"}
"""Kinds that fix an axis in the parent, and the argument that says it."""

FRAME = {"slide": "axis", "weld": "frame", "roll": "normal"}
"""Kinds that fix a frame in the parent."""


@dataclass(frozen=True)
class _Fixed:
    """Directions that an argument fixes in a body."""

    body: str | None
    argument: str
    frame: ReferenceFrame
    directions: tuple[Vector, ...]


def check_fixed(scene: Declaration, joint: Joint) -> None:
    """What a joint fixes in its bodies does not turn there.

    Raises
    ------
    SceneError
        Names the joint, the direction and what turns it.
    """
    for fixed in _fixed(joint):
        for direction in fixed.directions:
            turns = turned_by(scene, fixed.body, direction)
            if turns:
                name, own = fixed.body or "the ground", frame_of(scene, fixed.body).name
                raise SceneError(
                    f"joint {joint.name}: {direction} of its {fixed.argument}= turns against"
                    f" {name} by {turns}: give what is fixed in {name}, as in"
                    f" {fixed.argument}={_example(fixed, own)}"
                )


def absolute_coordinates(scene: Declaration) -> Iterator[str]:
    """A sentence for each joint that counts its coordinates from a frame that its parent leaves."""
    for joint in scene.joints:
        if not isinstance(joint, Joint) or not joint.coordinates:
            continue
        for fixed in _fixed(joint):
            turns = turning(frame_of(scene, fixed.body), fixed.frame, {*scene.coordinates})
            if turns:
                names = ", ".join(map(name_of, joint.coordinates))
                yield (
                    f"Joint {joint.name} counts {names} from {fixed.frame.name}, against which"
                    f" {fixed.body or 'the ground'} turns by {turns}: they are not relative to it."
                )


def _fixed(joint: Joint) -> Iterator[_Fixed]:
    """Of the parent, then of the child."""
    given, kind = joint.given, joint.given.get("kind")
    onto = given.get("onto")
    if kind in AXIS or kind in FRAME:
        argument = AXIS[kind] if kind in AXIS else FRAME[kind]
        value = given[argument]
        frame = value if isinstance(value, ReferenceFrame) else value.args[0][1]
        directions = tuple(axis for _, axis in along_axes(frame))
        if argument == "axis" and kind in AXIS:
            directions = (value,)
        elif kind == "planar":
            directions = (frame.z,)
        elif kind == "universal":
            directions = (getattr(frame, given["axes"][0].lower()),)
        yield _Fixed(joint.parent, argument, frame, directions)
    if isinstance(onto, tuple | list):
        held = onto[1]
        if isinstance(held, ReferenceFrame):
            yield _Fixed(joint.child, "onto", held, tuple(e for _, e in along_axes(held)))
        else:
            yield _Fixed(joint.child, "onto", held.args[0][1], (held,))


def _example(fixed: _Fixed, frame: str) -> str:
    whole = fixed.argument == "frame" or (fixed.argument == "onto" and len(fixed.directions) > 1)
    value = frame if whole else f"{frame}.z"
    return f"(P, {value})" if fixed.argument == "onto" else value
