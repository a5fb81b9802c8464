"""A scene as SymPy's frames, points, bodies and loads, with explicit velocities.

Velocities are composed in `mechanics.kinematics.textbook.chain` and set: this halves the operations
that SymPy's Kane method leaves after common subexpressions are shared. All objects are made anew,
because SymPy's are mutable.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import sympy.physics.mechanics as me
from sympy import Matrix, zeros
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector, outer

from mechanics.kinematics.textbook.chain import Chain, Mixed, axis_angle
from mechanics.routes.dynamic import Dynamic
from mechanics.scene import Body, RigidBody, Scene
from mechanics.scene.actions import Action
from mechanics.scene.geometry import frame_path, relative_rotation
from mechanics.symbolic import is_zero

MOST_FRAMES = 3
"""Frames up to which a velocity is kept in the frames in which its terms are short.

There L**2 stays L**2; with more frames the products between them, which SymPy forms pair by pair,
cost more than that saves, and the velocity is written in inertial components.
"""


@dataclass(frozen=True)
class Velocities:
    """Velocity of a material point and angular velocity of its body, inertial components."""

    velocity: Matrix
    omega: Matrix


@dataclass(frozen=True)
class SympyModel:
    """SymPy's objects for one scene.

    Attributes
    ----------
    frame : ReferenceFrame
        Inertial.
    bodies : dict of str to SymPy body
    """

    frame: ReferenceFrame
    bodies: dict[str, Any]

    def vector(self, column: Matrix, dynamic: Dynamic) -> Vector:
        """Inertial components as a SymPy vector."""
        return _vector(self.frame, column, dynamic)


def build(scene: Scene, dynamic: Dynamic) -> SympyModel:
    """Frames, points and bodies of a scene."""
    chain = Chain(scene)
    frames: dict[ReferenceFrame, ReferenceFrame] = {scene.frame: ReferenceFrame("N")}
    bodies = {body.name: _body(scene, body, chain, frames, dynamic) for body in scene.bodies}
    return SympyModel(frames[scene.frame], bodies)


def force_at(
    model: SympyModel, moving: Velocities, action: Action, dynamic: Dynamic
) -> list[tuple[object, Vector]]:
    """One action as SymPy's loads: a force on a material point, a torque on a turning frame."""
    loads: list[tuple[object, Vector]] = []
    if action.force != zeros(3, 1):
        point = Point(f"{action.name} on {action.body}")
        point.set_vel(model.frame, model.vector(moving.velocity, dynamic))
        loads.append((point, model.vector(action.force, dynamic)))
    if action.couple != zeros(3, 1):
        turning = ReferenceFrame(f"{action.name} on {action.body}")
        turning.set_ang_vel(model.frame, model.vector(moving.omega, dynamic))
        loads.append((turning, model.vector(action.couple, dynamic)))
    return loads


def _body(
    scene: Scene,
    body: Body,
    chain: Chain,
    frames: dict[ReferenceFrame, ReferenceFrame],
    dynamic: Dynamic,
) -> object:
    centre = Point(f"centre of {body.name}")
    motion = chain.point(body.centre)
    inertial = frames[scene.frame]
    if len(motion.velocity) > MOST_FRAMES:
        velocity = _vector(inertial, chain.inertial(motion.velocity), dynamic)
    else:
        velocity = _mixed(scene, chain, motion.velocity, frames, dynamic)
    centre.set_vel(inertial, velocity)
    # Accelerations are only projected: in inertial components that takes the fewest operations.
    centre.set_acc(inertial, _vector(inertial, chain.inertial(motion.acceleration), dynamic))
    if not isinstance(body, RigidBody) or body.inertia == 0:
        # A body without inertia about its centre is a point mass: no angular terms to form.
        return me.Particle(body.name, centre, body.mass)
    frame = _frame(scene, body.frame, chain, frames, dynamic)
    inertia = inertia_dyadic(scene, body, frame, dynamic)
    return me.RigidBody(body.name, centre, frame, body.mass, (inertia, centre))


def _frame(
    scene: Scene,
    frame: ReferenceFrame,
    chain: Chain,
    frames: dict[ReferenceFrame, ReferenceFrame],
    dynamic: Dynamic,
) -> ReferenceFrame:
    """A new frame like the scene's, with its angular velocity composed along the chain."""
    path = frame_path(scene.frame, frame)
    for parent, child in pairwise(path):
        if child in frames:
            continue
        new = ReferenceFrame(child.name)
        step = relative_rotation(parent, child).applyfunc(
            lambda entry: dynamic.to(scene.plain(entry))
        )
        simple = axis_angle(step)
        if simple is None:
            new.orient_explicit(frames[parent], step)
        else:
            axis, angle = simple
            old = frames[parent]
            new.orient_axis(old, axis[0] * old.x + axis[1] * old.y + axis[2] * old.z, angle)
        frames[child] = new
        turn = chain.frame(child)
        inertial = frames[scene.frame]
        new.set_ang_vel(inertial, _vector(new, turn.omega, dynamic))
        new.set_ang_acc(inertial, _vector(new, turn.alpha, dynamic))
    return frames[frame]


def _mixed(
    scene: Scene,
    chain: Chain,
    mixed: Mixed,
    frames: dict[ReferenceFrame, ReferenceFrame],
    dynamic: Dynamic,
) -> Vector:
    total = Vector(0)
    for frame, column in mixed.items():
        total += _vector(_frame(scene, frame, chain, frames, dynamic), column, dynamic)
    return total


def _vector(frame: ReferenceFrame, column: Matrix, dynamic: Dynamic) -> Vector:
    # Built at once: SymPy's sums of scaled unit vectors take ten times as long.
    return Vector([(Matrix([dynamic.to(entry) for entry in column]), frame)])


def inertia_dyadic(
    scene: Scene, body: RigidBody, frame: ReferenceFrame, dynamic: Dynamic
) -> Dyadic:
    """Inertia about the mass centre in the axes of a frame fixed in the body."""
    axes = (frame.x, frame.y, frame.z)
    if not isinstance(body.inertia, Dyadic):
        scalar = dynamic.to(scene.plain(body.inertia))
        return sum((scalar * outer(axis, axis) for axis in axes), Dyadic(0))
    inside = body.inertia.to_matrix(body.frame)
    return sum(
        (
            dynamic.to(scene.plain(inside[i, j])) * outer(axes[i], axes[j])
            for i in range(3)
            for j in range(3)
            if not is_zero(scene.plain(inside[i, j]))
        ),
        Dyadic(0),
    )
