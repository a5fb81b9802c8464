"""Mistakes in every notation and about every quantity: one edit in the person's own words.

energies, mass matrices, solved forms, definitions, momenta; text, SymPy's objects, Python, C
"""

import math
from typing import Any

import pytest
from sympy import Matrix, Rational, cos, sin, symbols

import mechanics
from mechanics.blame.result import Mistake, Repair
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import acrobot, cartpole, double_pendulum, elastic_pendulum, rocker
from tests.notation_scenes import judged, truth

SCENES = {
    "pendulum": derived(elastic_pendulum.scene()),
    "rocker": derived(rocker.scene()),
    "cartpole": derived(cartpole.scene()),
    "acrobot": derived(acrobot.scene()),
    "double": derived(double_pendulum.scene()),
}


def first_repair(name: str, thing: Any, place: int = 0, **options: Any) -> Repair:
    """The first repair of a refuted statement; it is proved, and read again where it is a text."""
    entry = mechanics.check(SCENES[name], thing, **options).judged[place]
    assert entry.finding.verdict is Verdict.REFUTED, entry.finding
    assert entry.blame is not None
    assert entry.blame.repairs, entry.blame.searched
    first = entry.blame.repairs[0]
    assert first.finding.shown
    assert first.row is not None
    if isinstance(thing, str) and options.get("notation") != "c":
        *before, _ = thing.strip().splitlines()
        text = "\n".join([*before, first.repaired])
        told = not any(edit.definition for edit in first.edits)
        again = mechanics.check(SCENES[name], text, **options).judged[0] if told else first
        assert again.finding.shown, first.repaired
    return first


KINETIC = "KE = m*x'^2/2 + M*x'^2/2 + M*L*x'*theta'*cos(theta)/2 + M*L^2*theta'^2/6"
LAGRANGE = f"L = {KINETIC[5:]} - k*x^2 + M*g*L/2*cos(theta)"
POTENTIAL = "V = k*x^2 - M*g*L/2*cos(theta) + M*g*L"
SOLVED = (
    "theta'' = (g*sin(theta) - cos(theta)*(F + mp*l*theta'^2*sin(theta))/(mc + mp))"
    "/(l*(4/3 - mp*cos(theta)^2/(mc + mp)))"
)

TEXTS = (
    ("pendulum", KINETIC, "m*x'^2/2", "m*x'^2", Mistake.FACTOR),
    ("pendulum", KINETIC, "/6", "/24", Mistake.FACTOR),
    ("pendulum", KINETIC, "+ M*L*x'*theta'*cos(theta)/2 ", "", Mistake.MISSING),
    ("pendulum", KINETIC, "cos", "sin", Mistake.FUNCTION),
    ("pendulum", KINETIC, "L^2", "L", Mistake.POWER),
    ("pendulum", POTENTIAL, "k*x^2", "k*x^2/2", Mistake.FACTOR),
    ("pendulum", POTENTIAL, "- M*g*L/2*cos", "+ M*g*L/2*cos", Mistake.SIGN),
    ("pendulum", POTENTIAL, "k*x^2 ", "", Mistake.MISSING),
    ("pendulum", POTENTIAL, "cos", "sin", Mistake.FUNCTION),
    ("pendulum", LAGRANGE, "- k*x^2", "+ k*x^2", Mistake.SIGN),
    ("pendulum", LAGRANGE, "+ M*g*L/2*cos(theta)", "", Mistake.MISSING),
    ("pendulum", LAGRANGE, "M*L^2*theta'^2/6", "M*L^2*theta'^2/24", Mistake.FACTOR),
    ("cartpole", SOLVED, "4/3", "7/3", Mistake.FACTOR),
    ("cartpole", SOLVED, "theta'^2", "theta^2", Mistake.SYMBOL),
    ("cartpole", SOLVED, "(F + mp", "(F - mp", Mistake.SIGN),
    ("cartpole", SOLVED, "g*sin", "g*cos", Mistake.FUNCTION),
    ("cartpole", SOLVED, "F + ", "", Mistake.MISSING),
    ("cartpole", SOLVED, "(l*(4/3", "((4/3", Mistake.FACTOR),
    ("cartpole", SOLVED, " - mp*cos(theta)^2/(mc + mp)", "", Mistake.MISSING),
)


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "right", "part", "wrong", "mistake"), TEXTS)
def test_one_mistake_in_text(
    name: str, right: str, part: str, wrong: str, mistake: Mistake
) -> None:
    assert part in right
    text = right.replace(part, wrong, 1)
    (edit,) = first_repair(name, text).edits
    assert edit.mistake is mistake, edit


