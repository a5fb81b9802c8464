"""Outputs of code that stand in each other's place: ``return [acceleration, speed]``.

x' = f, v' = g    both wrong,    x' = g, v' = f    both right
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from sympy import Symbol

from mechanics.blame.reference import Reference
from mechanics.blame.result import Edit, Mistake, Repair
from mechanics.checks.ledger import check_row
from mechanics.claims.statement import Statement
from mechanics.errors import ExpressionError, InputError, SceneError


def exchanged_outputs(
    reference: Reference, statements: Sequence[Statement], repairs: Sequence[tuple[Repair, ...]]
) -> list[tuple[Repair, ...]]:
    """The repairs of each statement; those without get the exchange that makes two of them right.

    Parameters
    ----------
    statements : sequence of Statement
        Refuted.
    repairs : sequence of tuple of Repair
        Of each.
    """
    found = list(repairs)
    lost = [k for k, own in enumerate(found) if not own and _is_output(statements[k])]
    for one, other in combinations(lost, 2):
        here = _put(reference, statements[one], statements[other])
        there = _put(reference, statements[other], statements[one])
        if here is not None and there is not None:
            found[one], found[other] = (here,), (there,)
    return found


def _is_output(statement: Statement) -> bool:
    """Whether a statement is what code returns for one quantity."""
    row, written = statement.row, statement.written
    code = written is None or written.notation == "code"
    return code and row is not None and len(row.sides) == 2 and isinstance(row.sides[0], Symbol)


def _put(reference: Reference, statement: Statement, other: Statement) -> Repair | None:
    """The repair by which a statement gets the value of another one."""
    if statement.row is None or other.row is None:
        return None
    row = replace(statement.row, sides=(statement.row.sides[0], other.row.sides[1]))
    try:
        finding = check_row(reference.truth.scene, row, reference.truth)
    except (InputError, SceneError, ExpressionError):
        return None  # it has no value there
    if not finding.shown:
        return None
    before, after = str(statement.row.sides[1]), str(other.row.sides[1])
    edit = Edit(Mistake.ORDER, before, after)
    return Repair((edit,), f"{statement.row.sides[0]} = {after}", finding, row)
