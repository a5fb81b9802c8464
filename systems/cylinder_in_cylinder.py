"""Cylinder that rolls without slip inside a larger one at rest.

theta is the angle of the line of centres from hanging straight down. The period of small motions
is that of every textbook's exercise, for example J. L. Meriam, L. G. Kraige and J. N. Bolton,
"Engineering Mechanics: Dynamics", and L. D. Landau and E. M. Lifshitz, "Mechanics", section 32,
which prints the kinetic energy.
"""

from sympy import sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Outline, RigidBody, Scene, gravity, parameters, roll
from mechanics.scene.linear_quantities import Eigenvalue, operating_point
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, KineticEnergy

theta, spin = dynamicsymbols("theta spin")
m, R, a, g = parameters(
    "m R a g",
    units="kg m m m/s^2",
    typical="1 0.5 0.1 9.81",
    meanings=(
        "mass of the cylinder",
        "inner radius of the surface",
        "radius of the cylinder",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """A homogeneous cylinder, held on the surface by its weight."""
    ground, centre = ReferenceFrame("N"), Point("O")
    contact = roll("contact", None, "cylinder", at=centre, normal=-ground.y, axis=ground.z,
                   inside=R, radius=a, angles=(theta, spin))  # fmt: skip
    shape = Outline(a * contact.frame.x, a * contact.frame.y, filled=True)
    return Scene(
        "cylinder in a cylinder",
        ground,
        centre,
        bodies=(RigidBody("cylinder", contact.point, contact.frame, m, m * a**2 / 2, (shape,)),),
        joints=(contact,),
        plane=ground.z,
        loads=(gravity(-g * ground.y),),
        example={"theta": 0.6},
    )


PUBLISHED = (
    published(
        "T",
        KineticEnergy(),
        3 * m * (R - a) ** 2 * theta.diff() ** 2 / 4,
        label="kinetic energy",
    ),
    published(
        "theta",
        EquationOfMotion(),
        theta.diff().diff(),
        -2 * g * sin(theta) / (3 * (R - a)),
        label="equation of motion",
    ),
    published(
        "omega^2",
        Eigenvalue(operating_point({"theta": 0, "spin": 0}), 1),
        2 * g / (3 * (R - a)),
        label="square of the frequency of small motions",
    ),
)
