"""What is wrong with what is refuted, as far as it can be looked for in a bounded number of steps.

REFUTED  ->  Blame        the first `MOST` statements, each of at most `LARGEST` nodes
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from sympy import Expr, Symbol, preorder_traversal

from mechanics.blame.blame import blame as blame_of
from mechanics.blame.exchanged_outputs import exchanged_outputs
from mechanics.blame.explanations import explanations
from mechanics.blame.reference import Reference
from mechanics.blame.result import Blame, Edit
from mechanics.blame.search.budget import Budget
from mechanics.blame.search.claim import Claim, claim_of, used
from mechanics.blame.shared_edits import shared
from mechanics.checks.force_potentials import potentials_beside
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.place import Refused
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Node, parts
from mechanics.errors import MechanicsError
from mechanics.judge.branches import blame_by_branch
from mechanics.judge.frequencies import solved
from mechanics.report.answer.judged import Judged, differs

MOST = 12
"""Statements that are searched: where more are wrong, a name or sign is wrong in all of them."""

LARGEST = 1200
"""Nodes of a row: an equation of a page, searched in some seconds."""


STEPS = 25_000
"""Of the search, for all statements of a text."""


def blamed(
    reference: Reference, judged: Sequence[Judged], put: Mapping[Symbol, Expr] | None = None
) -> tuple[Judged, ...]:
    """The same with what is wrong, where something is refuted.

    Parameters
    ----------
    put : mapping of Symbol to Expr, optional
        What stands for the person's symbols, by a convention or as values of parameters; then no
        known mistakes are looked for, which are those of the scene's own derivation.
    """
    wrong = [k for k, entry in enumerate(judged) if differs(entry.finding)]
    if not wrong:
        return tuple(judged)
    small = [k for k, entry in enumerate(judged) if nodes(entry.statement) <= LARGEST]
    searched = [k for k in wrong if k in small][:MOST]
    beside = [k for k in small if k not in wrong][:MOST]
    told: Sequence[tuple[str, ...]] = [()] * len(searched)
    if not put:
        told = _explained(reference, [judged[k] for k in (*searched, *beside)])
    found = list(judged)
    for k in wrong:
        words = "it is too large" if k not in small else f"{MOST} statements before it are wrong"
        found[k] = replace(found[k], blame=Blame((), (), searched=f"not searched: {words}"))
    budget = Budget(STEPS)
    for k, reasons in zip(searched, told[: len(searched)], strict=True):
        late = Blame((), (), searched=f"not searched: those before it took {STEPS} steps")
        blame = late if budget.spent else _search(reference, judged, k, budget, put)
        found[k] = replace(found[k], blame=replace(blame, explanations=reasons))
    blames = [found[k].blame or Blame((), ()) for k in searched]
    statements = [found[k].statement for k in searched]
    own = [blame.repairs for blame in blames]
    if not put:
        own = exchanged_outputs(reference, statements, own)
    together = shared(reference, statements, own)
    for k, blame, repairs in zip(searched, blames, together, strict=True):
        words = blame.searched if bool(repairs) == bool(blame.repairs) else ""
        blame = replace(blame, repairs=repairs, searched=words)
        found[k] = replace(found[k], blame=blame)
    return named_once(found)


def declared_only(judged: Sequence[Judged], words: str) -> tuple[Judged, ...]:
    """The same, told why no edit was searched."""
    none = Blame((), (), searched=f"not searched: {words}")
    return tuple(replace(e, blame=none) if differs(e.finding) else e for e in judged)


def named_once(judged: Sequence[Judged]) -> tuple[Judged, ...]:
    """One error in a definition of the person that spoils several statements is told to be one."""
    tags: dict[Edit, list[str]] = {}
    for entry in judged:
        for edit in _in_definitions(entry):
            tags.setdefault(edit, []).append(entry.statement.tag)
    found = []
    for entry in judged:
        words = tuple(
            f"one error in the definition of {edit.definition}: {', '.join(tags[edit])}"
            for edit in _in_definitions(entry)
            if len(tags[edit]) > 1
        )
        blame = entry.blame
        if words and blame is not None:
            blame = replace(blame, explanations=(*blame.explanations, *words))
        found.append(replace(entry, blame=blame))
    return tuple(found)


def _in_definitions(entry: Judged) -> list[Edit]:
    """Edits of the first repair that stand in a definition of the person."""
    repairs = entry.blame.repairs if entry.blame is not None else ()
    return [edit for repair in repairs[:1] for edit in repair.edits if edit.definition]


def nodes(statement: Statement) -> int:
    """How large a statement is: as it is written, where it is, else as it was traced."""
    if statement.row is None:
        return 0
    if statement.written is not None:
        defined = (tree for _, tree in statement.written.definitions)
        return sum(1 for side in (*statement.written.sides, *defined) for _ in walked(side))
    return sum(1 for side in statement.row.sides for _ in preorder_traversal(side))


def walked(node: Node) -> Iterator[Node]:
    """A tree, node by node."""
    yield node
    for part in parts(node):
        yield from walked(part)


def shown_with(reference: Reference, judged: Sequence[Judged], k: int) -> frozenset[int | str]:
    """What a refuted statement has in common with those that are shown: an edit there spoils them.

    Definitions, and sides of one line; rows of matrices have entries of their own.
    """
    own = _claim(reference, judged[k])
    if own is None:
        return frozenset()
    found: set[int | str] = set()
    for entry in [entry for entry in judged if entry.finding.shown][:MOST]:
        other = entry.statement.written
        same = other is not None and other.sides is own.written.sides
        if not (own.definitions or same):
            continue
        claim = _claim(reference, entry)
        if claim is None:
            continue  # no edit of it was told, either
        found |= used(claim)
        if same:
            found |= {n for n, tree in enumerate(own.entries) if tree in claim.entries}
    return frozenset(found)


def _claim(reference: Reference, entry: Judged) -> Claim | None:
    if entry.statement.written is None:
        return None
    try:
        return claim_of(reference, entry.statement)
    except (Untreeable, Refused):
        return None


def _search(
    reference: Reference, judged: Sequence[Judged], k: int, budget: Budget,
    put: Mapping[Symbol, Expr] | None,
) -> Blame:  # fmt: skip
    """The blame; the verdict stands whatever the search meets."""

    def search(one: Statement) -> Blame:
        kept = shown_with(reference, judged, k)
        own = blame_of(reference, one, kept, budget, put)
        if one.row is None or put:
            return own
        sums = (added for added, _ in potentials_beside(reference.truth.scene, one.row))
        others = (blame_of(reference, one, kept, budget, beside=added) for added in sums)
        # Who writes what such a force has as a potential counts it.
        return min((*others, own), key=lambda blame: _length(blame)[0])

    try:
        some = solved(reference.truth, judged[k].statement)
        blame = blame_by_branch(reference.truth, some[0], judged[k].finding, search)
        return blame or min(map(search, some), key=_length)
    except (MechanicsError, Refused, RecursionError) as error:
        words = str(error) if not isinstance(error, RecursionError) else "it is nested too deeply"
        return Blame((), (), searched=f"not searched: {words}")


def _length(blame: Blame) -> tuple[int, int]:
    """Of the first repair: edits, and letters in them."""
    edits = blame.repairs[0].edits if blame.repairs else ()
    size = sum(len(edit.written) + len(edit.right) for edit in edits)
    return (len(edits), size) if edits else (MOST, 0)


def _explained(reference: Reference, judged: Sequence[Judged]) -> Sequence[tuple[str, ...]]:
    """Known mistakes that explain what is refuted; or why they were not looked for."""
    try:
        return explanations(reference, [e.statement for e in judged], [e.finding for e in judged])
    except (MechanicsError, Refused, RecursionError) as error:
        words = str(error) if not isinstance(error, RecursionError) else "it is nested too deeply"
        return [(f"known mistakes were not looked for: {words}",)] * len(judged)
