"""What is told beside an equation: definitions hold, values of parameters are told and not used."""

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
POLE = r"\tfrac43 l\ddot\theta + \ddot x\cos\theta = g\sin\theta"
RAIL = r"\ddot x + \mu l\ddot\theta\cos\theta = F/M + \mu l\dot\theta^2\sin\theta"
TYPED = "x'' + mu*l*theta''*cos(theta) = F/M + mu*l*theta'^2*sin(theta)"


def verdicts(text: str) -> list[str]:
    found = mechanics.check(CART, text, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "told",
    [
        r"\text{ where } g = 9.81",
        r", \text{ where } g = 9.81.",
        r"\quad\text{with}\quad g = 9.81\,\mathrm{m/s^2}",
        r",\quad g = 9.81\ \mathrm{m\,s^{-2}}",
        r"\quad (g = 9.81)",
        r",\quad (g = 9.81, l = 0.5)",
        r"\text{ where } l = 0.5\,\text{m}, m_p = 0.1\,\mathrm{kg} \text{ and } g = 9.81",
        r"\\ g &= \SI{9.81}{m/s^2}",
        r",\quad x(0) = 0, \dot x(0) = 0, \theta(0) = \theta_0",
    ],
)
def test_values_of_parameters_are_told_and_not_used(told: str) -> None:
    shown = rf"\[ {POLE} {told} \]"
    found = mechanics.check(CART, shown, blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]
    assert any("values and lists in the text are not used" in r for r in found.remarks)
    assert verdicts(shown.replace("= g", "= -g")) == ["REFUTED"]


@pytest.mark.parametrize("claim", [r"\ddot x = 0", "N = 0", r"\theta = 0", "F = 2"])
def test_what_moves_or_is_a_reaction_is_no_value(claim: str) -> None:
    assert verdicts(rf"\[ {POLE}, \quad {claim} \]") == ["PROVED", "REFUTED"]


def test_values_alone_are_no_verdict() -> None:
    found = mechanics.check(CART, r"\[ g = 9.81 \]", blame=False)
    assert not found.judged
    assert not found.ok


@pytest.mark.parametrize(
    "told",
    [
        r"\text{ where } \mu = m_p/M \text{ and } M = m_c + m_p",
        r",\quad \text{with } \mu = \frac{m_p}{M}, M = m_c + m_p.",
        r",\quad M = m_c+m_p,\ \mu = m_p/M.",
        r"\quad (M = m_c + m_p) \] where $\mu = \frac{m_p}{M}$. \[",
    ],
)
def test_definitions_beside_an_equation_hold(told: str) -> None:
    shown = rf"\[ {RAIL} {told} \]"
    assert verdicts(shown) == ["PROVED"]
    assert verdicts(shown.replace("m_c", "2 m_c")) == ["REFUTED"]


@pytest.mark.parametrize(
    "told",
    [
        " where M = mc + mp, mu = mp/M",
        ", with M = mc + mp and mu = mp/M.",
        ",\nwhere mu = mp/M and M = mc + mp, and g = 9.81 m/s^2",
        "\nwith:\nM = mc + mp\nmu = mp/M\nl = 0.5 m\ng = 9.81",
        "   (6)\nM = mc + mp, mu = mp/M",
    ],
)
def test_sentences_in_plain_text(told: str) -> None:
    assert verdicts(TYPED + told) == ["PROVED"]
    assert verdicts(TYPED + told.replace("mc", "2*mc")) == ["REFUTED"]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        "{a}\n  {b} = F",
        "{a} {b}\n = F",
        "{a}\n  {b}\n = F",
        "{a} = F\n  + mp*l*theta'^2*sin(theta)",
        "{a} = F +\n  mp*l*theta'^2*sin(theta)",
        "{a} {b} =\n  F",
        "(mc + mp)*x'' + mp*l*\n theta''*cos(theta) {b} = F",
        "(mc + mp)*x''\n + mp*l*theta''*cos(theta)\n {b} = F",
    ],
)
def test_an_equation_goes_on_over_lines_of_plain_text(text: str) -> None:
    a, b = "(mc + mp)*x'' + mp*l*theta''*cos(theta)", "- mp*l*theta'^2*sin(theta)"
    text = text.format(a=a, b=b)
    pole = "4/3*l*theta'' + x''*cos(theta)\n  - g*sin(theta) = 0"
    assert verdicts(text) == ["PROVED"]
    assert verdicts(text.replace("F", "2*F")) == ["REFUTED"]
    assert verdicts(f"{pole}\n{text}\n{pole}") == ["PROVED"] * 3


