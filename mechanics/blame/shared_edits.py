"""One edit of a definition that makes several statements right, before those that mend one each.

temp = (F - m l w^2 s)/M    x'' = temp - ...,  theta'' = (g s - c temp)/...    ->    temp
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.blame.reference import Reference
from mechanics.blame.result import Repair
from mechanics.checks.ledger import check_row
from mechanics.claims.claim import row_of, row_trees
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.place import Refused
from mechanics.claims.statement import Statement
from mechanics.errors import ExpressionError, InputError, SceneError


def shared(
    reference: Reference, statements: Sequence[Statement], repairs: Sequence[tuple[Repair, ...]]
) -> list[tuple[Repair, ...]]:
    """The repairs of each statement, those first that make most of all statements right.

    Parameters
    ----------
    statements : sequence of Statement
        Refuted.
    repairs : sequence of tuple of Repair
        Of each.
    """
    found = [list(own) for own in repairs]
    known = {repair.edits: repair for own in repairs for repair in own if _in_definitions(repair)}
    if len(statements) < 2 or not known:
        return list(map(tuple, found))
    mended = dict.fromkeys(known, 1)
    for edits, repair in known.items():
        for statement, own in zip(statements, found, strict=True):
            same = [k for k, other in enumerate(own) if other.edits == edits]
            here = None if same else _put(reference, statement, repair)
            fewer = own and len(edits) > len(own[0].edits)
            if here is not None and not fewer:
                own.append(here)
                mended[edits] += 1
    for own in found:
        own.sort(key=lambda repair: -mended.get(repair.edits, 0))
    return [tuple(own[: max(1, len(before))]) for own, before in zip(found, repairs, strict=True)]


def _in_definitions(repair: Repair) -> bool:
    return repair.written is not None and all(edit.definition for edit in repair.edits)


def _put(reference: Reference, statement: Statement, repair: Repair) -> Repair | None:
    """A repair of another statement put into this one, where that makes it right."""
    row, written = statement.row, statement.written
    if row is None or written is None or repair.written is None:
        return None
    changed = {edit.definition for edit in repair.edits}
    new = {n: tree for n, tree in repair.written.definitions if n in changed}
    if not changed <= dict(written.definitions).keys():
        return None
    definitions = tuple((n, new.get(n, tree)) for n, tree in written.definitions)
    try:
        trees = row_trees(row, written)
        edited = replace(written, definitions=definitions)
        other = row_of(row, edited, trees)
        finding = check_row(reference.truth.scene, other, reference.truth)
    except (Untreeable, Refused, InputError, SceneError, ExpressionError):
        return None  # it has no value there
    return replace(repair, finding=finding, row=other, written=edited) if finding.shown else None
