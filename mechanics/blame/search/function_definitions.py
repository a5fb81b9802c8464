"""Edits of a definition that stands in a function, where no value tells what it has to be.

delta = theta_2' - theta_1',    sin(delta), cos(delta)    ->    delta = theta_2 - theta_1

The edits are put in one after the other, and the statement is valued anew.
"""

from collections.abc import Iterator
from itertools import islice

from mechanics.blame.search.change import Change
from mechanics.blame.search.exchanged_names import mends
from mechanics.blame.search.function_arguments import Inside
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.claims.tree import Call

MOST = 80
"""Edits that are tried."""


def in_functions(homogeneity: Homogeneity) -> list[tuple[Change, ...]]:
    """Single edits of such definitions that make the statement right."""
    changes = islice(_changes(homogeneity), MOST)
    return [(change,) for change in changes if mends(homogeneity, (change,))]


def _changes(homogeneity: Homogeneity) -> Iterator[Change]:
    tree = homogeneity.problem.tree
    inside = Inside(tree, homogeneity.words)
    zero = (0,) * len(homogeneity.problem.sheets)  # they are valued with the statement
    for index in range(len(tree.nodes)):
        place = tree.place[index]
        above = any(tree.opaque(k) for k in tree.ways_up(index)[1:])
        if place[1] or not above or tree.copies[place][0] != index or not tree.written(index):
            continue
        around = Call(0, "", (tree.nodes[index],))
        for below, node, mistake, cost in (
            *inside.edits(index, tree.nodes[index], around),
            *inside.of(index),
        ):
            yield Change(below, node, mistake, cost, below, zero)
