"""Bead on a smooth wire bent to a cycloid."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction

theta = dynamicsymbols("theta")
m, a, g = parameters("m a g", units="kg m m/s^2", typical="0.1 0.5 9.81")


def make_scene():
    """x = a (theta - sin theta), y = a (1 + cos theta), y upwards."""
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", a * (theta - sin(theta)) * N.x + a * (1 + cos(theta)) * N.y)
    A = N.orientnew("A", "Axis", (theta / 2, N.z))
    # The tangent is (1 - cos theta, -sin theta), along (sin theta/2, -cos theta/2): across A.x.
    return Scene(
        "bead on a cycloid",
        N,
        O,
        coordinates=(theta,),
        bodies=(Particle("bead", P, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("R", at=P, on="bead", by=None, along=A.x),),
        example={"theta": 2.0},
    )
