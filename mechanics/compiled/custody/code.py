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

import casadi as ca
from sympy import Expr, Rational

from mechanics.compiled.programs.program import Program as Printed
from mechanics.compiled.programs.program import program
from mechanics.errors import ExpressionError
from mechanics.program import Builder, Node, Program
from mechanics.program.as_written import AsWritten
from mechanics.program.casadi_reader import Instruction, nodes_of
from mechanics.program.sympy_reader import read

CONSTANTS = "constants"
EVERY = "every"
"""The output of a program that holds all its values."""


@dataclass(frozen=True)
class Code:
    """Straight-line code of one function.

    Attributes
    ----------
    name : str
    nodes : tuple of Instruction
    outputs : tuple of tuple of int
        Instruction of each entry of each output, column by column.
    inputs : tuple of (str, int)
        Name and number of entries; without the constants.
    shapes : tuple of (str, (int, int))
        Of the outputs.
    constants : tuple of Expr
        What the entries of the last input stand for.
    """

    name: str
    nodes: tuple[Instruction, ...]
    outputs: tuple[tuple[int, ...], ...]
    inputs: tuple[tuple[str, int], ...]
    shapes: tuple[tuple[str, tuple[int, int]], ...]
    constants: tuple[Expr, ...] = ()

    def build(
        self, builder: Builder, given: Mapping[str, Sequence[Node]], wanted: Sequence[int]
    ) -> tuple[Node, ...]:
        """Nodes of some of its values, inputs being those that are given by group."""
        inputs = [given.get(group, ()) for group, _ in self.inputs]
        constants = read(builder, self.constants)
        return nodes_of(builder, self.nodes, [*inputs, constants], wanted)

    def results(
        self, builder: Builder, given: Mapping[str, Sequence[Node]]
    ) -> dict[str, list[Node]]:
        """Nodes of every output by name."""
        flat = [number for numbers in self.outputs for number in numbers]
        nodes = iter(self.build(builder, given, flat))
        return {
            name: [next(nodes) for _ in numbers]
            for (name, _), numbers in zip(self.shapes, self.outputs, strict=True)
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
        nodes.append(Instruction(op, operands, value))
    left = tuple(constants[i] for i in irrational)
    return Code(
        found.name, tuple(nodes), found.outputs, found.inputs[:-1], found.shapes, left
    )  # fmt: skip


def exact(found: Printed) -> Code:
    """A program with the rationals that its doubles are."""
    nodes: list[Instruction] = []
    for op, operands, constant in found.nodes:
        value = None if constant is None else _dyadic(found.name, constant)
        nodes.append(Instruction(op, operands, value))
    return Code(found.name, tuple(nodes), found.outputs, found.inputs, found.shapes)


def as_written(found: Printed) -> Program:
    """What a text was printed from, every operation as it stands; all values, too."""
    builder, code = AsWritten(), exact(found)
    given = {name: entries(builder, name, size) for name, size in code.inputs}
    every = code.build(builder, given, range(len(code.nodes)))
    return builder.program({**code.results(builder, given), EVERY: every})


def entries(builder: Builder, name: str, size: int) -> list[Node]:
    """The inputs that stand for an array."""
    return [builder.input(f"{name}[{k}]") for k in range(size)]


def _dyadic(name: str, constant: float) -> Fraction:
    if constant - constant != 0:
        raise ExpressionError(f"{name} holds the constant {constant}: no exact value")
    return Fraction(constant)
