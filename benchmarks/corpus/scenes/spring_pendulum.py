"""A mass on a spring that swings in a vertical plane."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from mechanics.scene import Particle, Scene, gravity, parameters, spring

r, theta, x, y = dynamicsymbols("r theta x y")
m, k, b, g, L, l0 = parameters(
    "m k b g L l0", units="kg N/m m m/s^2 m m", typical="1 20 1 9.81 1 1"
)


def polar():
    """Length r of the spring, whose slack length is b; theta from hanging."""
    return _polar(b)


def polar_with_L():
    """The same, the slack length is L."""
    return _polar(L)


def _polar(slack):
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", -r * A.y)
    bob = Particle("bob", P, m)

    return Scene(
        "spring pendulum",
        N,
        O,
        coordinates=(r, theta),
        bodies=(bob,),
        loads=(gravity(-g * N.y), spring("k", O, P, k, length=slack)),
        example={"r": 1.2, "theta": 0.5},
    )


def cartesian():
    """Position x, y of the mass from the suspension, y upwards."""
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", x * N.x + y * N.y)
    return of_one_particle(
        "springy pendulum", N, O, (x, y), ("bob", P, m),
        (gravity(-g * N.y), spring("k", O, P, k, length=l0)), example={"x": 0.5, "y": -1.2},
    )  # fmt: skip
