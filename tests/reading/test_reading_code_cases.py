"""Code with cases that random states hardly ever enter: each is judged where it holds."""

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

import mechanics
from mechanics.exact import Finding
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


def test_cases_that_are_not_entered_by_one_boundary_each_are_in_doubt() -> None:
    def within(theta, theta_dot, u, m, l, g):
        return 0 * u if 50 < theta_dot < 60 else right(theta, u, m, l, g)

    assert judged(within).verdict.name == "UNDECIDED"


def test_a_case_at_one_state_alone_is_in_doubt() -> None:
    def at_zero(theta, u, m, l, g):
        return 0 * u if theta == 0 else right(theta, u, m, l, g)

    assert judged(at_zero).verdict.name == "UNDECIDED"


def test_cases_that_are_all_right_are_shown() -> None:
    def both(theta, u, m, l, g):
        if theta > 1000:
            return right(theta, u, m, l, g) + (theta - 1000 - abs(theta - 1000))
        return right(theta, u, m, l, g) + (theta - 1000 + abs(theta - 1000))

    assert judged(both).shown
