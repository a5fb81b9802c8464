"""A rod on a pivot that a torque u swings up: the environment `Pendulum-v1` of Gymnasium.

theta'' = 3 g / (2 l) sin theta + 3 / (m l^2) u        theta from upright
"""

from sympy import sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, gravity, parameters, reaction, torque
from mechanics.scene.composite import part
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.shapes import Rod

theta, u = dynamicsymbols("theta u")
m, l, g = parameters(
    "m l g",
    units="kg m m/s^2",
    typical="1 1 10",
    meanings=("mass of the rod", "length of the rod", "acceleration of gravity"),
)
ROD = part(Rod(l), mass=m)


def scene() -> Scene:
    """A uniform rod in a vertical plane, a pivot at one end of it."""
    ground = ReferenceFrame("N")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    pivot = Point("O")
    centre = pivot.locatenew("C", l / 2 * rod.y)
    return Scene(
        "rod pendulum",
        ground,
        pivot,
        coordinates=(theta,),
        bodies=(RigidBody("rod", centre, rod, m, ROD.inertia),),
        loads=(gravity(-g * ground.y), torque("u", u * ground.z, on="rod")),
        reactions=(
            reaction("X", at=pivot, on="rod", by=None, along=ground.x),
            reaction("Y", at=pivot, on="rod", by=None, along=ground.y),
        ),
        inputs=(u,),
        example={"theta": 0.5},
    )


PUBLISHED = (
    published(
        "newthdot",
        EquationOfMotion(),
        theta.diff().diff(),
        3 * g / (2 * l) * sin(theta) + 3 / (m * l**2) * u,
        label="angular acceleration of the rod",
    ),
)
