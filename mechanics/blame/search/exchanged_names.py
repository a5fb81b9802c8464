"""Two names that are exchanged wherever they stand: A for C and C for A, theta_1 for theta_2.

The edits are put in together, and the statement is valued anew.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations, islice

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import HINT, TOKEN, Change
from mechanics.blame.search.claim import edited_claim, posed
from mechanics.blame.search.homogeneity_test import Growth
from mechanics.blame.search.words import Word
from mechanics.claims.tree import Name
from mechanics.kernel.field import Inadmissible

MOST = 12
"""Pairs of names that are tried."""


def exchanged(growth: Growth) -> list[tuple[Change, ...]]:
    """Edits that exchange two names of one kind, and make the statement right."""
    pairs = islice(_pairs(growth), MOST)
    found = [changes for one, other in pairs if (changes := _changes(growth, one, other))]
    return [changes for changes in found if _mends(growth, changes)]


def _pairs(growth: Growth) -> Iterator[tuple[Word, Word]]:
    """Parameters of one unit, coordinates; both of a pair were written."""
    held = set(growth.words.held)
    words = [w for w in growth.words.symbols if w.symbol in held and w.kind != "acceleration"]
    for one, other in combinations(words, 2):
        if one.kind == other.kind and one.name.order == other.name.order == 0:
            yield one, other


def _changes(growth: Growth, one: Word, other: Word) -> tuple[Change, ...]:
    """One edit for each place: a name with its dots."""
    forest = growth.problem.forest
    turned = {one.name.name: other.name.name, other.name.name: one.name.name}
    places = [
        (index, node)
        for index, node in enumerate(forest.nodes)
        if isinstance(node, Name) and node.name in turned and forest.written(index)
        and forest.copies[forest.place[index]][0] == index
    ]  # fmt: skip
    if len(places) < 2 or any(forest.kids[index] for index, _ in places):
        return ()
    cost = 2 * TOKEN / len(places) + HINT
    zero = (0,) * len(growth.problem.sheets)  # they are valued all together
    return tuple(
        Change(index, replace(node, name=turned[node.name]), Mistake.SYMBOL, cost, index, zero)
        for index, node in places
    )


def _mends(growth: Growth, changes: tuple[Change, ...]) -> bool:
    problem = growth.problem
    claim = edited_claim(growth.claim, [(problem.forest, change) for change in changes])
    families = [sheet.point.family for sheet in problem.sheets]
    try:
        return posed(claim, problem.numbers, problem.target, families).residual == 0
    except Inadmissible:
        return False
