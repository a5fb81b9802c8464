"""How bodies and points move: the common form that both kinematics modules fill in."""

from dataclasses import dataclass

from sympy import Expr, Matrix, diag, eye
from sympy.physics.vector import Dyadic

from mechanics.scene import Body, RigidBody, Scene


@dataclass(frozen=True)
class PointMotion:
    """Motion of a geometric point, 3 x 1 inertial components in plain symbols.

    Attributes
    ----------
    position, velocity, acceleration : Matrix
        In m, m/s, m/s^2; the velocity in q and u, the acceleration in q, u and u'.
    """

    position: Matrix
    velocity: Matrix
    acceleration: Matrix


@dataclass(frozen=True)
class BodyMotion:
    """Motion of a body: its mass centre, and how it turns.

    Attributes
    ----------
    body : Body
    centre : PointMotion
    rotation : Matrix
        3 x 3, v_inertial = R v_body; the identity for a particle.
    angular_velocity, angular_acceleration : Matrix
        3 x 1, inertial components, in rad/s and rad/s^2; zero for a particle.
    """

    body: Body
    centre: PointMotion
    rotation: Matrix
    angular_velocity: Matrix
    angular_acceleration: Matrix

    @property
    def turns(self) -> bool:
        """Whether the body has an angular velocity at all."""
        return any(entry != 0 for entry in self.angular_velocity)


def inertia_matrix(scene: Scene, body: Body, rotation: Matrix) -> Matrix:
    """3 x 3 inertia about the mass centre in inertial components, in kg m^2: R I R^T.

    A scalar inertia stands for a multiple of the identity: in the plane that the scene is proved
    to keep, only the product with the normal counts.
    """
    if not isinstance(body, RigidBody):
        return Matrix.zeros(3, 3)
    if not isinstance(body.inertia, Dyadic):
        return body_scalar(scene, body.inertia) * eye(3)
    inside = body.inertia.to_matrix(body.frame).applyfunc(
        lambda entry: scene.plain(entry, f"body {body.name}")
    )
    if inside == diag(*([inside[0, 0]] * 3)):
        return inside
    return rotation * inside * rotation.T


def body_scalar(scene: Scene, inertia: Expr) -> Expr:
    """A scalar inertia in plain symbols."""
    return scene.plain(inertia, "inertia")
