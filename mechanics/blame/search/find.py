"""The cheapest edits that make an equality hold at its points: one, two, several, else a term.

one token  <  one term dropped  <  a term added  <  two of these  <  several, or a term replaced
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mechanics.blame.result import Mistake
from mechanics.blame.search.bracket_signs import signs
from mechanics.blame.search.candidates import Candidates
from mechanics.blame.search.change import Change
from mechanics.blame.search.claim import Claim
from mechanics.blame.search.edit_and_term import Both
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.exact_cover import Several
from mechanics.blame.search.exchanged_names import exchanged
from mechanics.blame.search.function_definitions import in_functions
from mechanics.blame.search.group_differences import whole
from mechanics.blame.search.homogeneity_test import Homogeneity, growing
from mechanics.blame.search.missing import Missing
from mechanics.blame.search.pairs import pairs
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.solved_numbers import numbers
from mechanics.blame.search.two_terms import Two
from mechanics.blame.search.words import Words
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Name

EQUALLY = 0.45
"""Edits that cost that much more are not equally small."""


@dataclass(frozen=True, eq=False)
class Solution:
    """Edits that together make an equality hold."""

    problem: Problem
    changes: tuple[Change, ...]

    @property
    def cost(self) -> float:
        """Sum of the costs."""
        return sum(change.cost for change in self.changes)


def solutions(claim: Claim, problem: Problem, statement: Statement) -> Iterator[list[Solution]]:
    """Solutions stage by stage, those of a stage the cheapest first."""
    words = words_of(claim, problem)
    changes = Candidates(Maker(problem.tree, problem.sheets, words)).all()
    singles = [change for change in changes if problem.mends(change)]
    yield _sorted(problem, [(change,) for change in (*singles, *numbers(problem))])
    if (elsewhere := growing(claim, problem, words)) is not problem:
        problem, words = elsewhere, words_of(claim, elsewhere)
        changes = Candidates(Maker(problem.tree, problem.sheets, words)).all()
    homogeneity = Homogeneity(claim, problem, words)
    yield _sorted(problem, [*exchanged(homogeneity), *in_functions(homogeneity)])
    lacking = Missing(homogeneity).changes()
    added = [change for change in lacking if change.mistake is Mistake.MISSING]
    yield _sorted(problem, [(change,) for change in added])
    yield _sorted(problem, pairs(problem, changes))
    yield _sorted(problem, signs(problem))
    many = Several(homogeneity, changes)
    yield _sorted(problem, many.pairs())
    yield _sorted(problem, Both(homogeneity).pairs())
    yield _sorted(problem, Two(homogeneity).pairs())
    groups = whole(claim, problem, statement, words)
    yield _sorted(problem, [*many.all(), *groups])
    yield _sorted(problem, [(change,) for change in lacking if change not in added])


def _sorted(problem: Problem, found: Sequence[tuple[Change, ...]]) -> list[Solution]:
    made = [Solution(problem, changes) for changes in found]

    def size(solution: Solution) -> int:
        """How much stands where something is exchanged: -S is likelier than -(all of a side)."""
        nodes = problem.tree.nodes
        there = (c for c in solution.changes if c.mistake is not Mistake.MISSING)
        return sum(nodes[change.index].depth for change in there)

    return sorted(made, key=lambda solution: (solution.cost, size(solution)))


def words_of(claim: Claim, problem: Problem) -> Words:
    """The words of the scene at the points of a problem."""
    held = []
    for node in problem.tree.nodes:
        if isinstance(node, Name) and node.name not in claim.definitions:
            try:
                held.append(claim.written.naming.symbol(node.name, node.order))
            except KeyError:
                continue  # a rate of a constant has no value anyway
    return Words(claim.truth, claim.written, problem.sheets, {s for s in held if s is not None})
