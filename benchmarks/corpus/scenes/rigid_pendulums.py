"""Pendulums: one, two, on a spring, driven, spherical; beads on wires that turn; rods on
springs."""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    double_pendulum,
    held,
    of_one_particle,
    pendulum,
    roller,
    spring_pendulum,
)
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    holonomic,
    pin,
    torque,
    weld,
)

t = dynamicsymbols._t


def plain():
    """theta1, m1, l1."""
    return double_pendulum("theta1 theta2", *P("m1:kg m2:kg l1:m l2:m g:m/s^2"))


def subscripts():
    """theta_1, m_1, l_1."""
    return double_pendulum("theta_1 theta_2", *P("m_1:kg m_2:kg l_1:m l_2:m g:m/s^2"))


def arms():
    """theta1, m1, L1."""
    return double_pendulum("theta1 theta2", *P("m1:kg m2:kg L1:m L2:m g:m/s^2"))


def capitals():
    """theta1, M1, L1."""
    return double_pendulum("theta1 theta2", *P("M1:kg M2:kg L1:m L2:m g:m/s^2"))


def equal():
    """Equal bobs on equal rods."""
    m, l, g = P("m:kg l:m g:m/s^2")
    return double_pendulum("theta1 theta2", m, m, l, l, g)


def phis():
    """phi1, m1, l1."""
    return double_pendulum("phi1 phi2", *P("m1:kg m2:kg l1:m l2:m g:m/s^2"))


def _rods(angles, first, second, g, moments, inputs, *, horizontal=False, between=0, length=None):
    """Two bodies, both angles absolute, from below or from the horizontal; each (mass, reach,
    inertia); moments from the ground."""
    a, b = dynamicsymbols(angles)
    N, O = ReferenceFrame("N"), Point("O")
    way = (lambda F: F.x) if horizontal else (lambda F: -F.y)
    hold = pin("hold", None, "upper", at=O, axis=N.z, angle=a)
    link = pin(
        "link",
        "upper",
        "lower",
        at=hold.point.locatenew("E", length * way(hold.frame)),
        axis=N.z,
        angle=b,
    )
    (m1, c1, I1), (m2, c2, I2) = first, second
    loads = [
        gravity(-g * N.y),
        torque("one", moments[0] * N.z, on="upper"),
        torque("two", moments[1] * N.z, on="lower"),
    ]
    if between != 0:
        loads.append(torque("between", between(a, b) * N.z, on="upper", by="lower"))
    return Scene(
        "two rods",
        N,
        O,
        plane=N.z,
        joints=(hold, link),
        inputs=inputs,
        loads=loads,
        bodies=(
            RigidBody(
                "upper", hold.point.locatenew("C1", c1 * way(hold.frame)), hold.frame, m1, I1
            ),
            RigidBody(
                "lower", link.point.locatenew("C2", c2 * way(link.frame)), link.frame, m2, I2
            ),
        ),
    )


def rods():
    """Uniform rods with torques u1, u2 from outside, coupled by a torque kappa sin(theta2 -
    theta1)."""
    u1, u2 = dynamicsymbols("u1 u2")
    m1, m2, l1, l2, g, k = P("m1:kg m2:kg l1:m l2:m gravity:m/s^2 kappa:N*m")
    return _rods(
        "theta1 theta2",
        (m1, l1 / 2, m1 * l1**2 / 12),
        (m2, l2 / 2, m2 * l2**2 / 12),
        g,
        (u1, u2),
        (u1, u2),
        between=lambda a, b: k * sin(b - a),
        length=l1,
    )


def oliva():
    """Bobs, both angles from the horizontal, torques on both rods from the ground."""
    u1, u2 = dynamicsymbols("tau1 tau2")
    m1, m2, l1, l2, g = P("M1:kg M2:kg L1:m L2:m g:m/s^2")
    return _rods(
        "theta1 theta2", (m1, l1, 0), (m2, l2, 0), g, (u1, u2), (u1, u2), horizontal=True, length=l1
    )


