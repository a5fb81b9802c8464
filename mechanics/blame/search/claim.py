"""What a refuted statement claims, as equalities at a point.

equation of motion: left = right, along the motion      reaction: side = its value
energy, mass, momentum: side = what the scene gives
potential, sum of energies, Lagrangian: side at two states, up to a constant
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from sympy import Expr, S, Symbol
from sympy.matrices import MatrixBase

from mechanics.blame.reference import Reference
from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import Sheet, sheet_of
from mechanics.blame.search.point import Family, Point
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.syntax_tree import Step, SyntaxTree, Way, edited
from mechanics.checks.ledger_energy import ENERGIES, energy_of
from mechanics.checks.ledger_momenta import derived
from mechanics.claims.claim import Trees, Written, row_of, row_trees
from mechanics.claims.entrywise import entrywise
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.statement import Statement
from mechanics.claims.tree import COMPOSED, Node, Power, names
from mechanics.equations import Equations
from mechanics.scene import quantities as q
from mechanics.scene.published import Published

CONSTANT_FREE = (q.PotentialEnergy, q.TotalEnergy, q.Lagrangian, q.Hamiltonian)
ALONG = (q.EquationOfMotion, q.ReactionValue)

Target = Callable[[Point], int]


@dataclass(frozen=True, eq=False)
class Claim:
    """A statement as trees.

    Attributes
    ----------
    reference : Reference
        What it is compared with.
    entries : tuple of Node
        As many as the row compares.
    kept : frozenset of int or str
        Entries and definitions that are not edited: others are shown with them.
    derived : bool
        Whether one of the entries is the scene's own.
    beside : Expr
        What makes of an energy with potentials of forces the scene's own.
    """

    reference: Reference
    row: Published
    written: Written
    entries: Trees
    kept: frozenset[int | str] = frozenset()
    derived: bool = False
    beside: Expr = S.Zero

    @property
    def truth(self) -> Equations:
        """The derivation."""
        return self.reference.truth

    @property
    def definitions(self) -> dict[str, Node]:
        """The person's own, by name."""
        return dict(self.written.definitions)


def edited_claim(claim: Claim, changes: Sequence[tuple[SyntaxTree, Change]]) -> Claim:
    """A claim with edits put in, each told by the tree that it was found in."""
    steps: dict[int | str, list[tuple[Way, Step]]] = {}
    for tree, change in changes:
        home, way = tree.place[change.index]
        steps.setdefault(home, []).append((way, change.wrap or change.node))
    entries = tuple(edited(tree, steps.get(k, ())) for k, tree in enumerate(claim.entries))
    definitions = tuple(
        (name, edited(tree, steps.get(name, ()))) for name, tree in claim.written.definitions
    )
    written = replace(claim.written, definitions=definitions)
    return replace(claim, entries=entries, written=written)


def claim_of(
    reference: Reference, statement: Statement, put: Mapping[Symbol, Expr] | None = None
) -> Claim | None:
    """The claim of a statement that could be read.

    Parameters
    ----------
    put : mapping of Symbol to Expr, optional
        What stands for the person's symbols: by a convention, or as values of parameters.

    Raises
    ------
    Untreeable
        Where it holds what the trees do not know.
    """
    row = statement.row
    if row is None:
        return None
    written = statement.written
    if written is None:
        written = Written((), (), Naming(Vocabulary(reference.truth.scene)), "code", "")
    written = entrywise(written)
    trees = row_trees(row, written)
    if put:
        written = replace(written, put=put)
        row = row_of(row, written, trees)
    # What a function returns is no line of its author: nothing is changed on the left of it. Of a
    # residual it stands there itself.
    named = len(row.sides) == 2 and isinstance(row.sides[0], Symbol)
    kept = frozenset({0} if written.notation == "code" and named else ())
    if statement.derived:
        kept |= {k for k, tree in enumerate(trees) if not _authored(tree, written)}
    return Claim(reference, row, written, trees, kept, statement.derived)


def _authored(tree: Node, written: Written) -> bool:
    """Whether an entry is a side that was written, or the square of one."""
    inner = tree.base if isinstance(tree, Power) and tree.at == COMPOSED else tree
    return any(inner is side for side in written.sides)


def used(claim: Claim) -> frozenset[str]:
    """Definitions that a claim holds, and those that these hold in turn."""
    known, found = claim.definitions, set[str]()
    todo = [name.name for entry in claim.entries for name in names(entry)]
    while todo:
        name = todo.pop()
        if name in known and name not in found:
            found.add(name)
            todo += [inner.name for inner in names(known[name])]
    return frozenset(found)


