"""Furuta's pendulum: an arm that a motor turns about the vertical, a pendulum at its end.

    theta1   of the arm about the vertical
    theta2   of the pendulum about the arm, from hanging

The equations are those of B. S. Cazzolato and Z. Prime, "On the dynamics of the Furuta pendulum",
Journal of Control Science and Engineering (2011), with viscous friction in both bearings and the
full inertias of both links. In the frame of the pendulum x points along it.
"""

from sympy import cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    parameters,
    pin,
    torque,
)
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion

theta1, theta2, tau1 = dynamicsymbols("theta1 theta2 tau1")
m1, m2, L1, l1, l2, J1xx, J1yy, J1zz, J2xx, J2yy, J2zz, b1, b2, g = parameters(
    "m1 m2 L1 l1 l2 J1xx J1yy J1zz J2xx J2yy J2zz b1 b2 g",
    units="kg kg m m m kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2 N*m*s N*m*s m/s^2",
    typical="0.3 0.075 0.278 0.15 0.148 1e-5 2.48e-2 2.48e-2 1e-6 3.86e-3 3.86e-3 1e-4 2.8e-4 9.81",
    meanings=(
        "mass of the arm",
        "mass of the pendulum",
        "length of the arm",
        "distance of the arm's mass centre from its axis",
        "distance of the pendulum's mass centre from its axis",
        "inertia of the arm along it",
        "inertia of the arm across it",
        "inertia of the arm about the vertical",
        "inertia of the pendulum along it",
        "inertia of the pendulum across it, in its plane of swing",
        "inertia of the pendulum about its axis",
        "viscous friction of the motor's bearing",
        "viscous friction of the pendulum's bearing",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """An arm in the horizontal plane and a pendulum in the plane across it."""
    ground, pivot = ReferenceFrame("N"), Point("O")
    motor = pin("motor", None, "arm", at=pivot, axis=ground.z, angle=theta1)
    arm = motor.frame
    end = pivot.locatenew("E", L1 * arm.x)
    # x downwards, z along the arm.
    down = arm.orientnew("D", "Axis", (pi / 2, arm.y))
    bearing = pin("bearing", "arm", "pendulum", at=end, axis=down.z, angle=theta2)
    swing = bearing.frame
    return Scene(
        "Furuta's pendulum",
        ground,
        pivot,
        bodies=(
            RigidBody(
                "arm", pivot.locatenew("C1", l1 * arm.x), arm, m1, inertia(arm, J1xx, J1yy, J1zz)
            ),
            RigidBody(
                "pendulum",
                end.locatenew("C2", l2 * swing.x),
                swing,
                m2,
                inertia(swing, J2xx, J2yy, J2zz),
            ),
        ),
        joints=(motor, bearing),
        loads=(
            gravity(-g * ground.z),
            torque("tau1", tau1 * ground.z, on="arm"),
            torque("friction1", -b1 * theta1.diff() * ground.z, on="arm"),
            torque("friction2", -b2 * theta2.diff() * down.z, on="pendulum", by="arm"),
        ),
        inputs=(tau1,),
        example={"theta2": 2.5},
    )


w1, w2 = theta1.diff(), theta2.diff()

PUBLISHED = (
    published(
        "arm",
        EquationOfMotion(),
        w1.diff() * (J1zz + m1 * l1**2 + m2 * L1**2 + (J2yy + m2 * l2**2) * sin(theta2) ** 2
                     + J2xx * cos(theta2) ** 2)
        + w2.diff() * m2 * L1 * l2 * cos(theta2)
        - m2 * L1 * l2 * sin(theta2) * w2**2
        + w1 * w2 * sin(2 * theta2) * (m2 * l2**2 + J2yy - J2xx)
        + b1 * w1,
        tau1,
        label="equation of motion of the arm",
    ),
    published(
        "pendulum",
        EquationOfMotion(),
        w1.diff() * m2 * L1 * l2 * cos(theta2)
        + w2.diff() * (m2 * l2**2 + J2zz)
        + w1**2 * sin(2 * theta2) * (-m2 * l2**2 - J2yy + J2xx) / 2
        + b2 * w2
        + g * m2 * l2 * sin(theta2),
        0,
        label="equation of motion of the pendulum",
    ),
)  # fmt: skip
