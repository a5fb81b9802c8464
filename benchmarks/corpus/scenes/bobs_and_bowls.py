"""Pendulums: one, two, on a spring, spherical; rods on hinges, a bead on a wire.

Cylinders and balls in bowls.
"""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    double_pendulum,
    of_one_particle,
    pendulum,
    roller,
    spring_pendulum,
)
from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    pin,
    spring,
    torque,
)

t = dynamicsymbols._t


def capitals():
    """theta1, M1, L1, G."""
    return double_pendulum("theta1 theta2", *P("M1:kg M2:kg L1:m L2:m G:m/s^2"))


def subscripts():
    """theta_1, m_1, ell_1."""
    return double_pendulum("theta_1 theta_2", *P("m_1:kg m_2:kg ell_1:m ell_2:m g:m/s^2"))


def equal():
    """theta, phi, m_1, m_2 on equal rods ell."""
    m1, m2, l, g = P("m_1:kg m_2:kg ell:m g:m/s^2")
    return double_pendulum("theta phi", m1, m2, l, l, g)


def drag():
    """A drag gamma m v on each bob."""
    return double_pendulum(
        "theta1 theta2", *P("m1:kg m2:kg l1:m l2:m g:m/s^2"), drag=P("gamma:1/s")[0]
    )


def between():
    """Two pendulums side by side, d apart, a spring k of the natural length l from bob to bob."""
    a, b = dynamicsymbols("theta1 theta2")
    m1, m2, l1, l2, l, g, d, k = P(
        "m1:kg m2:kg l1:m l2:m l:m g:m/s^2 d:m k:N/m", typical="1 1 2.5 2.5 5 15 5 5"
    )
    N, O = ReferenceFrame("N"), Point("O")
    S = O.locatenew("S", d * N.x)
    holds = [
        pin(n, None, n, at=at, axis=N.z, angle=q) for n, at, q in (("one", O, a), ("two", S, b))
    ]
    ends = [
        h.point.locatenew(f"C {h.frame}", -L * h.frame.y)
        for h, L in zip(holds, (l1, l2), strict=True)
    ]
    bodies = [
        RigidBody(n, e, h.frame, m, 0)
        for n, e, h, m in zip(("one", "two"), ends, holds, (m1, m2), strict=True)
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
            spring("S", ends[0], ends[1], k, length=l, first_on="one", second_on="two"),
        ),
    )


def upright():
    """A bob, clockwise from upright, a torque tau."""
    theta, tau = dynamicsymbols("theta tau")
    m, g, l = P("m:kg g:m/s^2 l:m")
    return pendulum(theta, m, 0, l, g, tau, (tau,), up=True)


def simple_ell():
    """theta, m, ell."""
    m, l, g = P("m:kg ell:m g:m/s^2")
    return pendulum(dynamicsymbols("theta"), m, 0, l, g)


def hinge():
    """A uniform rod, theta downwards from the horizontal.

    A torsional spring k that rests at theta_r, a friction c.
    """
    theta = dynamicsymbols("theta")
    m, l, g, k, c, rest = P("m:kg l:m g:m/s^2 k:N*m c:N*m*s theta_r:1")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "rod", at=O, axis=-N.z, angle=theta)
    C = hold.point.locatenew("C", l / 2 * hold.frame.x)
    return Scene(
        "rod on a hinge",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        bodies=(RigidBody("rod", C, hold.frame, m, m * l**2 / 12),),
        loads=(
            gravity(-g * N.y),
            torque("spring", -(k * (theta - rest) + c * theta.diff()) * -N.z, on="rod"),
        ),
    )


def compound():
    """A light rod of length 2a with m at its tip and 2m at its middle."""
    theta = dynamicsymbols("theta")
    m, a, g = P("m:kg a:m g:m/s^2")
    return pendulum(theta, 3 * m, 2 * m * a**2 / 3, 4 * a / 3, g)


