r"""Functions of two numbers in text and LaTeX: hypot, wraps of angles by mod, Mod, rem, fmod."""

import pytest

import mechanics
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
ROW = "m*l^2*theta_ddot/3 + m*g*l*{}/2 = u"


def verdict(text: str) -> str:
    (entry,) = mechanics.check(SCENE, text, blame=False).judged
    return entry.finding.verdict.name


def turned(text: str) -> str:
    """The right row with something in it; the sign of gravity as the scene has it."""
    plain = ROW.format("sin(theta)")
    sign = "" if verdict(plain) == "PROVED" else "-"
    return ROW.replace("m*g*l", f"({sign}m)*g*l").format(text)


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["mod", "Mod", "rem", "fmod"])
def test_a_wrap_by_the_period_is_the_angle_to_its_sine_and_no_other_period_is(name: str) -> None:
    assert verdict(turned(f"sin({name}(theta, 2*pi))")) == "PROVED"
    assert verdict(turned(f"sin({name}(theta, 3*pi))")) != "PROVED"
    assert verdict(turned(f"2*sin({name}(theta, 2*pi))")) == "REFUTED"


def test_a_wrap_by_nothing_has_no_value() -> None:
    assert verdict(turned("sin(mod(theta, 0))")) == "REFUTED"


@pytest.mark.campaign
@pytest.mark.parametrize("text", ["hypot(g, l)", "hypot(-l, g)"])
def test_a_length_is_the_root_of_its_squares(text: str) -> None:
    assert verdict(turned(f"(sin(theta) + {text} - sqrt(g^2 + l^2))")) == "PROVED"
    assert verdict(turned(f"(sin(theta) + {text} - sqrt(g^2 - l^2))")) == "REFUTED"


def test_latex_names_them_as_operators() -> None:
    zero = r"\operatorname{hypot}(g, l) - \sqrt{g^2 + l^2}"
    rows = [
        rf"\frac{{m l^2}}{{3}}\ddot\theta {sign} \frac{{m g l}}{{2}}\sin\theta + {zero} = u"
        for sign in "+-"
    ]
    assert "PROVED" in map(verdict, rows)
