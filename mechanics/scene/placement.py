"""Whether joints carry the bodies that they name, each body once."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from sympy.core.function import AppliedUndef
from sympy.physics.vector import ReferenceFrame

from mechanics.errors import SceneError
from mechanics.scene.bodies import Body, RigidBody
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.joints import Joint
from mechanics.scene.symbols import name_of

if TYPE_CHECKING:
    from mechanics.scene.scene import Scene


def check_joints(scene: Scene) -> None:
    """Bodies of joints exist; each is placed on the joint that carries it, and on no other.

    Raises
    ------
    SceneError
        Names the joint and the body.
    """
    if not scene.joints:
        return
    bodies = {body.name: body for body in scene.bodies}
    carrier: dict[str, Joint] = {}
    for joint in scene.joints:
        for name in (joint.parent, joint.child):
            if name is not None and name not in bodies:
                raise SceneError(
                    f"joint {joint.name}: there is no body {name!r}: the bodies are"
                    f" {', '.join(sorted(bodies))}"
                )
        if joint.parent == joint.child:
            raise SceneError(f"joint {joint.name}: body {joint.child!r} is tied to itself")
        if joint.closes:
            continue
        other = carrier.setdefault(joint.child, joint)
        if other is not joint:
            raise SceneError(
                f"joints {other.name} and {joint.name} both carry {joint.child}: the one that"
                f" closes a loop says onto which point of it, as in pin({joint.name!r}, ...,"
                " onto=P) without an angle"
            )
        _placed(joint, bodies[joint.child])
    tied = {name for reaction in scene.reactions for name in (reaction.on, reaction.by)}
    for name in bodies:
        if name not in carrier and name not in tied:
            raise SceneError(
                f"body {name}: no joint carries it: add one, as in"
                f' free("{name}", {name!r}, ...) where nothing holds it'
            )


def _placed(joint: Joint, body: Body) -> None:
    """The body does not move against what the joint carries."""
    what = f"joint {joint.name} carries {body.name}"
    if isinstance(body, RigidBody):
        moving = _turning(joint.frame, body.frame)
        if moving:
            raise SceneError(
                f"{what}, but the frame {body.frame.name} of {body.name} turns against that of"
                f" the joint by {moving}: use {joint.name}.frame"
            )
    for parent, point in pairwise(point_path(joint.point, body.centre)):
        for frame, column in components(step_vector(parent, point)):
            moving = ", ".join(sorted(name_of(f) for f in column.atoms(AppliedUndef)))
            moving = moving or _turning(joint.frame, frame)
            if moving:
                raise SceneError(
                    f"{what}, but the centre of {body.name} moves against the joint by {moving}:"
                    f" place it from {joint.name}.point along {joint.name}.frame"
                )


def _turning(first: ReferenceFrame, second: ReferenceFrame) -> str:
    """What turns one frame against another; empty if nothing does."""
    moving = {
        name_of(function)
        for parent, child in pairwise(frame_path(first, second))
        for function in relative_rotation(parent, child).atoms(AppliedUndef)
    }
    return ", ".join(sorted(moving))
