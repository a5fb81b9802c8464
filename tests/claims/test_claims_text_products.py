"""Factors side by side in plain text are multiplied, as in books; a slash may take one or more."""

import pytest

import mechanics
from mechanics.claims.read import read_source
from mechanics.judge.check import derived
from systems import bead_on_hoop, cartpole, elastic_pendulum

CART, SPRING, HOOP = (
    derived(system.scene()) for system in (cartpole, elastic_pendulum, bead_on_hoop)
)


def verdict(truth: object, text: str) -> str:
    return mechanics.check(truth, text, notation="text", blame=False).verdict.name


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "text",
    [
        "4/3 l theta'' + x'' cos theta = g sin theta",
        "4/3 l theta'' + x''cos(theta) = g sin(theta)",
        "l (4 theta''/3 - g sin(theta)/l) + x'' cos(theta) = 0",
        "(4/3) (l) theta'' + cos(theta) x'' = g sin(theta)",
        "4 l theta''/3 + x'' cos(theta) = 1/2 (g + g) sin(theta)",
        "4l theta''/3 + cos(theta) x'' = l^2 g sin(theta)/l^2",
        "T = 1/2 (mc + mp) x'^2 + mp l x' theta' cos(theta) + 2/3 mp l^2 theta'^2",
    ],
)
def test_products_without_a_sign(text: str) -> None:
    assert verdict(CART, text) == "PROVED"
    assert verdict(CART, text.replace("theta'", "theta theta'", 1)) == "REFUTED"


@pytest.mark.parametrize(
    "text",
    [
        "(M + m)x'' + ML/2 (theta'' cos(theta) - theta'^2 sin(theta)) + 2kx = 0",
        "ML^2/3 theta'' + MLx''cos(theta)/2 + MgL/2 sin(theta) = 0",
        "MLL/3 theta'' + ML/2 x''cos theta + MgLsin(theta)/2 = 0",
    ],
)
def test_letters_of_the_scene_side_by_side(text: str) -> None:
    assert verdict(SPRING, text) == "PROVED"
    assert verdict(SPRING, text.replace("sin", "cos")) == "REFUTED"


def test_a_word_that_the_text_defines_is_none_of_letters() -> None:
    text = "(M + m)*x'' + mL*(theta''*cos(theta) - theta'^2*sin(theta)) + 2*k*x = 0\nmL = M*L/2"
    assert verdict(SPRING, text) == "PROVED"


def test_the_square_behind_a_factor_and_a_bracket_is_of_the_bracket() -> None:
    scene = elastic_pendulum.scene()
    one, other = (
        read_source(scene, f"{text} = 0", notation="text").statements[0].row
        for text in ("M(x + L)^2", "M*(x + L)^2")
    )
    assert one is not None and other is not None and one.sides == other.sides


def test_what_stands_below_a_slash_is_told_by_dimensions() -> None:
    text = "theta'' = (g sin(theta) - x'' cos(theta)) 3/4 l"
    found = mechanics.check(CART, text, notation="text", blame=False)
    assert found.verdict.name == "PROVED"
    assert any("/4 l is /(4 l)" in note for e in found.judged for note in e.statement.notes)
    assert verdict(CART, text.replace("3/4", "3/2")) == "REFUTED"
