"""Which change of convention makes statements right, where bodies are taken for point masses."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
from sympy import Eq, Expr, Matrix, pi

import mechanics
from mechanics.claims.convention import POINT_MASS
from mechanics.equations import Equations
from mechanics.judge import other_conventions as module
from mechanics.judge.check import derived
from mechanics.judge.other_conventions import targets_of
from systems import cartpole, double_pendulum, elastic_pendulum_ledger, rod_pendulum, rolling_disc

WITH_RODS = {"cartpole": cartpole, "rod_pendulum": rod_pendulum}
Said = Callable[[Equations], Expr | Matrix]


@cache
def truth(name: str) -> Equations:
    return derived(WITH_RODS[name].scene())


@cache
def lighter(name: str) -> Equations:
    """Equations of the same scene with point masses."""
    (found,) = targets_of(truth(name), [(POINT_MASS,)])
    assert found is not None
    return found


SAID: dict[str, tuple[Said, str]] = {
    "kinetic energy": (lambda e: e.kinematics.kinetic_energy, "kinetic energy"),
    "mass matrix": (lambda e: e.kinematics.mass_matrix, "mass matrix"),
    "equation of motion": (lambda e: Eq(e.residual[-1], 0, evaluate=False), ""),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("about", SAID)
@pytest.mark.parametrize("name", WITH_RODS)
def test_point_masses_are_told_where_they_make_it_right(name: str, about: str) -> None:
    said, words = SAID[about]
    found = mechanics.check(truth(name), said(lighter(name)), about=words or None, blame=False)
    assert found.verdict.name == "REFUTED"
    assert all(entry.right_if[0] == POINT_MASS.words for entry in found.judged)


@pytest.mark.parametrize("about", SAID)
def test_they_are_not_told_where_more_is_wrong(about: str) -> None:
    said, words = SAID[about]
    right = said(lighter("rod_pendulum"))
    wrong = Eq(right.lhs + right.lhs.args[0] / 7, 0) if isinstance(right, Eq) else right * 8 / 7
    found = mechanics.check(truth("rod_pendulum"), wrong, about=words or None, blame=False)
    assert [entry.right_if for entry in found.judged] == [()]


@pytest.mark.parametrize("system", [double_pendulum, rolling_disc], ids=["no rods", "in space"])
def test_scenes_without_such_bodies_have_no_point_masses(system) -> None:
    assert targets_of(derived(system.scene()), [(POINT_MASS,)]) == [None]


def test_simplest_change_is_told_without_more_besides() -> None:
    # A rod of no inertia that is seen from the other vertical, too.
    row = lighter("rod_pendulum").residual[0]
    (theta,) = truth("rod_pendulum").scene.q
    turned = Eq(row.xreplace({theta: theta + pi}), 0, evaluate=False)
    found = mechanics.check(truth("rod_pendulum"), turned, blame=False)
    (entry,) = found.judged
    assert any(POINT_MASS.words in words and "vertical" in words for words in entry.right_if)
    assert POINT_MASS.words not in entry.right_if


def test_a_line_that_stands_often_is_tried_once() -> None:
    """172 times the same line took 45 s of the processor; they take 3 s now."""
    rows = [replace(row, tag=tag) for tag in "abc" for row in elastic_pendulum_ledger.PUBLISHED[:4]]
    assert module._distinct(rows) == rows[:4]