GYMNASIUM = """
temp = (F + mp*l*theta_dot**2*sin(theta))/(mc + mp)
thetaacc = (g*sin(theta) - cos(theta)*temp)/(l*(4/3 - mp*cos(theta)**2/(mc + mp)))
theta'' = thetaacc
x'' = temp - mp*l*thetaacc*cos(theta)/(mc + mp)
"""


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("part", "wrong", "definition", "mistake"),
    [
        ("4/3", "7/3", "thetaacc", Mistake.FACTOR),
        ("theta_dot**2", "theta**2", "temp", Mistake.SYMBOL),
        ("- cos(theta)*temp", "+ cos(theta)*temp", "thetaacc", Mistake.SIGN),
        ("(F + ", "(F - ", "temp", Mistake.SIGN),
    ],
)
def test_a_mistake_in_a_definition_is_named_there(
    part: str, wrong: str, definition: str, mistake: Mistake
) -> None:
    """Both lines that use it blame the same place of the definition."""
    text = GYMNASIUM.replace(part, wrong, 1)
    found = [first_repair("cartpole", text, place) for place in (0, 1)]
    edits = [repair.edits for repair in found]
    assert edits[0] == edits[1]
    ((edit,), _) = edits
    assert (edit.mistake, edit.definition, edit.span) == (mistake, definition, None)
    for entry in mechanics.check(SCENES["cartpole"], text).judged:
        told = f"one error in the definition of {definition}: 1, 2"
        assert entry.blame is not None and told in entry.blame.explanations


def test_the_mass_matrix_entry_by_entry() -> None:
    """One entry that is wrong is mended where it stands."""
    M, m, L, theta = symbols("M m L theta")
    right = Matrix([[M + m, M * L * cos(theta) / 2], [M * L * cos(theta) / 2, M * L**2 / 3]])
    wrong = right.copy()
    wrong[1, 1] = M * L**2 / 12
    (edit,) = first_repair("pendulum", wrong).edits
    assert (edit.mistake, edit.written, edit.right) == (Mistake.FACTOR, "1/12", "1/3")
    wrong = right.copy()
    wrong[0, 1] = M * L * sin(theta) / 2
    (edit,) = first_repair("pendulum", wrong).edits
    assert (edit.mistake, edit.written, edit.right) == (
        Mistake.FUNCTION, "sin(theta)", "cos(theta)",
    )  # fmt: skip


def test_an_object_of_sympy() -> None:
    M, m, L, k, x, theta = symbols("M m L k x theta")
    xdd, thdd, thd = symbols("x_ddot theta_ddot theta_dot")
    bracket = thdd * cos(theta) - thd**2 * sin(theta)
    wrong = (M + m) * xdd + 2 * k * x + M * L * bracket * Rational(1, 3)
    (edit,) = first_repair("pendulum", wrong).edits
    assert (edit.mistake, edit.written, edit.right) == (Mistake.FACTOR, "1/3", "1/2")


def cart_pole(x, x_dot, theta, theta_dot, F, l, mp, mc, g):
    """SharpNEAT's: the parallel axis counted twice."""
    total = mc + mp
    temp = (F + mp * l * theta_dot**2 * math.sin(theta)) / total
    inertia = l * (7.0 / 3.0 - mp * math.cos(theta) ** 2 / total)
    thetaacc = (g * math.sin(theta) - math.cos(theta) * temp) / inertia
    return temp - mp * l * thetaacc * math.cos(theta) / total, thetaacc


def test_a_function_of_python() -> None:
    (edit,) = first_repair("cartpole", cart_pole, 1).edits
    assert (edit.mistake, edit.written, edit.right) == (Mistake.FACTOR, "7/3", "4/3")


def test_a_function_of_c() -> None:
    text = """
    #include <math.h>
    double acceleration(double theta, double theta_dot, double f, double M, double R, double I_C,
                        double g)
    {
        double inertia = I_C + M * R * R * (5.0 / 4.0 - cos(theta));
        return (R * f + R / 2 * f * cos(theta) + M * g * R / 2 * sin(theta)
                + M * R * R / 2 * theta_dot * theta_dot * sin(theta)) / inertia;
    }
    """
    (edit,) = first_repair("rocker", text, notation="c").edits
    assert edit.mistake is Mistake.SIGN


