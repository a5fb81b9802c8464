"""Pendulums: single, double, winding, on a spring; a leg; a bead on a helix."""

from sympy import pi, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, of_one_particle
from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    pin,
    torque,
)

t = dynamicsymbols._t


def _two(angles, names, *, rods=False, drag=None):
    """Two links, both angles from the vertical: bobs at the ends, or uniform rods."""
    a, b = dynamicsymbols(angles)
    m1, m2, l1, l2, g = parameters(names, units="kg kg m m m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    first = pin("first", None, "upper", at=O, axis=N.z, angle=a)
    end = first.point.locatenew("E", -l1 * first.frame.y)
    second = pin("second", "upper", "lower", at=end, axis=N.z, angle=b)
    half = 2 if rods else 1
    P1 = O.locatenew("P1", -l1 / half * first.frame.y)
    P2 = end.locatenew("P2", -l2 / half * second.frame.y)
    I1, I2 = (m1 * l1**2 / 12, m2 * l2**2 / 12) if rods else (0, 0)
    loads = [gravity(-g * N.y)]
    if drag:
        c1, c2 = parameters(drag, units="N*m*s N*m*s")
        loads += [
            torque("drag1", -c1 * a.diff() * N.z, on="upper"),
            torque("drag2", -c2 * b.diff() * N.z, on="lower"),
        ]
    return Scene(
        "double pendulum",
        N,
        O,
        plane=N.z,
        bodies=(
            RigidBody("upper", P1, first.frame, m1, I1),
            RigidBody("lower", P2, second.frame, m2, I2),
        ),
        joints=(first, second),
        loads=loads,
    )


def plain():
    """theta1, l1: without subscripts."""
    return _two("theta1 theta2", "m1 m2 l1 l2 g")


def matplotlib():
    """Capital letters."""
    return _two("th1 th2", "M1 M2 L1 L2 G")


def _one(angle, m, inertia, reach, g, loads=(), *, origin=None):
    """A body on a pin, from the downward vertical, counterclockwise."""
    N, O = ReferenceFrame("N"), Point("O")
    at = O if origin is None else O.locatenew("A", origin * N.x)
    hold = pin("hold", None, "body", at=at, axis=N.z, angle=angle)
    C = hold.point.locatenew("C", -reach * hold.frame.y)
    return Scene(
        "pendulum",
        N,
        O,
        plane=N.z,
        bodies=(RigidBody("body", C, hold.frame, m, inertia),),
        joints=(hold,),
        loads=(gravity(-g * N.y), *(make(N, C, hold.frame) for make in loads)),
    )


def tension():
    """A bob on a rod; F pulls it to the pivot."""
    phi = dynamicsymbols("phi")
    m, g, L = P("m:kg g:m/s^2 L:m")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (phi, N.z))
    C = O.locatenew("C", -L * B.y)
    return of_one_particle(
        "pendulum", N, O, (phi,), ("bob", C, m), (gravity(-g * N.y),), F=B.y, side=N.z
    )


