"""Straight-line code at many states at once, in the precision of the machine.

Used for what is discrete, statuses, and for how large the terms of a result are:

    S(x + y) = S(x) + S(y)        S(x y) = S(x) S(y)        S(x / y) = S(x) S(y) / y^2
    S(f(x)) = |f(x)| + |f'(x)| S(x) for computed x,         S(input) = |input|

A result of plain operations is off by a few roundings of S, whatever cancels.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.sine import LIMIT
from mechanics.compiled.programs.operations import OPERATIONS
from mechanics.exact.c.condition import Atom, Choice, Condition, Decision
from mechanics.program.casadi_reader import Instruction as Node

Values = list[NDArray[np.floating]]


def values(
    nodes: Sequence[Node], inputs: Sequence[NDArray[np.floating]], kind: type[np.floating]
) -> Values:
    """Every node at N states.

    Parameters
    ----------
    inputs : arrays, N x entries
        By place of the argument.
    """
    found: Values = []
    with np.errstate(all="ignore"):
        for node in nodes:
            if node.constant is not None:
                found.append(np.asarray(kind(float(node.constant))))
            elif node.op == ca.OP_INPUT:
                place, entry = node.operands
                found.append(inputs[place][:, entry])
            else:
                operands = [found[i] for i in node.operands]
                found.append(np.asarray(OPERATIONS[node.op].numpy(*operands)))
    return found


def decided(decision: Decision, known: Values, count: int) -> NDArray[np.int64]:
    """What a decision comes to at each state."""
    if not isinstance(decision, Choice):
        return np.full(count, decision)
    holds = _holds(decision.condition, known, count)
    return np.where(holds, decided(decision.yes, known, count), decided(decision.no, known, count))


def _holds(condition: Condition, known: Values, count: int) -> NDArray[np.bool_]:
    if isinstance(condition, bool):
        return np.full(count, condition)
    if isinstance(condition, Atom):
        found = np.broadcast_to(_atom(condition, known), count)
        return found if condition.holds else ~found
    parts = [_holds(part, known, count) for part in condition.parts]
    return np.all(parts, axis=0) if condition.both else np.any(parts, axis=0)


def _atom(atom: Atom, known: Values) -> Any:
    x = [known[i] for i in atom.operands]
    if atom.relation == "finite":
        return np.isfinite(x[0])
    if atom.relation == "far":
        return ~(np.abs(x[0]) <= LIMIT)
    return {"<": np.less, "<=": np.less_equal, "==": np.equal}[atom.relation](*x)


def sizes(nodes: Sequence[Node], known: Values) -> Values:
    """S of every node."""
    found: Values = []
    with np.errstate(all="ignore"):
        for k, node in enumerate(nodes):
            size = np.abs(np.asarray(known[k], dtype=float))
            if node.constant is None and node.op != ca.OP_INPUT:
                x = [np.asarray(known[i], dtype=float) for i in node.operands]
                s = [found[i] for i in node.operands]
                if node.op in _SIZES:
                    size = _SIZES[node.op](x, s)
                elif node.op in _SLOPES and nodes[node.operands[0]].op != ca.OP_INPUT:
                    size = size + np.abs(_SLOPES[node.op](x[0])) * s[0]
            found.append(size)
    return found


_SIZES: dict[int, Any] = {
    ca.OP_ADD: lambda x, s: s[0] + s[1], ca.OP_SUB: lambda x, s: s[0] + s[1],
    ca.OP_MUL: lambda x, s: s[0] * s[1], ca.OP_SQ: lambda x, s: s[0] * s[0],
    ca.OP_TWICE: lambda x, s: 2 * s[0], ca.OP_NEG: lambda x, s: s[0],
    ca.OP_DIV: lambda x, s: s[0] / np.abs(x[1]) * (s[1] / np.abs(x[1])),
    ca.OP_INV: lambda x, s: s[0] / np.abs(x[0]) / np.abs(x[0]),
    ca.OP_FABS: lambda x, s: s[0],
}  # fmt: skip
_SLOPES: dict[int, Any] = {
    ca.OP_SIN: np.cos, ca.OP_COS: np.sin, ca.OP_EXP: np.exp,
    ca.OP_TAN: lambda x: 1 / np.cos(x) ** 2, ca.OP_SQRT: lambda x: 0.5 / np.sqrt(x),
    ca.OP_ATAN: lambda x: 1 / (1 + x * x), ca.OP_TANH: lambda x: 1 / np.cosh(x) ** 2,
    ca.OP_LOG: lambda x: 1 / x,
}  # fmt: skip
