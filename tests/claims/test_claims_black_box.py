"""Code that can only be called is SUPPORTED at most."""

import math
import re

import pytest
from sympy import Symbol, lambdify, solve

import mechanics
from mechanics import BlackBox
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import elastic_pendulum, pendulum_chain, rocker

CART = derived(pendulum_chain.scene(1))
VALUES = {"m0": 2.0, "m1": 0.5, "l0": 0.7, "g": 9.8}
NAMES = {"state": "q0 q0_dot q1 q1_dot", "force": "F"}


def simulator(state, force, sign=1.0):
    """Numbers only: a text hides what it computes."""
    _, x_dot, angle, rate = (float(str(entry)) for entry in state)
    m0, m1, l, g = VALUES.values()
    c, s = math.cos(angle), math.sin(angle)
    pull = force - sign * m1 * l * rate**2 * s
    turn = ((m0 + m1) * g * s + c * pull) / (l * (m0 + m1 * s**2))
    return [x_dot, (force + m1 * l * (turn * c - rate**2 * s)) / (m0 + m1), rate, turn]


def test_a_box_that_agrees_is_supported_and_no_more() -> None:
    def box(state, force):
        return simulator(state, force)

    found = mechanics.check(CART, BlackBox(box, VALUES), names=NAMES)
    assert [entry.finding.verdict.name for entry in found.judged] == ["SUPPORTED"] * 4
    assert not found.ok


def test_a_box_that_is_wrong_is_refuted_at_a_state() -> None:
    def box(state, force):
        return simulator(state, force, sign=-1.0)

    found = mechanics.check(CART, BlackBox(box, VALUES), names=NAMES)
    verdicts = [entry.finding.verdict.name for entry in found.judged]
    assert verdicts == ["SUPPORTED", "REFUTED", "SUPPORTED", "REFUTED"]
    witness = found.judged[1].finding.witness
    assert witness is not None
    assert {"q1", "q1_dot", "F"} <= dict(witness.state).keys()


def test_between_rounding_and_an_error_nothing_is_said() -> None:
    def box(state, force):
        return [rate * (1 + 1e-7) for rate in simulator(state, force)]

    found = mechanics.check(CART, BlackBox(box, VALUES), names=NAMES)
    assert [entry.finding.verdict.name for entry in found.judged] == ["UNDECIDED"] * 4
    assert all("more than rounding" in entry.finding.evidence for entry in found.judged)


def test_what_is_inside_has_to_be_told() -> None:
    with pytest.raises(InputError, match=re.escape("what is g, l0, m0, m1 inside?")):
        mechanics.check(CART, BlackBox(simulator), names=NAMES | {"sign": "q0"})
    with pytest.raises(InputError, match="the scene has no parameter 'gravity'"):
        mechanics.check(CART, BlackBox(simulator, {"gravity": 9.8}), names=NAMES | {"sign": "q0"})


def test_what_a_box_raises_is_one_line() -> None:
    def broken(state, force):
        return [state[0], {}["mass"]]

    with pytest.raises(InputError, match=r"^black box broken: KeyError: 'mass'$"):
        mechanics.check(CART, BlackBox(broken, VALUES), names=NAMES)

    def nowhere(state, force):
        raise ValueError("out of bounds")

    with pytest.raises(InputError, match="black box nowhere: it fails at each of 200 states"):
        mechanics.check(CART, BlackBox(nowhere, VALUES), names=NAMES)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"step": -1.0}, "the step -1.0 s is no time"),
        ({"step": math.nan}, "is no time"),
        ({"integrator": "leapfrog"}, "it can be euler, semi-implicit euler, rk4"),
    ],
)
def test_a_step_is_a_time_and_its_integrator_is_known(options: dict, words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        BlackBox(simulator, VALUES, **options)


def test_a_step_returns_a_state() -> None:
    def half(state, force):
        return simulator(state, force)[1::2]

    with pytest.raises(InputError, match="as many numbers as its argument for the state has, 4; 2"):
        mechanics.check(CART, BlackBox(half, VALUES, step=0.01), names=NAMES)


def test_definitions_of_the_scene_have_their_values() -> None:
    pendulum = derived(elastic_pendulum.scene())

    def rate(q, u, M, m, L, k, g):
        c, s = math.cos(float(q[1])), math.sin(float(q[1]))
        first = M * L / 2 * float(u[1]) ** 2 * s - 2 * k * float(q[0])
        second = -M * g * L / 2 * s
        det = (M + m) * M * L**2 / 3 - (M * L / 2 * c) ** 2
        both = M * L**2 / 3 * first - M * L / 2 * c * second
        return [both / det, ((M + m) * second - M * L / 2 * c * first) / det]

    found = mechanics.check(pendulum, [BlackBox(rate), "x'' = 0"], blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == [
        "REFUTED", "SUPPORTED", "SUPPORTED",
    ]  # fmt: skip


@pytest.mark.campaign
def test_a_density_that_stands_in_a_definition_only_has_a_value_too() -> None:
    truth = derived(rocker.scene())
    (theta_ddot,) = truth.scene.ud
    (solution,) = solve(truth.residual, [theta_ddot]).values()
    names = [*truth.scene.q, *truth.scene.u, *truth.scene.input_symbols, *truth.scene.parameters]
    assert Symbol("rho", real=True, positive=True) not in names
    box = lambdify(names, [solution], "math")
    found = mechanics.check(truth, BlackBox(box))
    assert [entry.finding.verdict.name for entry in found.judged] == ["SUPPORTED"]
