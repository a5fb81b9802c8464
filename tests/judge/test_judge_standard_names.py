"""A definition that gives a standard name a multiple of what it means makes nothing right."""

import pytest

from mechanics import check
from systems import rod_pendulum
from tests.notation_scenes import verdicts


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        (
            r"With $I = m l^2/2$, $$T = I\dot\theta^2$$",
            r"With $I = m l^2$, $$T = \frac12 I\dot\theta^2$$",
        ),
        (
            r"where $\omega = \dot\theta/2$: $$T = 2 m l^2\omega^2$$",
            r"where $\omega = \dot\theta$: $$T = \frac12 m l^2\omega^2$$",
        ),
        (
            r"With $v = l\dot\theta/2$, $$T = 2 m v^2$$",
            r"With $v = l\dot\theta$, $$T = \frac12 m v^2$$",
        ),
        (
            r"With $I = 2 m l^2$, $$I\ddot\theta = -2 m g l\sin\theta$$",
            r"With $\alpha = g/(2 l)$: $$\ddot\theta = -2\alpha\sin\theta$$",
        ),
    ],
)
def test_a_multiple_of_what_a_name_means(wrong: str, right: str) -> None:
    assert verdicts("pendulum", wrong) == ["UNDECIDED"]
    assert verdicts("pendulum", right) == ["PROVED"]


@pytest.mark.parametrize("inertia", [r"I_O = \frac13 m l^2", r"I_C = \frac1{12} m l^2"])
def test_a_body_has_an_inertia_about_any_of_its_points(inertia: str) -> None:
    times = "" if "O" in inertia else "4"
    text = rf"With ${inertia}$, $$T = \frac12 {times} {inertia[:3]} \dot\theta^2$$"
    (entry,) = check(rod_pendulum.scene(), text, blame=False).judged
    assert entry.verdict.name == "PROVED"
