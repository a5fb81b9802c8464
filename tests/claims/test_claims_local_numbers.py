"""Numbers that a Python function gives to names of the scene inside of it."""

import numpy as np
import pytest

import mechanics
from systems import rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
HALF = 2


def inside(theta, u):
    LENGTH = 0.4
    l = LENGTH / HALF
    m, g = 1.0, 9.81  # assigned side by side: numbers
    g = 9.81
    return 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)


def plain(theta, u):
    m = 0.5
    g = 9.81
    l = 2 * 0.3
    return 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)


def wrong(theta, u):
    m = 0.5
    g = 9.81
    l = 2 * 0.3
    return 3 * g / l * np.sin(theta) + 3 * u / (m * l**2)


def changed(theta, u):
    l = 0.3
    l = l + theta
    return l


class Rod:
    def rate(self, theta, u):
        m = 0.5
        g = 9.81
        l = 0.3
        return 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)


def around(scale):
    def rate(theta, u):
        m = 0.5
        g = 9.81
        l = 0.3
        return scale * 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)

    return rate


@pytest.mark.parametrize("function", [plain, Rod().rate, around(1)])
def test_they_stand_for_all_values(function) -> None:
    before = function(0.3, 0.2)
    found = mechanics.check(ROD, function)
    assert found.verdict.name == "PROVED"
    assert any("l = " in str(remark) for remark in found.remarks)
    assert function(0.3, 0.2) == before


@pytest.mark.parametrize("function", [wrong, around(2)])
def test_a_wrong_formula_is_refuted(function) -> None:
    assert mechanics.check(ROD, function).verdict.name == "REFUTED"


@pytest.mark.parametrize("function", [inside, changed])
def test_what_is_assigned_twice_is_no_parameter(function) -> None:
    assert mechanics.check(ROD, function, blame=False).verdict.name != "PROVED"


def test_casadi_by_its_functions_names() -> None:
    space: dict = {}
    exec(
        "from casadi import sin, vertcat\n"
        "def rate(x, u, l, g, m):\n"
        "    return vertcat(x[1], 3*g/(2*l)*sin(x[0]) + 3*u/(m*l**2))\n",
        space,
    )
    assert mechanics.check(ROD, space["rate"]).verdict.name == "PROVED"


def test_accelerations_named_by_a_letter_before() -> None:
    def rate(theta, u, m, g, l):
        atheta = 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)
        return atheta

    (entry,) = mechanics.check(ROD, rate).judged
    assert entry.statement.tag == "theta_ddot"
    assert entry.finding.shown
