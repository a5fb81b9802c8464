"""Masses on springs, on inclines, a disk that rolls."""

from sympy import sin
from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, one_mass, two_masses
from mechanics.scene import force

t = dynamicsymbols._t


def den_hartog():
    """The same in the symbols of a textbook: M, K, m, k, P_0 sin(omega t)."""
    x1, x2 = dynamicsymbols("x_1 x_2")
    M, m, K, k, P0, w = P("M:kg m:kg K:N/m k:N/m P_0:N omega:1/s")
    return two_masses(
        (x1, x2),
        (M, m),
        lambda N, A, B: (
            force("wall", A, (-K * x1 + P0 * sin(w * t)) * N.x, on="one"),
            force("between", B, -k * (x2 - x1) * N.x, on="two", by="one"),
        ),
    )


def pushed():
    """A spring k with the rest position x0, a damping c, a force F."""
    x, F = dynamicsymbols("x F")
    m, k, c, x0 = P("m:kg k:N/m c:N*s/m x0:m")
    return one_mass(x, m, F - k * (x - x0) - c * x.diff(), (F,))


def linear():
    """m, k, c."""
    x = dynamicsymbols("x")
    m, k, c = P("m:kg k:N/m c:N*s/m")
    return one_mass(x, m, -k * x - c * x.diff())


def game():
    """m, k, b."""
    x = dynamicsymbols("x")
    m, k, b = P("m:kg k:N/m b:N*s/m")
    return one_mass(x, m, -k * x - b * x.diff())


def components():
    """A spring k, a damper c, a force u to the left."""
    x, u = dynamicsymbols("x u")
    m, k, c = P("m:kg k:N/m c:N*s/m")
    return one_mass(x, m, -k * x - c * x.diff() - u, (u,))
