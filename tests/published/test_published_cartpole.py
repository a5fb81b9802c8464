"""Cart-poles of Gymnasium, SharpNEAT, pybrain, and Barto, Sutton and Anderson (1983)."""

from collections.abc import Callable

import numpy as np
import pytest

import mechanics

POINT = {"mc": 1, "mp": 0.1, "l": 0.5, "g": 9.8, "F": 10, "x": 0, "x_dot": 0,
         "theta": 0.2, "theta_dot": 1}  # fmt: skip
RIGHT = ("9.59844758931534", "-11.1902373594858")
STATE = {"state": "x x_dot theta theta_dot"}


def cart_pole(shape: float, squared: Callable, down: int = 1) -> Callable:
    """The formulas of `CartPole-v1`, with what others have in three places of them."""

    def accelerations(state, force, masscart, masspole, length, gravity):
        _, _, theta, theta_dot = state
        costheta, sintheta = np.cos(theta), np.sin(theta)
        total_mass = masspole + masscart
        polemass_length = masspole * length
        temp = (force + polemass_length * squared(theta, theta_dot) * sintheta) / total_mass
        thetaacc = (down * gravity * sintheta - costheta * temp) / (
            length * (shape - masspole * np.square(costheta) / total_mass)
        )
        xacc = temp - polemass_length * thetaacc * costheta / total_mass
        return np.array([xacc, thetaacc])

    return accelerations


def of_rate(theta, theta_dot):
    return np.square(theta_dot)


def of_angle(theta, theta_dot):
    return np.square(theta)


CASES = {
    "Gymnasium": (cart_pole(4.0 / 3.0, of_rate), RIGHT, "PROVED"),
    "SharpNEAT": (cart_pole(7.0 / 3.0, of_rate), (None, "-6.20796857779"), "REFUTED"),
    "pybrain": (cart_pole(4.0 / 3.0, of_angle), (None, "-11.1765996134"), "REFUTED"),
    "Barto": (cart_pole(4.0 / 3.0, of_rate, -1), ("9.8769", "-17.4404463445993"), "REFUTED"),
}


def values(function: Callable) -> np.ndarray:
    state = np.array([POINT[n] for n in ("x", "x_dot", "theta", "theta_dot")], dtype=float)
    return function(state, *(POINT[n] for n in ("F", "mc", "mp", "l", "g")))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", CASES)
def test_the_code_itself_gets_its_verdict(truth, assert_agree, name: str) -> None:
    function, printed, verdict = CASES[name]
    pairs = [(v, p) for v, p in zip(values(function), printed, strict=True) if p is not None]
    assert_agree([v for v, _ in pairs], tuple(p for _, p in pairs))
    found = mechanics.check(truth("cartpole"), function, names=STATE)
    assert [entry.finding.verdict.name for entry in found.judged] == [verdict] * 2
    meanings = {match.name: match.meaning for match in found.names}
    assert meanings == {
        **STATE, "force": "F", "masscart": "mc", "masspole": "mp", "length": "l", "gravity": "g",
    }  # fmt: skip
    if name == "Gymnasium":
        folded = found.judged[0].statement.notes
        assert folded == ("1.3333333333333333 is read as 4/3",)


def test_the_engine_gives_the_right_values(truth, assert_agree, accelerations) -> None:
    assert_agree(accelerations(truth("cartpole"), POINT), RIGHT)


TEXT = r"""
\begin{{align}}
\ddot\theta &= \frac{{{g} \sin\theta + \cos\theta \frac{{-F - m_p l {w} \sin\theta}}{{m_c + m_p}}}}
    {{l \left[ \frac{{{shape}}}{{3}} - \frac{{m_p \cos^2\theta}}{{m_c + m_p}} \right]}} \\
\ddot x &= \frac{{F + m_p l \left[ {w} \sin\theta - \ddot\theta \cos\theta \right]}}{{m_c + m_p}}
\end{{align}}"""


def written(g: str = "g", w: str = r"\dot\theta^2", shape: str = "4") -> str:
    return TEXT.format(g=g, w=w, shape=shape)


def test_florians_equations_are_proved(truth) -> None:
    found = mechanics.check(truth("cartpole"), written())
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]


def test_the_parallel_axis_counted_twice_is_named(truth, edits) -> None:
    first, second = mechanics.check(truth("cartpole"), written(shape="7")).judged
    assert edits(first) == [("FACTOR", "7", "4")]
    assert first.blame.explanations == ("parallel axis counted twice: pole",)
    assert second.finding.verdict.name == "PROVED"


def test_the_angle_squared_for_its_rate_is_named(truth, edits) -> None:
    for entry in mechanics.check(truth("cartpole"), written(w=r"\theta^2")).judged:
        ((mistake, wrong, right),) = edits(entry)
        assert mistake in ("SYMBOL", "TERM")
        assert wrong.startswith(r"\theta") and r"\dot" in right and r"\theta" in right


@pytest.mark.campaign
def test_gravity_of_1983_is_reversed_and_right_in_a_mirror(truth, edits) -> None:
    first, second = mechanics.check(truth("cartpole"), written(g="-g")).judged
    assert [mistake for mistake, _, _ in edits(first)] == ["SIGN"]
    assert "gravity reversed" in first.blame.explanations
    assert second.finding.verdict.name == "PROVED"
    assert (
        "theta is counted from the other vertical and x is counted the other way and F is counted"
        " the other way"
    ) in first.right_if


def test_it_is_right_where_that_convention_is_declared(truth) -> None:
    declared = ("other vertical", "other sign of displacements", "other sign of inputs")
    found = mechanics.check(truth("cartpole"), written(g="-g"), convention=declared)
    assert found.ok and len(found.judged) == 2
