"""Double pendulum: two point masses on massless rods, its momenta and Hamilton's equations.

    phi_i' = dH/dp_i        p_i' = -dH/dphi_i        p_i = dL/dphi_i'

Both angles are counted from hanging. The Lagrangian is that of L. D. Landau and E. M. Lifshitz,
"Mechanics", section 5, problem 1; the equations are those of D. Assencio, "The double pendulum:
Lagrangian formulation" and "The double pendulum: Hamiltonian formulation" (2014).
"""

from sympy import Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, gravity, parameters, reaction
from mechanics.scene.published import published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Identity,
    Lagrangian,
    TotalEnergy,
)

phi1, phi2 = dynamicsymbols("phi1 phi2")
m1, m2, l1, l2, g = parameters(
    "m1 m2 l1 l2 g",
    units="kg kg m m m/s^2",
    typical="1 1 1 1 9.81",
    meanings=(
        "mass at the end of the first rod",
        "mass at the end of the second rod",
        "length of the first rod",
        "length of the second rod",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """Two massless rods that hang one from the other, a point mass at the end of each.

    A rod is a rigid body without inertia about its mass centre, so that each pivot has a force in
    both directions, which its moment equation turns along the rod.
    """
    ground = ReferenceFrame("N")
    first = ground.orientnew("A", "Axis", (phi1, ground.z))
    second = ground.orientnew("B", "Axis", (phi2, ground.z))
    pivot = Point("O")
    upper = pivot.locatenew("P1", -l1 * first.y)
    lower = upper.locatenew("P2", -l2 * second.y)
    return Scene(
        "double pendulum",
        ground,
        pivot,
        coordinates=(phi1, phi2),
        bodies=(
            RigidBody("upper", upper, first, m1, 0),
            RigidBody("lower", lower, second, m2, 0),
        ),
        loads=(gravity(-g * ground.y),),
        reactions=(
            reaction("X1", at=pivot, on="upper", by=None, along=ground.x),
            reaction("Y1", at=pivot, on="upper", by=None, along=ground.y),
            reaction("X2", at=upper, on="lower", by="upper", along=ground.x),
            reaction("Y2", at=upper, on="lower", by="upper", along=ground.y),
        ),
        example={"phi1": 2.0, "phi2": 2.5},
    )


# Names of the source for what its later lines repeat, typed as it prints them.
w1, w2 = phi1.diff(), phi2.diff()
a1, a2 = w1.diff(), w2.diff()
p1, p2 = dynamicsymbols("p_phi1 p_phi2")
c, s = cos(phi1 - phi2), sin(phi1 - phi2)
half = Rational(1, 2)
h1 = p1 * p2 * s / (l1 * l2 * (m1 + m2 * s**2))
h2 = (m2 * l2**2 * p1**2 + (m1 + m2) * l1**2 * p2**2 - 2 * m2 * l1 * l2 * p1 * p2 * c) / (
    2 * l1**2 * l2**2 * (m1 + m2 * s**2) ** 2
)

PUBLISHED = (
    published(
        "L",
        Lagrangian(),
        half * (m1 + m2) * l1**2 * w1**2
        + half * m2 * l2**2 * w2**2
        + m2 * l1 * l2 * w1 * w2 * c
        + (m1 + m2) * g * l1 * cos(phi1)
        + m2 * g * l2 * cos(phi2),
        label="Lagrangian",
        latex=(
            r"L=\frac{1}{2}\left(m_{1}+m_{2}\right) l_{1}^{2} \dot{\phi}_{1}^{2}+\frac{1}{2} "
            r"m_{2} l_{2}^{2} \dot{\phi}_{2}^{2}+m_{2} l_{1} l_{2} \dot{\phi}_{1} "
            r"\dot{\phi}_{2} \cos \left(\phi_{1}-\phi_{2}\right)+\left(m_{1}+m_{2}\right) g "
            r"l_{1} \cos \phi_{1}+m_{2} g l_{2} \cos \phi_{2}"
        ),
    ),
    published(
        "phi1",
        EquationOfMotion(),
        (m1 + m2) * l1 * a1 + m2 * l2 * a2 * c + m2 * l2 * w2**2 * s + (m1 + m2) * g * sin(phi1),
        0,
        label="Lagrange's equation for phi1, divided by l1",
    ),
    published(
        "phi2",
        EquationOfMotion(),
        l2 * a2 + l1 * a1 * c - l1 * w1**2 * s + g * sin(phi2),
        0,
        label="Lagrange's equation for phi2, divided by m2 l2",
    ),
    published(
        "p1",
        GeneralizedMomentum("phi1"),
        (m1 + m2) * l1**2 * w1 + m2 * l1 * l2 * w2 * c,
        label="momentum of phi1",
    ),
    published(
        "p2",
        GeneralizedMomentum("phi2"),
        m2 * l2**2 * w2 + m2 * l1 * l2 * w1 * c,
        label="momentum of phi2",
    ),
    published(
        "H",
        TotalEnergy(),
        (m2 * l2**2 * p1**2 + (m1 + m2) * l1**2 * p2**2 - 2 * m2 * l1 * l2 * p1 * p2 * c)
        / (2 * m2 * l1**2 * l2**2 * (m1 + m2 * s**2))
        - (m1 + m2) * g * l1 * cos(phi1)
        - m2 * g * l2 * cos(phi2),
        label="Hamiltonian in momenta",
    ),
    published(
        "phi1'",
        Identity(),
        w1,
        (l2 * p1 - l1 * p2 * c) / (l1**2 * l2 * (m1 + m2 * s**2)),
        label="angular velocity of the first rod from the momenta",
    ),
    published(
        "phi2'",
        Identity(),
        w2,
        (-m2 * l2 * p1 * c + (m1 + m2) * l1 * p2) / (m2 * l1 * l2**2 * (m1 + m2 * s**2)),
        label="angular velocity of the second rod from the momenta",
    ),
    published(
        "p1'",
        EquationOfMotion(),
        p1.diff(),
        -(m1 + m2) * g * l1 * sin(phi1) - h1 + h2 * sin(2 * (phi1 - phi2)),
        label="rate of the momentum of phi1",
    ),
    published(
        "p2'",
        EquationOfMotion(),
        p2.diff(),
        -m2 * g * l2 * sin(phi2) + h1 - h2 * sin(2 * (phi1 - phi2)),
        label="rate of the momentum of phi2",
    ),
)