NIPS = "(tau + d2/d1*phi1 - phi2)/(m2*lc2^2 + I2 - d2^2/d1)"
ACROBOT = """
d1 = m1*lc1^2 + m2*(l1^2 + lc2^2 + 2*l1*lc2*cos(theta2)) + I1 + I2
d2 = m2*(lc2^2 + l1*lc2*cos(theta2)) + I2
phi2 = m2*lc2*g*cos(theta1 + theta2 - pi/2)
phi1 = -m2*l1*lc2*theta2'^2*sin(theta2) - 2*m2*l1*lc2*theta2'*theta1'*sin(theta2) ...
  + (m1*lc1 + m2*l1)*g*cos(theta1 - pi/2) + phi2
theta2'' = """


@pytest.mark.campaign
def test_the_term_that_the_first_acrobot_lacks() -> None:
    """Sutton's of 1996 has no m2 l1 lc2 theta1'^2 sin(theta2) in the second row."""
    found = first_repair("acrobot", ACROBOT + NIPS)
    (edit,) = found.edits
    assert edit.mistake is Mistake.MISSING
    assert edit.right.startswith("-")
    for factor in ("l1", "lc2", "m2", "theta1'^2", "sin(theta2)"):
        assert factor in edit.right


@pytest.mark.parametrize(("part", "wrong"), [("l1^2", "l1"), ("m2*l1*l2", "m2*l1")])
def test_momenta_of_the_double_pendulum(part: str, wrong: str) -> None:
    """The public notebook's: l1 for l1^2."""
    text = "pi_1 = (m1 + m2)*l1^2*phi1' + m2*l1*l2*phi2'*cos(phi1 - phi2)"
    names = {"pi_1": "p_phi1"}
    (edit,) = first_repair("double", text.replace(part, wrong), names=names).edits
    assert edit.mistake in (Mistake.POWER, Mistake.FACTOR)


@pytest.mark.parametrize(
    ("scene", "text", "written", "right"),
    [
        # The second angle is counted from the first rod.
        ("arm", "V = m1*g*l1*sin(theta1) + m2*g*(l1*sin(theta1) + l2*sin(theta2))",
         "theta2", "theta2 + theta1"),
        ("oscillator", "m*x'' = F0*cos(omega*t) - c*x'", "", "- k*x"),
        ("oscillator", "m*x'' = -k*x", "", "+ (F0*cos(t*omega) - x'*c)"),
    ],
)  # fmt: skip
def test_what_is_lacking_stands_where_its_like_stands(
    scene: str, text: str, written: str, right: str
) -> None:
    (entry,) = judged(scene, text, blame=True).judged
    assert entry.blame is not None
    edits = entry.blame.repairs[0].edits
    assert edits[0].written == written
    assert "".join(e.right for e in edits).replace(" ", "") == right.replace(" ", "")
    if not written:
        assert all(e.span is not None and e.span[0] > text.index("=") for e in edits)


def test_an_abbreviated_sine_is_told_as_it_stands() -> None:
    text = (
        r"\[ \tau_1 = m_2 l_2^2(\ddot\theta_1+\ddot\theta_2) + (m_1+m_2) l_1^2\ddot\theta_1"
        r" + m_2 l_1 l_2 c_2(2\ddot\theta_1+\ddot\theta_2) - m_2 l_1 l_2 s_2\dot\theta_2^2"
        r" - 2 m_2 l_1 l_2 s_2\dot\theta_1\dot\theta_2 + m_2 l_2 g c_2 + (m_1+m_2) l_1 g c_1 \]"
    )
    (entry,) = judged("arm", text, blame=True).judged
    assert entry.blame is not None
    (edit,) = entry.blame.repairs[0].edits
    assert edit.written == "c_2"
    assert edit.span is not None
    assert edit.span[0] > text.index("dot\\theta_2 +") - 3


def test_a_sum_that_lacks_a_term_keeps_the_brackets_that_stand_around_it() -> None:
    def rate(x, v, t, m, k, F0, omega):
        pull = (F0 * math.cos(omega * t) - k * x) / m
        return v, pull

    found = mechanics.check(truth("oscillator"), rate)
    told = [entry.blame for entry in found.judged if entry.blame is not None]
    edits = [edit for blame in told for repair in blame.repairs for edit in repair.edits]
    assert "pull" in {edit.definition for edit in edits}
    sums = [edit for edit in edits if " - " in edit.written]
    assert not any(edit.right.startswith("(") and edit.right.endswith(")") for edit in sums)