def modsim():
    """A damping d per moment of inertia."""
    phi = dynamicsymbols("phi")
    m, l, g, d = P("m:kg l:m g:m/s^2 d:1/s")
    return pendulum(phi, m, 0, l, g, -d * m * l**2 * phi.diff())


def trolley_lock():
    """A damping dp."""
    theta = dynamicsymbols("theta")
    m, r, dp, g = P("m:kg r:m dp:N*m*s g:m/s^2")
    return pendulum(theta, m, 0, r, g, -dp * theta.diff())


def simple_capital():
    """theta, m, L."""
    m, L, g = P("m:kg L:m g:m/s^2")
    return pendulum(dynamicsymbols("theta"), m, 0, L, g)


def simple():
    """theta, m, l."""
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(dynamicsymbols("theta"), m, 0, l, g)


def simple_varphi():
    """varphi, m, l."""
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(dynamicsymbols("varphi"), m, 0, l, g)


def simple_ell():
    """phi, m, ell."""
    m, l, g = P("m:kg ell:m g:m/s^2")
    return pendulum(dynamicsymbols("phi"), m, 0, l, g)


def damping_ratio():
    """A friction by the damping ratio epsilon: 2 epsilon omega_0 per moment of inertia."""
    theta = dynamicsymbols("theta")
    M, l, g, e = P("M:kg l:m g:m/s^2 epsilon:1")
    return pendulum(theta, M, 0, l, g, -2 * e * sqrt(g / l) * M * l**2 * theta.diff())


def one_link():
    """A link from the horizontal, the mass centre at a/2, an inertia I about it, a torque
    tau1."""
    q1, tau = dynamicsymbols("q1 tau1")
    m, a, I, g = P("m:kg a:m I:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "link", at=O, axis=N.z, angle=q1)
    C = hold.point.locatenew("C", a / 2 * hold.frame.x)
    return Scene(
        "one link",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        inputs=(tau,),
        bodies=(RigidBody("link", C, hold.frame, m, I),),
        loads=(gravity(-g * N.y), torque("motor", tau * N.z, on="link")),
    )


def rod_and_bob():
    """A uniform rod M, l on a pin at its end, a mass m at the other."""
    theta = dynamicsymbols("theta")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "rod", at=O, axis=N.z, angle=theta)
    B = hold.frame
    end = weld("end", "rod", "mass", at=hold.point.locatenew("E", -l * B.y), frame=B)
    return Scene(
        "rod with a mass",
        N,
        O,
        plane=N.z,
        joints=(hold, end),
        loads=(gravity(-g * N.y),),
        bodies=(
            RigidBody("rod", hold.point.locatenew("C", -l / 2 * B.y), B, M, M * l**2 / 12),
            RigidBody("mass", end.point, end.frame, m, 0),
        ),
    )


def two_springs():
    """A uniform rod M, L on a pin at its centre, in a horizontal plane; a spring k at each end,
    across it at rest."""
    theta = dynamicsymbols("theta")
    M, L, k = P("M:kg L:m k:N/m")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "rod", at=O, axis=N.z, angle=theta)
    A, B = (hold.point.locatenew(n, s * L / 2 * hold.frame.x) for n, s in (("A", 1), ("B", -1)))
    pull = k * L / 2 * sin(theta)
    return Scene(
        "rod between springs",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        bodies=(RigidBody("rod", hold.point, hold.frame, M, M * L**2 / 12),),
        loads=(force("right", A, -pull * N.y, on="rod"), force("left", B, pull * N.y, on="rod")),
    )


