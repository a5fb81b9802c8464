"""Sentences of a plain text that give parameters values, which the scene can have or not."""

import pytest

from mechanics import check
from mechanics.judge.check import derived
from systems import rod_pendulum

TRUTH = derived(rod_pendulum.scene())
RIGHT = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)"
WRONG = "theta'' = 2*g/l*sin(theta) + 3*u/(m*l**2)"
VALUES = (
    "We simulate with l = 1 and g = 9.81.",
    "Here we use l = 1, m = 2 kg, and g = 9.81 m/s^2",
    "- l = 1 m\n- g = 9.81",
)
NOT_ALLOWED = (
    "We simulate with l = 1 and g = -9.81.",
    "We simulate with l = 0 and g = 9.81.",
    "We simulate with theta = 0.1 and g = 9.81.",
    "This is wrong with l = 1.",
    "This holds only for l = 1.",
)


@pytest.mark.parametrize("words", VALUES)
def test_values_that_a_scene_can_have_say_nothing(words: str) -> None:
    found = [check(TRUTH, f"{words}\n\n{text}\n", blame=False) for text in (RIGHT, WRONG)]
    assert [one.verdict.name for one in found] == ["PROVED", "REFUTED"]


@pytest.mark.parametrize("words", NOT_ALLOWED)
def test_other_values_and_limits_leave_nothing_proved(words: str) -> None:
    assert check(TRUTH, f"{words}\n\n{RIGHT}\n", blame=False).verdict.name == "UNDECIDED"
