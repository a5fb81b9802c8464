"""do-mpc's double inverted pendulum: its equations are right, its kinetic energy is not."""

import pytest
from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

import mechanics

WRONG, RIGHT = r"\frac12 J_2 \dot\theta_1^2", r"\frac12 J_2 \dot\theta_2^2"
EQUATIONS = r"""
h_1 &= m_0 + m_1 + m_2 \\
h_2 &= m_1 l_1 + m_2 L_1 \\
h_3 &= m_2 l_2 \\
h_4 &= m_1 l_1^2 + m_2 L_1^2 + J_1 \\
h_5 &= m_2 l_2 L_1 \\
h_6 &= m_2 l_2^2 + J_2 \\
h_7 &= (m_1 l_1 + m_2 L_1) g \\
h_8 &= m_2 l_2 g \\
h_1 \ddot x + h_2 \ddot\theta_1 \cos\theta_1 + h_3 \ddot\theta_2 \cos\theta_2
    &= h_2 \dot\theta_1^2 \sin\theta_1 + h_3 \dot\theta_2^2 \sin\theta_2 + u \tag{1} \\
h_2 \cos\theta_1 \ddot x + h_4 \ddot\theta_1 + h_5 \cos(\theta_1 - \theta_2) \ddot\theta_2
    &= h_7 \sin\theta_1 - h_5 \dot\theta_2^2 \sin(\theta_1 - \theta_2) \tag{2} \\
h_3 \cos\theta_2 \ddot x + h_5 \cos(\theta_1 - \theta_2) \ddot\theta_1 + h_6 \ddot\theta_2
    &= h_5 \dot\theta_1^2 \sin(\theta_1 - \theta_2) + h_8 \sin\theta_2 \tag{3} \\"""
ENERGIES = r"""
E_{kin} &= \frac12 m_0 \dot x^2
    + \frac12 m_1 \left( (\dot x + l_1 \dot\theta_1 \cos\theta_1)^2
        + (l_1 \dot\theta_1 \sin\theta_1)^2 \right) + \frac12 J_1 \dot\theta_1^2
    + \frac12 m_2 \left( (\dot x + L_1 \dot\theta_1 \cos\theta_1
        + l_2 \dot\theta_2 \cos\theta_2)^2
        + (L_1 \dot\theta_1 \sin\theta_1 + l_2 \dot\theta_2 \sin\theta_2)^2 \right)
    + ROTATION \tag{kin} \\
E_{pot} &= m_1 g l_1 \cos\theta_1 + m_2 g (L_1 \cos\theta_1 + l_2 \cos\theta_2) \tag{pot}"""


def text(rotation: str) -> str:
    energies = ENERGIES.replace("ROTATION", rotation)
    return r"\begin{align}" + EQUATIONS + energies + r"\end{align}"


@pytest.mark.campaign
def test_the_energy_is_blamed_and_not_the_equations(truth, edits) -> None:
    found = mechanics.check(truth("double_inverted_pendulum"), text(WRONG))
    definitions, statements = found.judged[:8], found.judged[8:]
    assert {entry.finding.verdict.name for entry in definitions} == {"PROVED"}
    verdicts = {entry.statement.tag: entry.finding.verdict.name for entry in statements}
    assert verdicts == {
        "(1)": "PROVED", "(2)": "PROVED", "(3)": "PROVED", "(kin)": "REFUTED", "(pot)": "PROVED",
    }  # fmt: skip
    kinetic = statements[3]
    assert edits(kinetic) == [("SYMBOL", r"\dot\theta_1", r"\dot\theta_2")]
    (words,) = kinetic.blame.explanations
    assert words.startswith("the equations are right, this energy is not")
    assert "(0, J2*theta1_ddot, -J2*theta2_ddot)" in words


def test_with_the_other_rotation_all_is_right(truth) -> None:
    found = mechanics.check(truth("double_inverted_pendulum"), text(RIGHT))
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * (8 + 5)


def by_lagrange(rotation) -> LagrangesMethod:
    """Equations from the published energies, by SymPy, with one of the two rotations."""
    x, a, b, u = dynamicsymbols("x theta1 theta2 u")
    m0, m1, m2, L1, l1, l2, J1, J2, g = symbols("m0 m1 m2 L1 l1 l2 J1 J2 g")
    v, w1, w2 = x.diff(), a.diff(), b.diff()
    upper = (v + L1 * w1 * cos(a) + l2 * w2 * cos(b)) ** 2
    upper += (L1 * w1 * sin(a) + l2 * w2 * sin(b)) ** 2
    lower = (v + l1 * w1 * cos(a)) ** 2 + (l1 * w1 * sin(a)) ** 2
    kinetic = m0 * v**2 + m1 * lower + J1 * w1**2 + m2 * upper + J2 * rotation(w1, w2) ** 2
    stored = m1 * g * l1 * cos(a) + m2 * g * (L1 * cos(a) + l2 * cos(b)) - u * x
    method = LagrangesMethod(Rational(1, 2) * kinetic - stored, [x, a, b])
    method.form_lagranges_equations()
    return method


@pytest.mark.campaign
def test_equations_from_that_energy_differ_by_the_published_rows(truth) -> None:
    wrong, right = by_lagrange(lambda one, two: one), by_lagrange(lambda one, two: two)
    (a, b), J2 = dynamicsymbols("theta1 theta2"), symbols("J2")
    rows = (wrong.eom - right.eom).expand()
    assert rows == Matrix([0, J2 * a.diff().diff(), -J2 * b.diff().diff()])
    system = truth("double_inverted_pendulum")
    verdicts = [e.finding.verdict.name for e in mechanics.check(system, right).judged]
    assert verdicts == ["PROVED"] * 3
    verdicts = [e.finding.verdict.name for e in mechanics.check(system, wrong, blame=False).judged]
    assert verdicts == ["PROVED", "REFUTED", "REFUTED"]
