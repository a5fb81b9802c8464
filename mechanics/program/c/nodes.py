"""C functions into the nodes of a builder, what each operation demands under its conditions."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from mechanics.program.builder import Builder, Node
from mechanics.program.c.condition import Atom, Condition
from mechanics.program.c.function import BEYOND
from mechanics.program.c.select import RELATIONS, truth
from mechanics.program.composed import build
from mechanics.program.operations import LESS, OPERATIONS, SELECT


class Nodes:
    """The target of a reader that is a builder.

    Parameters
    ----------
    arguments : sequence of sequence of Node
        Entries of each argument, in order; empty for integers and outputs.
    meaning : mapping of Fraction to Node, optional
        What literals stand for that are not what they are: 0.333... for a third.
    """

    def __init__(
        self,
        builder: Builder,
        arguments: Sequence[Sequence[Node]],
        meaning: Mapping[Fraction, Node] | None = None,
    ) -> None:
        self.builder, self.arguments, self.meaning = builder, arguments, meaning or {}

    def number(self, value: Fraction, kind: str) -> int:
        """A constant, or what it stands for."""
        node = self.meaning.get(value)
        return self.builder.number_of(value) if node is None else node.number

    def input(self, place: int, entry: int, kind: str) -> int:
        """An entry of an argument."""
        if place == BEYOND:
            return self.builder.input(f"beyond the end of an array, {entry}").number
        return self.arguments[place][entry].number

    def apply(self, operation: str, operands: tuple[int, ...], kind: str) -> int:
        """An operation; 1 / 0 is refused by the builder."""
        nodes = (Node(self.builder, operand) for operand in operands)
        return build(self.builder, operation, *nodes).number

    def constant(self, node: int) -> Fraction | None:
        """The number that a node is."""
        return self.builder.constant_at(node)

    def is_truth(self, node: int) -> bool:
        """Whether it is 0 or 1."""
        return OPERATIONS[self.builder.operations[node]].boolean

    def choose(self, condition: Condition, yes: int, no: int, kind: str, where: Any) -> int:
        """x > 0 ? 1 : (x < 0 ? -1 : x) is sign(x); another choice is a select."""
        if isinstance(condition, bool):
            return yes if condition else no
        holds = truth(self, condition, kind, where)
        if self.constant(no) == 0 and self.constant(yes) == 1 and self.is_truth(holds):
            return holds
        b, (first, second, third) = self.builder, self.builder.operands
        zero, one, minus = b.zero_number, b.one_number, b.number_of(-1)
        if (
            b.operations[holds] == LESS and first[holds] == zero and yes == one
            and b.operations[no] == SELECT and second[no] == minus and third[no] == second[holds]
            and b.operations[first[no]] == LESS
            and (first[first[no]], second[first[no]]) == (second[holds], zero)
        ):  # fmt: skip
            return self.apply("sign", (second[holds],), kind)
        return self.apply("select", (holds, yes, no), kind)

    @contextmanager
    def under(self, condition: Condition) -> Iterator[None]:
        """Demands inside hold where the condition does; what never runs demands nothing."""
        if condition is False:
            before = dict(self.builder.obligations)
            yield
            self.builder.obligations = before
        elif condition is True or not _is_real(condition):
            yield
        else:
            holds = Node(self.builder, truth(self, condition, "", ""))
            with self.builder.under(holds, True):
                yield


def _is_real(condition: Condition) -> bool:
    """Whether it is about real values alone, and not about what a machine makes of them."""
    if isinstance(condition, Atom):
        return condition.relation in RELATIONS
    return isinstance(condition, bool) or all(_is_real(part) for part in condition.parts)
