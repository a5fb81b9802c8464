"""A bracket that was opened with the wrong sign: three terms of a sum or more are turned.

has - 2 * (sum of the turned terms) = needed

The sums of all choices among one half of the terms are looked up in what the other half leaves.
"""

from collections.abc import Iterator, Sequence

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import TOKEN, Change, minus
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.claims.tree import Sum

FEWEST, MOST = 3, 18
"""Terms: two are a pair of edits; of more there are too many choices."""

EACH = 0.6 * TOKEN
"""What a term costs that is turned together with others."""


def signs(problem: Problem) -> list[tuple[Change, ...]]:
    """Sets of terms that make a statement right with the other sign, the smaller of two that do."""
    return list(_found(problem)) if problem.plain else []


def _found(problem: Problem) -> Iterator[tuple[Change, ...]]:
    (sheet,) = problem.sheets
    tree, p = problem.tree, problem.prime
    half = pow(2, -1, p)
    for index, node in enumerate(tree.nodes):
        kids, need = tree.kids[index], sheet.needs[index]
        if not isinstance(node, Sum) or need is None or not tree.written(index):
            continue
        if not FEWEST < len(kids) <= MOST or not tree.single(index):
            continue
        wanted = (sheet.has[index] - need) * half % p
        for chosen in _choices([sheet.has[kid] for kid in kids], wanted, p):
            if FEWEST <= len(chosen) < len(kids):
                yield tuple(_turned(problem, kids[i]) for i in chosen)


def _choices(values: Sequence[int], wanted: int, p: int) -> Iterator[tuple[int, ...]]:
    """Places of values whose sum is wanted."""
    middle = len(values) // 2
    known: dict[int, list[tuple[int, ...]]] = {}
    for total, places in _sums(values[:middle], 0, p):
        known.setdefault(total, []).append(places)
    for total, places in _sums(values[middle:], middle, p):
        for first in known.get((wanted - total) % p, ()):
            yield (*first, *places)


def _sums(values: Sequence[int], start: int, p: int) -> list[tuple[int, tuple[int, ...]]]:
    """The sum of every choice of values, with their places."""
    found: list[tuple[int, tuple[int, ...]]] = [(0, ())]
    for place, value in enumerate(values, start):
        found += [((total + value) % p, (*places, place)) for total, places in found]
    return found


def _turned(problem: Problem, index: int) -> Change:
    values = tuple(-sheet.has[index] % problem.prime for sheet in problem.sheets)
    node = minus(problem.tree.nodes[index])
    return Change(index, node, Mistake.SIGN, EACH, index, values, minus)