def coupled():
    """Two equal pendulums side by side, frictions gamma and a torsional coupling k, both per
    moment of inertia."""
    a, b = dynamicsymbols("theta_1 theta_2")
    m, L, g, gamma, k = P("m:kg L:m g:m/s^2 gamma:1/s k:1/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    S = O.locatenew("S", L * N.x)
    J = m * L**2
    holds = [
        pin(n, None, n, at=at, axis=N.z, angle=q) for n, at, q in (("one", O, a), ("two", S, b))
    ]
    bodies = [
        RigidBody(n, h.point.locatenew(f"C {n}", -L * h.frame.y), h.frame, m, 0)
        for n, h in zip(("one", "two"), holds, strict=True)
    ]
    return Scene(
        "coupled pendulums",
        N,
        O,
        plane=N.z,
        joints=holds,
        bodies=bodies,
        loads=(
            gravity(-g * N.y),
            torque("friction one", -J * gamma * a.diff() * N.z, on="one"),
            torque("friction two", -J * gamma * b.diff() * N.z, on="two"),
            torque("coupling", J * k * (b - a) * N.z, on="one", by="two"),
        ),
    )


def elastic_fr():
    """rho, phi, k, l_0."""
    rho, phi = dynamicsymbols("rho phi")
    m, k, l0, g = P("m:kg k:N/m l_0:m g:m/s^2")
    return spring_pendulum(phi, rho, m, g, k * (rho - l0))


def _pivot(move):
    """A bob on l, phi from below; the pivot moves by move(a, gamma, N)."""
    phi = dynamicsymbols("phi")
    m, l, a, gamma, g = P("m:kg l:m a:m gamma:1/s g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = O.locatenew("A", move(a, gamma, N))
    hold = pin("hold", None, "rod", at=A, axis=N.z, angle=phi)
    C = hold.point.locatenew("C", -l * hold.frame.y)
    return Scene(
        "driven pendulum",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        loads=(gravity(-g * N.y),),
        bodies=(RigidBody("rod", C, hold.frame, m, 0),),
    )


def pivot_circle():
    """On a vertical circle."""
    return _pivot(lambda a, w, N: a * cos(w * t) * N.x + a * sin(w * t) * N.y)


def pivot_sideways():
    """Horizontally, as a cos(gamma t)."""
    return _pivot(lambda a, w, N: a * cos(w * t) * N.x)


def spherical_up():
    """theta from the upward vertical, varphi about it."""
    theta, phi = dynamicsymbols("theta varphi")
    m, l, g = P("m:kg l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    out = sin(theta) * A.x + cos(theta) * A.z
    C = O.locatenew("C", l * out)
    return of_one_particle(
        "spherical pendulum", N, O, (theta, phi), ("bob", C, m), (gravity(-g * N.z),),
        example={"theta": 2.0, "varphi_dot": 1.0}, S=out,
    )  # fmt: skip


def hoop():
    """A bead on a circular wire of radius a that turns about its vertical diameter by Omega;
    theta from below."""
    theta = dynamicsymbols("theta")
    m, a, Omega, g = P("m:kg a:m Omega:1/s g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (Omega * t, N.z))
    out = sin(theta) * A.x - cos(theta) * A.z
    C = O.locatenew("C", a * out)
    return of_one_particle(
        "bead on a hoop", N, O, (theta,), ("bead", C, m), (gravity(-g * N.z),), F_N=-out, side=A.y
    )


def hollow():
    """A solid cylinder m, r rolls inside a hollow one R; theta of the line of centres from the
    vertical."""
    m, R, r, g = P("m:kg R:m r:m g:m/s^2", typical="1 0.5 0.1 9.81")
    return roller(m, R, r, g, m * r**2 / 2)


def cartesian():
    """A bob at q1 sideways and q2 downwards, held at the distance l."""
    x, y = dynamicsymbols("q1 q2")
    m, g, l = P("m:kg g:m/s^2 l:m", typical="1 9.81 1")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x - y * N.y)
    return Scene(
        "pendulum",
        N,
        O,
        coordinates=(x, y),
        bodies=(Particle("bob", C, m),),
        loads=(gravity(-g * N.y),),
        constraints=(holonomic("rod", x**2 + y**2 - l**2, "tension"),),
        reactions=held(C, "bob", tension=(-x * N.x + y * N.y) / sqrt(x**2 + y**2), side=N.z),
        example={"q1": 0.6, "q2": 0.8},
    )
