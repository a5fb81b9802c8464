"""Velocities by differentiating components.

    v = dr/dt,  a = dv/dt,  [omega]x = (dR/dt) R^T

Positions and orientations enter as inertial components; nothing is composed along frames. The
other way is `mechanics.kinematics.textbook.chain`; a check proves the two equal.
"""

from collections.abc import Mapping

from sympy import Expr, Matrix, Symbol, eye, zeros
from sympy.physics.vector import Point, ReferenceFrame

from mechanics.kinematics.textbook.motion import BodyMotion, PointMotion
from mechanics.scene import Particle, Scene
from mechanics.scene.rates import rate, rate_table, rates
from mechanics.symbolic import canonical


def body_motions(scene: Scene) -> tuple[BodyMotion, ...]:
    """Motion of every body in scene order, in q, u and u'."""
    return _bodies(scene, rate_table(scene))


def angular_velocity(
    scene: Scene, frame: ReferenceFrame, table: Mapping[Symbol, Expr]
) -> tuple[Matrix, Matrix]:
    """(R, omega) of a frame: omega is read off the skew matrix (dR/dt) R^T."""
    rotation = scene.rotation(frame)
    turning = rotation.applyfunc(lambda entry: rate(entry, table))
    skew = turning * rotation.T
    omega = Matrix([skew[2, 1], skew[0, 2], skew[1, 0]])
    # cos^2 + sin^2 goes here, or it would be carried into everything that follows.
    return rotation, omega.applyfunc(canonical)


def _point(scene: Scene, point: Point, table: Mapping[Symbol, Expr]) -> PointMotion:
    position = scene.position(point)
    velocity = rates(position, table)
    return PointMotion(position, velocity, rates(velocity, table))


def _bodies(scene: Scene, table: Mapping[Symbol, Expr]) -> tuple[BodyMotion, ...]:
    found = []
    for body in scene.bodies:
        centre = _point(scene, body.centre, table)
        if isinstance(body, Particle):
            found.append(BodyMotion(body, centre, eye(3), zeros(3, 1), zeros(3, 1)))
            continue
        rotation, omega = angular_velocity(scene, body.frame, table)
        found.append(BodyMotion(body, centre, rotation, omega, rates(omega, table)))
    return tuple(found)
