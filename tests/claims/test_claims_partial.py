"""Partial input, by every way in: one equation of two, an energy, a matrix, a reaction."""

import pytest
from sympy import Matrix, cos, sin, symbols
from sympy.physics.mechanics import (
    Force,
    Particle,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    System,
    Torque,
    dynamicsymbols,
)

import mechanics
from mechanics.judge.check import derived
from systems import acrobot, cartpole, rod_pendulum, two_mass_chain

CART = derived(cartpole.scene())


def verdicts(truth, thing, **options) -> list[str]:
    return [e.finding.verdict.name for e in mechanics.check(truth, thing, **options).judged]


@pytest.mark.parametrize(
    "text",
    [
        # MATLAB, with continued lines, elementwise operators and comments.
        "xdd = (F + mp.*l.*(thetad.^2.*sin(theta) - thetadd.*cos(theta)))./(mc + mp);  % rail",
        "(mc + mp)*xdd + mp*l*(thetadd*cos(theta) ...\n    - thetad^2*sin(theta)) == F",
        # SymPy.
        "(mc + mp)*x.diff(t, 2) + mp*l*Derivative(sin(theta), t, t) - F",
        "Eq(4*l/3*theta_ddot + x_ddot*cos(theta), g*sin(theta))",
    ],
)
def test_one_equation_of_two(text: str) -> None:
    assert verdicts(CART, text) == ["PROVED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "kind", "verdict"),
    [
        ("N = (mc + mp)*g - mp*l*(theta'' * sin(theta) + theta'^2 * cos(theta))",
         "ReactionValue", "PROVED"),
        (r"T_x = m_p (\ddot x + l \ddot\theta \cos\theta - l \dot\theta^2 \sin\theta)",
         "ReactionValue", "PROVED"),
        ("Ty = mp*g - mp*l*(theta'' * sin(theta) - theta'^2 * cos(theta))",
         "ReactionValue", "REFUTED"),
        ("V = mp*g*l*cos(theta)", "PotentialEnergy", "PROVED"),
        ("T = mc*x'^2/2 + mp*(x'^2/2 + l*x'*theta'*cos(theta) + 2*l^2*theta'^2/3)",
         "KineticEnergy", "PROVED"),
        ("[mc + mp, mp*l*cos(theta); mp*l*cos(theta), 4*mp*l^2/3]", "MassMatrix", "PROVED"),
        ("[mc + mp, mp*l*cos(theta); mp*l*cos(theta), 4*mp*l/3]", "MassMatrix", "REFUTED"),
        ("p_x = 2*mp", "Identity", "UNDECIDED"),
    ],
)  # fmt: skip
def test_only_a_reaction_an_energy_or_the_mass_matrix(text, kind, verdict) -> None:
    found = mechanics.check(CART, text)
    assert [type(e.statement.row.quantity).__name__ for e in found.judged] == [kind]
    assert [e.finding.verdict.name for e in found.judged] == [verdict]


def test_a_matrix_is_the_mass_matrix_when_the_person_says_so() -> None:
    mc, mp, l = symbols("mc mp l")
    theta = dynamicsymbols("theta")
    mass = Matrix([[mc + mp, mp * l * cos(theta)], [mp * l * cos(theta), 4 * mp * l**2 / 3]])
    assert verdicts(CART, mass, about="mass matrix") == ["PROVED"]
    assert verdicts(CART, mass * 2, about="mass matrix") == ["REFUTED"]
    (single,) = [Matrix([[symbols("m") * l**2 / 3]])]
    rod = derived(rod_pendulum.scene())
    assert verdicts(rod, single, about="mass matrix") == ["PROVED"]


def test_code_that_gives_the_mass_matrix_or_an_energy() -> None:
    def inertia(theta, mc, mp, l):
        mixed = mp * l * cos_of(theta)
        return [[mc + mp, mixed], [mixed, mp * l**2 * 4.0 / 3.0]]

    def kinetic(x_dot, theta, theta_dot, mc, mp, l):
        return mc * x_dot**2 / 2 + mp * (
            x_dot**2 / 2 + l * x_dot * theta_dot * cos_of(theta) + 2 * l**2 * theta_dot**2 / 3
        )

    assert verdicts(CART, inertia) == ["PROVED"]
    assert verdicts(CART, kinetic, about="kinetic energy") == ["PROVED"]


