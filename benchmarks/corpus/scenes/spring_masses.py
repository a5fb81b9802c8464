"""Masses on springs, a car's body, a cylinder that rolls."""

from sympy import cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, of_one_particle, on_walls, one_mass, two_masses
from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    reaction,
    torque,
)

t = dynamicsymbols._t


def _cookbook(more):
    x1, x2 = dynamicsymbols("x1 x2")
    m1, m2, k1, k2, L1, L2, b1, b2 = P("m1:kg m2:kg k1:N/m k2:N/m L1:m L2:m b1:N*s/m b2:N*s/m")
    return two_masses(
        (x1, x2),
        (m1, m2),
        lambda N, A, B: (
            force("one", A, (-b1 * x1.diff() - k1 * (x1 - L1) + more) * N.x, on="one"),
            force("two", B, -b2 * x2.diff() * N.x, on="two"),
            force("between", B, -k2 * (x2 - x1 - L2) * N.x, on="two", by="one"),
        ),
    )


def cookbook():
    """Wall, spring, mass, spring, mass, each with a friction."""
    return _cookbook(0)


def shaken():
    """The same with a force F0 sin(2 pi f t) on the first."""
    F0, f = P("F0:N f:1/s")
    return _cookbook(F0 * sin(2 * pi * f * t))


def three_springs():
    """Wall, spring, mass, spring, mass, spring, wall."""
    m1, m2, k1, k2, k3 = P("m_1:kg m_2:kg k_1:N/m k_2:N/m k_3:N/m")
    return on_walls("x_1 x_2", m1, m2, k1, k2, k3)


def molecule():
    """Two equal masses on a spring of the length l, free."""
    x1, x2 = dynamicsymbols("x_1 x_2")
    m, k, l = P("m:kg k:N/m l:m")
    return two_masses(
        (x1, x2),
        (m, m),
        lambda N, A, B: (force("spring", B, -k * (x2 - x1 - l) * N.x, on="two", by="one"),),
    )


def kappa():
    """A spring and a damping."""
    x = dynamicsymbols("x")
    m, k, c = P("m:kg spring_const:N/m kappa:N*s/m")
    return one_mass(x, m, -k * x - c * x.diff())


def incline():
    """A cart on an incline, x down it from the upper end of a spring."""
    x = dynamicsymbols("x")
    m, k, x0, theta, g = P("m:kg k:N/m x_0:m theta:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    along = cos(theta) * N.x - sin(theta) * N.y
    C = O.locatenew("C", x * along)
    return of_one_particle(
        "cart on an incline", N, O, (x,), ("cart", C, m),
        (gravity(-g * N.y), force("spring", C, -k * (x - x0) * along, on="cart")),
        R=sin(theta) * N.x + cos(theta) * N.y, side=N.z,
    )  # fmt: skip


def cylinder():
    """A solid cylinder rolls on a table, a spring k at its axle."""
    x = dynamicsymbols("x")
    M, R, k = P("M:kg R:m k:N/m")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + R * N.y)
    K = C.locatenew("K", -R * N.y)
    B = N.orientnew("B", "Axis", (-x / R, N.z))
    return Scene(
        "cylinder on a spring",
        N,
        O,
        coordinates=(x,),
        bodies=(RigidBody("cylinder", C, B, M, M * R**2 / 2),),
        loads=(force("spring", C, -k * x * N.x, on="cylinder"),),
        reactions=held(K, "cylinder", f=N.x, N=N.y),
    )


def bounce():
    """A car's body, Z up, theta nose up; front axle b ahead, rear axle c behind, K_f, K_r per
    axle, radius of gyration kappa."""
    Z, theta = dynamicsymbols("Z theta")
    M, kappa, b, c, Kf, Kr = P("M:kg kappa:m b:m c:m K_f:N/m K_r:N/m")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", Z * N.y)
    f, r = -Kf * (Z + b * theta), -Kr * (Z - c * theta)
    return Scene(
        "body of a car",
        N,
        O,
        coordinates=(Z, theta),
        bodies=(RigidBody("body", C, A, M, M * kappa**2),),
        loads=(
            force("springs", C, (f + r) * N.y, on="body"),
            torque("pitch", (b * f - c * r) * N.z, on="body"),
        ),
        reactions=(reaction("guide", at=C, on="body", by=None, along=N.x),),
    )
