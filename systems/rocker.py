"""Rocker, rolling without slip on two half discs and a rectangle: seed document, problem 2.

x_C = R theta + R/2 sin theta,   y_C = R + R/2 cos theta        (theta clockwise)
"""

from fractions import Fraction

from sympy import Abs, Expr, Integer, Rational, Symbol, pi, symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import (
    Outline,
    RigidBody,
    Scene,
    condition,
    force,
    gravity,
    parameters,
    reaction,
)
from mechanics.scene.composite import composite, inertia_about, part
from mechanics.scene.shapes import Rectangle, Semidisc
from mechanics.scene.system import Path

theta, f = dynamicsymbols("theta f")
M, I_C, R, g = parameters(
    "M I_C R g",
    units="kg kg*m^2 m m/s^2",
    typical="- - 0.1 9.81",
    meanings=(
        "mass of the rocker",
        "moment of inertia of the rocker about its mass centre",
        "radius of the half discs",
        "acceleration of gravity",
    ),
)
rho, h = parameters(
    "rho h", units="kg/m^3 m", typical="2700 0.02", meanings=("density", "thickness of the rocker")
)
m_1, m_2, I_1, I_2, I_C1, I_o, ybar = parameters(
    "m_1 m_2 I_1 I_2 I_C1 I_o ybar",
    units="kg kg kg*m^2 kg*m^2 kg*m^2 kg*m^2 m",
    meanings=(
        "mass of a half disc",
        "mass of the rectangle",
        "moment of inertia of a half disc about the rocker's mass centre",
        "moment of inertia of the rectangle about the rocker's mass centre",
        "moment of inertia of a half disc about its own centroid",
        "moment of inertia of a half disc about the centre of its circle",
        "distance of a half disc's centroid from the centre of its circle",
    ),
)

# Axes of the rocker: the origin is the mass centre C, y points up when theta = 0.
CIRCLE = (0, R / 2)
UPPER = part(Semidisc(R), density=rho * h, at=CIRCLE)
LOWER = part(Semidisc(R), density=rho * h, at=(0, -R / 2), angle=pi)
MIDDLE = part(Rectangle(2 * R, R), density=rho * h)
ROCKER = composite((UPPER, MIDDLE, LOWER))

# The floor only pushes, friction is limited, and beyond pi/2 the rocker stands on its rectangle.
T, N = symbols("T N", real=True)
(mu,) = parameters("mu", units="1", typical="0.5", meanings=("coefficient of static friction",))
CONDITIONS = (
    condition("contact", N > 0, "lifts off"),
    condition("rolling", Abs(T) <= mu * N, "slips"),
    condition("half disc", Abs(theta) <= pi / 2, "comes to the end of its half disc"),
)

# The gain is real, not positive: for small and for negative gains the rocker falls.
(K,) = parameters(
    "K", units="N/rad", typical="30", meanings=("gain of the control",), positive=False
)
critical = Symbol("critical", real=True)
AT_CRITICAL_GAIN = Path(
    "gain K = (1 + share) M g / 3 beside the critical one",
    critical,
    tuple(
        sign * Fraction(1, 10**places)
        for sign, order in ((-1, 1), (1, -1))
        for places in (0, 3, 6, 9, 12, 15)[::order]
    ),
    (
        ("K", (1 + critical) * M * g / 3),
        # So small that the torques of control and weight cancel but for the share.
        ("theta", Rational(1, 2**40)),
        ("theta_dot", Integer(0)),
    ),
)
side = Symbol("side", real=True)
AT_THE_ENDS = Path(
    "theta = -pi/2 and pi/2, where a half disc ends",
    side,
    (Fraction(-1), Fraction(1)),
    (("theta", side * pi / 2),),
)


def scene() -> Scene:
    """The rocker on the floor; the control force f acts at the mass centre along +x."""
    return _scene("rocker", f, (f,))


def controlled() -> Scene:
    """The rocker with the control force f = -K theta."""
    return _scene("controlled rocker", -K * theta, ())


def _scene(name: str, control: Expr, inputs: tuple[Expr, ...]) -> Scene:
    ground = ReferenceFrame("N")
    # theta is counted clockwise.
    body = ground.orientnew("A", "Axis", (-theta, ground.z))
    origin = Point("O")
    # The floor touches the rocker straight below the centre of the lower circle.
    contact = origin.locatenew("B", R * theta * ground.x)
    circle = contact.locatenew("G", R * ground.y)
    centre = circle.locatenew("C", R / 2 * body.y)
    # Its two half discs; the rectangle is between them.
    discs = (Outline(R * body.x, R * body.y, sign * R / 2 * body.y, True) for sign in (1, -1))
    return Scene(
        name,
        ground,
        origin,
        coordinates=(theta,),
        bodies=(RigidBody("rocker", centre, body, M, I_C, tuple(discs)),),
        loads=(gravity(-g * ground.y), force("f", centre, control * ground.x, on="rocker")),
        reactions=(
            reaction("T", at=contact, on="rocker", by=None, along=ground.x),
            reaction("N", at=contact, on="rocker", by=None, along=ground.y),
        ),
        inputs=inputs,
        definitions={
            M: ROCKER.mass,
            I_C: ROCKER.inertia,
            m_1: UPPER.mass,
            m_2: MIDDLE.mass,
            I_1: inertia_about(UPPER, (0, 0)),
            I_2: inertia_about(MIDDLE, (0, 0)),
            I_C1: UPPER.inertia,
            I_o: inertia_about(UPPER, CIRCLE),
            ybar: UPPER.centroid[1] - CIRCLE[1],
        },
        example={"theta": 0.1},
        conditions=CONDITIONS,
    )
