"""Two rods one on the other on a cart: the double inverted pendulum of do-mpc's documentation.

    h1 x'' + h2 theta1'' cos theta1 + h3 theta2'' cos theta2 = ... + u

theta1 and theta2 are counted from upright, l1 and l2 are half of the rods' lengths. The equations
are those of the example "Double inverted pendulum". Its kinetic energy, as printed there, has
J2 theta1'^2 in place of J2 theta2'^2 (issue 85): it is typed here as the equations need it.
"""

from sympy import Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, RigidBody, Scene, force, gravity, parameters, reaction
from mechanics.scene.composite import part
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, KineticEnergy, PotentialEnergy
from mechanics.scene.shapes import Rod

x, theta1, theta2, u = dynamicsymbols("x theta1 theta2 u")
m0, m1, m2, L1, L2, g = parameters(
    "m0 m1 m2 L1 L2 g",
    units="kg kg kg m m m/s^2",
    typical="0.6 0.2 0.2 0.5 0.5 9.80665",
    meanings=(
        "mass of the cart",
        "mass of the first rod",
        "mass of the second rod",
        "length of the first rod",
        "length of the second rod",
        "acceleration of gravity",
    ),
)
l1, l2, J1, J2 = parameters(
    "l1 l2 J1 J2",
    units="m m kg*m^2 kg*m^2",
    meanings=(
        "half of the first rod's length",
        "half of the second rod's length",
        "inertia of the first rod about its mass centre",
        "inertia of the second rod about its mass centre",
    ),
)
h1, h2, h3, h4, h5, h6, h7, h8 = parameters(
    "h1 h2 h3 h4 h5 h6 h7 h8",
    units="kg kg*m kg*m kg*m^2 kg*m^2 kg*m^2 N*m N*m",
    meanings=(
        "mass of cart and rods",
        "moment of mass that the first joint carries",
        "moment of mass of the second rod",
        "inertia of the first rod and of the mass at its end, about its lower end",
        "product of inertia between the rods",
        "inertia of the second rod about its lower end",
        "weight's moment at the first joint",
        "weight's moment at the second joint",
    ),
)
FIRST, SECOND = part(Rod(L1), mass=m1), part(Rod(L2), mass=m2)


def scene() -> Scene:
    """A cart that the force u pushes along a rail, and two uniform rods that stand on it."""
    ground = ReferenceFrame("N")
    first = ground.orientnew("A", "Axis", (-theta1, ground.z))
    second = ground.orientnew("B", "Axis", (-theta2, ground.z))
    origin = Point("O")
    pivot = origin.locatenew("P0", x * ground.x)
    joint = pivot.locatenew("P1", L1 * first.y)
    centre1 = pivot.locatenew("C1", L1 / 2 * first.y)
    centre2 = joint.locatenew("C2", L2 / 2 * second.y)
    return Scene(
        "double inverted pendulum",
        ground,
        origin,
        coordinates=(x, theta1, theta2),
        bodies=(
            Particle("cart", pivot, m0),
            RigidBody("rod1", centre1, first, m1, FIRST.inertia),
            RigidBody("rod2", centre2, second, m2, SECOND.inertia),
        ),
        loads=(gravity(-g * ground.y), force("u", pivot, u * ground.x, on="cart")),
        reactions=(
            reaction("N", at=pivot, on="cart", by=None, along=ground.y),
            reaction("X1", at=pivot, on="rod1", by="cart", along=ground.x),
            reaction("Y1", at=pivot, on="rod1", by="cart", along=ground.y),
            reaction("X2", at=joint, on="rod2", by="rod1", along=ground.x),
            reaction("Y2", at=joint, on="rod2", by="rod1", along=ground.y),
        ),
        inputs=(u,),
        definitions={
            l1: L1 / 2,
            l2: L2 / 2,
            J1: FIRST.inertia,
            J2: SECOND.inertia,
            h1: m0 + m1 + m2,
            h2: m1 * l1 + m2 * L1,
            h3: m2 * l2,
            h4: m1 * l1**2 + m2 * L1**2 + J1,
            h5: m2 * l2 * L1,
            h6: m2 * l2**2 + J2,
            h7: (m1 * l1 + m2 * L1) * g,
            h8: m2 * l2 * g,
        },
        example={"theta1": 0.3, "theta2": -0.2},
    )


