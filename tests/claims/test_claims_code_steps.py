"""Code that returns the next state: the integrator is named, the accelerations are judged."""

from functools import partial

import numpy as np
import pytest

import mechanics
from mechanics.errors import InputError
from systems import cartpole, rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
CART = mechanics.derive(cartpole.scene(), "free_body")


def acceleration(theta, u, m, l, g, sign=1, share=2):
    return sign * 3 * g / (share * l) * np.sin(theta) + 3 / (m * l**2) * u


def explicit(state, u, dt, m, l, g, sign=1, share=2):
    th, thdot = state
    return np.array([th + dt * thdot, thdot + dt * acceleration(th, u, m, l, g, sign, share)])


def semi_implicit(theta, theta_dot, u, dt, m, l, g, sign=1, share=2):
    theta_dot = theta_dot + dt * acceleration(theta, u, m, l, g, sign, share)
    theta = theta + dt * theta_dot
    return theta, theta_dot


def coordinates_first(state, u, dt, m, l, g, sign=1, share=2):
    th, thdot = state
    th = th + dt * thdot
    return th, thdot + dt * acceleration(th, u, m, l, g, sign, share)


def constant(state, u, h, m, l, g, sign=1, share=2):
    th, thdot = state
    a = acceleration(th, u, m, l, g, sign, share)
    return th + h * thdot + 0.5 * a * h**2, thdot + h * a


def rk4(state, u, dt, m, l, g, sign=1, share=2):
    def f(y):
        return np.array([y[1], acceleration(y[0], u, m, l, g, sign, share)])

    y = np.array(state)
    k1 = f(y)
    k2 = f(y + dt / 2 * k1)
    k3 = f(y + dt / 2 * k2)
    k4 = f(y + dt * k3)
    return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def heun(state, u, dt, m, l, g, sign=1, share=2):
    th, w = state
    a = acceleration(th, u, m, l, g, sign, share)
    b = acceleration(th + dt * w, u, m, l, g, sign, share)
    return th + dt * (w + w + dt * a) / 2, w + dt / 2 * (a + b)


def verlet(state, u, dt, m, l, g, sign=1, share=2):
    th, w = state
    a = acceleration(th, u, m, l, g, sign, share)
    after = th + dt * w + dt**2 / 2 * a
    return after, w + dt / 2 * (a + acceleration(after, u, m, l, g, sign, share))


STEPS = (
    (explicit, "explicit Euler"),
    (semi_implicit, "semi-implicit Euler"),
    (coordinates_first, "semi-implicit Euler, coordinates first"),
    (constant, "constant acceleration"),
    (verlet, "velocity Verlet"),
    (heun, "Heun's method"),
    (rk4, "RK4"),
)


@pytest.mark.parametrize(("step", "name"), STEPS)
def test_a_step_is_named_and_its_accelerations_are_judged(step, name) -> None:
    right = mechanics.check(ROD, step, blame=False)
    assert right.verdict.name == "PROVED"
    assert f"a step of {name}" in [entry.statement.tag for entry in right.judged]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("step", "name"), STEPS)
def test_a_wrong_sign_or_factor_is_refuted(step, name) -> None:
    for wrong in ({"sign": -1}, {"share": 3}):
        found = mechanics.check(ROD, partial(step, **wrong), blame=False)
        # theta counted from the bottom would turn the sign of gravity, and nothing the factor.
        assert found.verdict.name == ("REFUTED" if "share" in wrong else "UNDECIDED")
        assert [e.statement.tag for e in found.judged if not e.finding.shown] == ["theta_ddot"]


def test_a_step_of_no_integrator_that_is_known_is_never_proved() -> None:
    def twice(state, u, dt, m, l, g):
        th, w = state
        return th + 2 * dt * w, w + dt * acceleration(th, u, m, l, g)

    assert mechanics.check(ROD, twice, blame=False).verdict.name == "REFUTED"

    def minus(state, u, dt, m, l, g):
        th, w = state
        a = acceleration(th, u, m, l, g)
        return th + dt * (w - dt * a), w + dt * a

    with pytest.raises(InputError, match="explicit Euler"):
        mechanics.check(ROD, minus, blame=False)

    def elsewhere(state, u, dt, m, l, g):
        th, w = state
        return w + dt * w, w + dt * acceleration(th, u, m, l, g)

    with pytest.raises(InputError, match="no state after a step"):
        mechanics.check(ROD, elsewhere, blame=False)


