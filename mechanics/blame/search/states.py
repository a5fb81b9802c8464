"""Two edits in one term where two states are compared, one of them the same at both.

slope has (a b - 1) at one state - at the other = needed        a: ratio of a number or parameter

g cos(theta) for g**2 sin(theta): every edit b asks for one ratio a, which is looked up.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence

from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import InsideHere
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.claims.tree import Product, Sum
from mechanics.kernel.field import DivisionHere

Entry = tuple[int, tuple[int, ...], Change]
"""Below which factor it is, the ratio of the term at each state, the edit."""


def in_one_term(problem: Problem, changes: Sequence[Change]) -> Iterator[tuple[Change, Change]]:
    """Pairs of edits in two factors of one term."""
    entries: dict[int, list[Entry]] = defaultdict(list)
    for change in changes:
        if problem.tree.single(change.at):
            for index, entry in _on_the_way(problem, change):
                entries[index].append(entry)
    for index, here in entries.items():
        slopes = problem.slopes(index) if len(here) > 1 else None
        if slopes is not None:
            yield from _meeting(problem, index, slopes, here)


def _on_the_way(problem: Problem, change: Change) -> Iterator[tuple[int, Entry]]:
    """The products above an edit, up to the term that it stands in."""
    tree, p = problem.tree, problem.prime
    child, values = change.at, change.values
    while (above := tree.parent[child]) >= 0 and not isinstance(tree.nodes[above], Sum):
        try:
            pairs = zip(problem.sheets, values, strict=True)
            values = tuple(sheet.above(above, {child: value}) for sheet, value in pairs)
        except (DivisionHere, InsideHere):
            return
        has = [sheet.has[above] for sheet in problem.sheets]
        if isinstance(tree.nodes[above], Product) and all(has) and any(values):
            ratios = tuple(v * pow(h, -1, p) % p for v, h in zip(values, has, strict=True))
            yield above, (child, ratios, change)
        child = above


def _meeting(
    problem: Problem, index: int, slopes: Sequence[int], here: Sequence[Entry]
) -> Iterator[tuple[Change, Change]]:
    p = problem.prime
    one, two = (s * sheet.has[index] % p for s, sheet in zip(slopes, problem.sheets, strict=True))
    needed = (one - two - problem.residual) % p
    same: dict[int, list[tuple[int, Change]]] = defaultdict(list)
    for child, ratios, change in here:
        if ratios[0] == ratios[1]:
            same[ratios[0]].append((child, change))
    for child, ratios, change in here:
        whole = (ratios[0] * one - ratios[1] * two) % p
        if whole and ratios[0] != ratios[1]:
            for other, partner in same.get(needed * pow(whole, -1, p) % p, ()):
                if other != child:
                    yield change, partner
