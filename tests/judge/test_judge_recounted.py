"""A declared convention changes what a person wrote, and nothing that is the scene's own."""

from functools import cache
from importlib import import_module

import pytest

from mechanics import check
from mechanics.equations import Equations
from mechanics.judge.check import derived

ALONE = "m1*lc1**2 + I1 + I2 + m2*(l1**2 + lc2**2 + 2*l1*lc2*cos(theta2))"


@cache
def truth(system: str) -> Equations:
    return derived(import_module(f"systems.{system}").scene())


def verdict(system: str, text: str, convention: str) -> str:
    (entry,) = check(truth(system), text, convention=convention, blame=False).judged
    return entry.verdict.name


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("system", "convention", "right", "wrong"),
    [
        ("cartpole", "other sign of angles", "M12 = -mp*l*cos(theta)", "M12 = mp*l*cos(theta)"),
        ("cartpole", "other vertical", "M12 = -mp*l*cos(theta)", "M12 = mp*l*cos(theta)"),
        ("cartpole", "twice the length", "M22 = mp*l**2/3", "M22 = 4/3*mp*l**2"),
        ("cartpole", "half-length", "M22 = 16/3*mp*l**2", "M22 = 4/3*mp*l**2"),
        ("acrobot", "absolute angles", "M11 = m1*lc1**2 + I1 + m2*l1**2", f"M11 = {ALONE}"),
        ("rod_pendulum", "other vertical", "omega = sqrt(3*g/(2*l))", "omega = sqrt(g/l)"),
        ("rod_pendulum", "twice the length", "omega = sqrt(3*g/l)", "omega = sqrt(3*g/(2*l))"),
        ("rod_pendulum", "point mass", "omega = sqrt(2*g/l)", "omega = sqrt(3*g/(2*l))"),
        (
            "bead_on_hoop", "other vertical",
            r"In equilibrium $\cos\theta = -\frac{g}{R\omega^2}$.",
            r"In equilibrium $\cos\theta = \frac{g}{R\omega^2}$.",
        ),
        (
            "bead_on_hoop", "other vertical",
            r"For small angles $\ddot\theta = (\omega^2 + g/R)\theta$.",
            r"For small angles $\ddot\theta = (\omega^2 - g/R)\theta$.",
        ),
    ],
)  # fmt: skip
def test_what_is_compared_with_the_scene_itself(
    system: str, convention: str, right: str, wrong: str
) -> None:
    assert verdict(system, right, convention) in ("PROVED", "CERTIFIED")
    assert verdict(system, wrong, convention) == "REFUTED"


def test_an_entry_in_no_sense_from_the_horizontal() -> None:
    assert verdict("cartpole", "M12 = mp*l*cos(theta)", "from the horizontal") == "REFUTED"


@pytest.mark.parametrize(("value", "verdict"), [("15/2", "PROVED"), ("15", "REFUTED")])
def test_a_frequency_with_a_value(value: str, verdict: str) -> None:
    text = f"omega = sqrt({value}/l)"
    (entry,) = check(truth("rod_pendulum"), text, values={"g": 5}, blame=False).judged
    assert entry.verdict.name == verdict


@pytest.mark.parametrize(("sign", "verdict"), [("", "CERTIFIED"), ("-", "REFUTED")])
def test_an_entry_where_a_cosine_is_positive(sign: str, verdict: str) -> None:
    text = f"M12 = {sign}mp*l*abs(cos(theta))"
    found = check(truth("cartpole"), text, where="cos(theta) > 0", blame=False)
    assert [entry.verdict.name for entry in found.judged] == [verdict]


@pytest.mark.parametrize(("value", "verdict"), [(10, "CERTIFIED"), (11, "REFUTED")])
def test_small_angles_with_a_value(value: int, verdict: str) -> None:
    text = r"For small angles $\ddot\theta = (\omega^2 - 10/R)\theta$"
    (entry,) = check(truth("bead_on_hoop"), text, values={"g": value}, blame=False).judged
    assert entry.verdict.name == verdict