def problems(claim: Claim) -> Iterator[Problem]:
    """The equalities of a claim, each with the entries that it compares."""
    quantity, size = claim.row.quantity, len(claim.entries)
    if isinstance(quantity, q.EquationOfMotion | q.Identity):
        rows = _width(claim.row)
        for k in range(rows, size):
            yield from _problems(claim, (k % rows, k), None)
        return
    for k, target in enumerate(targets(claim, claim.truth)):
        yield from _problems(claim, (k,), target)


def at_once(claim: Claim) -> Iterator[tuple[Claim, Problem]]:
    """What one edit may mend that the equalities of a claim do not show.

    An energy as one problem: a wrong symbol may be in what it is at rest and in the rest of it.
    What differs between two states tells of one edit, but not of a missing term.

    An equation without accelerations as one of motion: an acceleration may have lost its dots.
    """
    if isinstance(claim.row.quantity, q.TotalEnergy | q.Lagrangian | q.Hamiltonian):
        for k, target in enumerate(targets(claim, claim.truth)):

            def wanted(point: Point, target: Expr = target) -> int:
                return point.value(target)

            yield claim, posed(claim, (k,), wanted, STATES)
    for motion in as_motion(claim):
        for problem in problems(motion):
            yield motion, problem


def as_motion(claim: Claim) -> Iterator[Claim]:
    """A claim of two sides that holds no acceleration, as an equation of motion."""
    if isinstance(claim.row.quantity, q.Identity) and len(claim.entries) == 2:
        yield replace(claim, row=replace(claim.row, quantity=q.EquationOfMotion()))


STATES = (Family(False, free=True), Family(False, other_state=True, free=True))
"""Two states with the same parameters: what an energy is up to a constant."""


def _width(row: Published) -> int:
    first = row.sides[0]
    return len(first) if isinstance(first, MatrixBase) else 1


def targets(claim: Claim, truth: Equations) -> list[Expr]:
    """What each entry has to be, in plain symbols."""
    row, quantity = claim.row, claim.row.quantity
    if isinstance(quantity, q.ReactionValue):
        return [Symbol(quantity.name, real=True)] * len(row.sides)
    if isinstance(quantity, q.MassMatrix):
        return list(truth.kinematics.mass_matrix) * len(row.sides)
    if isinstance(quantity, ENERGIES):
        return [energy_of(truth.kinematics, quantity) - claim.beside] * len(row.sides)
    found = derived(truth.kinematics, quantity)
    chosen = [found[min(i, len(found) - 1)] for i in range(len(row.sides))]
    return [e for side in chosen for e in (side if isinstance(side, MatrixBase) else [side])]


def _problems(claim: Claim, numbers: tuple[int, ...], target: Expr | None) -> Iterator[Problem]:
    """One problem; of an energy with a constant two: what it is at rest, and the rest of it."""

    def wanted(point: Point) -> int:
        return 0 if target is None else point.value(target)

    quantity = claim.row.quantity
    if not isinstance(quantity, CONSTANT_FREE):
        free = not isinstance(quantity, (*ALONG, q.Identity))
        yield posed(claim, numbers, wanted, (Family(isinstance(quantity, ALONG), free=free),))
        return
    if isinstance(quantity, q.PotentialEnergy):
        yield posed(claim, numbers, wanted, STATES)
        return
    yield posed(claim, numbers, wanted, [replace(family, still=True) for family in STATES])
    yield posed(claim, numbers, _at_rest(claim, numbers[0], wanted), STATES[:1])


def _at_rest(claim: Claim, number: int, wanted: Target) -> Target:
    """What an energy has to be that is right, up to a constant, where nothing moves:

    right(q, u) - right(q, 0) + written(q, 0), so that one state tells what is wrong with the rest.
    """
    written = claim.written.builder()(claim.entries[number])

    def target(point: Point) -> int:
        rest = claim.reference.points.like(point, replace(point.family, still=True))
        return wanted(point) - wanted(rest) + rest.value(written)

    return target


def posed(
    claim: Claim, numbers: tuple[int, ...], target: Target, families: Sequence[Family]
) -> Problem:
    """Some entries of a claim at points: one alone, or the difference of two."""
    tree = SyntaxTree(claim.definitions, claim.kept).plant([(k, claim.entries[k]) for k in numbers])
    builder = claim.written.builder()

    def sheets(points: list[Point]) -> tuple[Sheet, ...]:
        return tuple(sheet_of(tree, point, builder, target(point)) for point in points)

    return Problem(tree, numbers, claim.reference.points.together(families, sheets), target)
