"""Everything that was written, as a numbered list of nodes with the root first.

    root = left - right,    or one side alone that is compared with a target

A definition stands, as a copy, wherever its name does: an edit of it is one of all its copies.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from mechanics.reading.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    negative,
    parts,
)

LARGEST = 2500
"""Nodes with definitions copied in; definitions beyond that stay names."""

Place = tuple[int | str, tuple[int, ...]]
"""Where a node belongs: number of the entry, or name of the definition, and the way down there."""

SYNTHETIC = -1
"""Entry of the nodes that nobody wrote: the difference of two sides."""


@dataclass(eq=False)
class Forest:
    """Nodes by number.

    Attributes
    ----------
    definitions : mapping of str to Node
    nodes : list of Node
    parent : list of int
        -1 for the root.
    kids : list of list of int
    place : list of Place
    copies : dict of Place to list of int
    """

    definitions: Mapping[str, Node]
    nodes: list[Node] = field(default_factory=list)
    parent: list[int] = field(default_factory=list)
    kids: list[list[int]] = field(default_factory=list)
    place: list[Place] = field(default_factory=list)
    copies: dict[Place, list[int]] = field(default_factory=dict)

    def add(self, node: Node, parent: int, place: Place) -> int:
        """Number a node and all below it."""
        index = self._one(node, parent, place)
        if isinstance(node, Name):
            inner = self.definitions.get(node.name)
            if inner is not None and not node.order and index < LARGEST:
                self.kids[index].append(self.add(inner, index, (node.name, ())))
            return index
        home, way = place
        for i, part in enumerate(parts(node)):
            self.kids[index].append(self.add(part, index, (home, (*way, i))))
        return index

    def _one(self, node: Node, parent: int, place: Place) -> int:
        self.nodes.append(node)
        self.parent.append(parent)
        self.kids.append([])
        self.place.append(place)
        self.copies.setdefault(place, []).append(len(self.nodes) - 1)
        return len(self.nodes) - 1

    def plant(self, entries: Sequence[tuple[int, Node]]) -> "Forest":
        """Number one entry, or the difference of two."""
        (number, left), *rest = entries
        if not rest:
            self.add(left, -1, (number, ()))
            return self
        ((other, right),) = rest
        root = self._one(Sum(0, (left, right)), -1, (SYNTHETIC, ()))
        self.kids[root].append(self.add(left, root, (number, ())))
        minus = self._one(negative(right), root, (SYNTHETIC, (1,)))
        self.kids[root].append(minus)
        one = Number(0, Fraction(-1))
        self.kids[minus].append(self.add(one, minus, (SYNTHETIC, (1, 0))))
        self.kids[minus].append(self.add(right, minus, (other, ())))
        return self

    def written(self, index: int) -> bool:
        """Whether somebody wrote the node."""
        return self.place[index][0] != SYNTHETIC

    def single(self, index: int) -> bool:
        """Whether a node stands at one place only."""
        return len(self.copies[self.place[index]]) == 1

    def term(self, index: int) -> bool:
        """Whether a node is a term of a sum, or a whole side."""
        above = self.parent[index]
        if above < 0 or not self.place[index][1]:
            return True
        return isinstance(self.nodes[above], Sum)

    def ways_up(self, index: int) -> list[int]:
        """The node and all above it."""
        found = [index]
        while self.parent[found[-1]] >= 0:
            found.append(self.parent[found[-1]])
        return found


def edited(root: Node, changes: Mapping[tuple[int, ...], Node | None]) -> Node:
    """A tree with other nodes at the ends of some ways down; None leaves a term or factor out."""
    if () in changes:
        return changes[()] or Number(root.at, Fraction(0))
    below: dict[int, dict[tuple[int, ...], Node | None]] = {}
    for (first, *rest), node in changes.items():
        below.setdefault(first, {})[tuple(rest)] = node
    if not below:
        return root
    new: list[Node] = []
    for i, part in enumerate(parts(root)):
        if i in below and below[i].get((), part) is None:
            continue
        new.append(edited(part, below[i]) if i in below else part)
    return with_parts(root, tuple(new))


def with_parts(node: Node, new: tuple[Node, ...]) -> Node:
    """A node of the same kind with other parts; it stands where the old one stood."""
    match node:
        case Sum() | Product():
            empty = Number(node.at, Fraction(0 if isinstance(node, Sum) else 1))
            if len(new) < 2:
                return new[0] if new else empty
            return type(node)(node.at, new)
        case Power():
            return Power(node.at, *new)
        case Call(function=function):
            return Call(node.at, function, new)
        case Rate(order=order):
            return Rate(node.at, new[0], order)
        case Table(rows=rows):
            width = len(rows[0])
            return Table(node.at, tuple(new[i : i + width] for i in range(0, len(new), width)))
    return node