def cos_of(angle):
    import numpy

    return numpy.cos(angle)


def sympy_chain(stiffness) -> System:
    """Two masses on springs by SymPy's joints."""
    x1, x2, v1, v2 = dynamicsymbols("x1 x2 v1 v2")
    m, k = symbols("m k")
    wall = RigidBody("wall")
    first = Particle("first", mass=3 * m)
    second = Particle("second", mass=2 * m)
    system = System.from_newtonian(wall)
    slide = wall.frame.x
    system.add_joints(
        PrismaticJoint("one", wall, first, x1, v1, joint_axis=slide),
        PrismaticJoint("two", wall, second, x2, v2, joint_axis=slide),
    )
    system.add_loads(
        Force(first.masscenter, (-k * x1 + stiffness * (x2 - x1)) * slide),
        Force(second.masscenter, -stiffness * (x2 - x1) * slide),
    )
    system.form_eoms()
    return system


def test_a_system_of_sympys_joints() -> None:
    chain = derived(two_mass_chain.scene())
    k = symbols("k")
    found = mechanics.check(chain, sympy_chain(k))
    assert {entry.finding.verdict.name for entry in found.judged} <= {"PROVED", "CERTIFIED"}
    assert len(found.judged) == 2
    assert verdicts(chain, sympy_chain(2 * k), blame=False) == ["REFUTED", "REFUTED"]


def sympy_acrobot() -> System:
    """A system put together by hand, not yet formed, with names of its own."""
    th1, th2, w1, w2, tau = dynamicsymbols("theta1 theta2 w1 w2 tau")
    m1, m2, l1, lc1, lc2, I1, I2, g = symbols("m1 m2 l1 lc1 lc2 I1 I2 g")
    ground, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(ground, 0)
    first = ground.orientnew("A", "Axis", (th1, ground.z))
    second = first.orientnew("B", "Axis", (th2, first.z))
    first.set_ang_vel(ground, w1 * ground.z)
    second.set_ang_vel(first, w2 * ground.z)
    joint = origin.locatenew("J", -l1 * first.y)
    joint.v2pt_theory(origin, ground, first)
    centre1 = origin.locatenew("C1", -lc1 * first.y)
    centre1.v2pt_theory(origin, ground, first)
    centre2 = joint.locatenew("C2", -lc2 * second.y)
    centre2.v2pt_theory(joint, ground, second)
    link1 = RigidBody("l1", centre1, first, m1, (I1 * (ground.z | ground.z), centre1))
    link2 = RigidBody("l2", centre2, second, m2, (I2 * (ground.z | ground.z), centre2))
    system = System(ground, origin)
    system.add_bodies(link1, link2)
    system.add_coordinates(th1, th2)
    system.add_speeds(w1, w2)
    system.add_kdes(w1 - th1.diff(), w2 - th2.diff())
    system.apply_uniform_gravity(-g * ground.y)
    system.add_loads(Torque(second, tau * ground.z), Torque(first, -tau * ground.z))
    return system


def test_a_system_that_was_not_formed_yet() -> None:
    found = mechanics.check(derived(acrobot.scene()), sympy_acrobot())
    assert {entry.finding.verdict.name for entry in found.judged} <= {"PROVED", "CERTIFIED"}
    assert len(found.judged) == 2


def test_expressions_of_sympy_one_by_one() -> None:
    x, theta, F = dynamicsymbols("x theta F")
    mc, mp, l = symbols("mc mp l")
    row = (mc + mp) * x.diff().diff() + mp * l * (sin(theta)).diff().diff() - F
    assert verdicts(CART, row) == ["PROVED"]
    assert verdicts(CART, [row, 3 * row, row + theta]) == ["PROVED", "PROVED", "REFUTED"]
