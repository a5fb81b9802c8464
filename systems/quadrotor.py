"""Quadrotor: a rigid body with four rotors that push along its axis.

    psi     about the vertical, then
    phi     about x, then
    theta   about y;    p, q, r: angular velocity in the body

Frames, speeds, rotor forces F_i with their moments gamma F_i, and the equations are those of
D. Mellinger and V. Kumar, "Minimum snap trajectory generation and control for quadrotors", IEEE
International Conference on Robotics and Automation (2011).
"""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import Outline, RigidBody, Scene, force, gravity, parameters, torque
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion

x, y, z, psi, phi, theta = dynamicsymbols("x y z psi phi theta")
vx, vy, vz, p, q, r = dynamicsymbols("vx vy vz p q r")
F1, F2, F3, F4 = inputs = dynamicsymbols("F1:5")
m, Ixx, Iyy, Izz, L, gamma, g = parameters(
    "m Ixx Iyy Izz L gamma g",
    units="kg kg*m^2 kg*m^2 kg*m^2 m m m/s^2",
    typical="0.5 0.0025 0.0025 0.0045 0.18 0.02 9.81",
    meanings=(
        "mass",
        "inertia about the first arm",
        "inertia about the second arm",
        "inertia about the axis of the rotors",
        "distance of a rotor's axis from the mass centre",
        "moment of a rotor over its force",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """A body that is free in space; rotors 1 and 3 lie on its x axis, 2 and 4 on its y axis."""
    ground, origin = ReferenceFrame("N"), Point("O")
    heading = ground.orientnew("E", "Axis", (psi, ground.z))
    rolled = heading.orientnew("F", "Axis", (phi, heading.x))
    body = rolled.orientnew("B", "Axis", (theta, rolled.y))
    centre = origin.locatenew("C", x * ground.x + y * ground.y + z * ground.z)
    places = (L * body.x, L * body.y, -L * body.x, -L * body.y)
    pushes = tuple(
        force(f"F{i}", centre.locatenew(f"R{i}", place), push * body.z, on="body")
        for i, (place, push) in enumerate(zip(places, inputs, strict=True), 1)
    )
    arms = (Outline(places[0]), Outline(places[1]))
    rotors = tuple(
        Outline(L / 2 * body.x, L / 2 * body.y, at=place, filled=True) for place in places
    )
    return Scene(
        "quadrotor",
        ground,
        origin,
        coordinates=(x, y, z, psi, phi, theta),
        speeds=(
            (vx, x.diff()),
            (vy, y.diff()),
            (vz, z.diff()),
            (p, phi.diff() * cos(theta) - psi.diff() * cos(phi) * sin(theta)),
            (q, theta.diff() + psi.diff() * sin(phi)),
            (r, phi.diff() * sin(theta) + psi.diff() * cos(phi) * cos(theta)),
        ),
        bodies=(
            RigidBody("body", centre, body, m, inertia(body, Ixx, Iyy, Izz), (*arms, *rotors)),
        ),
        loads=(
            gravity(-g * ground.z),
            *pushes,
            torque("drag", gamma * (F1 - F2 + F3 - F4) * body.z, on="body"),
        ),
        inputs=tuple(inputs),
        example={"z": 1.0, "phi": 0.1, "p": 0.5},
    )


thrust = F1 + F2 + F3 + F4

PUBLISHED = (
    published(
        "x",
        EquationOfMotion(),
        m * vx.diff(),
        thrust * (cos(psi) * sin(theta) + cos(theta) * sin(phi) * sin(psi)),
        label="momentum along x",
    ),
    published(
        "y",
        EquationOfMotion(),
        m * vy.diff(),
        thrust * (sin(psi) * sin(theta) - cos(psi) * cos(theta) * sin(phi)),
        label="momentum along y",
    ),
    published(
        "z",
        EquationOfMotion(),
        m * vz.diff(),
        -m * g + thrust * cos(phi) * cos(theta),
        label="momentum along z",
    ),
    published(
        "p",
        EquationOfMotion(),
        Ixx * p.diff(),
        L * (F2 - F4) - (Izz - Iyy) * q * r,
        label="angular momentum about x of the body",
    ),
    published(
        "q",
        EquationOfMotion(),
        Iyy * q.diff(),
        L * (F3 - F1) - (Ixx - Izz) * r * p,
        label="angular momentum about y of the body",
    ),
    published(
        "r",
        EquationOfMotion(),
        Izz * r.diff(),
        gamma * (F1 - F2 + F3 - F4) - (Iyy - Ixx) * p * q,
        label="angular momentum about z of the body",
    ),
)
