"""A bead on a smooth wire y = a x^2."""

from sympy import sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from mechanics.scene import gravity, parameters


def wire():
    """x to the side, y up."""
    x = dynamicsymbols("x")
    m, a, g = parameters("m a g", units="kg 1/m m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + a * x**2 * N.y)
    across = (N.y - 2 * a * x * N.x) / sqrt(1 + 4 * a**2 * x**2)
    return of_one_particle(
        "bead on a parabola", N, O, (x,), ("bead", C, m), (gravity(-g * N.y),), R=across
    )
