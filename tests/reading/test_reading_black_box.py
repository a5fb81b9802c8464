"""Code that can only be called is SUPPORTED at most."""

import math
import re

import pytest

import mechanics
from mechanics import BlackBox
from mechanics.crosscheck.check import derived
from mechanics.errors import InputError
from systems import pendulum_chain

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


def test_what_is_inside_has_to_be_told() -> None:
    with pytest.raises(InputError, match=re.escape("what is g, l0, m0, m1 inside?")):
        mechanics.check(CART, BlackBox(simulator), names=NAMES | {"sign": "q0"})
    with pytest.raises(InputError, match="the scene has no parameter 'gravity'"):
        mechanics.check(CART, BlackBox(simulator, {"gravity": 9.8}), names=NAMES | {"sign": "q0"})