@pytest.mark.sample(3)
@pytest.mark.parametrize(("step", "name"), STEPS)
def test_a_step_may_limit_its_input(step, name) -> None:
    def limited(state, u, dt, m, l, g, **changed):
        return (step(*state, np.clip(u, -2, 2), dt, m, l, g, **changed) if step is semi_implicit
                else step(state, np.clip(u, -2, 2), dt, m, l, g, **changed))  # fmt: skip

    right = mechanics.check(ROD, limited, blame=False)
    assert right.ok
    assert f"a step of {name}" in [entry.statement.tag for entry in right.judged]
    assert "limited to +-2" in str(right)
    wrong = mechanics.check(ROD, partial(limited, share=3), blame=False)
    assert wrong.verdict.name == "REFUTED"


def test_a_limit_of_one_part_is_no_step_of_an_integrator() -> None:
    def where_weak(state, u, dt, m, l, g):
        th, w = state
        after = w + dt * acceleration(th, np.clip(u, -2, 2), m, l, g)
        return th + dt * (after if u < 1 else w), after

    assert mechanics.check(ROD, where_weak, blame=False).verdict.name == "REFUTED"

    def fastest(state, u, dt, m, l, g):
        th, w = state
        w = np.clip(w + dt * acceleration(th, u, m, l, g), -8, 8)
        return th + dt * w, w

    with pytest.raises(InputError, match="no state after a step"):
        mechanics.check(ROD, fastest, blame=False)


C = """
#include <math.h>
void step(double state[2], double u, double dt, double m, double l, double g, double next[2])
{
    next[1] = state[1] + dt*(3*g/(2*l)*sin(state[0]) + 3/(m*l*l)*u);
    next[0] = state[0] + dt*next[1];
}
"""


def test_c() -> None:
    found = mechanics.check(ROD, C.replace("double state", "const double state"), notation="c")
    assert found.verdict.name == "PROVED"
    assert found.judged[-1].statement.tag == "a step of semi-implicit Euler"
    wrong = C.replace("double state", "const double state").replace("3*g/(2*l)", "3*g/l")
    assert mechanics.check(ROD, wrong, notation="c", blame=False).verdict.name == "REFUTED"


def cart(state, F, dt, mc, mp, l, g):
    x, x_dot, theta, theta_dot = state
    s, c = np.sin(theta), np.cos(theta)
    temp = (F + mp * l * theta_dot**2 * s) / (mc + mp)
    thetaacc = (g * s - c * temp) / (l * (4.0 / 3.0 - mp * c**2 / (mc + mp)))
    xacc = temp - mp * l * thetaacc * c / (mc + mp)
    x_dot = x_dot + dt * xacc
    theta_dot = theta_dot + dt * thetaacc
    return x + dt * x_dot, x_dot, theta + dt * theta_dot, theta_dot


def test_a_cart_pole_semi_implicitly() -> None:
    found = mechanics.check(CART, cart, blame=False)
    assert found.verdict.name == "PROVED"
    assert found.judged[-1].statement.tag == "a step of semi-implicit Euler"


@pytest.mark.campaign
def test_a_cart_pole_by_rk4() -> None:
    for sign, verdict in ((1, "PROVED"), (-1, "REFUTED")):

        def step(y, F, dt, mc, mp, l, g, sign=sign):
            def f(y):
                _, x_dot, theta, theta_dot = y
                s, c = np.sin(theta), np.cos(theta)
                temp = (F + mp * l * theta_dot**2 * s) / (mc + mp)
                thetaacc = (g * s - sign * c * temp) / (l * (4 / 3 - mp * c**2 / (mc + mp)))
                return np.array(
                    [x_dot, temp - mp * l * thetaacc * c / (mc + mp), theta_dot, thetaacc]
                )

            y = np.array(y)
            k1 = f(y)
            k2 = f(y + dt / 2 * k1)
            k3 = f(y + dt / 2 * k2)
            k4 = f(y + dt * k3)
            return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

        names = {"y": "x x_dot theta theta_dot"}
        found = mechanics.check(CART, step, names=names, blame=False)
        assert found.verdict.name == verdict
        assert found.judged[-1].statement.tag == "a step of RK4"
