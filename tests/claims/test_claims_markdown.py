"""Markdown around formulas in a plain text, sets of numbers and letters as they are printed."""

import pytest

import mechanics
from mechanics.claims.text.markdown import without_markdown
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
PAGE = """
**Equation of the pole:**
```
4/3*l*theta'' + x''*cos(theta) = SIGN g*sin(theta)
```
- **w = theta'**: its angular velocity
"""


def verdicts(text: str, notation: str) -> list[str]:
    found = mechanics.check(CART, text, notation=notation, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(("sign", "verdict"), [("+", "PROVED"), ("-", "REFUTED")])
def test_marks_of_markdown_hide_no_equation(sign: str, verdict: str) -> None:
    page = PAGE.replace("SIGN", sign)
    assert verdict in verdicts(page, "text")
    assert len(without_markdown(page)) == len(page)
    assert without_markdown(page).split("\n")[-2].strip() == "w = theta'"


def test_a_power_is_no_emphasis() -> None:
    for text in ("a = x\n**2 + y**2", "x**2 + y**2 = 0", "**x = 1", "y = x ** 2"):
        assert without_markdown(text) == text


@pytest.mark.sample(3)
@pytest.mark.parametrize(("factor", "verdict"), [(r"\tfrac12", "PROVED"), ("", "REFUTED")])
@pytest.mark.parametrize("letter", ["\u2112", "\U0001d4db", r"\mathcal{L}"])
def test_a_script_letter_is_the_letter(letter: str, factor: str, verdict: str) -> None:
    text = (
        rf"${letter} = {factor} m_c\dot x^2 + \tfrac12 m_p(\dot x^2 + 2 l\dot x\dot\theta\cos\theta"
        rf" + \tfrac43 l^2\dot\theta^2) - m_p g l\cos\theta$"
    )
    assert verdicts(text, "latex") == [verdict]


def test_a_set_of_numbers_is_no_claim() -> None:
    pole = r"$$\tfrac43 l\ddot\theta+\ddot x\cos\theta = g\sin\theta$$"
    text = r"On $Q=\mathbb{R}\times \mathbb{S}^{1}$: "
    assert verdicts(text + pole, "latex") == ["PROVED"]
