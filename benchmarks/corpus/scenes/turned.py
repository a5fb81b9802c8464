"""Particles on what is turned at a given rate: a table, a parabola."""

from sympy import sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from mechanics.scene import gravity, parameters, spring

x, y, r, p = dynamicsymbols("x y r p")
t = dynamicsymbols._t
m, k, Omega, c, omega, w, g = parameters(
    "m k Omega c omega w g", units="kg N/m 1/s 1/m 1/s 1/s m/s^2", typical="0.1 4 2 1.5 3 3 9.81"
)
(kp,) = parameters("k", units="1/m", typical="1.5")


def table():
    """x, y on a smooth table turned by Omega t; a spring k without slack length to its centre."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (Omega * t, N.z))
    P = O.locatenew("P", x * A.x + y * A.y)
    return of_one_particle(
        "rotating table", N, O, (x, y), ("puck", P, m), (spring("k", O, P, k),), example={"x": 0.2},
        support=N.z,
    )  # fmt: skip


def parabola():
    """z = c r^2, turned by omega t."""
    return _parabola(r, c, omega)


def parabola_in_p():
    """z = k p^2, turned by w t."""
    return _parabola(p, kp, w)


def _parabola(radius, bend, rate):
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (rate * t, N.z))
    P = O.locatenew("P", radius * A.x + bend * radius**2 * A.z)
    across = (-2 * bend * radius * A.x + A.z) / sqrt(1 + 4 * bend**2 * radius**2)
    return of_one_particle(
        "bead on a rotating parabola", N, O, (radius,), ("bead", P, m), (gravity(-g * N.z),),
        example={radius.func.__name__: 0.2}, normal=across, side=A.y,
    )  # fmt: skip
