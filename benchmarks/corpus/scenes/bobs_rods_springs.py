"""Pendulums: damped, driven, of rods, in a fluid, upright; on a sphere, on springs."""

from sympy import Rational, cos, pi, sin, sqrt, tanh
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, double_pendulum, of_one_particle, pendulum
from mechanics.scene import Particle, RigidBody, Scene, force, gravity, pin, reaction, torque


def subscripts_capital():
    """theta_1, m_1, L_1."""
    return double_pendulum("theta_1 theta_2", *P("m_1:kg m_2:kg L_1:m L_2:m g:m/s^2"))


def rods():
    """Two equal uniform rods m, L, angles theta1, theta2 from below."""
    m, L, g = P("m:kg L:m g:m/s^2")
    return _two("theta1 theta2", (m, m), (L, L), g, Rational(1, 2), m * L**2 / 12)


def rods_q():
    """Two equal uniform rods m, L, angles q1, q2 from below."""
    m, L, g = P("m:kg L:m g:m/s^2")
    return _two("q1 q2", (m, m), (L, L), g, Rational(1, 2), m * L**2 / 12)


def _two(angles, masses, lengths, g, share=1, inertia=0, damping=()):
    """Two bodies with the mass centre at a share of their lengths, both angles from below."""
    a, b = dynamicsymbols(angles)
    N, O = ReferenceFrame("N"), Point("O")
    first = pin("first", None, "upper", at=O, axis=N.z, angle=a)
    A = first.frame
    end = first.point.locatenew("E1", -lengths[0] * A.y)
    second = pin("second", "upper", "lower", at=end, axis=N.z, angle=b)
    B = second.frame
    C1 = first.point.locatenew("C1", -share * lengths[0] * A.y)
    C2 = second.point.locatenew("C2", -share * lengths[1] * B.y)
    loads = [gravity(-g * N.y)]
    if damping:
        between = -damping[1] * (b.diff() - a.diff()) * N.z
        loads += [
            torque("first damper", -damping[0] * a.diff() * N.z, on="upper"),
            torque("second damper", between, on="lower", by="upper"),
        ]
    return Scene(
        "double pendulum", N, O, plane=N.z, joints=(first, second), loads=loads,
        bodies=(RigidBody("upper", C1, A, masses[0], inertia),
                RigidBody("lower", C2, B, masses[1], inertia)),
    )  # fmt: skip


def simple_phi():
    """phi, m, l."""
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(dynamicsymbols("phi"), m, 0, l, g)


def driven_q():
    """q from below, a torque u."""
    q, u = dynamicsymbols("q u")
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(q, m, 0, l, g, u, (u,))


def stokes():
    """A ball m of radius r on a thread l in a fluid eta: a drag 6 pi eta r v."""
    theta = dynamicsymbols("theta")
    m, l, g, eta, r = P("m:kg l:m g:m/s^2 eta:Pa*s r:m")
    return pendulum(theta, m, 0, l, g, -6 * pi * eta * r * l**2 * theta.diff())


def upright_rod():
    """A uniform rod m, l, clockwise from upright, a torque max_torque tanh(u)."""
    theta, u = dynamicsymbols("theta u")
    m, l, g, top = P("m:kg l:m g:m/s^2 max_torque:N*m")
    return pendulum(theta, m, m * l**2 / 12, l / 2, g, top * tanh(u), (u,), up=True)


def upright_torque():
    """A bob m on l, clockwise from upright, a torque."""
    theta, u = dynamicsymbols("theta torque")
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(theta, m, 0, l, g, u, (u,), up=True)


def hanging_rod():
    """A uniform rod m, l, counterclockwise from below, a torque M."""
    theta, M = dynamicsymbols("theta M")
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(theta, m, m * l**2 / 12, l / 2, g, M, (M,))


def disturbed():
    """th from below; m with its mass centre at l, I about it; a torque U, a horizontal force F."""
    th, U, F = dynamicsymbols("th U F")
    m, l, g, I = P("m:kg l:m g:m/s^2 I:kg*m^2", typical="0.2 0.3 9.8 0.006")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "body", at=O, axis=N.z, angle=th)
    C = hold.point.locatenew("C", -l * hold.frame.y)
    return Scene(
        "pendulum", N, O, plane=N.z, joints=(hold,), inputs=(U, F),
        bodies=(RigidBody("body", C, hold.frame, m, I),),
        loads=(gravity(-g * N.y), torque("moment", U * N.z, on="body"),
               force("push", C, F * N.x, on="body")),
    )  # fmt: skip


def sphere():
    """theta about the vertical, phi from the downward vertical, a rod L."""
    theta, phi = dynamicsymbols("theta phi")
    m, L, g = P("m:kg L:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    out = sin(phi) * A.x - cos(phi) * A.z
    C = O.locatenew("C", L * out)
    return of_one_particle(
        "spherical pendulum", N, O, (theta, phi), ("bob", C, m), (gravity(-g * N.z),),
        example={"phi": 1.0, "theta_dot": 1.0}, S=out,
    )  # fmt: skip


def elastic():
    """th from below, the length l (1 + nu); l is the length at rest on the spring k."""
    th, nu = dynamicsymbols("th nu")
    g, k, l, m = P("g:m/s^2 k:N/m l:m m:kg", typical="9.81 100 1 0.1")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (th, N.z))
    C = O.locatenew("C", -l * (1 + nu) * B.y)
    return of_one_particle(
        "elastic pendulum", N, O, (th, nu), ("bob", C, m),
        (gravity(-g * N.y), force("spring", C, (k * l * nu + m * g) * B.y, on="bob")),
        example={"th": 0.5, "nu": 0.1}, side=N.z,
    )  # fmt: skip


def stiff():
    """A mass m at x, y on a spring k of the natural length l0 from the origin; gravity along -y."""
    x, y = dynamicsymbols("x y")
    m, k, l0, g = P("m:kg k:N/m l0:m g:m/s^2", typical="1 150 1 1")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + y * N.y)
    r = sqrt(x**2 + y**2)
    return Scene(
        "mass on a spring", N, O, coordinates=(x, y), bodies=(Particle("mass", C, m),),
        loads=(gravity(-g * N.y),
               force("spring", C, -k * (r - l0) / r * (x * N.x + y * N.y), on="mass")),
        reactions=(reaction("side", at=C, on="mass", by=None, along=N.z),),
        example={"x": 1.0, "y": 0.2},
    )  # fmt: skip
