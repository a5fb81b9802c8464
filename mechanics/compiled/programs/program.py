"""A CasADi graph as a list of values, each computed once (static single assignment).

    node k = operation(earlier nodes)        outputs[o][e] = node

From this list C is printed, and NumPy arrays of any precision are computed. CasADi's own work
vector reuses its slots, which is why its instructions cannot be printed one by one.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from mechanics.compiled.programs.operations import OPERATIONS, unknown


class Node(NamedTuple):
    """One value: its operation, and earlier nodes; (input, entry) for an input."""

    operation: int
    operands: tuple[int, ...]
    constant: float | None


@dataclass(frozen=True)
class Program:
    """The values of a CasADi function in the order of evaluation.

    Attributes
    ----------
    name : str
    nodes : tuple of Node
    outputs : tuple of tuple of int
        Node of each entry of each output, dense and column by column.
    inputs : tuple of (str, int)
        Name and number of entries of each input.
    shapes : tuple of (str, (int, int))
        Name and shape of each output.
    """

    name: str
    nodes: tuple[Node, ...]
    outputs: tuple[tuple[int, ...], ...]
    inputs: tuple[tuple[str, int], ...]
    shapes: tuple[tuple[str, tuple[int, int]], ...]

    @property
    def operations(self) -> int:
        """Number of arithmetic operations and function calls."""
        free = (ca.OP_INPUT, ca.OP_CONST)
        return sum(node.operation not in free for node in self.nodes)


def program(function: ca.Function) -> Program:
    """Read the instructions of an SX function whose inputs and outputs are dense."""
    nodes: list[Node] = []
    outputs = [[0] * function.nnz_out(i) for i in range(function.n_out())]
    slots: dict[int, int] = {}
    for k in range(function.n_instructions()):
        operation = function.instruction_id(k)
        operands = tuple(function.instruction_input(k))
        if operation == ca.OP_OUTPUT:
            output, entry = function.instruction_output(k)
            outputs[output][entry] = slots[operands[0]]
            continue
        constant = function.instruction_constant(k) if operation == ca.OP_CONST else None
        if operation not in (ca.OP_INPUT, ca.OP_CONST):
            operands = tuple(slots[slot] for slot in operands)
        slots[function.instruction_output(k)[0]] = len(nodes)
        nodes.append(Node(operation, operands, constant))
    return Program(
        function.name(),
        tuple(nodes),
        tuple(map(tuple, outputs)),
        tuple((function.name_in(i), function.numel_in(i)) for i in range(function.n_in())),
        tuple((function.name_out(i), function.size_out(i)) for i in range(function.n_out())),
    )


def operations(graph: ca.SX) -> int:
    """Operations of a graph, equal ones shared, a division counted twice."""
    function = ca.Function("graph", ca.symvar(graph), [ca.cse(ca.densify(graph))])
    code = program(function)
    return code.operations + sum(node.operation in DIVISIONS for node in code.nodes)


DIVISIONS = (ca.OP_DIV, ca.OP_INV)


def run(code: Program, columns: Sequence[Sequence[Any]], kind: Any) -> list[list[Any]]:
    """Evaluate with NumPy at many states at once, every operation rounded to `kind`.

    Parameters
    ----------
    columns : for every input, for every entry, an array of its values, or a scalar
    kind : NumPy floating type
        float32, float64 or longdouble.

    Returns
    -------
    For every output, for every entry, an array or scalar.

    Raises
    ------
    ExpressionError
        If the graph holds an operation that is not known here; it is named.
    """
    values: list[Any] = []
    with np.errstate(all="ignore"):
        for node in code.nodes:
            if node.constant is not None:
                values.append(kind(node.constant))
            elif node.operation == ca.OP_INPUT:
                group, entry = node.operands
                values.append(np.asarray(columns[group][entry], dtype=kind))
            elif node.operation in OPERATIONS:
                parts = [values[operand] for operand in node.operands]
                values.append(OPERATIONS[node.operation].numpy(*parts))
            else:
                raise unknown(node.operation)
    return [[values[node] for node in entries] for entries in code.outputs]
