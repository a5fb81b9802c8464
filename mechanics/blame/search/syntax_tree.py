"""Everything that was written, as a numbered list of nodes with the root first.

    root = left - right,    or one side alone that is compared with a target

A definition stands, as a copy, wherever its name does: an edit of it is one of all its copies.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from mechanics.claims.place import Refused
from mechanics.claims.tree import (
    COMPOSED,
    Call,
    Name,
    Node,
    Number,
    Power,
    Rate,
    Sum,
    constant,
    negative,
    parts,
    with_parts,
)

LARGEST = 2500
"""Nodes with definitions copied in; definitions beyond that stay names."""

Place = tuple[int | str, tuple[int, ...]]
"""Where a node belongs: number of the entry, or name of the definition, and the way down there."""

SYNTHETIC = -1
"""Entry of the nodes that nobody wrote: the difference of two sides."""


@dataclass(eq=False)
class SyntaxTree:
    """Nodes by number.

    Attributes
    ----------
    kept : frozenset of int or str
        Entries and definitions that are not edited.
    parent : list of int
        -1 for the root.
    rates : list of int
        How often a node is differentiated: that of the derivative around it, through sums only.
        Deeper inside 0: there a node alone tells nothing.
    """

    definitions: Mapping[str, Node]
    kept: frozenset[int | str] = frozenset()
    nodes: list[Node] = field(default_factory=list)
    parent: list[int] = field(default_factory=list)
    kids: list[list[int]] = field(default_factory=list)
    place: list[Place] = field(default_factory=list)
    copies: dict[Place, list[int]] = field(default_factory=dict)
    rates: list[int] = field(default_factory=list)

    def add(self, node: Node, parent: int, place: Place, rate: int = 0) -> int:
        """Number a node and all below it.

        Raises
        ------
        Refused
            When an edit has put a name into its own definition.
        """
        index = self._one(node, parent, place, rate)
        if isinstance(node, Name):
            inner = self.definitions.get(node.name)
            if inner is not None and not node.order and index < LARGEST:
                if any(self.place[above] == (node.name, ()) for above in self.ways_up(index)):
                    raise Refused(node.at, f"the definition of {node.name} contains {node.name}")
                self.kids[index].append(self.add(inner, index, (node.name, ())))
            return index
        home, way = place
        below = rate if isinstance(node, Sum) else 0
        if isinstance(node, Rate) and not rate:
            below = node.order
        for i, part in enumerate(parts(node)):
            self.kids[index].append(self.add(part, index, (home, (*way, i)), below))
        return index

    def _one(self, node: Node, parent: int, place: Place, rate: int = 0) -> int:
        self.rates.append(rate)
        self.nodes.append(node)
        self.parent.append(parent)
        self.kids.append([])
        self.place.append(place)
        self.copies.setdefault(place, []).append(len(self.nodes) - 1)
        return len(self.nodes) - 1

    def plant(self, entries: Sequence[tuple[int, Node]]) -> "SyntaxTree":
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

    def size(self, index: int) -> int:
        """How many nodes a node has, itself and what is below it."""
        return 1 + sum(map(self.size, self.kids[index]))

    def written(self, index: int) -> bool:
        """Whether somebody wrote the node, and may have to write it otherwise."""
        home = self.place[index][0]
        return home not in (SYNTHETIC, *self.kept) and self.nodes[index].at != COMPOSED

    def single(self, index: int) -> bool:
        """Whether a node stands at one place only."""
        return len(self.copies[self.place[index]]) == 1

    def plain(self, index: int) -> bool:
        """Whether somebody wrote the node, at one place, and not below d/dt."""
        return self.written(index) and self.single(index) and not self.rates[index]

    def side(self, index: int) -> bool:
        """Whether a node is a whole side, or all of a definition."""
        return not self.place[index][1]

    def term(self, index: int) -> bool:
        """Whether a node is a term of a sum, or a whole side."""
        above = self.parent[index]
        if above < 0 or not self.place[index][1]:
            return True
        return isinstance(self.nodes[above], Sum)

    def opaque(self, index: int) -> bool:
        """Whether a node is known by its value only: its parts are looked at as a whole."""
        node = self.nodes[index]
        return (isinstance(node, Call) and not is_root(node)) or (
            self.rates[index] > 0 and not isinstance(node, Sum)
        )

    def as_told(self, index: int, node: Node) -> Node:
        """What is worth the value of a node: its derivative, where it stands in one."""
        rate = self.rates[index]
        return Rate(node.at, node, rate) if rate else node

    def ways_up(self, index: int) -> list[int]:
        """The node and all above it."""
        found = [index]
        while self.parent[found[-1]] >= 0:
            found.append(self.parent[found[-1]])
        return found


def is_root(node: Node) -> bool:
    """Whether a node is a square root, of which the square tells what it is taken of."""
    if isinstance(node, Power):
        return constant(node.exponent) == Fraction(1, 2)
    return isinstance(node, Call) and node.function == "sqrt"


Way = tuple[int, ...]
Step = Node | None | Callable[[Node], Node]
"""Another node, None for one that is left out, or what is made of the node with its edits."""


def edited(root: Node, steps: Sequence[tuple[Way, Step]]) -> Node:
    """A tree with edits at the ends of some ways down."""
    here = [step for way, step in steps if not way]
    below: dict[int, list[tuple[Way, Step]]] = {}
    for way, step in steps:
        if way:
            below.setdefault(way[0], []).append((way[1:], step))
    node = root
    for step in here:
        if step is None or isinstance(step, Node):
            node = step or Number(root.at, Fraction(0))
    if node is root and below:
        new = [
            edited(part, below[i]) if i in below else part
            for i, part in enumerate(parts(root))
            if ((), None) not in below.get(i, ())
        ]
        node = with_parts(root, tuple(new))
    for step in here:
        if callable(step):
            node = step(node)
    return node
