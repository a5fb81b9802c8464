"""Arms, rotary pendulums, a top, a planar quadrotor, a satellite, a seed that falls, an orbit."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P, two_link_arm
from benchmarks.corpus.free_bodies import craft
from mechanics.scene import (
    RigidBody,
    Scene,
    ball,
    euler,
    force,
    gravity,
    torque,
)


def ends():
    """Two links with the masses at their ends, q1 from the horizontal.

    The angle q2 is from the first link, torques tau1, tau2.
    """
    u = dynamicsymbols("tau1 tau2")
    m1, m2, l1, l2, g = P("m1:kg m2:kg l1:m l2:m g:m/s^2")
    return two_link_arm(dynamicsymbols("q1 q2"), l1, (m1, l1, 0), (m2, l2, 0), g, u, u)


def gyro():
    """A symmetric gyroscope on a pedestal: the mass M at r along its axis.

    I1 about the support across it, I3 about it.
    """
    phi, theta, psi = dynamicsymbols("phi theta psi")
    M, r, I1, I3, g = P("M:kg r:m I1:kg*m^2 I3:kg*m^2 g:m/s^2", typical="1 0.5 0.3 0.08 9.8")
    N, O = ReferenceFrame("N"), Point("O")
    hold = ball("hold", None, "gyro", at=O, frame=N, rotation=euler("zxz", phi, theta, psi))
    F = hold.frame
    J = I1 - M * r**2
    return Scene(
        "gyroscope",
        N,
        O,
        joints=(hold,),
        bodies=(RigidBody("gyro", hold.point.locatenew("C", r * F.z), F, M, inertia(F, J, J, I3)),),
        loads=(gravity(-g * N.z),),
        example={"theta": 1.0, "psi_dot": 30.0},
    )


def _quad(names, m, J, g, thrust, turn, inputs, sense):
    """A body in a vertical plane with a thrust along its upper axis and a couple.

    Sense +1: the angle is clockwise.
    """
    return craft(
        names, m, J,
        lambda N, A, C: (
            force("thrust", C, thrust * A.y, on="craft"),
            torque("turn", -sense * turn * N.z, on="craft"),
        ),
        inputs, g=g, sense=-sense,
    )  # fmt: skip


def clockwise():
    """x, z, theta clockwise; thrust f, couple tau."""
    f, tau = dynamicsymbols("f tau")
    m, J, g = P("m:kg J:kg*m^2 g:m/s^2")
    return _quad("x z theta", m, J, g, f, tau, (f, tau), 1)


def rotors():
    """x, y, theta counterclockwise; u1 at the right arm, u2 at the left one.

    Each `radius` from the centre.
    """
    u1, u2 = dynamicsymbols("u1 u2")
    m, J, r, g = P("mass:kg inertia:kg*m^2 radius:m gravity:m/s^2")
    return _quad("x y theta", m, J, g, u1 + u2, r * (u1 - u2), (u1, u2), -1)


def qdynamics():
    """x, y, phi counterclockwise; thrust u1, couple u2."""
    u1, u2 = dynamicsymbols("u1 u2")
    m, J, g = P("m:kg Ixx:kg*m^2 g:m/s^2")
    return _quad("x y phi", m, J, g, u1, u2, (u1, u2), -1)
