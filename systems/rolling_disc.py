"""Thin uniform disc that rolls without slip on a horizontal plane: spatial and nonholonomic.

    u1 = lean',  u2 = spin' + yaw' sin(lean),  u3 = yaw' cos(lean)

are the components of the disc's angular velocity in the frame that yaws and leans with it, so the
generalized speeds are not the rates of the coordinates. Frames, speeds and the published equations
are those of SymPy's documentation, "A rolling disc using Kane's Method"; x and y of the contact
point and their speeds u4, u5 are added here, so that the two conditions of no slip and the
friction that maintains them are seen.
"""

from sympy import cos, sin, tan
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    Outline,
    RigidBody,
    Scene,
    gravity,
    nonholonomic,
    parameters,
    reaction,
)
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, Position, ReactionValue

x, y, yaw, lean, spin = dynamicsymbols("x y yaw lean spin")
u1, u2, u3, u4, u5 = dynamicsymbols("u1:6")
m, R, g = parameters(
    "m R g",
    units="kg m m/s^2",
    typical="2 0.5 9.81",
    meanings=("mass of the disc", "radius of the disc", "acceleration of gravity"),
)


def scene() -> Scene:
    """A disc that yaws about the vertical, leans about its heading and spins about its axle."""
    ground = ReferenceFrame("N")
    heading = ground.orientnew("Y", "Axis", (yaw, ground.z))
    leaning = heading.orientnew("L", "Axis", (lean, heading.x))
    disc = leaning.orientnew("D", "Axis", (spin, leaning.y))
    origin = Point("O")
    contact = origin.locatenew("P", x * ground.x + y * ground.y)
    centre = contact.locatenew("C", R * leaning.z)
    across, along = m * R**2 / 4, m * R**2 / 2
    shape = (Outline(R * disc.x, R * disc.z, filled=True),)
    return Scene(
        "rolling disc",
        ground,
        origin,
        coordinates=(x, y, yaw, lean, spin),
        speeds=(
            (u1, lean.diff()),
            (u2, spin.diff() + yaw.diff() * sin(lean)),
            (u3, yaw.diff() * cos(lean)),
            (u4, x.diff()),
            (u5, y.diff()),
        ),
        bodies=(RigidBody("disc", centre, disc, m, inertia(disc, across, along, across), shape),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("Fx", at=contact, on="disc", by=None, along=ground.x),
            reaction("Fy", at=contact, on="disc", by=None, along=ground.y),
            reaction("N", at=contact, on="disc", by=None, along=ground.z),
        ),
        constraints=(
            # The point of the disc that touches the plane is at rest; P, which is where they touch,
            # moves on by R spin' along the heading.
            nonholonomic("no slip along x", x.diff() - R * spin.diff() * cos(yaw), "Fx"),
            nonholonomic("no slip along y", y.diff() - R * spin.diff() * sin(yaw), "Fy"),
        ),
        example={"lean": 0.2, "u2": 6.0, "u3": 0.5},
    )


PUBLISHED = (
    published(
        "height",
        Position("C", "z"),
        R * cos(lean),
        label="height of the centre",
    ),
    published(
        "u1'",
        EquationOfMotion(),
        u1.diff(),
        (4 * g * sin(lean) + 6 * R * u2 * u3 - R * u3**2 * tan(lean)) / (5 * R),
        label="angular acceleration about the heading",
    ),
    published(
        "u2'",
        EquationOfMotion(),
        u2.diff(),
        -2 * u1 * u3 / 3,
        label="angular acceleration about the axle",
    ),
    published(
        "u3'",
        EquationOfMotion(),
        u3.diff(),
        (-2 * u2 + u3 * tan(lean)) * u1,
        label="angular acceleration about the diameter through the contact",
    ),
    published(
        "N",
        ReactionValue("N"),
        m * g - m * R * (u1.diff() * sin(lean) + u1**2 * cos(lean)),
        label="normal reaction",
    ),
)
