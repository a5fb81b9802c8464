"""What the roundings of a function add up to, to first order.

    |fl(f) - f|  <=  u sum_k |df / dv_k| |v_k| + O(u^2)        u = 2^-53, in single precision 2^-24

over all values v_k that are computed, each rounded once (a sine more, which the caller leaves room
for). Intervals forget that two values come from the same third one, and after some dozens of bodies
their radius says nothing; derivatives, taken backwards through the function, do not forget it.
"""

import functools
from collections.abc import Sequence

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.programs.operations import OPERATIONS, unknown
from mechanics.compiled.programs.program import Program

TOGETHER = 64
"""Outputs that are followed backwards at a time."""

Array = NDArray[np.float64]


def first_order(code: Program, inputs: Sequence[Sequence[float]], digits: int) -> list[list[float]]:
    """The sum for every entry of every output.

    Parameters
    ----------
    inputs : sequence of sequence of float
        By input of the program.
    digits : int
        Binary digits that a value is rounded to.
    """
    values = _values(code, inputs)
    slopes = _slopes(code, values)
    sizes = np.abs(values)
    sizes[[k for k, node in enumerate(code.nodes) if node.operation == ca.OP_INPUT]] = 0
    flat = [node for nodes in code.outputs for node in nodes]
    sums: list[float] = []
    for start in range(0, len(flat), TOGETHER):
        back = np.abs(_backwards(code, slopes, flat[start : start + TOGETHER]))
        with np.errstate(all="ignore"):
            sums += (2.0**-digits * (sizes @ back)).tolist()
    ends = np.cumsum([len(nodes) for nodes in code.outputs])
    return [list(part) for part in np.split(np.array(sums), ends[:-1])]


def _values(code: Program, inputs: Sequence[Sequence[float]]) -> Array:
    """Every value, as doubles give it."""
    values: list[float] = []
    with np.errstate(all="ignore"):
        for node in code.nodes:
            if node.constant is not None:
                values.append(node.constant)
            elif node.operation == ca.OP_INPUT:
                values.append(inputs[node.operands[0]][node.operands[1]])
            elif node.operation in OPERATIONS:
                parts = [np.float64(values[operand]) for operand in node.operands]
                values.append(float(OPERATIONS[node.operation].numpy(*parts)))
            else:
                raise unknown(node.operation)
    return np.array(values)


def _slopes(code: Program, values: Array) -> dict[int, tuple[float, ...]]:
    """Derivatives of every value that is computed by its operands."""
    groups: dict[int, list[int]] = {}
    for k, node in enumerate(code.nodes):
        if node.constant is None and node.operation != ca.OP_INPUT:
            groups.setdefault(node.operation, []).append(k)
    found: dict[int, tuple[float, ...]] = {}
    for operation, nodes in groups.items():
        operands = np.array([code.nodes[k].operands for k in nodes]).T
        slopes = _derivative(operation, len(operands)).map(len(nodes))(*values[operands])
        columns = np.atleast_2d(np.array(slopes)).T.tolist()
        found |= {k: tuple(column) for k, column in zip(nodes, columns, strict=True)}
    return found


@functools.cache
def _derivative(operation: int, count: int) -> ca.Function:
    """Derivatives of one operation by each operand, as a column."""
    operands = [ca.SX.sym(f"x{i}") for i in range(count)]
    apply = ca.SX.unary if count == 1 else ca.SX.binary
    slopes = ca.jacobian(apply(operation, *operands), ca.vertcat(*operands))
    return ca.Function("slopes", operands, [ca.densify(slopes.T)])


def _backwards(
    code: Program, slopes: dict[int, tuple[float, ...]], outputs: Sequence[int]
) -> Array:
    """Derivatives of some outputs by every value: one column an output."""
    found = np.zeros((len(code.nodes), len(outputs)))
    for column, node in enumerate(outputs):
        found[node, column] += 1
    # At a singular state a slope is infinite, and so is the sum, or no number.
    with np.errstate(all="ignore"):
        for k in range(len(code.nodes) - 1, -1, -1):
            for operand, slope in zip(code.nodes[k].operands, slopes.get(k, ()), strict=False):
                found[operand] += slope * found[k]
    return found
