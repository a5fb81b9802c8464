"""A C function as straight-line code: what it computes, node by node, as `graph` has it.

    node k = operation(earlier nodes)        output group, entry = node        status = decision

The nodes are those of a CasADi graph, so that one walker evaluates both.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import NamedTuple

import casadi

from mechanics.exact.c.condition import Condition, Decision
from mechanics.program.casadi_reader import Instruction as Node


@dataclass(frozen=True)
class Parameter:
    """What one argument of a C function is, in the order of the arguments.

    Attributes
    ----------
    name : str
        Of the quantity, for messages; the text may call it otherwise.
    kind : str
        ``"double"`` or ``"float"`` for an array, ``"size_t"`` for an integer.
    size : int
        Entries of an array, of one lane.
    output : bool
        Whether the function writes it.
    stride : str
        Name of the integer parameter by which entries of a lane are apart; empty where all lanes
        share the array, or there are none.
    """

    name: str
    kind: str
    size: int = 1
    output: bool = False
    stride: str = ""


class Written(NamedTuple):
    """A value that an output gets where a condition holds."""

    condition: Condition
    node: int


@dataclass(frozen=True)
class CProgram:
    """What a C function computes.

    Attributes
    ----------
    name : str
    nodes : tuple of Node
        For an input: (place among the parameters, entry).
    kinds : tuple of str
        Type of each node.
    outputs : mapping of (place, entry) to tuple of (Condition, node)
        What was written, in the order in which it was: each is what stands there at last where its
        condition holds and those after it do not.
    status : Decision or None
        What it returns; None for a function that returns nothing. Operands of its conditions are
        nodes.
    beyond : tuple of str
        Reads beyond the end of an array; such a value is an input of the place `BEYOND`.
    late : tuple of str
        Reads of an input after an output was written.
    lanes : str
        Name of the integer that counts the lanes; empty for a function of one state.
    """

    name: str
    nodes: tuple[Node, ...]
    kinds: tuple[str, ...]
    outputs: Mapping[tuple[int, int], tuple[Written, ...]]
    status: Decision | None
    beyond: tuple[str, ...]
    late: tuple[str, ...]
    lanes: str


BEYOND = -1


@dataclass
class Writer:
    """Nodes as they are found, equal ones once."""

    nodes: list[Node] = field(default_factory=list)
    kinds: list[str] = field(default_factory=list)
    _places: dict[tuple[Node, str], int] = field(default_factory=dict)

    def add(self, op: int, operands: tuple[int, ...], kind: str) -> int:
        """The node of an operation."""
        return self._kept(Node(op, operands, None), kind)

    def number(self, value: Fraction, kind: str) -> int:
        """The node of a constant."""
        return self._kept(Node(casadi.OP_CONST, (), value), kind)

    def input(self, place: int, entry: int, kind: str) -> int:
        """The node of an entry of an argument."""
        return self._kept(Node(casadi.OP_INPUT, (place, entry), None), kind)

    def _kept(self, node: Node, kind: str) -> int:
        """One place for equal nodes."""
        if (node, kind) not in self._places:
            self._places[node, kind] = len(self.nodes)
            self.nodes.append(node)
            self.kinds.append(kind)
        return self._places[node, kind]
