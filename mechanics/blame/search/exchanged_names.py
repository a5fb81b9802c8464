"""Two names that are exchanged wherever they stand, or within one sum: A for C and C for A.

    A x'' + C y'' -> C x'' + A y''        (C sin^2 + A cos^2) x' -> (A sin^2 + C cos^2) x'

The edits are put in together, and the statement is valued anew.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations, islice

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import HINT, SECOND, TOKEN, Change
from mechanics.blame.search.claim import edited_claim, posed
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.blame.search.words import Word
from mechanics.claims.place import Refused
from mechanics.claims.tree import Name, Sum
from mechanics.kernel.field import Inadmissible

MOST = 12
"""Pairs of names that are tried."""


def exchanged(homogeneity: Homogeneity) -> list[tuple[Change, ...]]:
    """Edits that exchange two names of one kind, and make the statement right."""
    pairs = islice(_pairs(homogeneity), MOST)
    found = [changes for one, other in pairs for changes in _changes(homogeneity, one, other)]
    found = [changes for changes in found if mends(homogeneity, changes)]
    together = homogeneity.problem.together
    return [*found, *(changes for changes in _definitions(homogeneity) if together(changes))]


def _definitions(homogeneity: Homogeneity) -> Iterator[tuple[Change, ...]]:
    """What two definitions say, exchanged: s = cos(x), c = sin(x)."""
    tree, sheets = homogeneity.problem.tree, homogeneity.problem.sheets
    roots = [copies[0] for (_, way), copies in tree.copies.items() if not way]
    roots = [index for index in roots if isinstance(tree.place[index][0], str)]
    for pair in combinations([index for index in roots if tree.written(index)], 2):
        yield tuple(
            Change(
                index, tree.nodes[other], Mistake.SYMBOL, (TOKEN + SECOND) / 2, index,
                tuple(sheet.has[other] for sheet in sheets),
            )
            for index, other in (pair, pair[::-1])
        )  # fmt: skip


def _pairs(homogeneity: Homogeneity) -> Iterator[tuple[Word, Word]]:
    """Parameters of one unit, coordinates; both of a pair were written."""
    held = set(homogeneity.words.held)
    words = [w for w in homogeneity.words.symbols if w.symbol in held and w.kind != "acceleration"]
    for one, other in combinations(words, 2):
        if one.kind == other.kind and one.name.order == other.name.order == 0:
            yield one, other


def _changes(homogeneity: Homogeneity, one: Word, other: Word) -> Iterator[tuple[Change, ...]]:
    """One edit for each place, of all and of those in a sum: a name with its dots."""
    tree = homogeneity.problem.tree
    turned = {one.name.name: other.name.name, other.name.name: one.name.name}
    places = [
        (index, node)
        for index, node in enumerate(tree.nodes)
        if isinstance(node, Name) and node.name in turned and tree.written(index)
        and tree.copies[tree.place[index]][0] == index
    ]  # fmt: skip
    if any(tree.kids[index] for index, _ in places):
        return
    sums = [i for i, node in enumerate(tree.nodes) if isinstance(node, Sum) and tree.parent[i] > 0]
    inside = [tuple(p for p in places if _below(tree, p[0], i)) for i in sums[:MOST]]
    for group in dict.fromkeys((tuple(places), *inside)):
        both = len({node.name for _, node in group}) == 2
        if both or (group == tuple(places) and len(group) > 1):
            cost = (TOKEN + SECOND + HINT) / len(group)
            zero = (0,) * len(homogeneity.problem.sheets)  # they are valued all together
            yield tuple(
                Change(
                    index, replace(node, name=turned[node.name]), Mistake.SYMBOL, cost, index, zero
                )
                for index, node in group
            )


def _below(tree: SyntaxTree, index: int, above: int) -> bool:
    while index > above:
        index = tree.parent[index]
    return index == above


def mends(homogeneity: Homogeneity, changes: tuple[Change, ...]) -> bool:
    """Whether a statement is right at its points with edits, which are put in together."""
    problem = homogeneity.problem
    claim = edited_claim(homogeneity.claim, [(problem.tree, change) for change in changes])
    families = [sheet.point.family for sheet in problem.sheets]
    try:
        return posed(claim, problem.numbers, problem.target, families).residual == 0
    except (Inadmissible, Refused):
        return False
