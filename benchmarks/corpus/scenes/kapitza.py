"""Pendulum whose point of support is shaken up and down."""

from sympy import cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from mechanics.scene import gravity, parameters

phi, theta = dynamicsymbols("phi theta")
t = dynamicsymbols._t
m, l, g, a, gamma, w, ell = parameters(
    "m l g a gamma w ell", units="kg m m/s^2 m 1/s 1/s m", typical="1 1 9.81 0.1 250 250 1"
)


def hanging():
    """phi from hanging; the support is a cos(gamma t) below its mean place."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    S = O.locatenew("S", -a * cos(gamma * t) * N.y)
    P = S.locatenew("P", -l * A.y)
    return of_one_particle(
        "pendulum on a shaken support", N, O, (phi,), ("bob", P, m), (gravity(-g * N.y),),
        example={"phi": 0.3}, T=A.y,
    )  # fmt: skip
