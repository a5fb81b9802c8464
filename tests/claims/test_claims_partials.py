r"""Lagrange's and Hamilton's equations as they stand in papers, with partial derivatives."""

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import Check, derived
from systems import acrobot, cartpole, elastic_pendulum, rod_pendulum

CART = derived(cartpole.scene())
LAGRANGIAN = (
    r"L = \frac12 (m_c+m_p)\dot x^2 + m_p l \dot x\dot\theta\cos\theta"
    r" + \frac23 m_p l^2\dot\theta^2 - m_p g l\cos\theta"
)
LAGRANGE = (
    r"\frac{d}{dt}\frac{\partial L}{\partial \dot x} - \frac{\partial L}{\partial x} = F, \qquad"
    r" \frac{d}{dt}\left(\frac{\partial L}{\partial\dot\theta}\right)"
    r" = \frac{\partial}{\partial\theta} L"
)


def checked(truth, *lines: str, blame: bool = False, notation: str = "latex") -> Check:
    texts = lines if notation == "text" else [rf"\[ {line} \]" for line in lines]
    return mechanics.check(truth, "\n".join(texts), notation=notation, blame=blame)


def verdicts(found: Check) -> list[str]:
    return [entry.finding.verdict.name for entry in found.judged]


def test_lagrange_s_equations_and_the_lagrangian_are_judged() -> None:
    found = checked(CART, LAGRANGIAN, LAGRANGE)
    assert verdicts(found) == ["PROVED"] * 3
    assert type(found.judged[0].statement.row.quantity).__name__ == "Lagrangian"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (r"\frac23", r"\frac13", ["REFUTED", "PROVED", "REFUTED"]),
        (r"- m_p g l", r"+ m_p g l", ["REFUTED", "PROVED", "REFUTED"]),
        (r"= F", r"= -F", ["PROVED", "REFUTED", "PROVED"]),
        (r"- \frac{\partial L}{\partial x}", r"- \frac{\partial L}{\partial \theta}",
         ["PROVED", "REFUTED", "PROVED"]),
    ],
)  # fmt: skip
def test_wrong_ones_are_refuted(old: str, new: str, expected: list[str]) -> None:
    texts = [text.replace(old, new, 1) for text in (LAGRANGIAN, LAGRANGE)]
    assert texts != [LAGRANGIAN, LAGRANGE]
    assert verdicts(checked(CART, *texts)) == expected


def test_a_wrong_lagrangian_is_blamed_and_not_what_follows_from_it() -> None:
    found = checked(CART, LAGRANGIAN.replace(r"\frac23", r"\frac13"), LAGRANGE, blame=True)
    energy, _, equation = (entry.blame for entry in found.judged)
    assert energy is not None
    assert [(e.written, e.right) for e in energy.repairs[0].edits] == [("1", "2")]
    assert equation is not None
    assert any("follows from the energy" in words for words in equation.explanations)


def test_text_has_partial_derivatives_too() -> None:
    energy = (
        "Lag = (mc + mp)*xd^2/2 + mp*l*xd*thetad*cos(theta)"
        " + 2*mp*l^2*thetad^2/3 - mp*g*l*cos(theta)"
    )
    rows = ("diff(diff(Lag, xd), t) - diff(Lag, x) = F",
            "diff(Lag, thetad).diff(t) - Lag.diff(theta) = 0")  # fmt: skip
    assert verdicts(checked(CART, energy, *rows, notation="text"))[-2:] == ["PROVED", "PROVED"]
    wrong = verdicts(checked(CART, energy, rows[0].replace("= F", "= 2*F"), notation="text"))
    assert wrong[-1] == "REFUTED"


def test_hamilton_s_equations() -> None:
    hamiltonian = r"H = \frac{3 p_\theta^2}{2 m l^2} + \frac12 m g l\cos\theta"
    rows = (r"\dot\theta = \frac{\partial H}{\partial p_\theta}",
            r"\dot p_\theta = -\frac{\partial H}{\partial\theta} + u")  # fmt: skip
    truth = derived(rod_pendulum.scene())
    assert verdicts(checked(truth, hamiltonian, *rows)) == ["PROVED"] * 3
    turned = rows[1].replace("= -", "= ")
    assert verdicts(checked(truth, hamiltonian, rows[0], turned)) == ["PROVED", "PROVED", "REFUTED"]


def test_the_gradient_by_a_column() -> None:
    truth = derived(acrobot.scene())
    energy = (
        r"V = -m_1 g l_{c1}\cos\theta_1 - m_2 g(l_1\cos\theta_1 + l_{c2}\cos(\theta_1+\theta_2))"
    )
    mass = (
        r"M = \begin{bmatrix} m_1 l_{c1}^2 + m_2(l_1^2 + l_{c2}^2 + 2 l_1 l_{c2}\cos\theta_2)"
        r" + I_1 + I_2 & d \\ d & m_2 l_{c2}^2 + I_2 \end{bmatrix},"
        r" \quad d = m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2"
    )
    kinetic = r"T = \frac12 \dot q^T M \dot q"
    row = (
        r"\frac{d}{dt}\frac{\partial T}{\partial\dot q} - \frac{\partial T}{\partial q}"
        r" + \frac{\partial V}{\partial q} = \begin{bmatrix} 0 \\ \tau \end{bmatrix}"
    )
    assert verdicts(checked(truth, energy, mass, kinetic, row)) == ["PROVED"] * 4
    wrong = row.replace(r"- \frac{\partial T}{\partial q}", r"+ \frac{\partial T}{\partial q}")
    assert verdicts(checked(truth, energy, mass, kinetic, wrong))[-1] == "REFUTED"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\frac{\partial x}{\partial t} = \dot x", "by time"),
        (r"\frac{\partial L}{\partial (2x)} = 0", "one name below the bar"),
        (r"\frac{\partial^2 L}{\partial x^2} = 0", r"\\partial is not supported"),
        (r"\frac{\partial l}{\partial x} = \ddot x", "derivative of a constant"),
    ],
)
def test_what_cannot_be_meant_is_refused(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        checked(CART, text)


def test_the_length_is_no_lagrangian() -> None:
    """L is the length of the pendulum: its derivative would be zero without a word."""
    text = r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{\partial L}{\partial x} = 0"
    with pytest.raises(InputError, match="rename yours"):
        checked(derived(elastic_pendulum.scene()), text)
