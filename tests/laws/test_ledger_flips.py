"""Sensitivity law: one flipped sign in a typed side turns its row REFUTED, with a witness.

Every term of every sum, however deep, and the leading sign of every side is flipped in turn. A flip
that the normal form shows to change nothing is left out: a constant under d/dt, or the whole left
side of an equation of motion ... = 0.
"""

from functools import cache
from typing import Any

import pytest
from sign_flips import flipped_rows
from sympy import Expr
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


@pytest.mark.sample(2)
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


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", WITH_ROWS, ids=lambda system: system.name)
def test_only_the_flipped_row_is_refuted(system: System) -> None:
    equations = derived_equations(system)
    rows = [row for row in system.published if isinstance(row.quantity, QUANTITIES)]
    place = len(rows) // 2
    *_, flipped = flipped_rows(rows[place])
    every = [*rows[:place], flipped, *rows[place + 1 :]]
    findings = [check_row(equations.scene, row, equations) for row in every]
    assert [i for i, finding in enumerate(findings) if not finding.shown] == [place]
