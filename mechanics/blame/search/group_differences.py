"""Where no small edit helps: what is missing, group by group, as the difference to what is right.

right = written + sum over groups of (right terms - written terms)
"""

from collections.abc import Iterator, Sequence

from sympy import Add, Expr, S, cancel, factor_terms, powsimp

from mechanics.blame.difference import Group, groups
from mechanics.blame.result import Mistake
from mechanics.blame.search.change import ADDED, HINT, REPLACED, Change
from mechanics.blame.search.claim import Claim
from mechanics.blame.search.edits import added, worth
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.words import Words
from mechanics.blame.terms import difference, written
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Name, Sum, constant
from mechanics.scene.quantities import MassMatrix, ReactionValue

MOST = 3
"""Groups; more of them are another equation."""

LARGEST = 60
"""Nodes of an equation of which a whole side is told."""


def whole(
    claim: Claim, problem: Problem, statement: Statement, words: Words
) -> list[tuple[Change, ...]]:
    """A term for each group that differs, all of them together; empty where they are many."""
    if len(claim.entries) > 2 or isinstance(claim.row.quantity, MassMatrix):
        return []
    found = groups(claim.reference, statement)
    if not 0 < len(found) <= MOST or any(group.multiplied for group in found):
        return []
    first, *others = (problem.tree.copies[k, ()][0] for k in problem.numbers)
    left = problem.tree.nodes[first]
    if isinstance(left, Name) and any(group.about is not None for group in found):
        return _side(claim, problem, found, others)
    if problem.numbers[0] in claim.kept:
        return []
    # What m x'' = F lacks is a force.
    forces = [k for k in others if constant(problem.tree.nodes[k]) != 0]
    force = not any(words.quadratic(t) for g in found for t in Add.make_args(_step(claim, g)))
    place = forces[0] if forces and force and words.accelerates(left) else first
    changes = list(_changes(claim, problem, found, place, -1 if place != first else 1))
    return [tuple(changes)] if len(changes) == len(found) else []


def _side(
    claim: Claim, problem: Problem, found: tuple[Group, ...], others: Sequence[int]
) -> list[tuple[Change, ...]]:
    """One term in place of one: of x'' = a, where c x'' = a is right, it is a/c."""
    if len(others) != 1:
        return []
    tree, index, group = problem.tree, others[-1], found[0]
    while isinstance(tree.nodes[index], Name) and tree.kids[index]:  # what a definition says
        (index,) = tree.kids[index]
    one = len(found) == 1 and tree.single(index) and tree.written(index)
    if not one or isinstance(tree.nodes[index], Sum) or len(tree.nodes) > LARGEST:
        return []
    factor = written(group.written) / written(group.right)
    side = powsimp(factor_terms(cancel(factor * problem.sheets[0].builder(tree.nodes[index]))))
    try:
        new = claim.written.tree(side)
    except Untreeable:
        return []
    worths = worth(problem.sheets, new)
    if worths is None or isinstance(new, Sum):
        return []
    return [(Change(index, new, Mistake.TERM, REPLACED, index, worths),)]


def _changes(
    claim: Claim, problem: Problem, found: tuple[Group, ...], index: int, sign: int
) -> Iterator[Change]:
    for group in found:
        try:
            term = claim.written.tree(sign * _step(claim, group))
        except Untreeable:
            return
        mistake = Mistake.TERM if group.written else Mistake.MISSING
        # What replaces a term may be a long sum.
        count = len(difference(group.right, group.written))
        cost = max(REPLACED, ADDED * (count - 1)) if group.written else ADDED + HINT
        change = added(problem, index, term, cost, mistake)
        if change is None:
            return
        yield change


def _step(claim: Claim, group: Group) -> Expr:
    step = factor_terms(written(difference(group.right, group.written)))
    sign = S.NegativeOne if isinstance(claim.row.quantity, ReactionValue) else S.One
    return sign * step * (S.One if group.about is None else group.about)
