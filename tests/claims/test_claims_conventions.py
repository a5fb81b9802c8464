"""Equations that are right under another convention, and only there."""

from dataclasses import replace

import pytest
from sympy import Eq

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.claims.conventions import conventions
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.scene import Gravity
from mechanics.scene.symbols import plain_symbol
from systems import (
    acrobot,
    double_pendulum,
    elastic_pendulum,
    pendulum_chain,
)

PENDULUM = derived(elastic_pendulum.scene())
CART = derived(pendulum_chain.scene(1))
CLOCKWISE = (
    "(m0 + m1)*q0'' + m1*l0*(q1''*cos(q1) - q1'^2*sin(q1)) = F\n"
    "l0*q1'' + q0''*cos(q1) - g*sin(q1) = 0"
)


def about_the_pivot(inertia: str, arm: str) -> str:
    return f"M*{arm}*x''*cos(theta) + M*{inertia}*theta'' + M*g*{arm}*sin(theta) = 0"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("scene", "text", "words", "declared"),
    [
        (CART, CLOCKWISE, "q1 is counted the other way round", "other sign of angles"),
        (
            PENDULUM, about_the_pivot("4*L^2/3", "L"), "L is half of the scene's L", "half-length",
        ),
        (
            PENDULUM, about_the_pivot("L^2/4", "L/2"), "every rod is a point mass", "point mass",
        ),
        (
            PENDULUM, about_the_pivot("L^2/3", "L/2").replace("+ M*g", "- M*g").replace(
                "x''", "(-x'')"
            ),
            "theta is counted from the other vertical", "other vertical",
        ),
    ],
)  # fmt: skip
def test_right_if(scene, text: str, words: str, declared: str) -> None:
    found = mechanics.check(scene, text)
    assert {entry.finding.verdict.name for entry in found.judged} == {"REFUTED"}
    assert all(words in entry.right_if[0] for entry in found.judged)
    assert mechanics.check(scene, text, convention=declared).ok
    assert not mechanics.check(scene, text, convention="other sign of displacements").ok


def test_no_convention_helps_what_is_wrong() -> None:
    for text in (
        about_the_pivot("L^2/5", "L/2"),
        about_the_pivot("L^2/3", "L/2").replace("sin", "cos"),
        CLOCKWISE.replace("F", "2*F"),
    ):
        found = mechanics.check(CART if "m0" in text else PENDULUM, text)
        assert {entry.finding.verdict.name for entry in found.judged} == {"REFUTED"}
        assert all(entry.right_if == () for entry in found.judged)


def test_a_change_of_one_equation_alone_is_none() -> None:
    """The second row counts the angle clockwise, the first counterclockwise."""
    first, second = CLOCKWISE.split("\n")
    right = first.replace("(q1''*cos(q1) - q1'^2*sin(q1))", "(-q1''*cos(q1) + q1'^2*sin(q1))")
    found = mechanics.check(CART, f"{right}\n{second}")
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "REFUTED"]
    assert all(entry.right_if == () for entry in found.judged)


@pytest.mark.parametrize(
    ("system", "sign", "declared", "words"),
    [
        (double_pendulum, 1, "relative angles", "counted from the link before"),
        (acrobot, -1, "absolute angles", "counted from the fixed direction"),
    ],
)
def test_joint_angles(system, sign: int, declared: str, words: str) -> None:
    """The second angle is the scene's, less or more by the first one."""
    truth = derived(system.scene())
    one, two = truth.scene.coordinates
    counted = {
        plain_symbol(two, k): plain_symbol(two, k) + sign * plain_symbol(one, k) for k in range(3)
    }
    rows = [Eq(row.value.xreplace(counted), 0) for row in Derivation(truth).generalized_rows]
    found = mechanics.check(truth, rows, blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["REFUTED"] * 2
    assert all(len(e.right_if) == 1 and words in e.right_if[0] for e in found.judged)
    assert mechanics.check(truth, rows, convention=declared).ok


def test_the_simplest_changes_are_told_alone() -> None:
    """The other vertical helps, and so would it with all else that does not matter."""
    text = "M*L^2/3*theta'' - M*L/2*x''*cos(theta) - M*g*L/2*sin(theta) = 0"
    (entry,) = mechanics.check(PENDULUM, text).judged
    changes = [frozenset(words.split(" and ")) for words in entry.right_if]
    assert changes
    assert not any(one < other for one in changes for other in changes)


def test_what_is_wrong_under_a_declared_convention_is_searched_under_it() -> None:
    text = about_the_pivot("L^2/5", "L/2")
    (entry,) = mechanics.check(PENDULUM, text, convention="other vertical").judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.blame is not None
    for repair in entry.blame.repairs:
        assert mechanics.check(PENDULUM, repair.repaired, convention="other vertical").ok
    assert entry.blame.repairs


def test_an_unknown_convention_is_refused() -> None:
    with pytest.raises(InputError, match="the conventions are other vertical, other sign"):
        mechanics.check(CART, CLOCKWISE, convention="upside down")


def test_a_scene_without_gravity_has_no_vertical() -> None:
    heavy = PENDULUM.scene
    light = replace(heavy, loads=tuple(o for o in heavy.loads if not isinstance(o, Gravity)))
    words = {change[0].words for change in conventions(light) if change[0].name == "other vertical"}
    assert words == {"theta is counted from the opposite direction"}
