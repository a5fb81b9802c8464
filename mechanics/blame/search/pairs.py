"""Two edits at once, found where their ways up meet.

    at a sum:      change of one term + change of another = needed - has
    at a product:  ratio of one factor * ratio of another = needed / has

Every edit is entered at every node above it with what it does there; its partner is looked up.
"""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import InsideHere, Sheet
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.residues import inverses
from mechanics.blame.search.states import in_one_term
from mechanics.claims.tree import Product, Sum
from mechanics.kernel.field import DivisionHere

MOST = 60
"""Pairs that are kept, the cheapest first."""

Entry = tuple[int, int, Change]
"""Below which part of the node it is, what the part becomes, the edit."""


def pairs(problem: Problem, changes: Sequence[Change]) -> list[tuple[Change, Change]]:
    """Pairs of edits that make a statement right, the cheapest first."""
    if not problem.plain:
        found = [*_at_root(problem, changes), *in_one_term(problem, changes)]
    else:
        found = list(_where_they_meet(problem, changes))
    found.sort(key=lambda pair: pair[0].cost + pair[1].cost)
    return found[:MOST]


def _where_they_meet(
    problem: Problem, changes: Sequence[Change]
) -> Iterator[tuple[Change, Change]]:
    (sheet,) = problem.sheets
    tree = problem.tree
    entries: dict[int, list[Entry]] = defaultdict(list)
    reached: dict[int, dict[int, list[Change]]] = defaultdict(lambda: defaultdict(list))
    for change in changes:
        if not tree.single(change.at):
            continue
        way = chain([(change.at, change.values[0])], sheet.climb(change.at, change.values[0]))
        try:
            for child, value in way:
                above = tree.parent[child]
                if above >= 0 and isinstance(tree.nodes[above], Sum | Product):
                    entries[above].append((child, value, change))
                reached[child][value].append(change)
        except (DivisionHere, InsideHere):
            continue
    for change in changes:
        if change.wrap is not None and tree.single(change.at):
            yield from _around(sheet, change, reached[change.index])
    for index, here in entries.items():
        for need in sheet.needed(index):
            if need == sheet.has[index]:
                continue
            if isinstance(tree.nodes[index], Sum):
                yield from _added(sheet, need - sheet.has[index], here)
            elif sheet.has[index]:
                yield from _multiplied(sheet, index, need, here)


def _around(
    sheet: Sheet, outer: Change, reached: Mapping[int, Sequence[Change]]
) -> Iterator[tuple[Change, Change]]:
    """A sign, factor or term around a node, and an edit in it."""
    p, index = sheet.point.prime, outer.index
    need, has, value = sheet.needs[index], sheet.has[index], outer.values[0]
    if need is None or not has:
        return
    if outer.mistake is Mistake.MISSING:
        wanted = (need - value + has) % p
    elif value:
        wanted = need * has * pow(value, -1, p) % p
    else:
        return
    for inner in reached.get(wanted, ()):
        if inner.wrap is None or inner.index != index:
            yield inner, outer


def _added(sheet: Sheet, missing: int, here: Sequence[Entry]) -> Iterator[tuple[Change, Change]]:
    p = sheet.point.prime
    known: dict[int, list[tuple[int, Change]]] = defaultdict(list)
    for child, value, change in here:
        step = (value - sheet.has[child]) % p
        for other, partner in known.get((missing - step) % p, ()):
            if other != child:
                yield partner, change
        known[step].append((child, change))


def _multiplied(
    sheet: Sheet, index: int, need: int, here: Sequence[Entry]
) -> Iterator[tuple[Change, Change]]:
    p = sheet.point.prime
    inverse = {kid: pow(sheet.has[kid], -1, p) for kid in sheet.tree.kids[index] if sheet.has[kid]}
    wanted = need * pow(sheet.has[index], -1, p) % p
    known: dict[int, list[tuple[int, Change]]] = defaultdict(list)
    for child, value, change in here:
        if value and child in inverse:
            known[value * inverse[child] % p].append((child, change))
    for one, (_, group) in zip(inverses(list(known), p), known.items(), strict=True):
        partners = known.get(wanted * one % p, ())
        for child, change in group:
            for other, partner in partners:
                if other < child:
                    yield partner, change


def _at_root(problem: Problem, changes: Sequence[Change]) -> Iterator[tuple[Change, Change]]:
    """Where two points are needed the edits meet at the root only."""
    p, missing = problem.prime, -problem.residual
    known: dict[int, list[Change]] = defaultdict(list)
    for change in changes:
        try:
            step = (problem.residual_with([change]) - problem.residual) % p
        except (DivisionHere, InsideHere):
            continue
        for partner in known.get((missing - step) % p, ()):
            if problem.together([partner, change]):
                yield partner, change
        known[step].append(change)
