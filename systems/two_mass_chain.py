"""Two masses in a row on two springs: seed document, problem 3."""

from fractions import Fraction

from sympy import Expr, Symbol
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, parameters, spring
from mechanics.scene.system import Path

x1, x2 = dynamicsymbols("x1 x2")
m, k = parameters(
    "m k",
    units="kg N/m",
    typical="1 1",
    meanings=(
        "unit of mass: the masses are 3 m and 2 m",
        "stiffness of each of the two springs",
    ),
)


m1, m2, k1, k2 = parameters(
    "m1 m2 k1 k2",
    units="kg kg N/m N/m",
    typical="3 2 1 1",
    meanings=(
        "mass of the first body",
        "mass of the second body",
        "stiffness of the spring to the wall",
        "stiffness of the spring between the masses",
    ),
)
decades = Symbol("decades", real=True)
TOWARDS_EQUAL_FREQUENCIES = Path(
    "m2/m1 = k2/k1 = 10^-decades: the frequencies approach each other",
    decades,
    tuple(map(Fraction, range(19))),
    (("m2", m1 / 10**decades), ("k2", k1 / 10**decades)),
)


def scene() -> Scene:
    """Wall, spring k, mass 3 m, spring k, mass 2 m; x1 and x2 from where the springs are slack."""
    return _scene("two masses on springs", (3 * m, 2 * m), (k, k))


def unequal() -> Scene:
    """The same with masses m1, m2 and springs k1, k2 of their own."""
    return _scene("two unequal masses on springs", (m1, m2), (k1, k2))


def _scene(name: str, masses: tuple[Expr, Expr], springs: tuple[Expr, Expr]) -> Scene:
    """The chain; the slack lengths of the springs change no force, so they are left out."""
    ground = ReferenceFrame("N")
    origin = Point("O")
    first = origin.locatenew("P1", x1 * ground.x)
    second = origin.locatenew("P2", x2 * ground.x)
    return Scene(
        name,
        ground,
        origin,
        coordinates=(x1, x2),
        bodies=(Particle("first", first, masses[0]), Particle("second", second, masses[1])),
        loads=(
            spring("k1", origin, first, springs[0], along=ground.x),
            spring("k2", first, second, springs[1], along=ground.x),
        ),
        example={"x1": 1.0, "x2": 0.0},
    )
