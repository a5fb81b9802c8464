"""Literals and the constants that they stand for.

    0x1.5555555555555p-2   bit for bit the nearest double to 1/3   ->   1/3

A literal counts as an exact constant only where it is, bit for bit, the nearest number of its type
to a constant of the graph, or what the graph's own operations on such doubles give (2 * fl(pi)),
or what CasADi made of two of them while the graph with doubles was built (-1/2 times fl(9.81)).
Every other literal is the dyadic rational that it is, so a change of its last digit is seen.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product

import numpy as np

from mechanics.compiled.custody.code import Code
from mechanics.program import Builder, Node
from mechanics.program.c.literal import rounded
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import INPUT, OPERATIONS

DIGITS = 40
FOLDED = ("multiply", "add", "subtract", "divide")


def literals(
    builder: Builder, code: Code, kind: str, written: Iterable[Fraction] = ()
) -> dict[Fraction, Node]:
    """What literals of a type stand for, where that is not their own value, as nodes.

    Parameters
    ----------
    builder : Builder
    code : Code
        The exact graph.
    kind : str
        ``"double"`` or ``"float"``.
    written : iterable of Fraction
        Constants of the graph with doubles.
    """
    doubles = _doubles(code)
    known = list(zip(code.build(builder, {}, list(doubles)), doubles.values(), strict=True))
    table: dict[Fraction, Node] = {}
    for node, double in (*known, *_folded(known, map(float, written))):
        value = node.constant
        seen = {Fraction(double)} if kind == "double" else {rounded(Fraction(double), "float")}
        if value is not None:
            seen.add(rounded(value, kind))
        for literal in sorted(seen):
            if value is None or literal not in (0, value):
                table.setdefault(literal, node)
                table.setdefault(-literal, -node)
    return table


def _folded(
    known: Iterable[tuple[Node, float]], written: Iterable[float]
) -> Iterator[tuple[Node, float]]:
    """Constants that are none of the known doubles, but one operation away from two of them."""
    nodes = {sign * double: sign * node for node, double in known for sign in (1, -1)}
    values, functions = np.array(list(nodes)), Arrays().operations
    for wanted in written:
        if wanted in nodes:
            continue
        for name, x in product(FOLDED, values):
            with np.errstate(all="ignore"):
                hits = values[functions[name](x, values) == wanted]
            if len(hits):
                one, other = nodes[float(x)], nodes[float(hits[0])]
                yield one.builder.call(name, one, other), wanted
                break


def _doubles(code: Code) -> dict[int, float]:
    """What a machine computes of each value that depends on no input, where that is finite."""
    place, functions = len(code.inputs), Arrays().operations
    found: dict[int, float] = {}
    for k, (op, operands, constant) in enumerate(code.routine.nodes):
        if constant is not None:
            found[k] = float(constant)
        elif op == INPUT:
            if operands[0] == place:
                found[k] = float(code.constants[operands[1]].evalf(DIGITS))
        elif all(i in found for i in operands):
            with np.errstate(all="ignore"):
                number = float(functions[OPERATIONS[op].name](*(found[i] for i in operands)))
            if np.isfinite(number):
                found[k] = number
    return found
