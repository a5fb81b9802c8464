"""Masses on springs, wheels on springs, a quarter of a car, a cylinder on a slab."""

from sympy import Abs, cos, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, one_mass, two_masses
from mechanics.scene import RigidBody, Scene, force, slide

t = dynamicsymbols._t


def ceiling():
    """A device M on kM and a counterweight m on kT below it.

    Both with friction in the air, the ceiling moved by -Ax cos(Omega t).
    """
    a, b = dynamicsymbols("zM zT")
    M, m, kM, kT, eM, eT, A, W = P("M:kg m:kg kM:N/m kT:N/m etaM:N*s/m etaT:N*s/m Ax:m Omega:1/s")
    return two_masses(
        (a, b),
        (M, m),
        lambda N, A1, B1: (
            force("ceiling", A1, (-kM * (a + A * cos(W * t)) - eM * a.diff()) * N.x, on="one"),
            force("air", B1, -eT * b.diff() * N.x, on="two"),
            force("between", B1, -kT * (b - a) * N.x, on="two", by="one"),
        ),
    )


def masas():
    """Wall, k_1, m_1, k_2 beside a damper b, m_2, k_3, wall; a force u on m_1."""
    x1, x2, u = dynamicsymbols("x_1 x_2 u")
    m1, m2, k1, k2, k3, b = P("m_1:kg m_2:kg k_1:N/m k_2:N/m k_3:N/m b:N*s/m")
    return two_masses(
        (x1, x2),
        (m1, m2),
        lambda N, A, B: (
            force("left", A, (u - k1 * x1) * N.x, on="one"),
            force("right", B, -k3 * x2 * N.x, on="two"),
            force(
                "between",
                B,
                (-k2 * (x2 - x1) - b * (x2.diff() - x1.diff())) * N.x,
                on="two",
                by="one",
            ),
        ),
        (u,),
    )


def cubic():
    """X on a spring k_1 X + k_2 X^2, a drag b |X'| X'."""
    X = dynamicsymbols("X")
    m, b, k1, k2 = P("m:kg b:kg/m k_1:N/m k_2:N/m^2")
    return one_mass(X, m, -b * Abs(X.diff()) * X.diff() - k1 * X - k2 * X**2)


def mass_spring():
    """m, k."""
    x = dynamicsymbols("x")
    m, k = P("m:kg k:N/m")
    return one_mass(x, m, -k * x)


def across():
    """A particle m on a line.

    A spring k of the natural length L/2 to a point at the distance L beside it.
    """
    x = dynamicsymbols("x")
    m, k, L = P("m:kg k:N/m L:m")
    return one_mass(x, m, -k * x * (1 - L / 2 / sqrt(L**2 + x**2)))


def across_h():
    """A particle m on a line.

    A spring k of the natural length l0 to a point at the distance h beside it.
    """
    x = dynamicsymbols("x")
    m, k, l0, h = P("m:kg k:N/m l0:m h:m", typical="5 500 0.5 0.3")
    return one_mass(x, m, -k * x * (1 - l0 / sqrt(x**2 + h**2)))


def ressort():
    """A mass m at z below its hook on a spring k, l_0."""
    z = dynamicsymbols("z")
    m, k, l0, g = P("m:kg k:N/m ell_0:m g:m/s^2")
    return one_mass(z, m, -k * (z - l0), g=g, sense=-1)


def strut():
    """A sprung mass m, its strut k, c compressed by chi."""
    chi = dynamicsymbols("chi")
    m, k, c, g = P("m:kg k:N/m c:N*s/m g:m/s^2")
    return one_mass(chi, m, -k * chi - c * chi.diff(), g=g, sense=-1)


def quarter():
    """A mass quarter_car_mass at car_x above the road, pulled down by F_suspension."""
    x, F = dynamicsymbols("car_x F_suspension")
    m, g = P("quarter_car_mass:kg g:m/s^2")
    return one_mass(x, m, -F, (F,), g=g, sense=1)


