"""Derivatives of nodes in reverse, and the parts that forward ones are made of, too.

    gradient   sum_j w_j dy_j/dx_k   for all k, in one walk         (1)
    solve      M x = f:   a weight w of x is                        (2)
               M^-T w on f and -(M^-T w) x^T on M

Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, chapter 3; (2): section 2.2 of
Giles, Collected matrix derivative results for forward and reverse mode AD, 2008.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from mechanics.program.builder import Builder, Node
from mechanics.program.operations import (
    ADD,
    ARITY,
    ENTRY,
    MULTIPLY,
    NEGATE,
    OPERATIONS,
    SOLVE,
    SUBTRACT,
)
from mechanics.program.program import reachable


def partials(builder: Builder, number: int, code: int) -> tuple[Any, ...]:
    """Derivatives of a node by its operands."""
    operands = [Node(builder, builder.operands[k][number]) for k in range(ARITY[code])]
    row = OPERATIONS[code]
    assert row.partials is not None, row.name  # every row with operands has them
    return row.partials(*operands, Node(builder, number))


def system(builder: Builder, number: int) -> tuple[list[list[Node]], list[Node], bool]:
    """Matrix and right side of a linear system, and whether it is symmetric."""
    size, symmetric, *entries = builder.systems[builder.operands[0][number]]
    nodes = [Node(builder, entry) for entry in entries]
    return (
        [nodes[size * i : size * (i + 1)] for i in range(size)],
        nodes[size * size :],
        bool(symmetric),
    )


def components(builder: Builder, number: int) -> tuple[Node, ...]:
    """Its solution."""
    matrix, right, symmetric = system(builder, number)
    return builder.solve(matrix, right, symmetric=symmetric)


def gradient(
    outputs: Sequence[Node], weights: Sequence[Node | int], inputs: Sequence[Node]
) -> list[Node]:
    """sum_j w_j dy_j/dx_k for every x_k, equation (1).

    Parameters
    ----------
    outputs, weights : sequences of equal length
    inputs : sequence of Node
        Any nodes; what they are computed from is not looked into.
    """
    if not outputs:
        return [x.builder.zero for x in inputs]
    builder = outputs[0].builder
    order = reachable(builder, [y.number for y in outputs])
    varying = _varying(builder, order, {x.number for x in inputs})
    adjoints: dict[int, Node] = {}
    parts: dict[int, dict[int, Node]] = {}

    def accumulate(number: int, value: Node) -> None:
        if number in varying and not value.is_zero:
            adjoints[number] = adjoints[number] + value if number in adjoints else value

    for y, weight in zip(outputs, weights, strict=True):
        accumulate(y.number, builder.node(weight))
    leaves = {x.number for x in inputs}
    for number in reversed(order):
        code = builder.operations[number]
        if code == SOLVE and number in parts:
            _accumulate_solve(builder, number, parts[number], accumulate)
        if number not in adjoints or number in leaves:
            continue
        weight = adjoints[number]
        first, second, _ = builder.operands
        if code == ENTRY:
            of_system = parts.setdefault(first[number], {})
            of_system[second[number]] = weight
        elif code == ADD:
            accumulate(first[number], weight)
            accumulate(second[number], weight)
        elif code == SUBTRACT:
            accumulate(first[number], weight)
            accumulate(second[number], -weight)
        elif code == NEGATE:
            accumulate(first[number], -weight)
        elif code == MULTIPLY:
            a, b = first[number], second[number]
            if a in varying:
                accumulate(a, weight * Node(builder, b))
            if b in varying:
                accumulate(b, weight * Node(builder, a))
        elif ARITY[code]:
            for k, factor in enumerate(partials(builder, number, code)):
                operand = builder.operands[k][number]
                if operand in varying:
                    accumulate(operand, weight * factor)
    return [adjoints.get(x.number, builder.zero) for x in inputs]


def _varying(builder: Builder, order: Sequence[int], inputs: set[int]) -> set[int]:
    """Nodes that depend on the inputs."""
    found = set(inputs)
    for number in order:
        if any(operand in found for operand in builder.operands_of(number)):
            found.add(number)
    return found


def _accumulate_solve(
    builder: Builder, number: int, weights: Mapping[int, Node], accumulate: Any
) -> None:
    """The reverse half of equation (2)."""
    matrix, right, symmetric = system(builder, number)
    size = len(right)
    transposed = matrix if symmetric else [list(column) for column in zip(*matrix, strict=True)]
    sides = [weights.get(i, builder.zero) for i in range(size)]
    adjoint = builder.solve(transposed, sides, symmetric=symmetric)
    x = components(builder, number)
    for i in range(size):
        accumulate(right[i].number, adjoint[i])
        for j in range(size):
            accumulate(matrix[i][j].number, -(adjoint[i] * x[j]))
