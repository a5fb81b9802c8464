"""The environments of the installed Gymnasium, called as they are: SUPPORTED at most.

A step is undone exactly as the environment does it: the mean rates over it are compared with those
of the engine's own equations, advanced by the same integrator.
"""

import gymnasium
import numpy as np
import pytest

import mechanics
from mechanics import BlackBox

CART = {"mc": 1.0, "mp": 0.1, "l": 0.5, "g": 9.8}
CART_NAMES = {"state": "x x_dot theta theta_dot", "force": "F"}
LINKS = {"m1": 1, "m2": 1, "l1": 1, "lc1": 0.5, "lc2": 0.5, "I1": 1, "I2": 1, "g": 9.8}
LINK_NAMES = {"state": "theta1 theta2 theta1_dot theta2_dot", "torque": "tau"}


def verdicts(scene, box: BlackBox, names: dict[str, str]) -> list[str]:
    found = mechanics.check(scene, box, names=names)
    assert not found.ok
    return [entry.finding.verdict.name for entry in found.judged]


def cart_pole(integrator: str):
    env = gymnasium.make("CartPole-v1").unwrapped
    env.kinematics_integrator = integrator

    def step(state, force):
        env.reset()
        env.state, env.force_mag = state, force
        env.step(1)
        return env.state

    return env, step


@pytest.mark.parametrize("integrator", ["euler", "semi-implicit euler"])
def test_the_cart_pole_is_supported(truth, integrator: str) -> None:
    env, step = cart_pole(integrator)
    box = BlackBox(step, CART, step=env.tau, integrator=integrator)
    assert verdicts(truth("cartpole"), box, CART_NAMES) == ["SUPPORTED"] * 4


@pytest.mark.campaign
def test_a_cart_pole_of_another_mass_or_integrator_is_refuted(truth) -> None:
    env, step = cart_pole("euler")
    heavier = BlackBox(step, CART | {"mp": 0.2}, step=env.tau)
    found = mechanics.check(truth("cartpole"), heavier, names=CART_NAMES)
    names = [entry.finding.verdict.name for entry in found.judged]
    assert names == ["SUPPORTED", "REFUTED", "SUPPORTED", "REFUTED"]
    assert all(e.finding.witness for e in found.judged if e.finding.verdict.name == "REFUTED")
    other = BlackBox(step, CART, step=env.tau, integrator="rk4")
    assert verdicts(truth("cartpole"), other, CART_NAMES) == ["REFUTED"] * 4


@pytest.mark.campaign
@pytest.mark.parametrize(("variant", "verdict"), [("book", "SUPPORTED"), ("nips", "REFUTED")])
def test_the_acrobot_is_supported_in_its_variant_of_the_book(truth, variant, verdict) -> None:
    env = gymnasium.make("Acrobot-v1").unwrapped
    env.book_or_nips = variant

    def step(state, torque):
        env.reset()
        env.state, env.AVAIL_TORQUE = state, [torque]
        env.step(0)
        return env.state

    box = BlackBox(step, LINKS, step=env.dt, integrator="rk4")
    assert verdicts(truth("acrobot"), box, LINK_NAMES) == [verdict] * 4


def test_the_pendulum_is_supported_for_all_its_parameters(truth) -> None:
    env = gymnasium.make("Pendulum-v1").unwrapped
    env.max_speed = np.inf

    def step(state, torque, m, l, g):
        env.reset()
        env.state, env.m, env.l, env.g = state, m, l, g
        env.step(np.array([torque]))
        return env.state

    box = BlackBox(step, step=env.dt, integrator="semi-implicit euler")
    names = {"state": "theta theta_dot", "torque": "u"}
    assert verdicts(truth("rod_pendulum"), box, names) == ["SUPPORTED"] * 2
