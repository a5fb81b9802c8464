"""Real numbers that depend on conditions: c ? x : y as operations of a graph.

x > 0 ? 1 : (x < 0 ? -1 : x)  ->  sign(x)         c ? x : 0  ->  if_else_zero(c, x)
c ? x : y  ->  if_else_zero(c, x) + if_else_zero(not c, y)
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import casadi

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Atom, Choice, Condition, Decision, negation
from mechanics.exact.c.library import RELATIONS, TRUTHS
from mechanics.exact.c.program import Writer
from mechanics.program.casadi_reader import Instruction as Node


def select(writer: Writer, condition: Condition, yes: int, no: int, kind: str, where: Any) -> int:
    """The node that is `yes` where the condition holds, else `no`."""
    if isinstance(condition, bool):
        return yes if condition else no
    if (signed := _sign(writer, condition, yes, no)) is not None:
        return writer.add(casadi.OP_SIGN, (signed,), kind)
    if _constant(writer, no) == 0:
        holds = truth(writer, condition, kind, where)
        if _constant(writer, yes) == 1:
            return holds
        return writer.add(casadi.OP_IF_ELSE_ZERO, (holds, yes), kind)
    holds, not_so = (truth(writer, c, kind, where) for c in (condition, negation(condition)))
    first = writer.add(casadi.OP_IF_ELSE_ZERO, (holds, yes), kind)
    second = writer.add(casadi.OP_IF_ELSE_ZERO, (not_so, no), kind)
    return writer.add(casadi.OP_ADD, (first, second), kind)


def chosen(writer: Writer, decision: Decision, kind: str, where: Any) -> int:
    """The node of an integer that depends on conditions, as a real number."""
    if not isinstance(decision, Choice):
        return writer.number(Fraction(decision), kind)
    yes, no = (chosen(writer, side, kind, where) for side in (decision.yes, decision.no))
    return select(writer, decision.condition, yes, no, kind, where)


def truth(writer: Writer, condition: Condition, kind: str, where: Any) -> int:
    """The node that is 1 where the condition holds, else 0."""
    if isinstance(condition, bool):
        return writer.number(Fraction(int(condition)), kind)
    if isinstance(condition, Atom):
        return _atom(writer, condition, kind, where)
    op = casadi.OP_AND if condition.both else casadi.OP_OR
    first, *rest = sorted((truth(writer, p, kind, where) for p in condition.parts), key=int)
    for other in rest:
        first = writer.add(op, (first, other), kind)
    return first


def _atom(writer: Writer, atom: Atom, kind: str, where: Any) -> int:
    if atom.relation not in RELATIONS:
        raise ExpressionError(
            f"{where}: is{atom.relation}(...) decides a value: it has no exact meaning here"
        )
    x, y = atom.operands
    if atom.relation == "==" and _constant(writer, y) == 0 and writer.nodes[x].op in TRUTHS:
        return writer.add(casadi.OP_NOT, (x,), kind) if atom.holds else x
    if atom.relation == "==" and not atom.holds:
        return writer.add(casadi.OP_NE, (x, y), kind)
    holds = writer.add(RELATIONS[atom.relation], (x, y), kind)
    return holds if atom.holds else writer.add(casadi.OP_NOT, (holds,), kind)


def _constant(writer: Writer, node: int) -> Fraction | None:
    return writer.nodes[node].constant


def _sign(writer: Writer, condition: Condition, yes: int, no: int) -> int | None:
    """x, where what is chosen is 1 for 0 < x, else -1 for x < 0, else x."""
    if not (isinstance(condition, Atom) and condition.relation == "<" and condition.holds):
        return None
    zero, x = condition.operands
    if _constant(writer, zero) != 0 or _constant(writer, yes) != 1:
        return None
    nodes = writer.nodes
    negative = Node(casadi.OP_LT, (x, -1), None)
    if nodes[no].op != casadi.OP_ADD:
        return None
    first, second = (nodes[i] for i in nodes[no].operands)
    if first.op != casadi.OP_IF_ELSE_ZERO or second.op != casadi.OP_IF_ELSE_ZERO:
        return None
    below, minus = first.operands
    above, same = second.operands
    fits = (
        nodes[below].op == negative.op
        and nodes[below].operands[0] == x
        and _constant(writer, nodes[below].operands[1]) == 0
        and _constant(writer, minus) == -1
        and nodes[above].op == casadi.OP_NOT
        and nodes[nodes[above].operands[0]][:2] == nodes[below][:2]
        and same == x
    )
    return x if fits else None
