"""Bead on a smooth wire bent to a cycloid."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from mechanics.scene import gravity, parameters

theta = dynamicsymbols("theta")
m, a, g = parameters("m a g", units="kg m m/s^2", typical="0.1 0.5 9.81")


def make_scene():
    """x = a (theta - sin theta), y = a (1 + cos theta), y upwards."""
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", a * (theta - sin(theta)) * N.x + a * (1 + cos(theta)) * N.y)
    A = N.orientnew("A", "Axis", (theta / 2, N.z))
    # The tangent is (1 - cos theta, -sin theta), along (sin theta/2, -cos theta/2): across A.x.
    return of_one_particle(
        "bead on a cycloid", N, O, (theta,), ("bead", P, m), (gravity(-g * N.y),),
        example={"theta": 2.0}, R=A.x,
    )  # fmt: skip
