"""One particle in frames that turn, or in a trap."""

from sympy import sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P
from mechanics.scene import Particle, Scene, force, reaction

t = dynamicsymbols._t


def _particle(m, rate, push, *, plane=False):
    """x, y, z along axes that turn at the rate about z; the push in these axes."""
    x, y, z = dynamicsymbols("x y z")
    N, O = ReferenceFrame("N"), Point("O")
    A = N if rate == 0 else N.orientnew("A", "Axis", (rate * t, N.z))
    C = O.locatenew("C", x * A.x + y * A.y + (0 if plane else z) * A.z)
    X, Y, Z = push(x, y, z)
    loads = (
        ()
        if (X, Y, Z) == (0, 0, 0)
        else (force("push", C, X * A.x + Y * A.y + Z * A.z, on="particle"),)
    )
    holds = (reaction("support", at=C, on="particle", by=None, along=A.z),) if plane else ()
    return Scene(
        "particle",
        N,
        O,
        coordinates=(x, y) if plane else (x, y, z),
        reactions=holds,
        bodies=(Particle("particle", C, m),),
        loads=loads,
    )


def penning():
    """A charge q in a field B_0 along z and a quadrupole V_0/d^2."""
    m, q, B, V, d = P("m:kg q:C B_0:T V_0:V d:m")
    c = q * V / d**2
    return _particle(
        m, 0, lambda x, y, z: (c * x + q * B * y.diff(), c * y - q * B * x.diff(), -2 * c * z)
    )


def foucault():
    """Small swings at the latitude varphi; g is what a plumb line feels there."""
    m, w, phi, L, g = P("m:kg omega:1/s varphi:1 L:m g:m/s^2")
    n = w * sin(phi)
    # Gravity without the centrifugal force about the vertical, which g contains.
    return _particle(
        m, n, lambda x, y, z: (-m * (g / L + n**2) * x, -m * (g / L + n**2) * y, 0), plane=True
    )


def rotating():
    """Free, seen from axes that turn."""
    m, w = P("m:kg omega:1/s")
    return _particle(m, w, lambda x, y, z: (0, 0, 0))


def hill():
    """Near a circular orbit with the mean motion n, gravity to first order; x outwards, y
    forwards."""
    m, n = P("m:kg n:1/s")
    return _particle(m, n, lambda x, y, z: (2 * m * n**2 * x, -m * n**2 * y, -m * n**2 * z))


def three_bodies():
    """Two primaries at x = -D_1 and D_2 in the axes that turn with them at n."""
    m, n, a, b, D1, D2 = P("m:kg n:1/s mu_1:m^3/s^2 mu_2:m^3/s^2 D_1:m D_2:m")

    def push(x, y, z):
        r1, r2 = sqrt((x + D1) ** 2 + y**2 + z**2), sqrt((x - D2) ** 2 + y**2 + z**2)
        return (
            -m * a * (x + D1) / r1**3 - m * b * (x - D2) / r2**3,
            *(-m * (a / r1**3 + b / r2**3) * s for s in (y, z)),
        )

    return _particle(m, n, push)
