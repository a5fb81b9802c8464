"""Cart-pole with dry friction of the cart on its track and viscous friction in the pivot.

    F_f = -mu_c N_c sgn(N_c x'),        tau = -mu_p theta'

The track's normal force N_c depends on the accelerations, and so does the friction. theta is
counted from upright, l is half of the pole's length, mu_p is in N m s. The friction model is that
of R. V. Florian, "Correct equations for the dynamics of the cart-pole system" (2007), after
A. G. Barto, R. S. Sutton and C. W. Anderson (1983), who left the normal force out: `CLASSIC`.

Florian's angular acceleration is known here from public programs that cite it. They have
cos(theta) - mu_c sgn(N_c x') in its denominator: `TRANSCRIBED`. That is refuted; with
mu_c sgn(N_c x') sin(theta) it is right.
"""

from sympy import Expr, Rational, Symbol, cos, sign, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    condition,
    coulomb,
    force,
    gravity,
    parameters,
    reaction,
    torque,
)
from mechanics.scene.composite import part
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue
from mechanics.scene.shapes import Rod

x, theta, F = dynamicsymbols("x theta F")
m_c, m_p, l, g, mu_c, mu_p = parameters(
    "m_c m_p l g mu_c mu_p",
    units="kg kg m m/s^2 1 N*m*s",
    typical="1 0.1 0.5 9.8 0.05 0.002",
    meanings=(
        "mass of the cart",
        "mass of the pole",
        "half of the pole's length",
        "acceleration of gravity",
        "coefficient of friction between cart and track",
        "coefficient of viscous friction in the pivot",
    ),
)
N_c = Symbol("N_c", real=True)
POLE = part(Rod(2 * l), mass=m_p)


def scene() -> Scene:
    """A uniform pole that stands on a cart by a pivot; the cart rubs on its track."""
    ground = ReferenceFrame("N")
    rod = ground.orientnew("A", "Axis", (-theta, ground.z))
    origin = Point("O")
    pivot = origin.locatenew("P", x * ground.x)
    centre = pivot.locatenew("C", l * rod.y)
    return Scene(
        "cart-pole with friction",
        ground,
        origin,
        coordinates=(x, theta),
        bodies=(
            Particle("cart", pivot, m_c),
            RigidBody("pole", centre, rod, m_p, POLE.inertia),
        ),
        loads=(
            gravity(-g * ground.y),
            force("F", pivot, F * ground.x, on="cart"),
            coulomb("track", "N_c", along=ground.x, sliding=x.diff(), coefficient=mu_c),
            torque("pivot", mu_p * theta.diff() * ground.z, on="pole", by="cart"),
        ),
        reactions=(
            reaction("N_c", at=pivot, on="cart", by=None, along=ground.y),
            reaction("T_x", at=pivot, on="pole", by="cart", along=ground.x),
            reaction("T_y", at=pivot, on="pole", by="cart", along=ground.y),
        ),
        inputs=(F,),
        conditions=(condition("contact", N_c > 0, "lifts off its track"),),
        example={"x_dot": 1.0, "theta": 0.1},
    )


# What the sources' lines repeat.
theta_dot, theta_ddot = theta.diff(), theta.diff().diff()
total = m_c + m_p
swing = m_p * l * (theta_dot**2 * sin(theta) - theta_ddot * cos(theta))
pressing = total * g - m_p * l * (theta_ddot * sin(theta) + theta_dot**2 * cos(theta))
forwards = sign(x.diff())


def angular(s: Expr, reach: Expr) -> Expr:
    """Florian's theta'': s the direction of friction, reach what stands beside cos(theta) below."""
    thrown = m_p * l * theta_dot**2 * (sin(theta) + mu_c * s * cos(theta))
    above = g * sin(theta) + cos(theta) * ((-F - thrown) / total + mu_c * g * s)
    lever = Rational(4, 3) - m_p * cos(theta) / total * (cos(theta) - reach)
    return (above - mu_p * theta_dot / (m_p * l)) / (l * lever)


PUBLISHED = (
    published("N_c", ReactionValue("N_c"), pressing, label="normal force of the track"),
    published(
        "x'', either way",
        EquationOfMotion(),
        x.diff().diff(),
        (F + swing - mu_c * N_c * sign(N_c * x.diff())) / total,
        label="acceleration of the cart",
    ),
    published(
        "theta'', either way",
        EquationOfMotion(),
        theta_ddot,
        angular(sign(N_c * x.diff()), mu_c * sign(N_c * x.diff()) * sin(theta)),
        label="angular acceleration of the pole",
        note="sin(theta) in the denominator is ours: public transcriptions leave it out",
    ),
    published(
        "x''",
        EquationOfMotion(),
        x.diff().diff(),
        (F + swing - mu_c * pressing * forwards) / total,
        label="acceleration of the cart while the track presses",
    ),
    published(
        "theta''",
        EquationOfMotion(),
        theta_ddot,
        angular(forwards, mu_c * forwards * sin(theta)),
        label="angular acceleration of the pole while the track presses",
    ),
)
TRANSCRIBED = published(
    "theta'' transcribed",
    EquationOfMotion(),
    theta_ddot,
    angular(sign(N_c * x.diff()), mu_c * sign(N_c * x.diff())),
    label="angular acceleration of the pole, as public programs transcribe it",
)
CLASSIC = (
    published(
        "x'' 1983",
        EquationOfMotion(),
        x.diff().diff(),
        (F + swing - mu_c * forwards) / total,
        label="acceleration of the cart, friction without the normal force",
    ),
    published(
        "theta'' 1983",
        EquationOfMotion(),
        theta_ddot,
        (
            g * sin(theta)
            + cos(theta) * (-F - m_p * l * theta_dot**2 * sin(theta) + mu_c * forwards) / total
            - mu_p * theta_dot / (m_p * l)
        )
        / (l * (Rational(4, 3) - m_p * cos(theta) ** 2 / total)),
        label="angular acceleration of the pole, friction without the normal force",
    ),
)
