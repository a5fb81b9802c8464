"""Definitions that can be read in two ways: as the terms of one have one dimension.

L = 1/2m v^2 - m g z      1/(2 m v^2) is no energy: (1/2) m v^2, also where L is used
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.definitions import defines
from mechanics.claims.dimension import dimension
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, Sum, parts
from mechanics.scene.unit_names import Dimension, dimension_of_unit

ENERGY = dimension_of_unit("kg*m^2/s^2", "")


def dimensionally_consistent(lines: Sequence[Entry], naming: Naming) -> list[Entry]:
    """The lines; a definition whose first reading mixes dimensions has the first that does not.

    What judges a definition by itself looks at all its readings; what uses it knows only one.
    """
    return [
        _chosen(line, naming)
        if isinstance(line, Line) and line.others and defines(line, naming)
        else line
        for line in lines
    ]


def _chosen(line: Line, naming: Naming) -> Line:
    if _agree(line.sides, naming):
        return line
    for words, sides in line.others:
        if _agree(sides, naming):
            note = f"{words.partition(': ')[0]}: as it is, dimensions do not agree"
            return replace(line, sides=sides, others=(), notes=(*line.notes, note))
    return line


def _agree(sides: Sequence[Node], naming: Naming) -> bool:
    """Whether all that is added or equal has one dimension, as far as that is known."""
    left, *rest = sides
    energy = isinstance(left, Name) and left.name in ENERGY_NAMES
    whole = [dimension(naming, side) for side in rest]
    groups = [[*whole, *([ENERGY] if energy else [])], *_sums(rest, naming)]
    return all(len({one for one in group if one is not None}) < 2 for group in groups)


def _sums(nodes: Sequence[Node], naming: Naming) -> Iterator[list[Dimension | None]]:
    for node in nodes:
        if isinstance(node, Sum):
            yield [dimension(naming, term) for term in node.terms]
        yield from _sums(parts(node), naming)
