"""Pendulums: of one bob, two, of rods, on springs, spherical."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    double_pendulum,
    of_one_particle,
    pendulum,
    spring_pendulum,
)
from mechanics.scene import RigidBody, Scene, force, gravity, pin, reaction


def letters():
    """Angles a, b, with m1, m2, l1, l2, g."""
    return double_pendulum("a b", *P("m1:kg m2:kg l1:m l2:m g:m/s^2"))


def arc():
    """A bob m on a thread l at the arc s from the lowest point, a drag k v."""
    s = dynamicsymbols("s")
    m, l, g, k = P("m:kg l:m g:m/s^2 k:N*s/m")
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (s / l, N.z))
    C = O.locatenew("C", -l * B.y)
    return of_one_particle(
        "pendulum", N, O, (s,), ("bob", C, m),
        (gravity(-g * N.y), force("drag", C, -k * s.diff() * B.x, on="bob")), example={"s": 0.3},
        pull=B.y, side=N.z,
    )  # fmt: skip


def spring_x():
    """x the length of the spring k with the natural length l, theta from below."""
    x, theta = dynamicsymbols("x theta")
    m, k, l, g = P("m:kg k:N/m l:m g:m/s^2")
    return spring_pendulum(theta, x, m, g, k * (x - l))


def three_rods():
    """Three equal rods m, l, the outer ones hang side by side at the distance l.

    The third joins their ends; theta from below.
    """
    theta = dynamicsymbols("theta")
    m, l, g = P("m:kg l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C1 = O.locatenew("C1", -l / 2 * A.y)
    C2 = O.locatenew("C2", l * N.x - l / 2 * A.y)
    C3 = O.locatenew("C3", l / 2 * N.x - l * A.y)
    E1, E2, Q = (
        O.locatenew("E1", -l * A.y),
        O.locatenew("E2", l * N.x - l * A.y),
        O.locatenew("Q", l * N.x),
    )
    return Scene(
        "three rods",
        N,
        O,
        plane=N.z,
        coordinates=(theta,),
        loads=(gravity(-g * N.y),),
        bodies=(
            RigidBody("left", C1, A, m, m * l**2 / 12),
            RigidBody("right", C2, A, m, m * l**2 / 12),
            RigidBody("lower", C3, N, m, m * l**2 / 12),
        ),
        reactions=(
            *(
                reaction(n + d, at=p, on=on, by=by, along=v)
                for n, p, on, by in (
                    ("A", O, "left", None),
                    ("B", Q, "right", None),
                    ("C", E1, "lower", "left"),
                    ("D", E2, "lower", "right"),
                )
                for d, v in (("x", N.x), ("y", N.y))
                if n + d != "Dy"
            ),
        ),
    )


def two_rods():
    """A rod m, l on a pin, theta from below.

    A second one turns by phi about its own midpoint at the end of the first.
    """
    theta, phi = dynamicsymbols("theta phi")
    m, l, g = P("m:kg l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    first = pin("first", None, "upper", at=O, axis=N.z, angle=theta)
    E = first.point.locatenew("E", -l * first.frame.y)
    second = pin("second", "upper", "lower", at=E, axis=N.z, angle=phi)
    C = first.point.locatenew("C", -l / 2 * first.frame.y)
    return Scene(
        "two rods",
        N,
        O,
        plane=N.z,
        joints=(first, second),
        loads=(gravity(-g * N.y),),
        bodies=(
            RigidBody("upper", C, first.frame, m, m * l**2 / 12),
            RigidBody("lower", E, second.frame, m, m * l**2 / 12),
        ),
    )


def length():
    """theta from below, m, length."""
    m, l, g = P("m:kg length:m g:m/s^2")
    return pendulum(dynamicsymbols("theta"), m, 0, l, g)
