"""Heavy symmetric top with its tip at rest, by Euler's angles.

    phi     about the vertical
    theta   of the axis from the vertical
    psi     about the axis

The equations are those of H. Goldstein, "Classical Mechanics", second edition (1980), section 5-7;
I1 counts about an axis across the top at its tip. The speeds are the components of the angular
velocity in the top, as in its section 4-9: so accelerations have a value where the axis is
vertical, too.
"""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import RigidBody, Scene, ball, euler, gravity, parameters
from mechanics.scene.published import published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Lagrangian,
    TotalEnergy,
)
from mechanics.scene.typed import d_dt

phi, theta, psi = dynamicsymbols("phi theta psi")
wx, wy, wz = dynamicsymbols("wx wy wz")
I1, I3, M, l, g = parameters(
    "I1 I3 M l g",
    units="kg*m^2 kg*m^2 kg m m/s^2",
    typical="0.003 0.001 0.5 0.06 9.81",
    meanings=(
        "inertia about an axis across the top at its tip",
        "inertia about the axis of the top",
        "mass",
        "distance of the mass centre from the tip",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """A top on a ball joint; what it has across its mass centre follows from I1."""
    ground, tip = ReferenceFrame("N"), Point("O")
    joint = ball("tip", None, "top", at=tip, frame=ground, rotation=euler("zxz", phi, theta, psi))
    centre = tip.locatenew("C", l * joint.frame.z)
    across = I1 - M * l**2
    return Scene(
        "spinning top",
        ground,
        tip,
        bodies=(
            RigidBody("top", centre, joint.frame, M, inertia(joint.frame, across, across, I3)),
        ),
        joints=(joint,),
        speeds=(
            (wx, phi.diff() * sin(theta) * sin(psi) + theta.diff() * cos(psi)),
            (wy, phi.diff() * sin(theta) * cos(psi) - theta.diff() * sin(psi)),
            (wz, phi.diff() * cos(theta) + psi.diff()),
        ),
        loads=(gravity(-g * ground.z),),
        example={"theta": 0.4, "wz": 150.0},
    )


spin = psi.diff() + phi.diff() * cos(theta)

p_psi = I3 * spin
p_phi = (I1 * sin(theta) ** 2 + I3 * cos(theta) ** 2) * phi.diff() + I3 * psi.diff() * cos(theta)

PUBLISHED = (
    published(
        "L",
        Lagrangian(),
        I1 * (theta.diff() ** 2 + phi.diff() ** 2 * sin(theta) ** 2) / 2
        + I3 * spin**2 / 2
        - M * g * l * cos(theta),
        label="Lagrangian",
    ),
    published(
        "p_psi",
        GeneralizedMomentum("psi"),
        p_psi,
        label="momentum of the spin",
    ),
    published(
        "p_phi",
        GeneralizedMomentum("phi"),
        p_phi,
        label="momentum of the precession",
    ),
    published("spin", EquationOfMotion(), d_dt(p_psi), 0, label="the first stays constant"),
    published("precession", EquationOfMotion(), d_dt(p_phi), 0, label="so does the second"),
    published(
        "E",
        TotalEnergy(),
        I1 * (theta.diff() ** 2 + phi.diff() ** 2 * sin(theta) ** 2) / 2
        + I3 * spin**2 / 2
        + M * g * l * cos(theta),
        label="energy",
    ),
    published(
        "nutation",
        EquationOfMotion(),
        I1 * theta.diff().diff(),
        I1 * phi.diff() ** 2 * sin(theta) * cos(theta)
        - I3 * spin * phi.diff() * sin(theta)
        + M * g * l * sin(theta),
        label="Lagrange's equation of theta",
    ),
)
