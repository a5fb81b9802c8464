"""A speed to the power of another is a mistake as any other: it is named, or not, and no crash."""

from pathlib import Path

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import acrobot

RIGHT = """function acrobot!(dx, x, p, t)
    q1, q2, w1, w2 = x
    m1, m2, l1, lc1, lc2, I1, I2, g, u = p
    a = m1*lc1^2 + m2*(l1^2 + lc2^2 + 2*l1*lc2*cos(q2)) + I1 + I2
    b = m2*(lc2^2 + l1*lc2*cos(q2)) + I2
    c = m2*lc2^2 + I2
    h = m2*l1*lc2*sin(q2)
    r1 = h*(w2^2 + 2*w1*w2) - (m1*lc1 + m2*l1)*g*sin(q1) - m2*lc2*g*sin(q1 + q2)
    r2 = u - h*w1^2 - m2*lc2*g*sin(q1 + q2)
    d = a*c - b^2
    dx[1] = w1
    dx[2] = w2
    dx[3] = (c*r1 - b*r2)/d
    dx[4] = (a*r2 - b*r1)/d
end
"""
NAMES = {
    "x": "theta1 theta2 theta1_dot theta2_dot",
    "p": "m1 m2 l1 lc1 lc2 I1 I2 g tau",
}


@pytest.mark.sample(1)
@pytest.mark.parametrize(("old", "new"), [("w2^2 + 2", "w2^w1 + 2"), ("w1^2", "w1^w2")])
def test_a_power_that_is_a_name_is_refuted(tmp_path: Path, old: str, new: str) -> None:
    path = tmp_path / "acrobot.jl"
    path.write_text(RIGHT.replace(old, new))
    assert mechanics.check(acrobot.scene(), path, names=NAMES).verdict is Verdict.REFUTED
