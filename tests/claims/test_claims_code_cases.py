"""Code with cases that random states hardly ever enter: each is judged where it holds."""

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from sympy import Abs, symbols

import mechanics
from mechanics.judge.cases import _alternatives
from mechanics.kernel import Finding
from systems import rod_pendulum

SCENE = rod_pendulum.scene()


def right(theta, u, m, l, g):
    return 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)


def otherwise(theta, u, m, l, g):
    return right(theta, u, m, l, g) if theta <= 1000 else 0 * u


def far_away(theta, u, m, l, g):
    if u > 10**6 and theta < -(10**6):
        return 2 * right(theta, u, m, l, g)
    return right(theta, u, m, l, g)


def second(theta, theta_dot, u, m, l, g):
    if theta_dot > 60:
        return right(theta, u, m, l, g)
    if u > 5000:
        return right(theta, u, m, l, g) + theta_dot
    return right(theta, u, m, l, g)


def judged(function: Callable) -> Finding:
    (entry,) = mechanics.check(SCENE, function, blame=False).judged
    return entry.finding


def state_of(finding: Finding) -> dict[str, Fraction]:
    assert finding.witness is not None
    return {name: Fraction(value) for name, value in finding.witness.state}


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("function", "words", "inside"),
    [
        (otherwise, "where theta > 1000", lambda s: s["theta"] > 1000),
        (far_away, "where u > 1000000 and theta < -1000000",
         lambda s: s["u"] > 10**6 and s["theta"] < -(10**6)),
        (second, "where theta_dot <= 60 and u > 5000",
         lambda s: s["theta_dot"] <= 60 and s["u"] > 5000),
    ],
)  # fmt: skip
def test_a_wrong_case_is_refuted_at_a_state_that_enters_it(
    function: Callable, words: str, inside: Callable[[dict[str, Fraction]], bool]
) -> None:
    finding = judged(function)
    assert finding.verdict.name == "REFUTED"
    assert finding.evidence.endswith(words)
    assert inside(state_of(finding))


@pytest.mark.parametrize("function", [otherwise, far_away])
def test_the_witness_is_a_state_of_the_scene(function: Callable) -> None:
    finding = judged(function)
    held = {"theta", "theta_dot", "u", "m", "l", "g"}
    assert {"theta", "u", "m", "l", "g"} <= state_of(finding).keys() <= held
    assert finding.witness is not None
    assert not dict(finding.witness.solved).keys() & held


def within(theta, theta_dot, u, m, l, g):
    return 0 * u if 50 < theta_dot < 60 else right(theta, u, m, l, g)


def clipped(theta, u, m, l, g):
    return right(np.clip(theta, -100, 100), u, m, l, g)


def dead_zone(theta, u, m, l, g):
    return right(theta, u if abs(u) > 50 else 0 * u, m, l, g)


def or_far(theta, theta_dot, u, m, l, g):
    far = theta_dot < -70 or theta > 80
    return 0 * u if far else right(theta, u, m, l, g)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("function", "inside"),
    [
        (within, lambda s: 50 < s["theta_dot"] < 60),
        (clipped, lambda s: abs(s["theta"]) > 100),
        (dead_zone, lambda s: abs(s["u"]) < 50),
        (or_far, lambda s: s.get("theta_dot", 0) < -70 or s["theta"] > 80),
    ],
)
def test_states_between_two_boundaries_and_beyond_either_are_met(
    function: Callable, inside: Callable[[dict[str, Fraction]], bool]
) -> None:
    finding = judged(function)
    assert finding.verdict.name == "REFUTED"
    assert inside(state_of(finding))


def test_a_case_that_no_state_meets_is_left_out() -> None:
    def never(theta, u, m, l, g):
        if u > 100 and u < 50:
            return 0 * u
        return right(theta, u, m, l, g) + (abs(u) - u if u > 7 else 0)

    assert judged(never).shown


def test_a_case_at_one_state_alone_is_in_doubt() -> None:
    def at_zero(theta, u, m, l, g):
        return 0 * u if theta == 0 else right(theta, u, m, l, g)

    found = judged(at_zero)
    assert found.verdict.name == "UNDECIDED"
    assert found.evidence.endswith("not shown where theta = 0")


def test_a_limit_that_is_right_is_shown() -> None:
    def without_torque(theta, u, m, l, g):
        return 3 * g / (2 * l) * np.sin(theta) if u == 0 else right(theta, u, m, l, g)

    assert judged(without_torque).shown


def otherwise_written(theta, u, m, l, g):
    return 3 * g / l * np.sin(theta / 2) * np.cos(theta / 2) + 3 * u / (m * l**2)


CONDITIONS = [
    lambda theta, u, m, l, g: np.sin(theta) > 0.999,
    lambda theta, u, m, l, g: theta * u > 5000,
    lambda theta, u, m, l, g: u / (m * l) > 300 * g,
    lambda theta, u, m, l, g: m * g * l * np.cos(theta) < -0.999 * m * g * l,
]


@pytest.mark.sample(2)
@pytest.mark.parametrize("condition", CONDITIONS)
def test_conditions_of_all_kinds(condition: Callable) -> None:
    def both(theta, u, m, l, g):
        if condition(theta, u, m, l, g):
            return otherwise_written(theta, u, m, l, g)
        return right(theta, u, m, l, g)

    def wrong(theta, u, m, l, g):
        if condition(theta, u, m, l, g):
            return otherwise_written(theta, u, m, l, g) * (1 + 1e-6)
        return right(theta, u, m, l, g)

    assert judged(both).shown
    found = judged(wrong)
    assert found.verdict.name == "REFUTED"
    state = {n: float(v) for n, v in state_of(found).items() if n != "theta_dot"}
    assert condition(**state)


def test_selections() -> None:
    def selected(theta, theta_dot, u, m, l, g):
        sign = np.select([theta_dot > 0, theta_dot < 0], [1.0, -1.0], default=1.0)
        return right(theta, u, m, l, g) * sign * np.where(theta_dot < 0, -1, 1)

    assert judged(selected).shown


def test_cases_that_are_all_right_are_shown() -> None:
    def both(theta, u, m, l, g):
        if theta > 1000:
            return right(theta, u, m, l, g) + (theta - 1000 - abs(theta - 1000))
        return right(theta, u, m, l, g) + (theta - 1000 + abs(theta - 1000))

    assert judged(both).shown


def test_moduli_are_split_in_the_order_of_their_names() -> None:
    """A set of them has another order in every run."""
    for k in range(12):
        one, other = symbols(f"a{k} b{k}", real=True)
        first = _alternatives(Abs(one) + Abs(other) > 1)[0]
        assert first[0] == (one >= 0)


def test_a_single_state_is_judged_alike_however_it_is_told_apart() -> None:
    def by_branch(theta, u, m, l, g):
        return 7.0 if theta == 0.3 else right(theta, u, m, l, g)

    def by_selection(theta, u, m, l, g):
        return np.where(theta == 0.3, 7.0, right(theta, u, m, l, g))

    found = [mechanics.check(SCENE, f, blame=False) for f in (by_branch, by_selection)]
    findings = [check.judged[0].finding for check in found]
    assert findings[0].verdict is findings[1].verdict
    assert not findings[0].shown
    assert all("where theta = 3/10" in finding.evidence for finding in findings)
