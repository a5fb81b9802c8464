"""Edits put in, proved, and told in the person's own notation.

statement with the edits  --check_row-->  PROVED or CERTIFIED,    else it is no repair
"""

from collections.abc import Iterator, Sequence

from mechanics.blame.result import Repair
from mechanics.blame.search.change import Change
from mechanics.blame.search.claim import Claim, edited_claim
from mechanics.blame.search.find import Solution
from mechanics.blame.search.notation import edit_of, spliced
from mechanics.blame.search.point import Family, Point
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.checks.force_potentials import with_potentials
from mechanics.checks.ledger import check_row
from mechanics.claims.claim import Trees, Written, row_of
from mechanics.claims.place import Refused
from mechanics.claims.spelling import Spelling
from mechanics.claims.tree import Name, Node, names, parts
from mechanics.compiled.dimensions import check_energy
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.kernel import Finding
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity


def edited_row(claim: Claim, chosen: Sequence[Solution]) -> tuple[Published, Trees] | None:
    """The row with all edits put in, and its trees; None where it has no value."""
    new = edited_claim(claim, _changes(chosen))
    try:
        return row_of(claim.row, new.written, new.entries), new.entries
    except Refused:
        return None


def _changes(chosen: Sequence[Solution]) -> list[tuple[SyntaxTree, Change]]:
    return [(solution.problem.tree, change) for solution in chosen for change in solution.changes]


def proved(
    claim: Claim, chosen: Sequence[Solution], source: str, finding: Finding | None = None
) -> Repair | None:
    """The repair that edits are, if the statement is right with them.

    Parameters
    ----------
    finding : Finding, optional
        Of the statement with the edits, where it is compared with something else than the truth.
    """
    found = edited_row(claim, chosen)
    if found is None:
        return None
    row, entries = found
    if _says_nothing(claim, row) or not _returns(claim, chosen) or _larger(claim, entries, chosen):
        return None
    try:
        if finding is None:
            finding = check_row(claim.truth.scene, with_potentials(row, claim.beside), claim.truth)
    except (InputError, SceneError, ExpressionError):
        return None
    if not finding.shown or check_energy(claim.truth, row) is not None:
        return None
    spelling = spelling_of(claim)
    edits = tuple(
        edit_of(claim, spelling, solution.problem.tree, change)
        for solution in chosen
        for change in _shown(solution)
    )
    new = edited_claim(claim, _changes(chosen))
    changed = list(dict.fromkeys(edit.definition for edit in edits if edit.definition))
    if claim.written.places and all(edit.definition for edit in edits):
        return Repair(edits, assigned(new.written, changed), finding, row, new.written)
    words = spliced(spelling, source, edits, entries, row)
    for name in changed:
        # As it can be read again.
        joint = r", \text{with } " if spelling.latex else ", with "
        words += f"{joint}{spelling(Name(0, name))} = {spelling(new.definitions[name])}"
    return Repair(edits, words, finding, row, new.written)


def _shown(solution: Solution) -> Iterator[Change]:
    """The edits, but for one that stands in a part of a definition that is told with it."""
    tree = solution.problem.tree
    whole = {
        change.index
        for change in solution.changes
        if change.wrap and change.node != change.wrap(tree.nodes[change.index])
        and isinstance(tree.place[change.index][0], str) and not tree.side(change.index)
    }  # fmt: skip
    return (c for c in solution.changes if whole.isdisjoint(tree.ways_up(c.index)[1:]))


def _larger(claim: Claim, entries: Trees, chosen: Sequence[Solution]) -> bool:
    """Whether several edits together add more than was written."""
    if len(_changes(chosen)) == 1:
        return False
    before, after = (sum(map(_nodes, trees)) for trees in (claim.entries, entries))
    return after > 2 * before


def _nodes(tree: Node) -> int:
    return 1 + sum(map(_nodes, parts(tree)))


def assigned(written: Written, names: Sequence[str]) -> str:
    """Definitions of code with their places: ``cart.py, line 12: temp = ...``."""
    spelling, table = Spelling(written, frozenset()), dict(written.definitions)
    lines = (f"{written.places[n]}: {n} = {spelling(table[n])}" for n in names)
    return "; ".join(lines)


def _returns(claim: Claim, chosen: Sequence[Solution]) -> bool:
    """Whether code still computes what it returns of what it had: of no further acceleration,
    nor, where the scene has speeds of its own, of a rate of a coordinate.
    """
    if claim.written.notation != "code" or len(claim.entries) < 2:
        return True
    before, after = map(_rates, (claim, edited_claim(claim, _changes(chosen))))
    return after <= before


def _rates(claim: Claim) -> set[tuple[str, int]]:
    """What code does not compute with, in what is returned and in the code's own names."""
    lookup, slowest = claim.written.naming.lookup, 1 if claim.truth.scene.speeds else 2
    trees = (*claim.entries[1:], *claim.definitions.values())
    held = {name for tree in trees for name in names(tree)}
    orders = ((n.name, (lookup(n.name) or ("", 0))[1] + n.order) for n in held)
    return {(name, order) for name, order in orders if order >= slowest}


def _says_nothing(claim: Claim, row: Published) -> bool:
    """Whether an equation of motion holds for free accelerations, too: one that was multiplied by
    zero, or became an identity.
    """
    first, *others = row.sides
    if isinstance(row.quantity, Identity):
        return not claim.derived and all(first == side for side in others)
    if not isinstance(row.quantity, EquationOfMotion):
        return False

    def vanish(points: list[Point]) -> bool:
        (point,) = points
        return all(point.value(first) == point.value(side) for side in others)

    return claim.reference.points.together([Family(moving=False)], vanish)


def spelling_of(claim: Claim) -> Spelling:
    """Spells in the notation of the claim."""
    known: set[int] = set()
    todo = [*claim.written.sides, *claim.definitions.values()]
    while todo:
        node = todo.pop()
        known.add(id(node))
        todo += parts(node)
    return Spelling(claim.written, known)
