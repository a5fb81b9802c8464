"""Another way to read what was written.

g sin(x) / 2 l is read as (g sin(x) / 2) l, and wrong;    "right if /2 l is /(2 l)"
"""

from dataclasses import replace

from mechanics.checks.ledger import check_row
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.kernel import Verdict
from mechanics.reading.kind import kind_of
from mechanics.reading.place import Refused
from mechanics.reading.sides import distinct, scalar
from mechanics.reading.tree import Node
from mechanics.reading.written import Written
from mechanics.report.answer.judged import Judged
from mechanics.scene.published import Published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Identity,
    ReactionValue,
)


def read_otherwise(truth: Equations, entry: Judged) -> Judged:
    """A refuted statement, with the other reading under which it is right.

    Which of them was meant is not known: it is neither right nor wrong.
    """
    statement = entry.statement
    row, written = statement.row, statement.written
    if (
        entry.finding.undefined
        or entry.finding.verdict is not Verdict.REFUTED
        or row is None
        or written is None
    ):
        return entry
    for words, sides in statement.others:
        if _right(truth, row, written, sides):
            return replace(entry, right_if=(*entry.right_if, words), open=True)
    return entry


def _right(truth: Equations, row: Published, written: Written, trees: tuple[Node, ...]) -> bool:
    try:
        meant = _row(truth, row, written, trees)
        return meant is not None and check_row(truth.scene, meant, truth).shown
    except (Refused, InputError, SceneError, ExpressionError):
        return False  # it cannot be read so


def _row(
    truth: Equations, row: Published, written: Written, trees: tuple[Node, ...]
) -> Published | None:
    """The row with the sides that it has then; None where they are matrices."""
    builder = written.builder()
    sides = tuple(builder(tree) for tree in trees)
    if not scalar(sides) or builder.unknown:
        return None
    if isinstance(row.quantity, EquationOfMotion | Identity | ReactionValue | GeneralizedMomentum):
        quantity, kept, _ = kind_of(truth.scene, distinct(sides))
        return replace(row, quantity=quantity, sides=tuple(map(truth.scene.pressed, kept)))
    return replace(row, sides=tuple(map(truth.scene.pressed, sides[-len(row.sides) :])))
