"""Terms and brackets that are wrong, in every place where a person makes them wrong.

definitions in a missing term, signs of sliding, four sines and cosines, below d/dt, in a factor
"""

from functools import cache

import pytest

import mechanics
from mechanics.blame.result import Mistake, Repair
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import (
    cartpole_friction,
    double_pendulum,
    elastic_pendulum,
    rocker,
    rolling_disc,
    two_mass_chain,
)

SCENES = {
    "pendulum": elastic_pendulum.scene,
    "rocker": rocker.scene,
    "friction": cartpole_friction.scene,
    "double": double_pendulum.scene,
    "disc": rolling_disc.scene,
    "chain": two_mass_chain.scene,
}

ROCKER = (
    r"(I_C + \frac{5}{4} M R^2 + M R^2 \cos\theta) \ddot\theta"
    r" - \frac{1}{2} M R^2 \dot\theta^2 \sin\theta = \frac{1}{2} M g R \sin\theta"
    r" + f R (1 + \frac{1}{2} \cos\theta)"
)
FRICTION = (
    "theta'' = (g*sin(theta) + (g*mu_c*sign(x') - (F + m_p*l*theta'^2*(sin(theta)"
    " + mu_c*sign(x')*cos(theta)))/(m_c + m_p))*cos(theta) - mu_p*theta'/(m_p*l))"
    "/(l*(4/3 - m_p*cos(theta)*(cos(theta) - mu_c*sign(x')*sin(theta))/(m_c + m_p)))"
)
DOUBLE = (
    "phi1'' = (-g*m1*sin(phi1) - g*m2*sin(phi1)*cos(phi2)^2 + g*m2*sin(phi2)*cos(phi1)*cos(phi2)"
    " - 2*l1*m2*phi1'^2*sin(phi1)*cos(phi1)*cos(phi2)^2 + l1*m2*phi1'^2*sin(phi1)*cos(phi1)"
    " + 2*l1*m2*phi1'^2*sin(phi2)*cos(phi1)^2*cos(phi2) - l1*m2*phi1'^2*sin(phi2)*cos(phi2)"
    " - l2*m2*phi2'^2*sin(phi1)*cos(phi2) + l2*m2*phi2'^2*sin(phi2)*cos(phi1))"
    "/(l1*(m1 - 2*m2*sin(phi1)*sin(phi2)*cos(phi1)*cos(phi2) - 2*m2*cos(phi1)^2*cos(phi2)^2"
    " + m2*cos(phi1)^2 + m2*cos(phi2)^2))"
)
FIRST = "diff((m + M)*x' + M*L/2*theta'*cos(theta), t) + 2*k*x = 0"
SECOND = "diff(M*L/2*x'*cos(theta) + M*L^2/3*theta', t) + M*L/2*sin(theta)*(x'*theta' + g) = 0"
OPENED = (
    "m1*l1*phi1'' + m2*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2)"
    " + m2*l2*phi2'^2*sin(phi1 - phi2) + m1*g*sin(phi1) + m2*g*sin(phi1) = 0"
)
HALF = r"E_k = \frac{1}{2}\left(I_C + \frac{5}{4} M R^2 + M R^2 \cos\theta\right)\dot\theta^2"

CASES = (
    # M follows from the density: the term grows with none of the quantities it is written in.
    ("rocker", ROCKER, r" - \frac{1}{2} M R^2 \dot\theta^2 \sin\theta", "", Mistake.MISSING),
    ("friction", FRICTION, "g*mu_c*sign(x') - ", "-", Mistake.MISSING),
    ("friction", FRICTION, "g*sin(theta) + (", "(", Mistake.MISSING),
    ("double", DOUBLE, " - 2*m2*cos(phi1)^2*cos(phi2)^2", "", Mistake.MISSING),
    ("pendulum", FIRST, "cos(theta)", "sin(theta)", Mistake.FUNCTION),
    ("pendulum", FIRST, "M*L/2*theta'", "M*L*theta'", Mistake.FACTOR),
    ("pendulum", FIRST, "+ M*L/2*theta'", "- M*L/2*theta'", Mistake.SIGN),
    ("pendulum", SECOND, "L^2/3", "L/3", Mistake.POWER),
    ("pendulum", SECOND, "*x'*cos(theta) +", "*x' +", Mistake.FACTOR),
    ("pendulum", SECOND, "M*L^2/3", "m*L^2/3", Mistake.SYMBOL),
    ("pendulum", FIRST, "+ 2*k*x", "+ 2*k*x + m*x'", Mistake.EXTRA),
    ("double", OPENED, "m1*g", "m2*g", Mistake.SYMBOL),
    ("rocker", HALF, "I_C +", "", Mistake.MISSING),
    ("chain", "2*m*x2'' + k*(x2 - x1) = 0", "x2''", "x2'", Mistake.SYMBOL),
)  # fmt: skip