# Names of the source for what its later lines repeat, typed as it prints them.
x_dot, w1, w2 = x.diff(), theta1.diff(), theta2.diff()
x_ddot, a1, a2 = x_dot.diff(), w1.diff(), w2.diff()
half = Rational(1, 2)
E_kin_cart = half * m0 * x_dot**2
E_kin_p1 = half * m1 * ((x_dot + l1 * w1 * cos(theta1)) ** 2 + (l1 * w1 * sin(theta1)) ** 2)
E_kin_p2 = (
    half
    * m2
    * (
        (x_dot + L1 * w1 * cos(theta1) + l2 * w2 * cos(theta2)) ** 2
        + (L1 * w1 * sin(theta1) + l2 * w2 * sin(theta2)) ** 2
    )
)

PUBLISHED = (
    published(
        "row 1",
        EquationOfMotion(),
        h1 * x_ddot + h2 * a1 * cos(theta1) + h3 * a2 * cos(theta2),
        h2 * w1**2 * sin(theta1) + h3 * w2**2 * sin(theta2) + u,
        label="momentum along the rail",
        latex=(
            r"h_1\ddot{x}+h_2\ddot{\theta}_1\cos(\theta_1)+h_3\ddot{\theta}_2\cos(\theta_2)"
            r"= (h_2\dot{\theta}_1^{2}\sin(\theta_1) + h_3\dot{\theta}_2^{2}\sin(\theta_2) + u)"
        ),
    ),
    published(
        "row 2",
        EquationOfMotion(),
        h2 * cos(theta1) * x_ddot + h4 * a1 + h5 * cos(theta1 - theta2) * a2,
        h7 * sin(theta1) - h5 * w2**2 * sin(theta1 - theta2),
        label="Lagrange's equation for the first rod",
        latex=(
            r"h_2\cos(\theta_1)\ddot{x} + h_4\ddot{\theta}_1"
            r" + h_5\cos(\theta_1-\theta_2)\ddot{\theta}_2"
            r"= (h_7\sin(\theta_1) - h_5\dot{\theta}_2^{2}\sin(\theta_1-\theta_2))"
        ),
    ),
    published(
        "row 3",
        EquationOfMotion(),
        h3 * cos(theta2) * x_ddot + h5 * cos(theta1 - theta2) * a1 + h6 * a2,
        h5 * w1**2 * sin(theta1 - theta2) + h8 * sin(theta2),
        label="Lagrange's equation for the second rod",
        latex=(
            r"h_3\cos(\theta_2)\ddot{x} + h_5\cos(\theta_1-\theta_2)\ddot{\theta}_1"
            r" + h_6\ddot{\theta}_2"
            r"= (h_5\dot{\theta}_1^{2}\sin(\theta_1-\theta_2) + h_8\sin(\theta_2))"
        ),
    ),
    published(
        "E_kin",
        KineticEnergy(),
        E_kin_cart + E_kin_p1 + half * J1 * w1**2 + E_kin_p2 + half * J2 * w2**2,
        label="kinetic energy",
        note="the source prints J2 theta1'^2 / 2",
    ),
    published(
        "E_pot",
        PotentialEnergy(),
        m1 * g * l1 * cos(theta1) + m2 * g * (L1 * cos(theta1) + l2 * cos(theta2)),
        label="potential energy",
        latex=(
            r"E_{\text{pot.}} = m_1 g  l_1 \cos(\theta_1)"
            r" + m_2 g (L_1 \cos(\theta_1) + l_2 \cos(\theta_2))"
        ),
    ),
)
