"""Arms, rotary pendulums, a top, a planar quadrotor, a satellite, a seed that falls, an orbit."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P, rotary_pendulum, two_link_arm
from benchmarks.corpus.free_bodies import central_force, craft, turning_body
from mechanics.scene import (
    RigidBody,
    Scene,
    ball,
    euler,
    force,
    gravity,
    pin,
    slide,
    torque,
)


def ends():
    """Two links with the masses at their ends, q1 from the horizontal.

    The angle q2 is from the first link, torques tau1, tau2.
    """
    u = dynamicsymbols("tau1 tau2")
    m1, m2, l1, l2, g = P("m1:kg m2:kg l1:m l2:m g:m/s^2")
    return two_link_arm(dynamicsymbols("q1 q2"), l1, (m1, l1, 0), (m2, l2, 0), g, u, u)


def rods():
    """Slender rods: an arm m_theta, r and a pendulum m_alpha, L; a torque tau."""
    theta, alpha, tau = dynamicsymbols("theta alpha tau")
    L, r, m1, m2, g = P("L:m r:m m_theta:kg m_alpha:kg g:m/s^2")
    J = m2 * L**2 / 12
    return rotary_pendulum(
        theta, alpha, r, m1 * r**2 / 3, m2, L / 2, (J, J, 0), 1, -1, g, tau, 0, (tau,)
    )


def rip():
    """An arm Jr, Lr and a pendulum mp, lp, Jp about its mass centre.

    In the plane across the arm only; frictions Br, Bp; a torque tau.
    """
    theta, alpha, tau = dynamicsymbols("theta alpha tau")
    Jr, Lr, mp, lp, Jp, Br, Bp, g = P(
        "Jr:kg*m^2 Lr:m mp:kg lp:m Jp:kg*m^2 Br:N*m*s Bp:N*m*s g:m/s^2"
    )
    drive, brake = tau - Br * theta.diff(), -Bp * alpha.diff()
    return rotary_pendulum(
        theta, alpha, Lr, Jr, mp, lp, (Jp, 0, 0), -1, -1, g, drive, brake, (tau,)
    )


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


def thruster():
    """A rigid body that turns freely, rates omega_x, omega_y, omega_z about principal axes.

    A thrust Ft at the distance d behind its mass centre, along the x axis but turned by alpha
    and beta.
    """
    Ft, al, be = dynamicsymbols("Ft alpha beta")
    (d,) = P("d:m", typical="0.5")
    # of the thrust, about the mass centre, which stays where it is
    return turning_body(
        "omega_x omega_y omega_z", "Ixx:kg*m^2 Iyy:kg*m^2 Izz:kg*m^2", (Ft, al, be), name="vehicle",
        load=lambda F: -d * Ft * (sin(al) * F.y + cos(al) * sin(be) * F.z),
    )  # fmt: skip


def moments():
    """A rigid body that turns freely, with moments about its principal axes.

    Its rates about them are omega_x, omega_y, omega_z, the moments Mx, My, Mz.
    """
    return turning_body(
        "omega_x omega_y omega_z", "Ixx:kg*m^2 Iyy:kg*m^2 Izz:kg*m^2", dynamicsymbols("Mx My Mz"),
        name="vehicle",
    )  # fmt: skip


def samara():
    """A slender wing I_y3y3 that cones by theta above the horizontal, turns by phi, rises by z.

    Its mass is m; phi is about the vertical; couples M_y3 (lowers theta) and M_z3 (about the wing's
    own upper axis), a force F_z3 along that axis.
    """
    theta, phi, z = dynamicsymbols("theta phi z")
    My, Mz, Fz = dynamicsymbols("M_y3 M_z3 F_z3")
    m, I, g = P("m:kg I_y3y3:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    guide = slide("guide", None, "stem", at=O, axis=N.z, distance=z)
    shaft = pin("shaft", "stem", "hub", at=guide.point, axis=N.z, angle=phi)
    A = shaft.frame
    cone = pin("cone", "hub", "wing", at=shaft.point, axis=-A.y, angle=theta)
    B = cone.frame
    return Scene(
        "samara",
        N,
        O,
        joints=(guide, shaft, cone),
        inputs=(My, Mz, Fz),
        bodies=(
            RigidBody("stem", guide.point, N, 0, inertia(N, 0, 0, 0)),
            RigidBody("hub", shaft.point, A, 0, inertia(A, 0, 0, 0)),
            RigidBody("wing", cone.point, B, m, inertia(B, 0, I, I)),
        ),
        loads=(
            gravity(-g * N.z),
            torque("aerodynamic", My * B.y + Mz * B.z, on="wing"),
            force("lift", cone.point, Fz * B.z, on="wing"),
        ),
    )


def orbit():
    """A mass m at r, theta from a fixed mass M."""
    m, M, G = P("m:kg M:kg G:N*m^2/kg^2")
    r, theta = dynamicsymbols("r theta")
    return central_force((r, theta), m, G * M * m / r**2)
