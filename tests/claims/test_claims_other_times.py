"""A function of time is the scene's at the time t only, and where the scene's depends on time."""

import pytest
from sympy import Eq, Function, Symbol, sin, symbols

import mechanics
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
t, g, l, m = symbols("t g l m")
theta, u = Function("theta"), Function("u")


def law(angle, force, length=l):
    return Eq(theta(t).diff(t, 2), 3 * g / (2 * length) * sin(angle) + 3 * force / (m * length**2))


def verdict(equation):
    return mechanics.check(ROD, equation, blame=False).judged[0]


def test_at_the_time_it_is_read() -> None:
    assert verdict(law(theta(t), u(t))).verdict.name == "PROVED"
    positive = Symbol("t", positive=True)
    assert verdict(law(theta(t), Function("F")(positive))).verdict.name == "PROVED"


@pytest.mark.parametrize("when", [t - 1, 0, 2 * t, -t, theta(t), Symbol("s")])
@pytest.mark.parametrize("name", ["u", "F"])
def test_an_input_at_another_time_is_not_read(name: str, when) -> None:
    force = Function(name)(when)
    entry = verdict(law(theta(t), force))
    assert entry.verdict.name == "UNDECIDED"
    assert f"{force} is not at the time t" in entry.statement.doubt


@pytest.mark.parametrize("when", [t - 1, 0])
def test_a_coordinate_at_another_time_is_not_read(when) -> None:
    V = m * g * l / 2 * sin(theta(when) + 1)
    (entry,) = mechanics.check(ROD, V, about="potential energy", blame=False).judged
    assert entry.verdict.name == "UNDECIDED"
    assert "is not at the time t" in entry.statement.doubt


def test_a_constant_of_the_scene_is_no_function_of_time() -> None:
    entry = verdict(law(theta(t), u(t), Function("l")(t)))
    assert entry.verdict.name == "UNDECIDED"
    assert "l of the scene is constant" in entry.statement.doubt
