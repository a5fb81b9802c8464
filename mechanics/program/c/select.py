"""Conditions, and integers that depend on them, as nodes whose value is 0 or 1, or that integer."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mechanics.errors import ExpressionError
from mechanics.program.c.condition import (
    Atom,
    Choice,
    Condition,
    Decision,
    joined,
    negation,
    possible,
)
from mechanics.program.c.function import Target, Written

RELATIONS = {"<": "less", "<=": "not_greater", "==": "equal"}


def chosen(target: Target, decision: Decision, kind: str, where: Any) -> int:
    """The node of an integer that depends on conditions, as a real number."""
    if not isinstance(decision, Choice):
        return target.number(Fraction(decision), kind)
    yes, no = (chosen(target, side, kind, where) for side in (decision.yes, decision.no))
    return target.choose(decision.condition, yes, no, kind, where)


def latest(
    target: Target, written: Sequence[Written], under: Condition, kind: str, where: Any
) -> int | None:
    """What was written last, each under its condition; None where some case has written nothing.

    if (c) y = a; else y = b;    ->    !c ? b : a

    Parameters
    ----------
    written : sequence of Written
        In order.
    under : Condition
        What holds where it is read.
    """
    node: int | None = None
    unset = under
    for one in written:
        both = joined(True, under, one.condition)
        if both is False:
            continue
        if node is None or both == under:
            node = one.node
        else:
            node = target.choose(one.condition, one.node, node, kind, where)
        unset = joined(True, unset, negation(one.condition))
    return None if possible(unset) else node


def truth(target: Target, condition: Condition, kind: str, where: Any) -> int:
    """The node that is 1 where the condition holds, else 0.

    Raises
    ------
    ExpressionError
        If it asks whether a value is finite, which has no exact meaning.
    """
    if isinstance(condition, bool):
        return target.number(Fraction(int(condition)), kind)
    if isinstance(condition, Atom):
        return _atom(target, condition, kind, where)
    name = "and" if condition.both else "or"
    first, *rest = sorted(truth(target, part, kind, where) for part in condition.parts)
    for other in rest:
        first = target.apply(name, (first, other), kind)
    return first


def _atom(target: Target, atom: Atom, kind: str, where: Any) -> int:
    if atom.relation not in RELATIONS:
        raise ExpressionError(
            f"{where}: is{atom.relation}(...) decides a value: it has no exact meaning"
        )
    x, y = atom.operands
    if atom.relation == "==" and target.constant(y) == 0 and target.is_truth(x):
        return target.apply("not", (x,), kind) if atom.holds else x
    if atom.relation == "==" and not atom.holds:
        return target.apply("not_equal", (x, y), kind)
    holds = target.apply(RELATIONS[atom.relation], (x, y), kind)
    return holds if atom.holds else target.apply("not", (holds,), kind)
