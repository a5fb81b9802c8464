"""Rates that are spelled with letters, of names that the scene has and of names that it has not."""

import pytest

import mechanics
from mechanics.claims.spelled_rates import bases, families
from mechanics.kernel import Verdict
from systems import ALL

DOUBLE = next(system for system in ALL if system.name.replace(" ", "_") == "double_pendulum")

ROWS = """
(m1+m2)*l1*{0}1{2} + m2*l2*{0}2{2}*cos({0}1-{0}2) + m2*l2*{0}2{1}^2*sin({0}1-{0}2) + (m1+m2)*g*sin({0}1) = 0
l2*{0}2{2} + l1*{0}1{2}*cos({0}1-{0}2) - l1*{0}1{1}^2*sin({0}1-{0}2) + g*sin({0}2) = 0
"""  # noqa: E501


@pytest.mark.sample(2)
@pytest.mark.parametrize("stem", ["th", "phi", "theta_", "q"])
@pytest.mark.parametrize(
    ("once", "twice"),
    [("d", "dd"), ("_dot", "_ddot"), ("dot", "ddot"), ("_vel", "_acc"), ("Dot", "DDot")],
)
def test_rates_follow_their_coordinate(stem: str, once: str, twice: str) -> None:
    found = mechanics.check(DOUBLE.scene(), ROWS.format(stem, once, twice))
    assert [entry.finding.shown for entry in found.judged] == [True, True]


@pytest.mark.campaign
def test_rates_of_a_name_that_is_given() -> None:
    text = ROWS.format("a", "d", "dd").replace("a1", "b").replace("a2", "c")
    found = mechanics.check(DOUBLE.scene(), text, names={"b": "phi1", "c": "phi2"})
    assert found.ok
    wrong = mechanics.check(DOUBLE.scene(), text, names={"b": "phi2", "c": "phi1"})
    assert wrong.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("thdd", ("th", 2)), ("th1_ddot", ("th1", 2)), ("dtheta", ("theta", 1)), ("d2x", ("x", 2)),
        ("x_dot", ("x", 1)), ("theta1acc", ("theta1", 2)), ("x_vel", ("x", 1)),
        ("thetaDot", ("theta", 1)), ("x1DDot", ("x1", 2)), ("phiDdot", ("phi", 2)),
        ("thAcc", ("th", 2)), ("theta_acc1", ("theta1", 2)),
    ],
)  # fmt: skip
def test_bases(name: str, found: tuple[str, int]) -> None:
    assert found in set(bases(name))


def test_masses_are_no_family() -> None:
    assert families(["m", "md", "d", "theta_d"]) == {}
    assert families(["th", "thd", "thdd"]) == {"thd": "th", "thdd": "th"}
