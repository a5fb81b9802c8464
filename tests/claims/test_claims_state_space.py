"""A linear model by its matrices is the equations that its rows are."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
MODEL = r"""
The state is $s = [\theta, \dot\theta]^T$. Linearised about $s = 0$:
$$ A = \begin{bmatrix} 0 & 1 \\ \frac{3g}{2l} & 0 \end{bmatrix}, \qquad
   B = \begin{bmatrix} 0 \\ \frac{3}{m l^2} \end{bmatrix} $$
"""


def verdict(text: str) -> str:
    return mechanics.check(ROD, text, blame=False).verdict.name


def test_matrices_of_the_state_that_the_text_gives_are_judged() -> None:
    assert verdict(MODEL) == "PROVED"


@pytest.mark.parametrize(
    ("right", "wrong"),
    [("{3g}", "{-3g}"), (r"\frac{3}{m l^2}", r"\frac{1}{m l^2}"), ("0 & 1", "0 & 2")],
)
def test_a_wrong_entry_is_refuted(right: str, wrong: str) -> None:
    assert verdict(MODEL.replace(right, wrong)) == "REFUTED"


def test_a_column_between_words_is_the_state() -> None:
    spoken = MODEL.replace("The state is $s = [", "State space, $[").replace("about $s = 0$", "")
    assert verdict(spoken) == "PROVED"
    assert verdict(spoken.replace("{3g}", "{2g}")) == "REFUTED"
    turned = spoken.replace(r"[\theta, \dot\theta]", r"[\dot\theta, \theta]")
    assert verdict(turned) != "PROVED"
    assert verdict(f"{spoken} $[\\dot\\theta, \\theta]^T$") != "PROVED"


@pytest.mark.parametrize("said", ["[\\theta, \\dot\\theta]^T", "Linearised about $s = 0$"])
def test_what_the_text_does_not_say_is_not_shown(said: str) -> None:
    assert verdict(MODEL.replace(said, "[x, y]" if "theta" in said else "")) != "PROVED"
