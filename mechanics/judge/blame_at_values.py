"""What is wrong with statements in which numbers stand for parameters.

    x'' = (u - 9.81 sin(th))/m    where the scene has g:    an edit that mends it where g = 9.81

The number is no mistake. Where the text names no parameter that the number may be, and values make
fewer edits enough, the edits are those under the values, which the answer tells.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Integer, Symbol

from mechanics.blame.reference import Reference
from mechanics.blame.result import Blame
from mechanics.compiled.fixed import fix
from mechanics.errors import MechanicsError
from mechanics.judge.at_values import (
    KINDS,
    TIMES,
    Values,
    held_by,
    judged_at,
    numbers_in,
    units_in,
    words,
)
from mechanics.judge.bounded_blame import blamed, nodes
from mechanics.judge.converted_rows import in_plain_symbols, moves_more
from mechanics.judge.tries import may_be_tried
from mechanics.kernel import Verdict
from mechanics.report.answer.judged import Judged
from mechanics.scene.published import Published

FALL = (9.7, 9.9)
"""What gravity is on the ground."""

LARGEST = 160
"""Nodes of a statement that is wrong, which is searched once for each choice of values."""

Size = tuple[int, int]
"""Refuted statements without a repair; edits of the others."""


def with_values(reference: Reference, judged: tuple[Judged, ...]) -> tuple[Judged, ...]:
    """The same, blamed where parameters have likely values if fewer edits are enough there."""
    truth = reference.truth
    rows = [e.statement.row for e in judged if e.statement.row is not None]
    wrong = [e for e in judged if e.blame is not None and e.finding.verdict is Verdict.REFUTED]
    best, smallest = judged, _size(wrong)
    if smallest <= (0, len(wrong)) or not all(isinstance(row.quantity, KINDS) for row in rows):
        return judged
    if any(moves_more(truth.scene, row) for row in rows):
        return judged
    # What is right with the values of its file is read with these; so is what stands beside it.
    if any((e.right_if or e.open) and not e.statement.file_values for e in wrong):
        return judged
    if not may_be_tried([e.statement for e in judged]):
        return judged
    if max(nodes(e.statement) for e in wrong) > LARGEST:
        return judged
    if any(e.statement.derived for e in wrong):
        return judged
    for values in likely(reference, judged, rows):
        try:
            found = _under(reference, judged, values)
        except MechanicsError:
            continue  # there the scene does not move
        size = _size([e for e in found if e.blame is not None])
        if size < smallest:
            best, smallest = found, size
    return best


def likely(
    reference: Reference, judged: Sequence[Judged], rows: Sequence[Published]
) -> Iterator[dict[Symbol, Integer]]:
    """Values of parameters that no statement holds: those of gravity, those of the scene, and 1.

    Or those that code gives its parameters, beside other numbers or in its file.
    """
    truth = reference.truth
    plain = [in_plain_symbols(truth.kinematics, row) for row in rows]
    held = held_by(truth.scene, plain)
    free = [p for p in truth.scene.parameters if p not in held]
    own = {s: v for e in judged for s, v in e.statement.code_values if s in held}
    if own:
        yield own
    file = {s: v for e in judged for s, v in e.statement.file_values if s in free}
    if file:
        yield file
    numbers = [number * times for times in TIMES for number in numbers_in(plain)]
    units = units_in([e.statement for e in judged]) or not held & {*truth.scene.parameters}
    if not free or not (numbers or units):
        return
    typical = {p: p.exact for p in free if getattr(p, "typical", None)}
    falls = [n for n in numbers if FALL[0] < n < FALL[1]]
    known = {p: falls[0] for p in free if falls and p.name in ("g", "gravity")}
    known |= {p: value for p, value in typical.items() if value in numbers}
    found = [known, known | {p: Integer(1) for p in free if p not in known} if units else {}]
    found.append(typical if len(typical) == len(free) > 1 else {})
    yield from {frozenset(values.items()): values for values in found if values}.values()


def _under(reference: Reference, judged: tuple[Judged, ...], values: Values) -> tuple[Judged, ...]:
    """The entries blamed at values; what is right there needs no edit."""
    target = Reference(fix(reference.truth, values))
    there = blamed(target, _refuted_at(reference, judged, values), values)
    told = f"numbers stand for parameters: this is where {words(values)}"
    found = []
    for entry, other in zip(judged, there, strict=True):
        if entry.blame is None or entry.right_if:
            found.append(entry)
        elif other.blame is None:
            found.append(replace(entry, blame=Blame((), ()), right_if=(words(values),)))
        else:
            searched = "; ".join(filter(None, (other.blame.searched, told)))
            found.append(replace(entry, blame=replace(other.blame, searched=searched)))
    return tuple(found)


def _refuted_at(reference: Reference, judged: Sequence[Judged], values: Values) -> list[Judged]:
    """The entries with their findings at values."""
    return [
        entry
        if entry.blame is None or entry.statement.row is None
        else replace(
            entry, blame=None, finding=judged_at(reference.truth, entry.statement.row, values)
        )
        for entry in judged
    ]


def _size(wrong: Sequence[Judged]) -> Size:
    first = [e.blame.repairs[:1] for e in wrong if e.blame is not None and not e.right_if]
    return sum(not some for some in first), sum(len(r.edits) for some in first for r in some)
