"""Literals and the constants that they stand for.

    0x1.5555555555555p-2   bit for bit the nearest double to 1/3   ->   1/3

A literal counts as an exact constant only where it is, bit for bit, the nearest number of its type
to a constant of the graph, or what the graph's own operations on such doubles give (2 * fl(pi)).
Every other literal is the dyadic rational that it is, so a change of its last digit is seen.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

import casadi as ca
import numpy as np

from mechanics.compiled.custody.code import Code
from mechanics.compiled.programs.operations import OPERATIONS
from mechanics.exact.c.literal import rounded
from mechanics.program.casadi_reader import Instruction as Node

DIGITS = 40


class Irrational(NamedTuple):
    """A node of the graph that stands for a constant such as pi, or for its negative."""

    node: int
    negative: bool


Table = Mapping[Fraction, Fraction | Irrational]
"""For the value of a literal what it stands for."""


def literals(code: Code, kind: str) -> dict[Fraction, Fraction | Irrational]:
    """What literals of a type stand for, where that is not their own value."""
    values, doubles = _constant_nodes(code)
    table: dict[Fraction, Fraction | Irrational] = {}
    for k, double in doubles.items():
        value = values[k]
        seen = {Fraction(double)} if kind == "double" else {rounded(Fraction(double), "float")}
        if value is not None:
            seen.add(rounded(value, kind))
        for literal in seen:
            if value is None:
                table.setdefault(literal, Irrational(k, False))
                table.setdefault(-literal, Irrational(k, True))
            elif literal not in (0, value):
                table.setdefault(literal, value)
                table.setdefault(-literal, -value)
    return table


def _constant_nodes(code: Code) -> tuple[dict[int, Fraction | None], dict[int, float]]:
    """Nodes without inputs: exact value (None if irrational) and the double computed for each."""
    place = len(code.inputs)
    values: dict[int, Fraction | None] = {}
    doubles: dict[int, float] = {}
    for k, node in enumerate(code.nodes):
        if node.constant is not None:
            values[k], doubles[k] = node.constant, float(node.constant)
        elif node.op == ca.OP_INPUT:
            if node.operands[0] == place:
                values[k] = None
                doubles[k] = float(code.constants[node.operands[1]].evalf(DIGITS))
        elif all(i in doubles for i in node.operands):
            values[k] = _rational(node, [values[i] for i in node.operands])
            with np.errstate(all="ignore"):
                number = OPERATIONS[node.op].numpy(*(doubles[i] for i in node.operands))
            doubles[k] = float(number)
            if not np.isfinite(doubles[k]):
                del values[k], doubles[k]
    return values, doubles


def _rational(node: Node, operands: Sequence[Fraction | None]) -> Fraction | None:
    """Value of an operation on rationals; None where it is none."""
    if node.op not in _RATIONAL or any(x is None for x in operands):
        return None
    known = [x for x in operands if x is not None]
    if node.op in (ca.OP_DIV, ca.OP_INV) and known[-1] == 0:
        return None
    return _RATIONAL[node.op](*known)


_RATIONAL: dict[int, Callable[..., Fraction]] = {
    ca.OP_ASSIGN: lambda x: x, ca.OP_ADD: lambda x, y: x + y, ca.OP_SUB: lambda x, y: x - y,
    ca.OP_MUL: lambda x, y: x * y, ca.OP_DIV: lambda x, y: x / y, ca.OP_NEG: lambda x: -x,
    ca.OP_SQ: lambda x: x * x, ca.OP_TWICE: lambda x: x + x, ca.OP_INV: lambda x: 1 / x,
}  # fmt: skip


def interpreted(
    nodes: Sequence[Node], table: Table, code: Code, place: int
) -> tuple[list[Node], list[int]]:
    """Nodes with literals as the constants that they stand for, and where each node went.

    Parameters
    ----------
    nodes : sequence of Node
        Of a C text or a program.
    table : mapping
        From `literals`.
    code : Code
        The graph whose constants they are; its irrational ones are repeated.
    place : int
        Of the input ``constants`` among those of the nodes.
    """
    result: list[Node] = []
    of: list[int] = []
    copied: dict[int, int] = {}
    for node in nodes:
        meaning = table.get(node.constant) if node.constant is not None else None
        if isinstance(meaning, Irrational):
            of.append(_copied(meaning.node, code, place, result, copied))
            if meaning.negative:
                result.append(Node(ca.OP_NEG, (of[-1],), None))
                of[-1] = len(result) - 1
            continue
        if meaning is not None:
            node = Node(node.op, (), meaning)
        elif node.op != ca.OP_INPUT:
            node = Node(node.op, tuple(of[i] for i in node.operands), node.constant)
        of.append(len(result))
        result.append(node)
    return result, of


def _copied(root: int, code: Code, place: int, result: list[Node], copied: dict[int, int]) -> int:
    """Repeat a constant node of the graph and what it is made of."""
    if root not in copied:
        node = code.nodes[root]
        if node.op == ca.OP_INPUT:
            operands: tuple[int, ...] = (place, node.operands[1])
        else:
            operands = tuple(_copied(i, code, place, result, copied) for i in node.operands)
        copied[root] = len(result)
        result.append(Node(node.op, operands, node.constant))
    return copied[root]
