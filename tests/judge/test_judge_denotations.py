"""What sentences say that a name denotes, of which part an energy is, and what they deny."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import (
    acrobot,
    bead_on_hoop,
    cartpole,
    double_pendulum,
    elastic_pendulum,
    rod_pendulum,
    two_mass_chain,
)

ROD = r"\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}"
SLIDE = r"(M+m)\ddot x + 2kx + \frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)=0"
BEAD = r"\ddot\theta=(\omega^2\cos\theta-g/R)\sin\theta"
LOWER = (
    r"l_2\ddot\theta_2+l_1\ddot\theta_1\cos(\theta_1-\theta_2)"
    r"-l_1\dot\theta_1^2\sin(\theta_1-\theta_2)+g\sin\theta_2=0"
)
JOINT = (
    r"(m_2(l_{c2}^2+l_1l_{c2}\cos\theta_2)+I_2)\ddot\theta_1+(m_2l_{c2}^2+I_2)\ddot\theta_2"
    r"+m_2l_1l_{c2}\dot\theta_1^2\sin\theta_2+m_2l_{c2}g\sin(\theta_1+\theta_2)=\tau"
)
CART = r"(m_c+m_p)\ddot x + m_pl\cos\theta\,\ddot\theta - m_pl\sin\theta\,\dot\theta^2 = F"
CHAIN = r"3m\ddot x_1 + 2kx_1 - kx_2 = 0"

SAID = [
    (rod_pendulum, r"where $m$ is the mass per unit length,", ROD, "UNDECIDED"),
    (rod_pendulum, r"where $m$ is the mass of the uniform rod,", ROD, "PROVED"),
    (rod_pendulum, r"where $g$ is the gravitational force per unit mass,", ROD, "PROVED"),
    (rod_pendulum, r"where $u$ is the torque divided by the inertia,", ROD, "UNDECIDED"),
    (rod_pendulum, r"$u$ acts in the direction of decreasing $\theta$:", ROD, "UNDECIDED"),
    (elastic_pendulum, r"where $m$ is the mass of the pendulum,", SLIDE, "UNDECIDED"),
    (elastic_pendulum, r"where $M$ is the mass of the rod,", SLIDE, "PROVED"),
    (elastic_pendulum, r"$k$ is the total stiffness of the springs:", SLIDE, "UNDECIDED"),
    (bead_on_hoop, r"$R$ is the diameter of the hoop:", BEAD, "UNDECIDED"),
    (bead_on_hoop, r"$\omega$ is the rate in revolutions per second:", BEAD, "UNDECIDED"),
    (bead_on_hoop, r"$\theta$ is measured from the top:", BEAD, "REFUTED"),
    (bead_on_hoop, r"$\theta$ is measured from the bottom:", BEAD, "PROVED"),
    (double_pendulum, r"$\theta_2$ is measured relative to the first rod:", LOWER, "UNDECIDED"),
    (double_pendulum, r"$\theta_2$ is measured relative to the vertical:", LOWER, "PROVED"),
    (double_pendulum, r"where dots are derivatives with respect to $\tau$,", LOWER, "UNDECIDED"),
    (double_pendulum, r"where dots are derivatives with respect to time,", LOWER, "PROVED"),
    (double_pendulum, rf"It moves by ${LOWER}$ and again by", LOWER, "PROVED"),
    (acrobot, r"$\theta_2$ is measured relative to the first link:", JOINT, "PROVED"),
    (acrobot, r"$\theta_2$ is measured from the downward vertical:", JOINT, "UNDECIDED"),
    (cartpole, r"where $l$ is the length of the pole,", CART, "REFUTED"),
    (cartpole, r"where $l$ is half the length of the pole,", CART, "PROVED"),
    (cartpole, r"$\theta$ is the angle of the pole with the horizontal:", CART, "REFUTED"),
    (two_mass_chain, r"$x_2$ is the displacement relative to the first mass:", CHAIN, "UNDECIDED"),
    (two_mass_chain, r"$x_2$ is the displacement relative to the wall:", CHAIN, "PROVED"),
]


@pytest.mark.sample(6)
@pytest.mark.parametrize(("system", "said", "formula", "verdict"), SAID)
def test_what_a_name_is_said_to_denote_counts(system, said, formula, verdict):  # type: ignore[no-untyped-def]
    answer = check(system.scene(), f"{said} ${formula}$", blame=False)
    assert answer.judged[0].verdict.name == verdict


@pytest.mark.parametrize(
    ("before", "behind"),
    [
        ("A student wrote (incorrectly)", ""),
        ("", " does not hold"),
        ("The following is wrong:\n\n", ""),
    ],
)
def test_more_ways_to_call_an_equation_wrong(before: str, behind: str) -> None:
    answer = check(rod_pendulum.scene(), f"{before} ${ROD}${behind}.", blame=False)
    assert answer.verdict is Verdict.UNDECIDED


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "unit", "verdict"),
    [
        ("Real theta", "deg", "UNDECIDED"),
        ("Real theta", "rad", "PROVED"),
        ("parameter Real l", "cm", "UNDECIDED"),
        ("parameter Real l", "m", "PROVED"),
        ("parameter Real g", "m/s2", "PROVED"),
        ("parameter Real g", "N/mm", "UNDECIDED"),
        ("parameter Real m", "N", "UNDECIDED"),
        ("input Real u", "N.m", "PROVED"),
        ("input Real u", "N", "UNDECIDED"),
        ("input Real u", "V", "UNDECIDED"),
    ],
)
def test_a_declaration_of_modelica_says_units(name: str, unit: str, verdict: str) -> None:
    names = (
        "Real theta",
        "parameter Real l",
        "parameter Real g",
        "parameter Real m",
        "input Real u",
    )
    rest = "; ".join(one for one in names if one != name)
    text = (
        f'model P\n {name}(unit="{unit}"); {rest}; Real w;\nequation\n'
        " der(theta) = w;\n der(w) = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);\nend P;"
    )
    answer = check(rod_pendulum.scene(), text, blame=False)
    assert answer.judged[-1].verdict.name == verdict
    assert verdict == "PROVED" or f" in {unit}, " in answer.judged[-1].finding.evidence


MODEL = """model P
  parameter Real m = 1, l = 1, g = 9.81;
  input Real u;
  Real theta;
  Real w;
