"""A graph as exact straight-line code: data that is written to a file and read back.

    node k = operation(earlier nodes)        outputs[o][e] = node

A constant of a node is a rational: the dyadic one that its double is, or the exact one that stands
for a number that no double holds, such as 1/3. What is not rational, such as pi, is an entry of the
input ``constants``, which is the last.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import casadi as ca
from sympy import Expr, Rational, Symbol

from mechanics.compiled.programs.program import Program, program
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Number
from mechanics.exact.graph import evaluated
from mechanics.program.casadi_reader import Instruction as Node

CONSTANTS = "constants"


@dataclass(frozen=True)
class Code:
    """Straight-line code of one function.

    Attributes
    ----------
    name : str
    nodes : tuple of Node
    outputs : tuple of tuple of int
        Node of each entry of each output, column by column.
    inputs : tuple of (str, int)
        Name and number of entries; without the constants.
    shapes : tuple of (str, (int, int))
        Of the outputs.
    constants : tuple of Expr
        What the entries of the last input stand for.
    """

    name: str
    nodes: tuple[Node, ...]
    outputs: tuple[tuple[int, ...], ...]
    inputs: tuple[tuple[str, int], ...]
    shapes: tuple[tuple[str, tuple[int, int]], ...]
    constants: tuple[Expr, ...] = ()

    def numbers(
        self, a: Arithmetic, symbols: Mapping[str, Sequence[Symbol]], whole_angles: bool = False
    ) -> list[Number]:
        """The number of every node, inputs being symbols."""
        given: list[list[Any]] = [
            [a.value(symbol) for symbol in symbols[group]] for group, _ in self.inputs
        ]
        constants = [a.value(constant) for constant in self.constants]
        return evaluated(a, self.nodes, [*given, constants], whole_angles)

    def results(self, numbers: Sequence[Number]) -> dict[str, list[Number]]:
        """The numbers of every output by name."""
        return {
            name: [numbers[node] for node in nodes]
            for (name, _), nodes in zip(self.shapes, self.outputs, strict=True)
        }


def code_of(function: ca.Function, constants: Sequence[Expr]) -> Code:
    """Exact code of a dense SX function whose last input are the constants.

    Raises
    ------
    ExpressionError
        If a constant is infinite or no number.
    """
    found = program(function)
    last = len(found.inputs) - 1
    irrational = [i for i, constant in enumerate(constants) if not constant.is_Rational]
    nodes = []
    for op, operands, constant in found.nodes:
        value = None if constant is None else _dyadic(found.name, constant)
        if op == ca.OP_INPUT and operands[0] == last:
            named = constants[operands[1]]
            if isinstance(named, Rational):
                op, operands, value = ca.OP_CONST, (), Fraction(int(named.p), int(named.q))
            else:
                operands = (last, irrational.index(operands[1]))
        nodes.append(Node(op, operands, value))
    left = tuple(constants[i] for i in irrational)
    return Code(
        found.name, tuple(nodes), found.outputs, found.inputs[:-1], found.shapes, left
    )  # fmt: skip


def exact(found: Program) -> Code:
    """A program with the rationals that its doubles are."""
    nodes: list[Node] = []
    for op, operands, constant in found.nodes:
        value = None if constant is None else _dyadic(found.name, constant)
        nodes.append(Node(op, operands, value))
    return Code(found.name, tuple(nodes), found.outputs, found.inputs, found.shapes)


def _dyadic(name: str, constant: float) -> Fraction:
    if constant - constant != 0:
        raise ExpressionError(f"{name} holds the constant {constant}: no exact value")
    return Fraction(constant)
