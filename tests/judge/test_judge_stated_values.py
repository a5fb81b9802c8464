"""Values beside an equation bind names as "for g = 9.81" does: what is right with them is open."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import bead_on_hoop, rod_pendulum

ROD = derived(rod_pendulum.scene())
HOOP = derived(bead_on_hoop.scene())
MODEL = """model P
  Real theta, w; Real u = 0; parameter Real m=1,l=1,g=9.81;
equation
  der(theta)=w; der(w)=3*g/(2*l)*sin(theta);
end P;
"""


@pytest.mark.parametrize(
    ("truth", "text", "values"),
    [
        (ROD, r"$$\ddot\theta=14.715\sin\theta+3u,\quad g=9.81,\ l=1,\ m=1$$", "g = 9.81"),
        (ROD, "g = 9.81, l = 1, m = 1\ntheta'' = 14.715*sin(theta) + 3*u", "g = 9.81"),
        (ROD, "g = 9.81; u = 0;\ntheta'' = 3*g/(2*l)*sin(theta)", "u = 0"),
        (ROD, MODEL, "u = 0"),
        (HOOP, "R = 2 m\ntheta'' = (omega^2*cos(theta) - g/2)*sin(theta)", "R = 2"),
    ],
)
def test_what_is_right_with_the_values_beside_it_is_open(truth, text: str, values: str) -> None:
    (entry,) = mechanics.check(truth, text, blame=False).judged
    assert entry.verdict.name == "UNDECIDED"
    assert any(values in one and one.endswith("as the text says") for one in entry.right_if)


@pytest.mark.parametrize(
    "text",
    [
        "g = 9.81, l = 1, m = 1\ntheta'' = 14.8*sin(theta) + 3*u",
        "l = 1\nl = 2\ntheta'' = 3*g/2*sin(theta) + 3*u/(m*l^2)",
        "u = 0\ntheta'' = 3*g/l*sin(theta)",
    ],
)
def test_what_is_wrong_with_them_is_wrong(text: str) -> None:
    assert mechanics.check(ROD, text, blame=False).verdict.name == "REFUTED"
