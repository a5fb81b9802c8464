"""A program rewritten node by node, in the order of evaluation."""

from collections.abc import Sequence
from dataclasses import replace

import casadi as ca

from mechanics.compiled.programs.program import Node, Program


class Rewriting:
    """New nodes as they are made, and what became of the old ones.

    Parameters
    ----------
    old : sequence of Node

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

    def add(self, node: Node) -> int:
        """Append a node; its operands are new ones."""
        self.nodes.append(node)
        return len(self.nodes) - 1

    def keep(self, k: int) -> int:
        """An old node as it was."""
        node = self._old[k]
        if node.constant is None and node.operation != ca.OP_INPUT:
            node = node._replace(operands=tuple(self.of[i] for i in node.operands))
        self.of[k] = self.add(node)
        return self.of[k]

    def program(self, like: Program) -> Program:
        """The program whose outputs have the values of those of the old one."""
        outputs = tuple(tuple(self.of[k] for k in entries) for entries in like.outputs)
        return replace(like, nodes=tuple(self.nodes), outputs=outputs)