def test_lines_that_begin_with_a_minus_may_be_of_their_own() -> None:
    pole = "- 4/3*l*theta'' - x''*cos(theta) + g*sin(theta)"
    rail = "-(mc + mp)*x'' - mp*l*theta''*cos(theta) + mp*l*theta'^2*sin(theta) + F"
    assert verdicts(f"{rail}\n{pole}") == ["PROVED", "PROVED"]
    assert verdicts(f"{rail} = 0\n{pole} = 0") == ["PROVED", "PROVED"]
    assert verdicts(f"{rail} = 0;\n{pole}") == ["PROVED", "PROVED"]


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("2x''*cos(theta)/2 + 4/3*l*theta'' = g*sin(theta)", "PROVED"),
        ("x''*cos(theta) + 4/3*l*theta'' = g*sin(theta) + 2x^2 - 2*x^2", "PROVED"),
        ("x''*cos(theta) + 4/3*l*theta'' = g*sin(theta) + 2x\u00b2 - 2*x^2", "PROVED"),
        ("x''*cos(theta) + 4/3*l*theta'' = g*sin(theta) + 2x^2 - 4*x^2", "REFUTED"),
        ("x''*cos(theta) + 4/3*l*theta'' = 2sin(theta)*g/2", "PROVED"),
    ],
)
def test_a_number_before_a_power_is_a_factor(text: str, verdict: str) -> None:
    assert verdicts(text) == [verdict]


def test_a_name_behind_a_power_is_no_part_of_it() -> None:
    text = "4/3 l^2 theta'' + l x'' cos(theta) = g l sin(theta)"
    assert verdicts(text) == verdicts(text.replace("g l", "l^2 g/l")) == ["PROVED"]
    assert verdicts(text.replace("l^2 theta''", "l^(2*theta'')")) == ["REFUTED"]


@pytest.mark.parametrize(
    "label", ["{k}) ", "({k}) ", "{k}. ", "{k} ", "1. ", "eq{k}: ", "* ", "\u2022 "]
)
def test_labels_of_lines_of_plain_text(label: str) -> None:
    lines = ["4/3*l*theta'' + x''*cos(theta) = g*sin(theta)", TYPED, "M = mc + mp", "mu = mp/M"]
    labelled = [label.format(k=k) + line for k, line in enumerate(lines, start=1)]
    assert verdicts("\n".join(labelled)) == ["PROVED", "PROVED"]


def test_the_number_of_an_item_is_no_factor() -> None:
    right = "4/3*l*theta'' + x''*cos(theta) = g*sin(theta)"
    wrong = "x''*cos(theta) + 4/3*l*theta'' = g*sin(theta)/2"
    assert verdicts(f"1. {right}\n2. {wrong}") == ["PROVED", "REFUTED"]
    with pytest.raises(InputError, match="may be a factor or count the line"):
        verdicts("2. theta''*4/3*l + 2*x''*cos(theta) = 2*g*sin(theta) - 4/3*l*theta''*0")


def test_a_number_in_brackets_may_be_a_factor() -> None:
    assert verdicts("(4)/3*l*theta'' + x''*cos(theta) = g*sin(theta)") == ["PROVED"]
    assert verdicts("(2)*x''*cos(theta) + 8/3*l*theta'' = 2*g*sin(theta)") == ["PROVED"]