equation
  der(theta) = w;
  der(w) = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end P;
"""


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ("Real theta", "output Real theta(start=1, fixed=true, nominal=2)", ""),
        ("Real theta", "Modelica.Units.SI.Angle theta", ""),
        ("model P", 'model P\n type Angle = Real(unit="rad");', ""),
        ("Real theta", "flow Real theta", "flow, which is not read"),
        ("Real theta", "stream Real theta", "stream, which is not read"),
        ("Real theta", "input Real theta", "the scene's moves"),
        ("Real theta", "parameter Real theta", "the scene's moves"),
        ("Real theta", "Real theta(max=0)", "limits theta"),
        ("Real theta", "Real theta(odd=0)", "'odd' of theta is not read"),
        ("Real theta", "Real theta = 0", "the scene's moves"),
        ("Real theta", "Real theta[2]", "an array"),
        ("Real theta", "Foo theta", "Foo, which is not read"),
        ("Real theta", "Modelica.Units.SI.Length theta", "another unit"),
        ("input Real u", "input Modelica.Units.SI.Force u", "another unit"),
        ("input Real u", 'input Real u(quantity="Force")', "another unit"),
        ("input Real u", 'input Real u(quantity="Torque")', ""),
        ("Real theta;", "", "nothing declares theta"),
        ("Real w;", "Real w; extends Base;", "'extends Base' is not read"),
        ("g = 9.81", "g = 1 - 10.81", "g is positive"),
        ("g = 9.81", "g(start = -9.81)", "g is positive"),
        ("model P", 'model P "this is wrong"', "denies or limits"),
        ("u/(m*l^2);", 'u/(m*l^2) "wrong";', "denies or limits"),
        ("end P", 'annotation(Documentation(info="only for small angles")); end P', "denies or"),
        ("= w;", "= w; // FIXME", "denies or limits"),
    ],
)
def test_what_a_model_declares_is_in_a_table_or_not_read(
    before: str, after: str, words: str
) -> None:
    answer = check(rod_pendulum.scene(), MODEL.replace(before, after, 1), blame=False)
    last = answer.judged[-1]
    assert last.verdict is (Verdict.UNDECIDED if words else Verdict.PROVED)
    assert words in last.finding.evidence


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"The kinetic energy of the cart is $\frac12 m_c\dot x^2$.", "UNDECIDED"),
        (r"The kinetic energy of rotation is $\frac16 m_pl^2\dot\theta^2$.", "UNDECIDED"),
        (r"Twice the kinetic energy of the cart is $m_c\dot x^2$.", "UNDECIDED"),
        (r"The potential energy of the pole is $m_pgl\cos\theta$.", "PROVED"),
        (r"The cart rolls on a rail, its kinetic energy is $\frac12 m_c\dot x^2$.", "UNDECIDED"),
        (r"On a rail, its kinetic energy is $\frac12 m_c\dot x^2$.", "REFUTED"),
        (r"The kinetic energy of the system is $\frac12 m_c\dot x^2$.", "REFUTED"),
        (r"The kinetic energy is $\frac12 m_c\dot x^2$.", "REFUTED"),
    ],
)
def test_the_energy_of_a_part_is_not_that_of_the_whole(text: str, verdict: str) -> None:
    answer = check(cartpole.scene(), text, blame=False)
    assert answer.verdict.name == verdict
