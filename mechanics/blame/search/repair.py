"""Edits put in, proved, and told in the person's own notation.

statement with the edits  --check_row-->  PROVED or CERTIFIED,    else it is no repair
"""

import re
from collections.abc import Sequence
from itertools import pairwise

from mechanics.blame.result import Edit, Mistake, Repair
from mechanics.blame.search.change import Change, is_minus
from mechanics.blame.search.claim import Claim, edited_claim
from mechanics.blame.search.find import Solution
from mechanics.blame.search.forest import Forest
from mechanics.blame.search.point import Family, Point, at_points
from mechanics.blame.search.spell import Spelling
from mechanics.checks.ledger import check_row
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.reading.place import Refused
from mechanics.reading.tree import Power, Product, Sum, parts
from mechanics.reading.written import Trees, row_of
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion

SIGN = re.compile(r"[-+\u2212]\s*$")


def edited_row(claim: Claim, chosen: Sequence[Solution]) -> tuple[Published, Trees] | None:
    """The row with all edits put in, and its trees; None where it has no value."""
    changes = [
        (solution.problem.forest, change) for solution in chosen for change in solution.changes
    ]
    new = edited_claim(claim, changes)
    try:
        return row_of(claim.row, new.written, new.entries), new.entries
    except Refused:
        return None


def proved(claim: Claim, chosen: Sequence[Solution], source: str) -> Repair | None:
    """The repair that edits are, if the statement is right with them."""
    found = edited_row(claim, chosen)
    if found is None:
        return None
    row, entries = found
    if _says_nothing(claim, row):
        return None
    try:
        finding = check_row(claim.truth.scene, row, claim.truth)
    except (InputError, SceneError, ExpressionError):
        return None
    if not finding.shown:
        return None
    spelling = spelling_of(claim)
    edits = tuple(
        _edit(claim, spelling, solution.problem.forest, change)
        for solution in chosen
        for change in solution.changes
    )
    return Repair(edits, _repaired(spelling, source, edits, entries), finding, row)


def _says_nothing(claim: Claim, row: Published) -> bool:
    """Whether an equation of motion holds for free accelerations, too: one that was multiplied by
    zero, or became an identity.
    """
    if not isinstance(row.quantity, EquationOfMotion):
        return False
    first, *others = row.sides

    def vanish(points: list[Point]) -> bool:
        (point,) = points
        return all(point.value(first) == point.value(side) for side in others)

    return at_points(claim.truth, [Family(moving=False)], vanish)


def spelling_of(claim: Claim) -> Spelling:
    """Spells in the notation of the claim."""
    known: set[int] = set()
    todo = [*claim.written.sides, *claim.definitions.values()]
    while todo:
        node = todo.pop()
        known.add(id(node))
        todo += parts(node)
    return Spelling(claim.written, known)


def _edit(claim: Claim, spelling: Spelling, forest: Forest, change: Change) -> Edit:
    node = forest.nodes[change.index]
    span = (node.at, node.end) if spelling.quoted(node) else None
    sign = _sign_before(claim, span)
    old, new = spelling(node), "" if change.node is None else spelling(change.node)
    if change.mistake is Mistake.SIGN and span is not None and sign is not None:
        mark = claim.written.text[sign[0]]
        return Edit(change.mistake, mark, "-" if mark == "+" else "+", _within(claim, sign))
    if change.mistake in (Mistake.MISSING, Mistake.TERM) and isinstance(change.node, Sum):
        added = spelling(change.node.terms[-1])
        text = f"- {added[1:].lstrip()}" if added.startswith("-") else f"+ {added}"
        at = None if span is None else (span[1], span[1])
        return Edit(change.mistake, "", text, _within(claim, at))
    if change.node is None and not forest.place[change.index][1]:
        new = "0"
    elif change.node is None:
        if change.mistake is Mistake.EXTRA and sign is not None and span is not None:
            old = f"{claim.written.text[sign[0]]} {old}"
            span = (sign[0], span[1])
        return Edit(change.mistake, old, "", _within(claim, span))
    return Edit(change.mistake, old, _fitting(forest, change, new, spelling), _within(claim, span))


def _fitting(forest: Forest, change: Change, new: str, spelling: Spelling) -> str:
    """The new text, in brackets where it would fall apart at its place."""
    above = forest.parent[change.index]
    if above < 0 or change.node is None or not forest.place[change.index][1]:
        return new
    around = forest.nodes[above]
    level = 0
    if isinstance(around, Product):
        level = 2 if not spelling.latex and isinstance(change.node, Product) else 1
    if isinstance(around, Power):
        level = 3
        fraction = (
            change.index != forest.kids[above][0]
            or not 0 <= around.at < forest.nodes[change.index].at
        )
        if spelling.latex and fraction:
            level = 0
    if isinstance(around, Sum) and is_minus(change.node):
        level = 0 if change.index == forest.kids[above][0] else 1
    return spelling.tight(change.node, level)


def _sign_before(claim: Claim, span: tuple[int, int] | None) -> tuple[int, int] | None:
    """Where the sign stands that belongs to what begins at a place."""
    if span is None:
        return None
    match = SIGN.search(claim.written.text, 0, span[0])
    return None if match is None else (match.start(), match.start() + 1)


def _within(claim: Claim, span: tuple[int, int] | None) -> tuple[int, int] | None:
    """A span of the text as one of the source of the statement, which has single blanks."""
    if span is None or span[0] < claim.written.start:
        return None
    text, start = claim.written.text, claim.written.start

    def place(at: int) -> int:
        return len(re.sub(r"\s+", " ", text[start:at]))

    return place(span[0]), place(span[1])


def _repaired(spelling: Spelling, source: str, edits: Sequence[Edit], entries: Trees) -> str:
    """The source with the edits put in; spelled anew where they have no place there."""
    spans = sorted((edit.span, edit.right) for edit in edits if edit.span is not None)
    apart = all(a[0][1] <= b[0][0] for a, b in pairwise(spans))
    if len(spans) < len(edits) or not apart:
        return " = ".join(spelling(entry) for entry in entries)
    found, at = "", 0
    for (start, end), right in spans:
        found += source[at:start] + _spaced(source, start, right)
        at = end
    return " ".join((found + source[at:]).split())


def _spaced(source: str, at: int, right: str) -> str:
    """What is added behind something stands apart from it."""
    return f" {right}" if right[:1] in "+-" and at and source[at - 1] != " " else right
