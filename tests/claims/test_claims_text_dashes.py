"""A dash before an equation is the mark of a list, a minus sign, or not read."""

import pytest

from mechanics import check
from systems import rod_pendulum

RIGHT = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
WRONG = "theta'' = -3*g/(2*l)*sin(theta) - 3*u/(m*l^2)"
MOMENT = "m*l^2/3*theta'' - u = m*g*l/2*sin(theta)"
MINUS = "m*l^2/3*theta'' + u = -m*g*l/2*sin(theta)"


def verdict(text: str) -> str:
    """Of what is written in a text."""
    return check(rod_pendulum.scene(), text, notation="text", blame=False).verdict.name


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (f"- {RIGHT}\n", "PROVED"),
        (f"- {WRONG}\n", "UNDECIDED"),  # right if theta is counted from hanging
        (f"Equations of motion\n\n- {RIGHT}\n- {MOMENT}\n", "PROVED"),
        (f"\u2013 {RIGHT}\n\u2013 {MOMENT}\n", "PROVED"),
        (f"  - `{MOMENT}`\n", "PROVED"),
        (f"  - `{MINUS}`\n", "UNDECIDED"),
        (f"-{MINUS}\n", "PROVED"),  # a minus has no blank behind it
        (f"-{WRONG}\n", "PROVED"),
        (f"{RIGHT}\n- {MINUS}\n", "PROVED"),  # no list has one item between equations
        ("m*l^2/3*theta''\n - m*g*l/2*sin(theta) = u\n", "PROVED"),
        ("m*l^2/3*theta''\n - m*g*l/2*sin(theta)\n - u = 0\n", "PROVED"),
    ],
)
def test_a_dash(text: str, expected: str) -> None:
    assert verdict(text) == expected


def test_a_dash_that_may_be_either_is_not_read() -> None:
    answer = check(rod_pendulum.scene(), f"- {MINUS}\n\n{RIGHT}\n", notation="text", blame=False)
    assert answer.verdict.name == "UNDECIDED"
    assert {entry.verdict.name for entry in answer.judged} == {"PROVED", "UNDECIDED"}
    assert "the dash may be a minus or the mark of a list" in " ".join(str(answer).split())
