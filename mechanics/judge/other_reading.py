"""Another way to read what was written: by dimension first.

g sin(x) / 2 l is (g sin(x) / 2) l, which has no dimension beside x'':    /2 l is read as /(2 l)
omega = sqrt(2 g / 3 (R - r)) is no frequency:    /3 (R - r) is read as /(3 (R - r))

Where dimensions leave the first way, and it is wrong, another that is right is told: "right if".
"""

from collections.abc import Mapping
from dataclasses import replace

from sympy import Symbol
from sympy.matrices import MatrixBase

from mechanics.checks.ledger import check_row
from mechanics.claims.claim import Written
from mechanics.claims.kind import kind_of
from mechanics.claims.place import Refused
from mechanics.claims.sides import distinct, scalar
from mechanics.claims.statement import Letter, Statement
from mechanics.claims.tree import Node
from mechanics.compiled.dimensions import known_dimensions
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.judge.letters import has_meaning
from mechanics.kernel import Verdict
from mechanics.report.answer.judged import Judged
from mechanics.scene.dimensions import MixedDimensions, one_dimension
from mechanics.scene.published import Published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Identity,
    ReactionValue,
)
from mechanics.scene.unit_names import Dimension


def of_one_dimension(truth: Equations, statement: Statement) -> Statement:
    """The statement, in the first way to read it whose terms have one dimension."""
    row, written = statement.row, statement.written
    if not statement.others or row is None or written is None or statement.doubt:
        return statement
    known = known_dimensions(truth)
    if not known or _agree(truth, row, statement.letter, known):
        return statement
    for words, sides in statement.others:
        try:
            meant = _row(truth, row, written, sides, statement.letter)
        except (Refused, InputError, SceneError, ExpressionError):
            continue  # it cannot be read so
        if meant is None:
            continue
        letter = statement.letter and replace(statement.letter, sides=meant.sides)
        if _agree(truth, meant, letter, known):
            note = f"{words.partition(': ')[0]}: as it is, dimensions do not agree"
            new = replace(written, sides=sides)
            notes = (*statement.notes, note)
            return replace(statement, row=meant, written=new, notes=notes, others=(), letter=letter)
    return statement


def _agree(
    truth: Equations, row: Published, letter: Letter | None,
    known: Mapping[Symbol, Dimension | None],
) -> bool:  # fmt: skip
    """Whether all terms have one dimension, as far as it is known, and that of the left side."""
    if any(isinstance(side, MatrixBase) for side in row.sides):
        return True
    try:
        one_dimension(truth.scene, [truth.scene.plain(side) for side in row.sides], known)
    except MixedDimensions:
        return False
    except SceneError:
        return True
    return letter is None or has_meaning(truth, letter, known)


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
        if _right(truth, row, written, sides, statement.letter):
            return replace(entry, right_if=(*entry.right_if, words), open=True)
    return entry


def _right(
    truth: Equations, row: Published, written: Written, trees: tuple[Node, ...],
    letter: Letter | None,
) -> bool:  # fmt: skip
    try:
        meant = _row(truth, row, written, trees, letter)
        return meant is not None and check_row(truth.scene, meant, truth).shown
    except (Refused, InputError, SceneError, ExpressionError):
        return False  # it cannot be read so


def _row(
    truth: Equations, row: Published, written: Written, trees: tuple[Node, ...],
    letter: Letter | None,
) -> Published | None:  # fmt: skip
    """The row with the sides that it has then; None where they are matrices."""
    builder = written.builder()
    # A letter that the scene does not have is no side: its row says what it means.
    meaning = letter is not None and not letter.own
    sides = tuple(builder(tree) for tree in trees[meaning:])
    if not scalar(sides) or builder.unknown:
        return None
    if isinstance(row.quantity, EquationOfMotion | Identity | ReactionValue | GeneralizedMomentum):
        quantity, kept, _ = kind_of(truth.scene, distinct(sides))
        return replace(row, quantity=quantity, sides=tuple(map(truth.scene.pressed, kept)))
    return replace(row, sides=tuple(map(truth.scene.pressed, sides[-len(row.sides) :])))
