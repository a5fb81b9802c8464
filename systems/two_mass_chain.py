"""Two masses in a row on two springs: seed document, problem 3."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, parameters, spring

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


def scene() -> Scene:
    """Wall, spring k, mass 3 m, spring k, mass 2 m; x1 and x2 from where the springs are slack.

    The slack lengths of the springs change no force, so they are left out of the positions.
    """
    ground = ReferenceFrame("N")
    origin = Point("O")
    first = origin.locatenew("P1", x1 * ground.x)
    second = origin.locatenew("P2", x2 * ground.x)
    return Scene(
        "two masses on springs",
        ground,
        origin,
        coordinates=(x1, x2),
        bodies=(Particle("first", first, 3 * m), Particle("second", second, 2 * m)),
        loads=(
            spring("k1", origin, first, k, along=ground.x),
            spring("k2", first, second, k, along=ground.x),
        ),
        example={"x1": 1.0, "x2": 0.0},
    )
