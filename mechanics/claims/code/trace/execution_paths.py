"""Straight-line code that decides, way by way: formulas of its outputs where decisions are known.

c ? x : y    ->    x where c holds,  y where it does not
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import product

import casadi
from sympy import Expr

from mechanics.claims.code.trace.formulas import Assignment, Authored, Formulas, of_graph
from mechanics.claims.code.trace.liveness import RELATIONS
from mechanics.claims.code.trace.sympy_expressions import Constants, expressions
from mechanics.program.casadi_reader import Instruction

MOST, LARGEST = 4, 1000
"""Decisions, and instructions."""


def ways_of(
    nodes: Sequence[Instruction],
    last: Sequence[int],
    inputs: Sequence[Sequence[Expr]],
    named: Mapping[int, tuple[str, str]],
) -> Formulas:
    """Formulas of the outputs on every way, by what the outputs are then.

    Parameters
    ----------
    nodes : sequence of Instruction
    last : sequence of int
        The instructions that are the outputs.
    inputs : sequence of sequence of Expr
        Entries of each input.
    named : mapping of int to (str, str)
        Names that the code gives to nodes, and where.
    """
    decided = [k for k, node in enumerate(nodes) if node.op in RELATIONS]
    if not 0 < len(decided) <= MOST or len(nodes) > LARGEST:
        return {}
    found: dict[Expr, Authored] = {}
    for answers in product((1, 0), repeat=len(decided)):
        way = list(nodes)
        for k, answer in zip(decided, answers, strict=True):
            way[k] = Instruction(casadi.OP_CONST, (), Fraction(answer))
        constants = Constants()
        numbers = expressions(way, inputs, constants)
        used = _used(way, numbers, last)
        assigned: dict[str, Assignment] = {}
        own = {k: words for k, words in named.items() if k in used}
        formulas = of_graph(way, inputs, constants, own, assigned)
        for node in last:
            known = formulas[node]
            if known is not None:
                found.setdefault(numbers[node], Authored(known.node, assigned))
    return found


def _used(way: Sequence[Instruction], numbers: Sequence[Expr], last: Sequence[int]) -> set[int]:
    """Nodes that outputs are made of on a way."""
    found: set[int] = set()
    todo = list(last)
    while todo:
        place = todo.pop()
        if place in found:
            continue
        found.add(place)
        op, operands, _ = way[place]
        if op in (casadi.OP_INPUT, casadi.OP_CONST):
            continue
        if op == casadi.OP_IF_ELSE_ZERO and numbers[operands[0]] == 0:
            operands = operands[:1]
        todo += operands
    return found
