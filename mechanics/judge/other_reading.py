"""Other readings of what was written: dimensions choose one, and what is refuted under one of
several that nobody chose is open.

    as it was read                                       another reading
    g sin(x) / 2 l    has no dimension beside x''        /2 l is /(2 l)
    return a, b       [1/s^2, m/s^2]: theta'', x''       the outputs are x'', theta''
    T = m g l sin(x)  T is the kinetic energy            T is the torque (`mechanics.judge.letters`)
    p(t)              of the only momentum               p is an input (`mechanics.judge.guesses`)

The first reading whose terms have one dimension is taken. A statement that is refuted as it is read
is open where another reading does not refute it, and none that is shown is refuted by that: "right
if p is M".
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from sympy.matrices import MatrixBase

from mechanics.claims.claim import Written
from mechanics.claims.kind import kind_of
from mechanics.claims.place import Refused
from mechanics.claims.sides import distinct, scalar
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Node
from mechanics.compiled.dimensions import known_dimensions
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.judge.letters import Known, has_meaning, other_meanings
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


@dataclass(frozen=True)
class OtherReading:
    """Another way to take statements.

    Attributes
    ----------
    words : str
        What is otherwise.
    statements : mapping of int to Statement or None
        The statements as they are then, by their places among all; None where that cannot be tried.
    """

    words: str
    statements: Mapping[int, Statement | None]


def other_readings(
    truth: Equations, statements: Sequence[Statement], dimensions: bool = True
) -> Iterator[OtherReading]:
    """What may be meant otherwise: what is read otherwise, and names on the left.

    Parameters
    ----------
    dimensions : bool
        Whether dimensions tell: a number may stand for a parameter that has a value.
    """
    yield from _read_otherwise(truth, statements)
    for words, meant in other_meanings(truth, statements, dimensions):
        yield OtherReading(words, meant)


def _read_otherwise(truth: Equations, statements: Sequence[Statement]) -> Iterator[OtherReading]:
    """What readers could have taken otherwise: slashes, and the order of what code returns."""
    calls: dict[str, dict[int, Statement]] = {}
    for k, statement in enumerate(statements):
        for words, trees in statement.others:
            if (meant := _with_sides(truth, statement, trees)) is not None:
                yield OtherReading(words, {k: meant})
        for words, row in statement.taken:
            source = statement.source.removesuffix(statement.tag) + row.tag
            calls.setdefault(words, {})[k] = replace(
                statement, row=row, tag=row.tag, source=source, taken=()
            )
    yield from (OtherReading(words, meant) for words, meant in calls.items())


def of_one_dimension(truth: Equations, statements: Sequence[Statement]) -> list[Statement]:
    """Statements in the first reading whose terms have one dimension; as they are without one."""
    found = list(statements)
    if not any(s.others or s.taken for s in found) or not (known := known_dimensions(truth)):
        return found
    for other in _read_otherwise(truth, statements):
        pairs = [(k, found[k], meant) for k, meant in other.statements.items() if meant is not None]
        if not all(_agrees(truth, own, known) for _, own, _ in pairs) and all(
            _agrees(truth, meant, known) for *_, meant in pairs
        ):
            note = f"{other.words.partition(': ')[0]}: as it is, dimensions do not agree"
            for k, own, meant in pairs:
                found[k] = replace(meant, notes=(*own.notes, note))
    return found


def left_open(
    judged: Sequence[Judged], others: Iterable[OtherReading],
    findings: Callable[[Sequence[Statement]], Sequence[Judged]],
) -> tuple[Judged, ...]:  # fmt: skip
    """Entries, open where they are refuted, and another reading may make them right.

    Parameters
    ----------
    findings : callable
        Verdicts on statements, all together, as the entries were judged.
    """
    found = list(judged)
    if not any(map(is_wrong, judged)):
        return tuple(found)
    for other in others:
        wrong = [k for k in other.statements if is_wrong(judged[k])]
        tried = {k: meant for k, meant in other.statements.items() if meant is not None}
        if not wrong:
            continue
        entries = zip(tried, findings(list(tried.values())) if tried else (), strict=True)
        refuted = {k for k, entry in entries if entry.finding.verdict is Verdict.REFUTED}
        if any(judged[k].finding.shown for k in refuted):
            continue
        for k in wrong:
            if k not in refuted:
                right_if = tuple(dict.fromkeys((*found[k].right_if, other.words)))
                found[k] = replace(found[k], right_if=right_if, open=True)
    return tuple(found)


def is_wrong(entry: Judged) -> bool:
    """Whether an entry is refuted, and by more than that it has no value somewhere."""
    return entry.finding.verdict is Verdict.REFUTED and not entry.finding.undefined


def _agrees(truth: Equations, statement: Statement, known: Known) -> bool:
    """Whether all terms have one dimension, as far as it is known, and that of the left side."""
    row, letter = statement.row, statement.letter
    if row is None or statement.doubt or any(isinstance(side, MatrixBase) for side in row.sides):
        return True
    try:
        one_dimension(truth.scene, [truth.scene.plain(side) for side in row.sides], known)
    except MixedDimensions:
        return False
    except SceneError:
        return True
    return letter is None or has_meaning(truth, letter, known)


def _with_sides(
    truth: Equations, statement: Statement, trees: tuple[Node, ...]
) -> Statement | None:
    """A statement with other sides; None where it cannot be read so."""
    row, written, letter = statement.row, statement.written, statement.letter
    if row is None or written is None:
        return None
    try:
        meant = _row(truth, row, written, trees, letter is not None and not letter.own)
    except (Refused, InputError, SceneError, ExpressionError):
        return None
    if meant is None:
        return None
    letter = letter and replace(letter, sides=meant.sides)
    return replace(
        statement, row=meant, written=replace(written, sides=trees), others=(), letter=letter
    )


def _row(
    truth: Equations, row: Published, written: Written, trees: tuple[Node, ...], named: bool
) -> Published | None:
    """The row with the sides that it has then; None where they are matrices.

    Parameters
    ----------
    named : bool
        Whether the first side is a letter that the scene does not have: the row says what it means.
    """
    builder = written.builder()
    sides = tuple(builder(tree) for tree in trees[named:])
    if not scalar(sides) or builder.unknown:
        return None
    if isinstance(row.quantity, EquationOfMotion | Identity | ReactionValue | GeneralizedMomentum):
        quantity, kept, _ = kind_of(truth.scene, distinct(sides))
        return replace(row, quantity=quantity, sides=tuple(map(truth.scene.pressed, kept)))
    return replace(row, sides=tuple(map(truth.scene.pressed, sides[-len(row.sides) :])))
