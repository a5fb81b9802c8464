"""Acrobots of Gymnasium: "book" is right, "nips" lacks a term. And its pendulum."""

from collections.abc import Callable

import numpy as np
import pytest

import mechanics

POINT = {"theta1": 0.3, "theta2": 0.5, "theta1_dot": 1, "theta2_dot": -2, "tau": 1, "m1": 1,
         "m2": 1, "l1": 1, "lc1": 0.5, "lc2": 0.5, "I1": 1, "I2": 1, "g": 9.8}  # fmt: skip
RIGHT = ("-1.97399000264033", "0.463119592337755")
NIPS = ("-2.12850552691412", "0.863645383910835")
STATE = {"s": "theta1 theta2 theta1_dot theta2_dot", "a": "tau"}


def dsdt(book_or_nips: str) -> Callable:
    """The formulas of Gymnasium's `AcrobotEnv._dsdt`."""

    def rate(s, a, m1, m2, l1, lc1, lc2, I1, I2, g):
        theta1, theta2, dtheta1, dtheta2 = s
        d1 = (
            m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * np.cos(theta2)) + I1 + I2
        )  # fmt: skip
        d2 = m2 * (lc2**2 + l1 * lc2 * np.cos(theta2)) + I2
        phi2 = m2 * lc2 * g * np.cos(theta1 + theta2 - np.pi / 2.0)
        phi1 = (
            -m2 * l1 * lc2 * dtheta2**2 * np.sin(theta2)
            - 2 * m2 * l1 * lc2 * dtheta2 * dtheta1 * np.sin(theta2)
            + (m1 * lc1 + m2 * l1) * g * np.cos(theta1 - np.pi / 2)
            + phi2
        )
        if book_or_nips == "nips":
            ddtheta2 = (a + d2 / d1 * phi1 - phi2) / (m2 * lc2**2 + I2 - d2**2 / d1)
        else:
            ddtheta2 = (a + d2 / d1 * phi1 - m2 * l1 * lc2 * dtheta1**2 * np.sin(theta2) - phi2) / (
                m2 * lc2**2 + I2 - d2**2 / d1
            )
        ddtheta1 = -(d2 * ddtheta2 + phi1) / d1
        return dtheta1, dtheta2, ddtheta1, ddtheta2

    return rate


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("variant", "printed", "verdict"), [("book", RIGHT, "PROVED"), ("nips", NIPS, "REFUTED")]
)
def test_the_code_itself_gets_its_verdict(truth, assert_agree, variant, printed, verdict) -> None:
    names = ("m1", "m2", "l1", "lc1", "lc2", "I1", "I2", "g")
    state = [POINT[n] for n in ("theta1", "theta2", "theta1_dot", "theta2_dot")]
    assert_agree(dsdt(variant)(state, POINT["tau"], *(POINT[n] for n in names))[2:], printed)
    found = mechanics.check(truth("acrobot"), dsdt(variant), names=STATE)
    assert {m.name: m.meaning for m in found.names}["s"] == STATE["s"]
    verdicts = [entry.finding.verdict.name for entry in found.judged]
    assert verdicts == ["PROVED", "PROVED", verdict, verdict]


def test_the_engine_gives_the_right_values(truth, assert_agree, accelerations) -> None:
    assert_agree(accelerations(truth("acrobot"), POINT), RIGHT)


ROWS = """
d1 = m1*lc1^2 + m2*(l1^2 + lc2^2 + 2*l1*lc2*cos(theta2)) + I1 + I2
d2 = m2*(lc2^2 + l1*lc2*cos(theta2)) + I2
phi2 = m2*lc2*g*cos(theta1 + theta2 - pi/2)
phi1 = -m2*l1*lc2*dtheta2^2*sin(theta2) - 2*m2*l1*lc2*dtheta2*dtheta1*sin(theta2) ...
    + (m1*lc1 + m2*l1)*g*cos(theta1 - pi/2) + phi2
ddtheta2 = (tau + d2/d1*phi1 {missing}- phi2)/(m2*lc2^2 + I2 - d2^2/d1)
ddtheta1 = -(d2*ddtheta2 + phi1)/d1
"""


def test_the_rows_of_the_book_are_proved(truth) -> None:
    text = ROWS.format(missing="- m2*l1*lc2*dtheta1^2*sin(theta2) ")
    found = mechanics.check(truth("acrobot"), text)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]


@pytest.mark.campaign
def test_the_missing_product_of_speeds_is_named(truth, edits) -> None:
    first, second = mechanics.check(truth("acrobot"), ROWS.format(missing="")).judged
    ((mistake, nothing, right),) = edits(first)
    assert (mistake, nothing) == ("MISSING", "")
    assert right.startswith("-") and {"m2", "l1", "lc2", "sin(theta2)"} <= set(
        right.strip("- ").split("*")
    )
    assert any("products of speeds" in d.group for d in first.blame.differences)
    assert any("link2: rate of linear momentum" in d.origin for d in first.blame.differences)
    assert second.finding.verdict.name == "PROVED"


def pendulum(th, thdot, u, g, m, l):
    """Gymnasium's `PendulumEnv.step`, without its limits."""
    return 3 * g / (2 * l) * np.sin(th) + 3.0 / (m * l**2) * u


def test_the_rod_pendulum_is_proved(truth, assert_agree, accelerations) -> None:
    names = {"th": "theta", "thdot": "theta_dot"}
    found = mechanics.check(truth("rod_pendulum"), pendulum, names=names)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]
    at = {"theta": 0.3, "theta_dot": 1, "u": 0.7, "g": 10, "m": 1.2, "l": 0.8}
    value = pendulum(at["theta"], at["theta_dot"], at["u"], at["g"], at["m"], at["l"])
    assert float(accelerations(truth("rod_pendulum"), at)[0]) == pytest.approx(value, rel=1e-14)