def winding():
    """The string winds on a fixed cylinder of radius a; it is l long where it hangs straight
    down."""
    theta = dynamicsymbols("theta")
    m, a, l, g = P("m:kg a:m l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (theta, N.z))
    C = O.locatenew("C", a * B.x - (l + a * theta) * B.y)
    return of_one_particle(
        "string on a cylinder", N, O, (theta,), ("bob", C, m), (gravity(-g * N.y),), S=B.y,
        side=N.z,
    )  # fmt: skip


def car():
    """The pivot is on a car with the acceleration a to the right."""
    m, l, a, g = P("m:kg l:m a:m/s^2 g:m/s^2")
    return _one(dynamicsymbols("theta"), m, 0, l, g, origin=a * t**2 / 2)


def driven():
    """Giordano's pendulum: friction q and drive F per moment of inertia."""
    theta = dynamicsymbols("theta")
    m, L, g, q, F, w = P("m:kg L:m g:m/s^2 q:1/s F:1/s^2 drive_freq:1/s")
    moment = m * L**2 * (F * sin(w * t) - q * theta.diff())
    return _one(theta, m, 0, L, g, [lambda N, C, B: torque("drive", moment * N.z, on="body")])


def torsion():
    """A uniform rod with a torsion spring in its pivot."""
    phi = dynamicsymbols("varphi")
    m, l, g, c = P("m:kg l:m g:m/s^2 c_T:N*m")
    return _one(
        phi,
        m,
        m * l**2 / 12,
        l / 2,
        g,
        [lambda N, C, B: torque("spring", -c * phi * N.z, on="body")],
    )


def physical():
    """I is about the pivot, h from there to the centre of mass."""
    m, h, I, g = P("m:kg h:m I:kg*m^2 g:m/s^2")
    return _one(dynamicsymbols("theta"), m, I - m * h**2, h, g)


def hoop():
    """A thin hoop on a nail."""
    M, R, g = P("M:kg R:m g:m/s^2")
    return _one(dynamicsymbols("theta"), M, M * R**2, R, g)


def viscous():
    """A friction k times the velocity of the bob."""
    theta = dynamicsymbols("theta")
    m, l, g, k = P("m:kg l:m g:m/s^2 k:N*s/m")
    drag = -k * l * theta.diff()
    return _one(theta, m, 0, l, g, [lambda N, C, B: force("drag", C, drag * B.x, on="body")])


def leg():
    """A mass on a leg with a spring, psi from the upward vertical, clockwise."""
    zeta, psi = dynamicsymbols("zeta psi")
    m, k, eta, g = P("m:kg k:N/m eta_0:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (-psi, N.z))
    C = O.locatenew("C", zeta * B.y)
    return of_one_particle(
        "leg with a spring", N, O, (zeta, psi), ("body", C, m),
        (gravity(-g * N.y), force("leg", C, k * (eta - zeta) * B.y, on="body")),
        example={"zeta": 1.0}, side=N.z,
    )  # fmt: skip


def helix():
    """A bead on a smooth helix of radius a, z = k theta."""
    theta = dynamicsymbols("theta")
    m, a, k, g = P("m:kg a:m k:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (theta, N.z))
    C = O.locatenew("C", a * B.x + k * theta * B.z)
    return of_one_particle(
        "bead on a helix", N, O, (theta,), ("bead", C, m), (gravity(-g * N.z),), radial=B.x,
        across=(a * B.z - k * B.y) / sqrt(a**2 + k**2),
    )  # fmt: skip


def usenet():
    """th1, th2 from the downward vertical, in plain letters."""
    return _two("th1 th2", "m1 m2 l1 l2 g")


def motor():
    """A weight above its motor: position clockwise from the horizontal, pi/2 is upright."""
    position, tau = dynamicsymbols("position torque")
    m, l, g = P("mass:kg length:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "weight", at=O, axis=-N.z, angle=position)
    C = hold.point.locatenew("C", -l * hold.frame.x)
    return Scene(
        "pendulum on a motor",
        N,
        O,
        plane=N.z,
        bodies=(RigidBody("weight", C, hold.frame, m, 0),),
        joints=(hold,),
        inputs=(tau,),
        loads=(gravity(-g * N.y), torque("motor", -tau * N.z, on="weight")),
    )


def forced_spring():
    """x, y from the pivot; spring k of length lo, drag c, a torque amp sin(2 pi w t) about the
    pivot, clockwise."""
    x, y = dynamicsymbols("x y")
    m, k, c, g, lo, amp, w = P("m:kg k:N/m c:N*s/m g:m/s^2 lo:m amp:N*m w:1/s")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + y * N.y)
    L = sqrt(x**2 + y**2)
    pull, side = k * (L - lo), amp * sin(2 * pi * w * t) / L
    fx = -pull * x / L + side * y / L - c * x.diff(t)
    fy = -pull * y / L - side * x / L - c * y.diff(t)
    return of_one_particle(
        "forced spring pendulum", N, O, (x, y), ("bob", C, m),
        (gravity(-g * N.y), force("all", C, fx * N.x + fy * N.y, on="bob")),
        example={"x": 0.3, "y": -1.0}, side=N.z,
    )  # fmt: skip
