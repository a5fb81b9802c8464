"""What is left when some edits are made: the single edit or the pair of edits that mends it.

values with the edits  ->  needs, from the root down  ->  the same questions as for one error or two
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from mechanics.blame.search.change import Change
from mechanics.blame.search.cover import adds
from mechanics.blame.search.inverse_evaluation import InsideHere, Sheet, again
from mechanics.blame.search.pairs import pairs
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.kernel.field import DivisionHere

MOST = 3
"""Pairs that are told."""


def completed(
    problem: Problem, made: Sequence[Change], changes: Sequence[Change]
) -> Iterator[tuple[Change, ...]]:
    """Edits that were made, with one or two more that make all of it right."""
    after = _with(problem, made)
    if after is None:
        return
    other = _elsewhere(problem, made, changes)
    for change in other:
        if after.mends(change):
            yield (*made, change)
    for pair in pairs(after, other)[:MOST]:
        yield (*made, *pair)


def _with(problem: Problem, made: Sequence[Change]) -> Problem | None:
    """The problem with edits put in; None where something is divided by zero."""
    try:
        sheets = tuple(_values(sheet, made, k) for k, sheet in enumerate(problem.sheets))
    except (DivisionHere, InsideHere):
        return None
    return replace(problem, sheets=sheets)


def _values(sheet: Sheet, made: Sequence[Change], k: int) -> Sheet:
    now = replace(sheet, has=list(sheet.has))
    for change in made:
        child, value = change.at, change.values[k]
        if adds(change):
            value = now.has[child] + value - sheet.has[child]
        while (above := sheet.tree.parent[child]) >= 0:
            upper = now.above(above, {child: value})
            now.has[child] = value
            child, value = above, upper
        now.has[child] = value
    return again(now)


def _elsewhere(problem: Problem, made: Sequence[Change], changes: Sequence[Change]) -> list[Change]:
    """Edits that do not stand in those that were made, nor around them."""
    tree = problem.tree
    inside: set[int] = set()
    around: set[int] = set()
    for change in made:
        around.update(tree.ways_up(change.at))
        if not adds(change):
            inside.add(change.at)
    for index in range(len(tree.nodes)):
        if tree.parent[index] in inside:
            inside.add(index)  # what stands below has a larger number
    return [c for c in changes if c.at not in inside and (adds(c) or c.at not in around)]
