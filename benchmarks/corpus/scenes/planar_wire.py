"""A bead on a smooth wire y = a x^2."""

from sympy import sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction


def wire():
    """x to the side, y up."""
    x = dynamicsymbols("x")
    m, a, g = parameters("m a g", units="kg 1/m m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + a * x**2 * N.y)
    across = (N.y - 2 * a * x * N.x) / sqrt(1 + 4 * a**2 * x**2)
    return Scene(
        "bead on a parabola",
        N,
        O,
        coordinates=(x,),
        bodies=(Particle("bead", C, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("R", at=C, on="bead", by=None, along=across),),
    )
