"""Masses on springs, wheels on springs, a quarter of a car, a cylinder on a slab."""

from sympy import cos, sqrt
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


def mass_spring():
    """m, k."""
    x = dynamicsymbols("x")
    m, k = P("m:kg k:N/m")
    return one_mass(x, m, -k * x)


def across_h():
    """A particle m on a line.

    A spring k of the natural length l0 to a point at the distance h beside it.
    """
    x = dynamicsymbols("x")
    m, k, l0, h = P("m:kg k:N/m l0:m h:m", typical="5 500 0.5 0.3")
    return one_mass(x, m, -k * x * (1 - l0 / sqrt(x**2 + h**2)))


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
