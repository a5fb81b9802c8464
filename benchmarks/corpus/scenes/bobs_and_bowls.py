"""Pendulums: one, two, on a spring, spherical; rods on hinges, a bead on a wire.

Cylinders and balls in bowls.
"""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    of_one_particle,
    pendulum,
    spring_pendulum,
)
from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    pin,
    torque,
)

t = dynamicsymbols._t


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


def sphere_long():
    """theta from the upward vertical, phi about it; the length l0 + a sin(w t)."""
    m, g, l0, a, w = P("m:kg g:m/s^2 l0:m a:m w:1/s", typical="10 9.81 6 1 0.1")
    return _sphere("theta phi", l0 + a * sin(w * t), m, g, 1, {"theta": 2.0, "phi_dot": 0.25})


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
