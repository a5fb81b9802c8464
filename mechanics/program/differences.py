"""Differences that are opposite to each other, computed once.

    p = c (x - y),  q = d (y - x)        ->        z = x - y,  p = c z,  q = -(d z)

A sign is carried along with each value and written where it is needed: most are taken up by a sum.
Roundings are the same, for a change of sign has none.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple

from mechanics.program.builder import Builder, Node
from mechanics.program.interpret import Nodes, interpret
from mechanics.program.program import Program


def with_one_difference(program: Program) -> Program:
    """The same program, of two opposite differences the first alone; it holds no linear systems.

    Raises
    ------
    ExpressionError
        If it holds a linear system.
    """
    builder = Builder()
    given = {name: _Signed(builder.input(name)) for name in program.inputs}
    outputs = interpret(program, _Signs(Nodes(builder)), given, release=False)
    written = {name: [value.written for value in values] for name, values in outputs.items()}
    other = builder.program(written, program.inputs)
    return other if other.count < program.count else program


class _Signed(NamedTuple):
    """A node, or what is opposite to it."""

    node: Node
    opposite: bool = False

    @property
    def written(self) -> Node:
        return -self.node if self.opposite else self.node


@dataclass(frozen=True)
class _Signs:
    """The domain of nodes with signs."""

    nodes: Nodes
    differences: dict[tuple[Node, Node], Node] = field(default_factory=dict)

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        def calling(function: Callable[..., Node]) -> Callable[..., _Signed]:
            return lambda *operands: _Signed(function(*(value.written for value in operands)))

        every = {name: calling(function) for name, function in self.nodes.operations.items()}
        return every | {
            "negate": self._negate,
            "add": self._add,
            "subtract": lambda a, b: self._add(a, self._negate(b)),
            "multiply": lambda a, b: _Signed(a.node * b.node, a.opposite != b.opposite),
            "divide": lambda a, b: _Signed(a.node / b.node, a.opposite != b.opposite),
        }

    def constant(self, value: Fraction) -> _Signed:
        return _Signed(self.nodes.constant(value))

    def pi(self) -> _Signed:
        return _Signed(self.nodes.pi())

    def _negate(self, a: _Signed) -> _Signed:
        return _Signed(a.node, not a.opposite)

    def _add(self, a: _Signed, b: _Signed) -> _Signed:
        if a.opposite == b.opposite:
            return _Signed(a.node + b.node, a.opposite)
        plus, minus = (b.node, a.node) if a.opposite else (a.node, b.node)
        if (minus, plus) in self.differences:
            return _Signed(self.differences[minus, plus], True)
        self.differences[plus, minus] = plus - minus
        return _Signed(self.differences[plus, minus])
