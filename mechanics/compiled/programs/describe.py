"""A value inside a program in words: ``theta_dot * theta_dot``."""

from collections.abc import Mapping

import casadi as ca

from mechanics.compiled.c.source import Text, expression
from mechanics.compiled.programs.operations import ATOM, SIGN
from mechanics.compiled.programs.program import Program

DEPTH = 4
"""Operations that are written out one inside the other; what is deeper is left out."""
MORE = "..."


def describe(code: Program, node: int, entries: Mapping[str, tuple[str, ...]]) -> str:
    """The expression that a node computes, in the names of the inputs.

    Parameters
    ----------
    code : Program
    node : int
    entries : names of the entries of each input
    """
    return _text(code, node, entries, DEPTH).code


def _text(code: Program, node: int, entries: Mapping[str, tuple[str, ...]], depth: int) -> Text:
    operation, operands, constant = code.nodes[node]
    if constant is not None:
        return Text(f"{constant:.4g}", ATOM if constant >= 0 else SIGN)
    if operation == ca.OP_INPUT:
        group, entry = operands
        return Text(entries[code.inputs[group][0]][entry], ATOM)
    if depth == 0:
        return Text(MORE, ATOM)
    return expression(operation, [_text(code, i, entries, depth - 1) for i in operands], "double")
