"""Bead on a smooth hoop that is turned about its vertical diameter at a constant rate.

theta is counted from the bottom. The equation, its equilibrium beside the bottom and the frequency
at the bottom are those of J. R. Taylor, "Classical Mechanics" (2005), examples 7.6 and 7.7.
"""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction
from mechanics.scene.linear_quantities import LinearizedEquation, operating_point
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, Lagrangian

theta = dynamicsymbols("theta")
t = dynamicsymbols._t
m, R, omega, g = parameters(
    "m R omega g",
    units="kg m 1/s m/s^2",
    typical="0.1 0.25 8 9.81",
    meanings=(
        "mass of the bead",
        "radius of the hoop",
        "rate at which the hoop is turned",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """A hoop turned as omega t, whose torque is a reaction that nobody asks for."""
    ground, centre = ReferenceFrame("N"), Point("O")
    hoop = ground.orientnew("H", "Axis", (omega * t, ground.z))
    arm = hoop.orientnew("B", "Axis", (-theta, hoop.y))
    place = centre.locatenew("P", -R * arm.z)
    return Scene(
        "bead on a hoop",
        ground,
        centre,
        coordinates=(theta,),
        bodies=(Particle("bead", place, m),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("across", at=place, on="bead", by=None, along=hoop.y),
            reaction("inwards", at=place, on="bead", by=None, along=arm.z),
        ),
        example={"theta": 0.3},
    )


PUBLISHED = (
    published(
        "L",
        Lagrangian(),
        m * R**2 * (theta.diff() ** 2 + omega**2 * sin(theta) ** 2) / 2
        - m * g * R * (1 - cos(theta)),
        label="Lagrangian",
        latex=(
            r"\mathcal{L}=\frac{1}{2} m R^{2}\left(\dot{\theta}^{2}+\omega^{2} \sin ^{2} "
            r"\theta\right)-m g R(1-\cos \theta)"
        ),
    ),
    published(
        "theta",
        EquationOfMotion(),
        theta.diff().diff(),
        (omega**2 * cos(theta) - g / R) * sin(theta),
        label="equation of motion",
        latex=r"\ddot{\theta}=\left(\omega^{2} \cos \theta-g / R\right) \sin \theta",
    ),
    published(
        "bottom",
        LinearizedEquation(operating_point({"theta": 0})),
        theta.diff().diff(),
        -(g / R - omega**2) * theta,
        label="small motions about the bottom",
    ),
)
