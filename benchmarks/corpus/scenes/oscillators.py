"""Masses on springs, on inclines, a disk that rolls."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, of_one_particle, on_walls, one_mass, two_masses
from mechanics.scene import RigidBody, Scene, force, gravity, slide

t = dynamicsymbols._t


def mck():
    """Wall, spring and damper, mass, spring and damper, mass."""
    x1, x2 = dynamicsymbols("x1 x2")
    m1, m2, k1, k2, c1, c2 = P("m1:kg m2:kg k1:N/m k2:N/m c1:N*s/m c2:N*s/m")
    return two_masses(
        (x1, x2),
        (m1, m2),
        lambda N, A, B: (
            force("wall", A, (-k1 * x1 - c1 * x1.diff()) * N.x, on="one"),
            force(
                "between",
                B,
                (-k2 * (x2 - x1) - c2 * (x2.diff() - x1.diff())) * N.x,
                on="two",
                by="one",
            ),
        ),
    )


def three():
    """Wall, spring, mass, spring, mass, spring, wall."""
    m1, m2, k1, k2, k3 = P("m1:kg m2:kg k1:N/m k2:N/m k3:N/m")
    return on_walls("x1 x2", m1, m2, k1, k2, k3)


def absorber():
    """A mass on a spring with a force f_01 cos(omega t), a second one on it."""
    x1, x2 = dynamicsymbols("x_1 x_2")
    m1, m2, k1, k2, f, w = P("m_1:kg m_2:kg k_1:N/m k_2:N/m f_01:N omega:1/s")
    return two_masses(
        (x1, x2),
        (m1, m2),
        lambda N, A, B: (
            force("wall", A, (-k1 * x1 + f * cos(w * t)) * N.x, on="one"),
            force("between", B, -k2 * (x2 - x1) * N.x, on="two", by="one"),
        ),
    )


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


def _slope(sense, name):
    x = dynamicsymbols(name)
    m, theta, g = P("m:kg theta:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    along, normal = (
        sense * (cos(theta) * N.x + sin(theta) * N.y),
        -sin(theta) * N.x + cos(theta) * N.y,
    )
    return N, O, x, m, theta, g, along, normal


def incline():
    """A block x up a smooth incline."""
    N, O, x, m, _theta, g, along, normal = _slope(1, "x")
    C = O.locatenew("C", x * along)
    return of_one_particle(
        "block on an incline", N, O, (x,), ("block", C, m), (gravity(-g * N.y),), R=normal,
        side=N.z,
    )  # fmt: skip


def vertical():
    """A mass y on a vertical spring, unstretched at y = 0."""
    y = dynamicsymbols("y")
    m, k, g = P("m:kg k:N/m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    track = slide("track", None, "mass", at=O, axis=N.y, distance=y)
    return Scene(
        "mass on a spring",
        N,
        O,
        plane=N.z,
        joints=(track,),
        bodies=(RigidBody("mass", track.point, N, m, 0),),
        loads=(gravity(-g * N.y), force("spring", track.point, -k * y * N.y, on="mass")),
    )


def disk():
    """A uniform disk m, r rolls down a slope theta, x along it."""
    N, O, x, m, _theta, g, along, normal = _slope(-1, "x")
    (r,) = P("r:m")
    C = O.locatenew("C", x * along)
    K = C.locatenew("K", -r * normal)
    B = N.orientnew("B", "Axis", (x / r, N.z))
    return Scene(
        "disk on a slope",
        N,
        O,
        coordinates=(x,),
        bodies=(RigidBody("disk", C, B, m, m * r**2 / 2),),
        loads=(gravity(-g * N.y),),
        reactions=held(K, "disk", f=-along, n=normal),
    )
