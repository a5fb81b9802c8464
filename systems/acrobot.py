"""Acrobot: two links that hang from a pivot; only the joint between them is driven.

    d1 theta1'' + d2 theta2'' + phi1 = 0        d2 theta1'' + d3 theta2'' + ... = tau

theta1 is counted from hanging, theta2 from the first link. The equations are those of R. S. Sutton
and A. G. Barto, "Reinforcement Learning" (1998), which Gymnasium's environment `Acrobot-v1`
computes as its variant "book".
"""

from sympy import ImmutableMatrix, cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, gravity, parameters, reaction, torque
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, MassMatrix

theta1, theta2, tau = dynamicsymbols("theta1 theta2 tau")
m1, m2, l1, lc1, lc2, I1, I2, g = parameters(
    "m1 m2 l1 lc1 lc2 I1 I2 g",
    units="kg kg m m m kg*m^2 kg*m^2 m/s^2",
    typical="1 1 1 0.5 0.5 1 1 9.8",
    meanings=(
        "mass of the first link",
        "mass of the second link",
        "length of the first link",
        "distance of the first link's mass centre from the pivot",
        "distance of the second link's mass centre from the joint",
        "inertia of the first link about its mass centre",
        "inertia of the second link about its mass centre",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """Two links in a vertical plane; the torque tau acts between them."""
    ground = ReferenceFrame("N")
    first = ground.orientnew("A", "Axis", (theta1, ground.z))
    second = first.orientnew("B", "Axis", (theta2, first.z))
    pivot = Point("O")
    joint = pivot.locatenew("J", -l1 * first.y)
    centre1 = pivot.locatenew("C1", -lc1 * first.y)
    centre2 = joint.locatenew("C2", -lc2 * second.y)
    return Scene(
        "acrobot",
        ground,
        pivot,
        coordinates=(theta1, theta2),
        bodies=(
            RigidBody("link1", centre1, first, m1, I1),
            RigidBody("link2", centre2, second, m2, I2),
        ),
        loads=(gravity(-g * ground.y), torque("tau", tau * ground.z, on="link2", by="link1")),
        reactions=(
            reaction("X1", at=pivot, on="link1", by=None, along=ground.x),
            reaction("Y1", at=pivot, on="link1", by=None, along=ground.y),
            reaction("X2", at=joint, on="link2", by="link1", along=ground.x),
            reaction("Y2", at=joint, on="link2", by="link1", along=ground.y),
        ),
        inputs=(tau,),
        example={"theta1": 1.0, "theta2": 0.5},
    )


# Names of the source for what its later lines repeat, typed as it prints them.
w1, w2 = theta1.diff(), theta2.diff()
d1 = m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * cos(theta2)) + I1 + I2
d2 = m2 * (lc2**2 + l1 * lc2 * cos(theta2)) + I2
phi2 = m2 * lc2 * g * cos(theta1 + theta2 - pi / 2)
phi1 = (
    -m2 * l1 * lc2 * w2**2 * sin(theta2)
    - 2 * m2 * l1 * lc2 * w2 * w1 * sin(theta2)
    + (m1 * lc1 + m2 * l1) * g * cos(theta1 - pi / 2)
    + phi2
)

PUBLISHED = (
    published(
        "ddtheta2",
        EquationOfMotion(),
        w2.diff(),
        (tau + d2 / d1 * phi1 - m2 * l1 * lc2 * w1**2 * sin(theta2) - phi2)
        / (m2 * lc2**2 + I2 - d2**2 / d1),
        label="angular acceleration of the joint",
    ),
    published(
        "ddtheta1",
        EquationOfMotion(),
        w1.diff(),
        -(d2 * w2.diff() + phi1) / d1,
        label="angular acceleration of the first link",
    ),
    published(
        "d1, d2",
        MassMatrix(),
        ImmutableMatrix([[d1, d2], [d2, m2 * lc2**2 + I2]]),
        label="mass matrix",
    ),
)
