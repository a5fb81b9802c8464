"""In which order code returns accelerations: by names, by dimensions, else the scene's."""

import numpy as np
import pytest
import sympy

import mechanics
from systems import acrobot, cartpole

CART = mechanics.derive(cartpole.scene(), "free_body")


def cart(y, F, mc, mp, l, g, sign=1):
    _, theta, _, theta_dot = y
    s, c = np.sin(theta), np.cos(theta)
    temp = (F + mp * l * theta_dot**2 * s) / (mc + mp)
    angular = (g * s - sign * c * temp) / (l * (4 / 3 - mp * c**2 / (mc + mp)))
    return angular, temp - mp * l * angular * c / (mc + mp)


def test_dimensions_tell_the_order() -> None:
    for sign, verdict in ((1, "PROVED"), (-1, "REFUTED")):

        def exchanged(y, F, mc, mp, l, g, sign=sign):
            one, other = cart(y, F, mc, mp, l, g, sign)
            return np.array([one + 0, other + 0])

        found = mechanics.check(CART, exchanged, blame=False)
        assert found.verdict.name == verdict
        assert [entry.statement.tag for entry in found.judged] == ["theta_ddot", "x_ddot"]

    def plain(y, F, mc, mp, l, g):
        one, other = cart(y, F, mc, mp, l, g)
        return np.array([other + 0, one + 0])

    assert mechanics.check(CART, plain, blame=False).verdict.name == "PROVED"


@pytest.mark.campaign
def test_equal_dimensions_without_names_are_in_the_order_of_the_scene() -> None:
    truth = mechanics.derive(acrobot.scene(), "free_body")
    one, other = truth.textbook.mass.LUsolve(truth.textbook.forcing)
    arguments = sorted(one.free_symbols | other.free_symbols, key=str)
    function = _function(arguments, (one, other))
    assert mechanics.check(truth, function, blame=False).verdict.name == "PROVED"
    exchanged = _function(arguments, (other, one))
    found = mechanics.check(truth, exchanged, blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert "about 'theta2_ddot theta1_ddot'" in found.judged[0].right_if[0]
    said = mechanics.check(truth, exchanged, blame=False, about="theta2_ddot theta1_ddot")
    assert said.verdict.name == "PROVED"
    wrong = _function(arguments, (other, 2 * one))
    assert mechanics.check(truth, wrong, blame=False).verdict.name == "REFUTED"


def _function(arguments, values):
    return sympy.lambdify(arguments, list(values), "math")
