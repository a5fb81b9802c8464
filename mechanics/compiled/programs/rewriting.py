"""A routine rewritten node by node, in the order of evaluation."""

from collections.abc import Sequence
from fractions import Fraction

from mechanics.program.operations import CONSTANT, INPUT
from mechanics.program.routine import Node, Routine, Shapes, Sizes, routine


class Rewriting:
    """New nodes as they are made, and what became of the old ones.

    Attributes
    ----------
    nodes : list of Node
        The new ones.
    of : dict of int to int
        For an old node the new one that has its value.
    """

    def __init__(self, old: Sequence[Node]) -> None:
        self._old = old
        self.nodes: list[Node] = []
        self.of: dict[int, int] = {}
        self._one: int | None = None

    def add(self, operation: int, *operands: int) -> int:
        """Append a node; its operands are new ones, those of an input its array and entry."""
        self.nodes.append(Node(operation, operands))
        return len(self.nodes) - 1

    def one(self) -> int:
        """The constant 1."""
        if self._one is None:
            self.nodes.append(Node(CONSTANT, (), Fraction(1)))
            self._one = len(self.nodes) - 1
        return self._one

    def keep(self, k: int) -> int:
        """An old node as it was."""
        node = self._old[k]
        if node.operation != INPUT:
            node = node._replace(operands=tuple(self.of[i] for i in node.operands))
        self.nodes.append(node)
        self.of[k] = len(self.nodes) - 1
        return self.of[k]

    def routine(
        self, like: Routine, name: str = "", inputs: Sizes = (), shapes: Shapes = ()
    ) -> Routine:
        """The routine whose outputs have the values of those of the old one."""
        outputs = [[self.of[k] for k in entries] for entries in like.outputs]
        return routine(
            name or like.name, self.nodes, outputs, inputs or like.inputs, shapes or like.shapes
        )
