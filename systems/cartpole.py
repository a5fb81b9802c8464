"""Cart-pole: a pole on a cart that a force pushes along a rail, without friction.

theta is counted from upright, l is half of the pole's length. The equations are those of R. V.
Florian, "Correct equations for the dynamics of the cart-pole system" (2005), in the form in which
Gymnasium's environment `CartPole-v1` computes them, and under the names that it gives them.
"""

from sympy import Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, RigidBody, Scene, force, gravity, parameters, reaction
from mechanics.scene.composite import part
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue
from mechanics.scene.shapes import Rod

x, theta, F = dynamicsymbols("x theta F")
mc, mp, l, g = parameters(
    "mc mp l g",
    units="kg kg m m/s^2",
    typical="1 0.1 0.5 9.8",
    meanings=(
        "mass of the cart",
        "mass of the pole",
        "half of the pole's length",
        "acceleration of gravity",
    ),
)
POLE = part(Rod(2 * l), mass=mp)


def scene() -> Scene:
    """A uniform pole that stands on a cart by a pivot; the force F pushes the cart."""
    ground = ReferenceFrame("N")
    rod = ground.orientnew("A", "Axis", (-theta, ground.z))
    origin = Point("O")
    pivot = origin.locatenew("P", x * ground.x)
    centre = pivot.locatenew("C", l * rod.y)
    return Scene(
        "cart-pole",
        ground,
        origin,
        coordinates=(x, theta),
        bodies=(
            Particle("cart", pivot, mc),
            RigidBody("pole", centre, rod, mp, POLE.inertia),
        ),
        loads=(gravity(-g * ground.y), force("F", pivot, F * ground.x, on="cart")),
        reactions=(
            reaction("N", at=pivot, on="cart", by=None, along=ground.y),
            reaction("Tx", at=pivot, on="pole", by="cart", along=ground.x),
            reaction("Ty", at=pivot, on="pole", by="cart", along=ground.y),
        ),
        inputs=(F,),
        example={"theta": 0.3},
    )


# Names of the source for what its later lines repeat, typed as it prints them.
theta_dot = theta.diff()
theta_ddot = theta_dot.diff()
total_mass = mc + mp
temp = (F + mp * l * theta_dot**2 * sin(theta)) / total_mass

PUBLISHED = (
    published(
        "thetaacc",
        EquationOfMotion(),
        theta_ddot,
        (g * sin(theta) - cos(theta) * temp)
        / (l * (Rational(4, 3) - mp * cos(theta) ** 2 / total_mass)),
        label="angular acceleration of the pole",
    ),
    published(
        "xacc",
        EquationOfMotion(),
        x.diff().diff(),
        temp - mp * l * theta_ddot * cos(theta) / total_mass,
        label="acceleration of the cart",
    ),
    published(
        "N_c",
        ReactionValue("N"),
        (mc + mp) * g - mp * l * (theta_ddot * sin(theta) + theta_dot**2 * cos(theta)),
        label="what the rail bears",
    ),
)
