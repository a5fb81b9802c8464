"""Sensitivity law: one flipped sign in a typed side turns its row REFUTED, with a witness.

Every term of every sum, however deep, and the leading sign of every side is flipped in turn. A flip
that the normal form shows to change nothing is left out: a constant under d/dt, or the whole left
side of an equation of motion ... = 0.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from sympy import Basic, Expr, ImmutableMatrix, sympify
from sympy.matrices import MatrixBase

import systems
from mechanics.checks.ledger import QUANTITIES, check_row, plain_side
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.routes.derivation import by_route
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.system import System
from mechanics.symbolic import canonical

ROWS = [
    pytest.param(system, row, id=f"{system.name}: {row.tag} {row.label}")
    for system in systems.ALL
    for row in system.published
    if isinstance(row.quantity, QUANTITIES)
]

WITH_ROWS = list(dict.fromkeys(parameter.values[0] for parameter in ROWS))


def flips(side: Any) -> Iterator[Any]:
    """Copies of a side with one sign flipped."""
    if isinstance(side, MatrixBase):
        for i, entry in enumerate(side):
            for flipped in flips(entry):
                entries = [*side[:i], flipped, *side[i + 1 :]]
                yield ImmutableMatrix(*side.shape, entries)
        return
    side = sympify(side)
    if side != 0:
        yield -side
    yield from inner_flips(side)


def inner_flips(expression: Basic) -> Iterator[Expr]:
    """Copies of an expression with one term of one sum in it flipped."""
    for i, part in enumerate(expression.args):
        before, after = expression.args[:i], expression.args[i + 1 :]
        if expression.is_Add:
            yield expression.func(*before, -part, *after)
        for flipped in inner_flips(part):
            yield expression.func(*before, flipped, *after)


def flipped_rows(row: Published) -> Iterator[Published]:
    """Copies of a row with one sign flipped."""
    for i, side in enumerate(row.sides):
        for flipped in flips(side):
            yield replace(row, sides=(*row.sides[:i], flipped, *row.sides[i + 1 :]))


def says_the_same(equations: Equations, row: Published, other: Published) -> bool:
    """Whether the flip changed nothing: equal sides, or an equation of motion times -1."""
    old, new = (
        [
            entry
            for side in r.sides
            for entry in entries(plain_side(equations.kinematics, side, r.tag))
        ]
        for r in (row, other)
    )
    if all(canonical(a - b) == 0 for a, b in zip(old, new, strict=True)):
        return True
    if not isinstance(row.quantity, EquationOfMotion):
        return False
    return canonical(old[0] - old[1] + new[0] - new[1]) == 0


def entries(side: Any) -> list[Expr]:
    return list(side) if isinstance(side, MatrixBase) else [side]


@cache
def derived_equations(system: System) -> Equations:
    return by_route("free_body", system.scene())


@pytest.mark.sample(3)
@pytest.mark.parametrize(("system", "row"), ROWS)
def test_one_flipped_sign_is_refuted(system: System, row: Published) -> None:
    equations = derived_equations(system)
    copies = list(flipped_rows(row))
    refuted = 0
    for other in copies:
        finding = check_row(equations.scene, other, equations)
        if finding.verdict is Verdict.REFUTED:
            assert finding.witness is not None
            refuted += 1
        else:
            assert says_the_same(equations, row, other), (other.sides, finding)
    assert refuted > 0


@pytest.mark.sample(3)
@pytest.mark.parametrize("system", WITH_ROWS, ids=lambda system: system.name)
def test_only_the_flipped_row_is_refuted(system: System) -> None:
    equations = derived_equations(system)
    rows = [row for row in system.published if isinstance(row.quantity, QUANTITIES)]
    place = len(rows) // 2
    *_, flipped = flipped_rows(rows[place])
    every = [*rows[:place], flipped, *rows[place + 1 :]]
    findings = [check_row(equations.scene, row, equations) for row in every]
    assert [i for i, finding in enumerate(findings) if not finding.shown] == [place]