@cache
def truth(name: str) -> Equations:
    """A scene, derived once."""
    return derived(SCENES[name]())


def repairs(name: str, text: str) -> tuple[Repair, ...]:
    """What makes a refuted text right."""
    (entry,) = mechanics.check(truth(name), text).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    assert entry.blame.repairs, entry.blame.searched
    return entry.blame.repairs


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "name, text", {(name, text): None for name, text, *_ in CASES}, ids=lambda value: value[:20]
)
def test_the_right_texts_are_right(name: str, text: str) -> None:
    (entry,) = mechanics.check(truth(name), text).judged
    assert entry.finding.shown, entry.finding


@pytest.mark.sample(2)
@pytest.mark.parametrize("name, text, old, new, mistake", CASES)
def test_one_edit_undoes_it(name: str, text: str, old: str, new: str, mistake: Mistake) -> None:
    assert text.count(old) >= 1
    found = repairs(name, text.replace(old, new, 1))
    assert [edit.mistake for edit in found[0].edits] == [mistake], found[0].edits


@pytest.mark.sample(2)
@pytest.mark.parametrize("name, text, old, new, mistake", CASES)
def test_what_is_told_is_right_when_it_is_read(
    name: str, text: str, old: str, new: str, mistake: Mistake
) -> None:
    for repair in repairs(name, text.replace(old, new, 1)):
        (again,) = mechanics.check(truth(name), repair.repaired, blame=False).judged
        assert again.finding.shown, (mistake, repair.repaired)


def test_two_errors_below_one_derivative_are_both_named() -> None:
    wrong = SECOND.replace("cos(theta)", "sin(theta)", 1).replace("L^2/3", "L^2/6")
    found = repairs("pendulum", wrong)[0]
    assert {edit.mistake for edit in found.edits} == {Mistake.FUNCTION, Mistake.FACTOR}


def test_a_bracket_that_was_opened_with_the_wrong_sign() -> None:
    wrong = OPENED.replace("+ m2*l2*phi2'^2", "- m2*l2*phi2'^2").replace("+ m1*g", "- m1*g")
    found = repairs("double", wrong.replace("+ m2*g", "- m2*g"))[0]
    assert [edit.mistake for edit in found.edits] == [Mistake.SIGN] * 3


@pytest.mark.campaign
def test_the_sign_of_a_whole_side_keeps_its_brackets() -> None:
    wrong = (
        r"2 k x + (m + M) \ddot x = \frac{M L}{2} (\ddot\theta\cos\theta - \dot\theta^2\sin\theta)"
    )
    found = repairs("pendulum", wrong)
    assert found[0].edits[0].mistake is Mistake.SIGN
    for repair in found:
        (again,) = mechanics.check(truth("pendulum"), repair.repaired, blame=False).judged
        assert again.finding.shown, repair.repaired


def test_two_names_that_are_exchanged_throughout() -> None:
    turned = OPENED.replace("m1", "m3").replace("m2", "m1").replace("m3", "m2")
    found = repairs("double", turned)[0]
    assert {(edit.written, edit.right) for edit in found.edits} <= {("m1", "m2"), ("m2", "m1")}
    (again,) = mechanics.check(truth("double"), found.repaired, blame=False).judged
    assert again.finding.shown


@pytest.mark.campaign
def test_an_equation_that_lost_its_only_acceleration() -> None:
    wrong = ROCKER.replace(r"(I_C + \frac{5}{4} M R^2 + M R^2 \cos\theta) \ddot\theta", "")
    (edit,) = repairs("rocker", wrong)[0].edits
    assert edit.mistake is Mistake.MISSING
    assert r"\ddot" in edit.right


def test_digits_are_not_put_together_where_a_factor_is_left_out() -> None:
    text = r"2 k x + (m + M) \ddot x + \frac{M L}{2 L \cdot 2 L} 2 L"
    wrong = text + r" (\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = 0"
    for repair in repairs("pendulum", wrong):
        (again,) = mechanics.check(truth("pendulum"), repair.repaired, blame=False).judged
        assert again.finding.shown, repair.repaired
