"""Edits of nodes: a node in place of another, or around it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from sympy.matrices import MatrixBase

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import Change, Wrap, plus
from mechanics.blame.search.inverse_evaluation import Sheet
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.blame.search.words import Words
from mechanics.claims.place import Refused
from mechanics.claims.tree import Node
from mechanics.errors import MechanicsError


@dataclass(frozen=True, eq=False)
class Maker:
    """Makes edits."""

    tree: SyntaxTree
    sheets: tuple[Sheet, ...]
    words: Words

    @property
    def p(self) -> int:
        """The modulus."""
        return self.sheets[0].point.prime

    def has(self, index: int) -> tuple[int, ...]:
        """What a node is worth at each point."""
        return tuple(sheet.has[index] for sheet in self.sheets)

    def around(self, index: int) -> Node | None:
        """The node that a node is a part of; None for the root."""
        above = self.tree.parent[index]
        return self.tree.nodes[above] if above >= 0 else None

    def change(
        self, index: int, node: Node | None, mistake: Mistake, cost: float, values: tuple[int, ...]
    ) -> Change:
        """Something else, or nothing, in place of a node."""
        return Change(index, node, mistake, cost, index, values)

    def wrapped(
        self, index: int, wrap: Wrap, mistake: Mistake, cost: float, values: tuple[int, ...]
    ) -> Change:
        """Something around a node, which goes together with edits in it."""
        node = wrap(self.tree.nodes[index])
        return Change(index, node, mistake, cost, index, values, wrap)


def worth(sheets: Sequence[Sheet], node: Node) -> tuple[int, ...] | None:
    """What a node is worth at each point; None where it has no value, or is a matrix."""
    try:
        value = sheets[0].builder(node)
        if isinstance(value, MatrixBase):
            return None
        return tuple(sheet.point.value(value) for sheet in sheets)
    except (MechanicsError, Refused):
        return None


def added(
    problem: Problem, index: int, term: Node, cost: float, mistake: Mistake = Mistake.MISSING
) -> Change | None:
    """A term added to a node; None where it has no value."""
    worths = worth(problem.sheets, term)
    if worths is None:
        return None
    wrap = partial(plus, term)
    values = tuple(
        (sheet.has[index] + value) % problem.prime
        for sheet, value in zip(problem.sheets, worths, strict=True)
    )
    return Change(index, wrap(problem.tree.nodes[index]), mistake, cost, index, values, wrap)
