"""A value inside a program in words: ``theta_dot * theta_dot``."""

from collections.abc import Mapping

from mechanics.program.c_printer import PRIMARY, UNARY, Text, expression
from mechanics.program.operations import INPUT
from mechanics.program.routine import Routine

DEPTH = 4
"""Operations that are written out one inside the other; what is deeper is left out."""
MORE = "..."


def describe(code: Routine, node: int, entries: Mapping[str, tuple[str, ...]]) -> str:
    """The expression that a node computes, in the names of the inputs.

    Parameters
    ----------
    entries : names of the entries of each input
    """
    return _text(code, node, entries, DEPTH).code


def _text(code: Routine, node: int, entries: Mapping[str, tuple[str, ...]], depth: int) -> Text:
    operation, operands, constant = code.nodes[node]
    if constant is not None:
        return Text(f"{float(constant):.4g}", UNARY if constant < 0 else PRIMARY)
    if operation == INPUT:
        group, entry = operands
        return Text(entries[code.inputs[group][0]][entry])
    if depth == 0:
        return Text(MORE)
    return expression(operation, [_text(code, i, entries, depth - 1) for i in operands])
