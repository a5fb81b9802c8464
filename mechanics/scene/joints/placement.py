"""Whether joints carry the bodies that they name, each body once."""

from collections.abc import Sequence

from sympy.physics.vector import Dyadic, Point

from mechanics.errors import SceneError
from mechanics.nearest import instead
from mechanics.scene.attachment import moved_by, moving, turning
from mechanics.scene.bodies import Body, Particle, RigidBody
from mechanics.scene.declaration import Declaration
from mechanics.scene.joints.fixed import check_fixed
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope


def check_joints(scene: Declaration) -> None:
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
    closing: list[Joint] = []
    ropes = [joint for joint in scene.joints if isinstance(joint, Rope)]
    joints = [joint for joint in scene.joints if isinstance(joint, Joint)]
    for joint in joints:
        for name in (joint.parent, joint.child):
            if name is not None and name not in bodies:
                raise SceneError(
                    f"joint {joint.name}: there is no body {name!r}:"
                    f" {instead(name, sorted(bodies), 'bodies')}"
                )
        if joint.parent == joint.child:
            raise SceneError(f"joint {joint.name}: body {joint.child!r} is tied to itself")
        if not joint.carries:
            _closed_once(joint, closing)
            closing.append(joint)
            continue
        other = carrier.setdefault(joint.child, joint)
        if other is not joint:
            raise SceneError(
                f"joints {other.name} and {joint.name} both carry {joint.child}: the one that"
                f" closes a loop says onto which point of it, as in pin({joint.name!r}, ...,"
                " onto=P) without an angle"
            )
        _placed(scene, joint, bodies[joint.child])
    for joint in joints:
        _attached(scene, f"joint {joint.name}", joint.at, joint.parent)
        if not joint.carries:
            _attached(scene, f"joint {joint.name}", joint.point, joint.child)
        check_fixed(scene, joint)
    for rope in ropes:
        for end, point in rope.ends:
            if end is not None:
                scene.body(end)
            _attached(scene, f"rope {rope.name}", point, end)
    acting = [action for reaction in scene.reactions for action in reaction.actions]
    tied = {name for action in acting for name in (action.on, action.by)}
    for name, body in bodies.items():
        flat = isinstance(body, RigidBody) and not isinstance(body.inertia, Dyadic)
        if flat and scene.plane is None and any(joint.reactions for joint in joints):
            raise SceneError(
                f"body {name}: its inertia is a scalar, but joints hold in space: give the scene"
                f" the normal of its plane, plane={scene.frame.name}.z, or the body a Dyadic"
            )
        if name not in carrier and name not in tied:
            raise SceneError(
                f"body {name}: no joint carries it: add one, as in"
                f' weld("hold", "BODY", "{name}", at=P, frame=F) where it moves with BODY,'
                f' free("move", "{name}", at=P, frame=F) where nothing holds it'
            )


def _closed_once(joint: Joint, others: Sequence[Joint]) -> None:
    ends = {(joint.parent, joint.at), (joint.child, joint.point)}
    for other in others:
        if ends == {(other.parent, other.at), (other.child, other.point)}:
            raise SceneError(
                f"joints {other.name} and {joint.name} close one loop twice, at the same points:"
                " leave one of them out"
            )


def _attached(scene: Declaration, what: str, point: Point, body: str | None) -> None:
    """A point does not move against the body of which the joint says that it is."""
    moving = moved_by(scene, body, point)
    if moving:
        name = body or "the ground"
        raise SceneError(
            f"{what}: its point {point.name} moves against {name} by {moving}: take a"
            f" point of {name}, or name the body that carries {point.name}"
        )


def _placed(scene: Declaration, joint: Joint, body: Body) -> None:
    """The body does not move against what the joint carries."""
    what = f"joint {joint.name} carries {body.name}"
    if isinstance(body, Particle) and joint.reactions:
        frame = f"{joint.name}.frame"
        none = "0" if scene.plane is not None else f"inertia({frame}, 0, 0, 0)"
        raise SceneError(
            f"{what}, a particle, which no couple holds: declare a body without inertia,"
            f' RigidBody("{body.name}", {body.centre.name}, {frame}, {body.mass}, {none})'
        )
    if isinstance(body, RigidBody):
        turns = turning(joint.frame, body.frame)
        if turns:
            raise SceneError(
                f"{what}, but the frame {body.frame.name} of {body.name} turns against that of"
                f" the joint by {turns}: use {joint.name}.frame"
            )
    moves = moving(joint.frame, joint.point, body.centre)
    if moves:
        raise SceneError(
            f"{what}, but the centre of {body.name} moves against the joint by {moves}: place it"
            f" from {joint.name}.point along {joint.name}.frame"
        )
