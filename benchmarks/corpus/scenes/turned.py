"""Particles on what is turned at a given rate: a table, a parabola."""

from sympy import sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction, spring

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
    return Scene(
        "rotating table",
        N,
        O,
        coordinates=(x, y),
        bodies=(Particle("puck", P, m),),
        loads=(spring("k", O, P, k),),
        reactions=(reaction("support", at=P, on="puck", by=None, along=N.z),),
        example={"x": 0.2},
    )


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
    return Scene(
        "bead on a rotating parabola",
        N,
        O,
        coordinates=(radius,),
        bodies=(Particle("bead", P, m),),
        loads=(gravity(-g * N.z),),
        reactions=(
            reaction("normal", at=P, on="bead", by=None, along=across),
            reaction("side", at=P, on="bead", by=None, along=A.y),
        ),
        example={radius.func.__name__: 0.2},
    )
