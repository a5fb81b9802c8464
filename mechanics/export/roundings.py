"""What the roundings of a function add up to, to first order.

    |fl(f) - f|  <=  u sum_k |df / dv_k| |v_k| + O(u^2)        u = 2^-53, in single precision 2^-24

over all values v_k that are computed, each rounded once (a sine more, which the caller leaves room
for). Intervals forget that two values come from the same third one, and after some dozens of bodies
their radius says nothing; derivatives, taken backwards through the function, do not forget it.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from mechanics.program import Builder
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import INPUT, OPERATIONS
from mechanics.program.routine import Routine, every_value

TOGETHER = 64
"""Outputs that are followed backwards at a time."""

Array = NDArray[np.float64]


def first_order(code: Routine, inputs: Sequence[Sequence[float]], digits: int) -> list[list[float]]:
    """The sum for every entry of every output.

    Parameters
    ----------
    inputs : sequence of sequence of float
        By input of the program.
    digits : int
        Binary digits that a value is rounded to.
    """
    values = np.array(every_value(code, inputs, np.float64))
    slopes = _slopes(code, values)
    sizes = np.abs(values)
    sizes[[k for k, node in enumerate(code.nodes) if node.operation == INPUT]] = 0
    flat = [node for nodes in code.outputs for node in nodes]
    sums: list[float] = []
    for start in range(0, len(flat), TOGETHER):
        back = np.abs(_backwards(code, slopes, flat[start : start + TOGETHER]))
        with np.errstate(all="ignore"):
            sums += (2.0**-digits * (sizes @ back)).tolist()
    ends = np.cumsum([len(nodes) for nodes in code.outputs])
    return [list(part) for part in np.split(np.array(sums), ends[:-1])]


def _slopes(code: Routine, values: Array) -> dict[int, Sequence[float]]:
    """Derivatives of every value that is computed by its operands."""
    groups: dict[int, list[int]] = {}
    for k, node in enumerate(code.nodes):
        if node.constant is None and node.operation != INPUT:
            groups.setdefault(node.operation, []).append(k)
    found: dict[int, Sequence[float]] = {}
    for operation, nodes in groups.items():
        operands = np.array([code.nodes[k].operands for k in nodes]).T
        columns = np.broadcast_arrays(*_derivatives(operation, values[operands]), nodes)[:-1]
        found |= {k: slopes for k, *slopes in zip(nodes, *columns, strict=True)}
    return found


def _derivatives(operation: int, operands: Array) -> tuple[Array, ...]:
    """Derivatives of one operation by each operand, at many places at once."""
    row, build = OPERATIONS[operation], Builder()
    given = [build.input(str(k)) for k in range(row.arity)]
    if row.partials is None:
        raise AssertionError(f"{row.name} is computed from nothing")
    program = build.program({"slopes": row.partials(*given, build.call(row.name, *given))})
    places = {str(k): column for k, column in enumerate(operands)}
    with np.errstate(all="ignore"):
        return interpret(program, Arrays(), places)["slopes"]


def _backwards(code: Routine, slopes: dict[int, Sequence[float]], outputs: Sequence[int]) -> Array:
    """Derivatives of some outputs by every value: one column an output."""
    found = np.zeros((len(code.nodes), len(outputs)))
    for column, node in enumerate(outputs):
        found[node, column] += 1
    # At a singular state a slope is infinite, and so is the sum, or no number.
    with np.errstate(all="ignore"):
        for k in range(len(code.nodes) - 1, -1, -1):
            for operand, slope in zip(code.operands(k), slopes.get(k, ()), strict=False):
                found[operand] += slope * found[k]
    return found