def roller():
    """A wheel M, R, J_c that rolls by x, a spring k from its top.

    A damper r at its centre, a couple C.
    """
    x, C = dynamicsymbols("x C")
    M, R, J, k, r = P("M:kg R:m J_c:kg*m^2 k:N/m r:N*s/m")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-x / R, N.z))
    G = O.locatenew("G", x * N.x)
    K, T = G.locatenew("K", -R * N.y), G.locatenew("T", R * N.y)
    return Scene(
        "wheel on a spring",
        N,
        O,
        coordinates=(x,),
        inputs=(C,),
        plane=N.z,
        bodies=(RigidBody("wheel", G, A, M, J),),
        loads=(
            force("spring", T, -k * 2 * x * N.x, on="wheel"),
            force("damper", G, (C / R - r * x.diff()) * N.x, on="wheel"),
        ),
        reactions=held(K, "wheel", f=N.x, n=N.y),
    )


def slab():
    """A slab m at x on a smooth table and a spring k, a cylinder M, R, I that rolls on it by z."""
    x, z = dynamicsymbols("x z")
    m, M, R, I, k = P("m:kg M:kg R:m I:kg*m^2 k:N/m")
    N, O = ReferenceFrame("N"), Point("O")
    track = slide("track", None, "slab", at=O, axis=N.x, distance=x)
    S = track.point
    A = N.orientnew("A", "Axis", (-z / R, N.z))
    C = S.locatenew("C", z * N.x + R * N.y)
    K = C.locatenew("K", -R * N.y)
    return Scene(
        "cylinder on a slab",
        N,
        O,
        coordinates=(z,),
        joints=(track,),
        plane=N.z,
        bodies=(RigidBody("slab", S, N, m, 0), RigidBody("cylinder", C, A, M, I)),
        loads=(force("spring", S, -k * x * N.x, on="slab"),),
        reactions=held(K, "cylinder", "slab", f=N.x, n=N.y),
    )


def tres():
    """Three masses: K_1, C_1 from the left wall to m_1, K_2 to m_2.

    K_3 from the right wall to m_3, K_13, K_23, C_12, C_23 between them; a force F_2.
    """
    x1, x2, x3, F = dynamicsymbols("x_1 x_2 x_3 F_2")
    m1, m2, m3, K1, K2, K3, K13, K23, C1, C12, C23 = P(
        "m_1:kg m_2:kg m_3:kg K_1:N/m K_2:N/m K_3:N/m "
        "K_13:N/m K_23:N/m C_1:N*s/m C_12:N*s/m C_23:N*s/m"
    )
    N, O = ReferenceFrame("N"), Point("O")
    names = ("one", "two", "three")
    joints = [
        slide(f"track {n}", None, n, at=O, axis=N.x, distance=q)
        for n, q in zip(names, (x1, x2, x3), strict=True)
    ]
    bodies = [
        RigidBody(n, j.point, N, m, 0) for n, j, m in zip(names, joints, (m1, m2, m3), strict=True)
    ]
    A, B, D = (j.point for j in joints)
    return Scene(
        "three masses",
        N,
        O,
        plane=N.z,
        joints=joints,
        bodies=bodies,
        inputs=(F,),
        loads=(
            force("left one", A, (-K1 * x1 - C1 * x1.diff()) * N.x, on="one"),
            force("left two", B, (F - K2 * x2) * N.x, on="two"),
            force("right", D, -K3 * x3 * N.x, on="three"),
            force("one two", B, -C12 * (x2.diff() - x1.diff()) * N.x, on="two", by="one"),
            force("one three", D, -K13 * (x3 - x1) * N.x, on="three", by="one"),
            force(
                "two three",
                D,
                (-K23 * (x3 - x2) - C23 * (x3.diff() - x2.diff())) * N.x,
                on="three",
                by="two",
            ),
        ),
    )
