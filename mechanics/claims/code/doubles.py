"""Straight-line code computed in doubles, beside the formulas that were read in it.

    isinf(exp(800))        taken by a machine, never by real numbers
    1e15*(1.0471975511965981 - M_PI/3)      0.4 in doubles, 0 where the literal is read as pi/3

Formulas are exact: nothing overflows, and a long literal is the number that it stands for. Where
that changes what the code computes, nothing is proved of it. This is a guard and no proof: some
states are tried. What has no value there is left to the obligations of the formulas.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

import casadi
from sympy import Expr

from mechanics.claims.code.trace.numerical_check import at_states, program_of, symbols_in, value_of
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.errors import ExpressionError
from mechanics.program.casadi_reader import Instruction

ROUNDED = 40
"""Digits that are asked for of the 53 that doubles have."""


def doubt_as_doubles(
    nodes: Sequence[Instruction],
    last: Sequence[int],
    inputs: Sequence[Sequence[Expr]],
    outputs: Outputs,
) -> str:
    """Why formulas are not what a machine computes, one line; empty where nothing says so.

    Parameters
    ----------
    nodes : sequence of Instruction
    last : sequence of int
        The instructions that are the outputs, in the order of the formulas.
    inputs : sequence of sequence of Expr
        Entries of each input.
    outputs : Outputs
    """
    symbols = symbols_in([entry for group in inputs for entry in group])
    try:
        for formulas in at_states(symbols, program_of(outputs), ROUNDED):
            numbers = [[value_of(entry, formulas.numbers) for entry in group] for group in inputs]
            values = computed(nodes, numbers)
            if values is None:
                continue
            found = [values[node] for node in last]
            rows = zip(found, formulas.values, formulas.slack, strict=True)
            for place, (number, value, slack) in enumerate(rows, 1):
                if not abs(number - value) <= slack:
                    read = "".join(f", where {note}" for note in outputs.notes)
                    return (
                        f"computed in doubles, output {place} is {number:.6g}, its formula in real"
                        f" numbers {value:.6g}, at {formulas.where}{read}"
                    )
    except ExpressionError as error:
        return f"it cannot be computed in doubles: {error}"
    return ""


def computed(nodes: Sequence[Instruction], inputs: Sequence[Sequence[float]]) -> list[float] | None:
    """The value of every instruction; None where one of finite numbers has none."""
    found: list[float] = []
    for node in nodes:
        if node.constant is not None:
            found.append(float(node.constant))
            continue
        if node.op == casadi.OP_INPUT:
            group, entry = node.operands
            found.append(inputs[group][entry])
            continue
        operands = [found[k] for k in node.operands]
        apply = casadi.DM.unary if len(operands) == 1 else casadi.DM.binary
        value = float(apply(node.op, *map(casadi.DM, operands)))
        if value != value and all(map(isfinite, operands)):
            return None
        found.append(value)
    return found
