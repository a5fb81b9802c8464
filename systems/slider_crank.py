"""Slider-crank: a crank, a connecting rod and a piston, with the gas force on it.

    theta   of the crank from the piston's line, counterclockwise
    phi     of the rod from that line, clockwise:   l sin(phi) = r sin(theta)
    x       of the piston from the crank's axis

The kinematic coefficients (rates per unit of the crank's) and the equation of motion in one
coordinate, by Eksergian's method, are those of S. Doughty, "Mechanics of Machines" (1988).
"""

from sympy import cos, sin, tan
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, force, parameters, pin, slide, torque
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, Identity, KineticEnergy

theta, phi, x, M, P = dynamicsymbols("theta phi x M P")
r, l, a, I1, m2, I2, m3 = parameters(
    "r l a I1 m2 I2 m3",
    units="m m m kg*m^2 kg kg*m^2 kg",
    typical="0.05 0.15 0.05 0.01 0.6 0.002 0.8",
    meanings=(
        "length of the crank",
        "length of the rod",
        "distance of the rod's mass centre from the crank pin",
        "inertia of crank and flywheel about the crank's axis",
        "mass of the rod",
        "inertia of the rod about its mass centre",
        "mass of the piston",
    ),
)


def scene() -> Scene:
    """A crank that the torque M drives, and the force P on the piston away from the crank."""
    ground, axis = ReferenceFrame("N"), Point("O")
    main = pin("main", None, "crank", at=axis, axis=ground.z, angle=theta)
    crank = main.frame
    throw = axis.locatenew("A", r * crank.x)
    guide = slide("guide", None, "piston", at=axis, axis=ground.x, distance=x)
    gudgeon = pin("gudgeon", "piston", "rod", at=guide.point, axis=-ground.z, angle=phi)
    rod = gudgeon.frame
    end = guide.point.locatenew("B", -l * rod.x)
    big_end = pin("big_end", "crank", "rod", at=throw, axis=ground.z, onto=end)
    return Scene(
        "slider-crank",
        ground,
        axis,
        bodies=(
            RigidBody("crank", axis, crank, 0, I1),
            RigidBody("rod", end.locatenew("C", a * rod.x), rod, m2, I2),
            RigidBody("piston", guide.point, guide.frame, m3, 0),
        ),
        joints=(main, guide, gudgeon, big_end),
        plane=ground.z,
        loads=(
            torque("M", M * ground.z, on="crank"),
            force("P", guide.point, P * ground.x, on="piston"),
        ),
        inputs=(M, P),
        example={"theta": 0.5, "theta_dot": 20.0},
    )


k2 = r * cos(theta) / (l * cos(phi))
kx = -r * sin(theta) - r * cos(theta) * tan(phi)
k2x, k2y = -r * sin(theta) - a * k2 * sin(phi), r * cos(theta) - a * k2 * cos(phi)
inertia = I1 + m2 * (k2x**2 + k2y**2) + I2 * k2**2 + m3 * kx**2

PUBLISHED = (
    published("phi", Identity(), l * sin(phi), r * sin(theta), label="angle of the rod"),
    published("x", Identity(), x, r * cos(theta) + l * cos(phi), label="position of the piston"),
    published(
        "T",
        KineticEnergy(),
        inertia * theta.diff() ** 2 / 2,
        label="kinetic energy in the crank's rate",
    ),
    published(
        "theta",
        EquationOfMotion(),
        inertia * theta.diff().diff()
        + (inertia.diff(theta) + inertia.diff(phi) * k2) * theta.diff() ** 2 / 2,
        M + P * kx,
        label="equation of motion in the crank's angle",
    ),
)