def stretch():
    """A bob m on a spring k of the natural length L_o, stretched by y, theta from below."""
    y, theta = dynamicsymbols("y theta")
    m, k, L, g = P("m:kg k:N/m L_o:m gravity:m/s^2")
    return spring_pendulum(theta, L + y, m, g, k * y, order=(y, theta))


def stretch_b():
    """A bob m on a spring k of the natural length b, stretched by y, theta from below."""
    y, theta = dynamicsymbols("y theta")
    m, k, b, g = P("m:kg k:N/m b:m g:m/s^2")
    return spring_pendulum(theta, b + y, m, g, k * y, order=(y, theta))


def _sphere(names, l, m, g, up, example):
    theta, phi = dynamicsymbols(names)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    out = sin(theta) * A.x + up * cos(theta) * A.z
    C = O.locatenew("C", l * out)
    return of_one_particle(
        "spherical pendulum", N, O, (phi, theta) if up > 0 else (theta, phi), ("bob", C, m),
        (gravity(-g * N.z),), example=example, S=out,
    )  # fmt: skip


def sphere_down():
    """theta from the downward vertical, phi about it, a rod ell."""
    m, l, g = P("m:kg ell:m g:m/s^2")
    return _sphere("theta phi", l, m, g, -1, {"theta": 1.0, "phi_dot": 1.0})


def sphere_long():
    """theta from the upward vertical, phi about it; the length l0 + a sin(w t)."""
    m, g, l0, a, w = P("m:kg g:m/s^2 l0:m a:m w:1/s", typical="10 9.81 6 1 0.1")
    return _sphere("theta phi", l0 + a * sin(w * t), m, g, 1, {"theta": 2.0, "phi_dot": 0.25})


def wire():
    """A bead on z = c rho^2 that turns about the vertical by Omega."""
    r = dynamicsymbols("rho")
    m, c, omega, g = P("m:kg c:1/m Omega:1/s g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (omega * t, N.z))
    C = O.locatenew("C", r * A.x + c * r**2 * A.z)
    normal = (-2 * c * r * A.x + A.z) / sqrt(1 + 4 * c**2 * r**2)
    return of_one_particle(
        "bead on a wire", N, O, (r,), ("bead", C, m), (gravity(-g * N.z),), example={"rho": 0.5},
        normal=normal, side=A.y,
    )  # fmt: skip


def hollow():
    """A solid cylinder m, r in a hollow one R."""
    m, R, r, g = P("m:kg R:m r:m g:m/s^2", typical="1 0.5 0.1 9.81")
    return roller(m, R, r, g, m * r**2 / 2)


def half():
    """A solid cylinder M, R in a hollow one 2R."""
    M, R, g = P("M:kg R:m g:m/s^2")
    return roller(M, 2 * R, R, g, M * R**2 / 2)


def bowl():
    """A solid sphere m, r in a bowl R, in a vertical plane."""
    m, R, r, g = P("m:kg R:m r:m g:m/s^2", typical="1 0.5 0.05 9.81")
    return roller(m, R, r, g, 2 * m * r**2 / 5)


def deviation():
    """A bob m on a spring k, its length a + r, a where it hangs at rest; theta from below."""
    r, theta = dynamicsymbols("r theta")
    m, k, a, g = P("m:kg k:N/m a:m g:m/s^2")
    return spring_pendulum(theta, a + r, m, g, k * r + m * g, order=(r, theta))


def bowl_point():
    """A point m that slides in a cylinder of radius r, theta from below."""
    m, r, g = P("m:kg r:m g:m/s^2")
    return pendulum(dynamicsymbols("theta"), m, 0, r, g)


def parabola():
    """A bead on a wire y = a x^2 at rest."""
    x = dynamicsymbols("x")
    m, a, g = P("m:kg a:1/m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + a * x**2 * N.y)
    normal = (-2 * a * x * N.x + N.y) / sqrt(1 + 4 * a**2 * x**2)
    return of_one_particle(
        "bead on a wire", N, O, (x,), ("bead", C, m), (gravity(-g * N.y),), example={"x": 0.5},
        normal=normal, side=N.z,
    )  # fmt: skip
