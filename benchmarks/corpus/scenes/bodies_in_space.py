"""Arms, rotary pendulums, a top, a planar quadrotor, a satellite, a seed that falls, an orbit."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    ball,
    euler,
    force,
    gravity,
    pin,
    reaction,
    slide,
    torque,
)


def ends():
    """Two links with the masses at their ends, q1 from the horizontal.

    The angle q2 is from the first link, torques tau1, tau2.
    """
    a, b, u, v = dynamicsymbols("q1 q2 tau1 tau2")
    m1, m2, l1, l2, g = P("m1:kg m2:kg l1:m l2:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    shoulder = pin("shoulder", None, "one", at=O, axis=N.z, angle=a)
    A = shoulder.frame
    E = shoulder.point.locatenew("E", l1 * A.x)
    elbow = pin("elbow", "one", "two", at=E, axis=A.z, angle=b)
    return Scene(
        "arm",
        N,
        O,
        plane=N.z,
        joints=(shoulder, elbow),
        inputs=(u, v),
        loads=(
            gravity(-g * N.y),
            torque("shoulder moment", u * N.z, on="one"),
            torque("elbow moment", v * N.z, on="two", by="one"),
        ),
        bodies=(
            RigidBody("one", E, A, m1, 0),
            RigidBody("two", elbow.point.locatenew("F", l2 * elbow.frame.x), elbow.frame, m2, 0),
        ),
    )


def _rotary(theta, alpha, tau, J, Lr, m, l, Jp, g, side, arm=0, rod=0):
    """An arm with J about its shaft, a rod m with the mass centre at l and Jp about it.

    The angle alpha is from below; side: the way it leans.
    """
    N, O = ReferenceFrame("N"), Point("O")
    shaft = pin("shaft", None, "arm", at=O, axis=N.z, angle=theta)
    A = shaft.frame
    axis = side * A.x
    hinge = pin(
        "hinge", "arm", "rod", at=shaft.point.locatenew("E", Lr * A.x), axis=axis, angle=alpha
    )
    B = hinge.frame
    loads = [gravity(-g * N.z), torque("motor", (tau - arm) * N.z, on="arm")]
    if rod != 0:
        loads.append(torque("friction", -rod * axis, on="rod", by="arm"))
    return Scene(
        "rotary pendulum",
        N,
        O,
        joints=(shaft, hinge),
        inputs=(tau,),
        loads=loads,
        bodies=(
            RigidBody("arm", O, A, 0, inertia(A, 0, 0, J)),
            RigidBody("rod", hinge.point.locatenew("C", -l * B.z), B, m, inertia(B, Jp, Jp, 0)),
        ),
    )


def rods():
    """Slender rods: an arm m_theta, r and a pendulum m_alpha, L; a torque tau."""
    theta, alpha, tau = dynamicsymbols("theta alpha tau")
    L, r, m1, m2, g = P("L:m r:m m_theta:kg m_alpha:kg g:m/s^2")
    return _rotary(theta, alpha, tau, m1 * r**2 / 3, r, m2, L / 2, m2 * L**2 / 12, g, 1)


def rip():
    """An arm Jr, Lr and a pendulum mp, lp, Jp about its mass centre.

    In the plane across the arm only; frictions Br, Bp; a torque tau.
    """
    theta, alpha, tau = dynamicsymbols("theta alpha tau")
    Jr, Lr, mp, lp, Jp, Br, Bp, g = P(
        "Jr:kg*m^2 Lr:m mp:kg lp:m Jp:kg*m^2 Br:N*m*s Bp:N*m*s g:m/s^2"
    )
    N, O = ReferenceFrame("N"), Point("O")
    shaft = pin("shaft", None, "arm", at=O, axis=N.z, angle=theta)
    A = shaft.frame
    hinge = pin(
        "hinge", "arm", "rod", at=shaft.point.locatenew("E", Lr * A.x), axis=-A.x, angle=alpha
    )
    B = hinge.frame
    return Scene(
        "rotary pendulum",
        N,
        O,
        joints=(shaft, hinge),
        inputs=(tau,),
        loads=(
            gravity(-g * N.z),
            torque("motor", (tau - Br * theta.diff()) * N.z, on="arm"),
            torque("friction", -Bp * alpha.diff() * -A.x, on="rod", by="arm"),
        ),
        bodies=(
            RigidBody("arm", O, A, 0, inertia(A, 0, 0, Jr)),
            RigidBody("rod", hinge.point.locatenew("C", -lp * B.z), B, mp, inertia(B, Jp, 0, 0)),
        ),
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
    x, y, a = dynamicsymbols(names)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-sense * a, N.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    return Scene(
        "planar quadrotor",
        N,
        O,
        coordinates=(x, y, a),
        inputs=inputs,
        plane=N.z,
        bodies=(RigidBody("body", C, A, m, J),),
        loads=(
            gravity(-g * N.y),
            force("thrust", C, thrust * A.y, on="body"),
            torque("turn", -sense * turn * N.z, on="body"),
        ),
    )


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
    a, b, c = dynamicsymbols("yaw pitch roll")
    w = dynamicsymbols("omega_x omega_y omega_z")
    Ft, al, be = dynamicsymbols("Ft alpha beta")
    I = P("Ixx:kg*m^2 Iyy:kg*m^2 Izz:kg*m^2", typical="10 15 20")
    (d,) = P("d:m", typical="0.5")
    N, O = ReferenceFrame("N"), Point("O")
    hold = ball("hold", None, "vehicle", at=O, frame=N, rotation=euler("zyx", a, b, c))
    F = hold.frame
    rates = (
        c.diff() - a.diff() * sin(b),
        b.diff() * cos(c) + a.diff() * cos(b) * sin(c),
        -b.diff() * sin(c) + a.diff() * cos(b) * cos(c),
    )
    moment = (
        -d * Ft * (sin(al) * F.y + cos(al) * sin(be) * F.z)
    )  # of the thrust, about the mass centre, which stays where it is
    return Scene(
        "vehicle",
        N,
        O,
        joints=(hold,),
        bodies=(RigidBody("vehicle", O, F, 0, inertia(F, *I)),),
        inputs=(Ft, al, be),
        speeds=tuple(zip(w, rates, strict=True)),
        loads=(torque("thrust", moment, on="vehicle"),),
        example={"omega_x": 0.5},
    )


def moments():
    """A rigid body that turns freely, with moments about its principal axes.

    Its rates about them are omega_x, omega_y, omega_z, the moments Mx, My, Mz.
    """
    a, b, c = dynamicsymbols("yaw pitch roll")
    w = dynamicsymbols("omega_x omega_y omega_z")
    M = dynamicsymbols("Mx My Mz")
    I = P("Ixx:kg*m^2 Iyy:kg*m^2 Izz:kg*m^2", typical="10 15 20")
    N, O = ReferenceFrame("N"), Point("O")
    hold = ball("hold", None, "vehicle", at=O, frame=N, rotation=euler("zyx", a, b, c))
    F = hold.frame
    rates = (
        c.diff() - a.diff() * sin(b),
        b.diff() * cos(c) + a.diff() * cos(b) * sin(c),
        -b.diff() * sin(c) + a.diff() * cos(b) * cos(c),
    )
    return Scene(
        "vehicle",
        N,
        O,
        joints=(hold,),
        bodies=(RigidBody("vehicle", O, F, 0, inertia(F, *I)),),
        inputs=M,
        speeds=tuple(zip(w, rates, strict=True)),
        loads=(torque("moment", M[0] * F.x + M[1] * F.y + M[2] * F.z, on="vehicle"),),
        example={"omega_x": 0.5},
    )


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
    r, theta = dynamicsymbols("r theta")
    m, M, G = P("m:kg M:kg G:N*m^2/kg^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", r * A.x)
    return Scene(
        "orbit",
        N,
        O,
        coordinates=(r, theta),
        bodies=(Particle("planet", C, m),),
        loads=(force("gravitation", C, -G * M * m / r**2 * A.x, on="planet"),),
        reactions=(reaction("side", at=C, on="planet", by=None, along=N.z),),
        example={"r": 1.5, "theta_dot": 0.7},
    )
