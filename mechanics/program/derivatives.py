"""Derivatives of nodes: forward along a direction, and in reverse.

    tangent    y' = sum_k (dy/dx_k) x_k'                            (1)
    gradient   sum_j w_j dy_j/dx_k   for all k, in one walk         (2)
    solve      M x = f:   x' = M^-1 (f' - M' x);                    (3)
               a weight w of x is M^-T w on f and -(M^-T w) x^T on M

Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, chapter 3; (3): section 2.2 of
Giles, Collected matrix derivative results for forward and reverse mode AD, 2008.
"""

from __future__ import annotations

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


def tangent(outputs: Sequence[Node], directions: Mapping[Node, Node]) -> list[Node]:
    """Derivatives of the outputs along a direction, equation (1).

    Parameters
    ----------
    outputs : sequence of Node
    directions : mapping of Node to Node
        x_k' for each x_k that changes; any node may be one of them, and is then not looked into.

    Returns
    -------
    list of Node
    """
    if not outputs:
        return []
    builder = outputs[0].builder
    rates: dict[int, Node] = {x.number: rate for x, rate in directions.items()}
    solutions: dict[int, tuple[Node, ...]] = {}
    for number in reachable(builder, [y.number for y in outputs]):
        if number in rates:
            continue
        code = builder.operations[number]
        if code == SOLVE:
            rate = _solution_rates(builder, number, rates)
            if rate is not None:
                solutions[number] = rate
        elif code == ENTRY:
            system = builder.operands[0][number]
            if system in solutions:
                rates[number] = solutions[system][builder.operands[1][number]]
        elif ARITY[code]:
            rate_of_node = _rate(builder, number, code, rates)
            if rate_of_node is not None and not rate_of_node.is_zero:
                rates[number] = rate_of_node
    return [rates.get(y.number, builder.zero) for y in outputs]


def _rate(builder: Builder, number: int, code: int, rates: Mapping[int, Node]) -> Node | None:
    """Rate of one node from those of its operands, or None where it does not change."""
    first, second, third = builder.operands
    arity = ARITY[code]
    a = rates.get(first[number])
    b = rates.get(second[number]) if arity > 1 else None
    c = rates.get(third[number]) if arity > 2 else None
    if a is None and b is None and c is None:
        return None
    if code == MULTIPLY:
        left = a * Node(builder, second[number]) if a is not None else None
        right = b * Node(builder, first[number]) if b is not None else None
        return left if right is None else right if left is None else left + right
    if code == ADD:
        return a if b is None else b if a is None else a + b
    if code == SUBTRACT:
        return a if b is None else -b if a is None else a - b
    if code == NEGATE:
        return -a if a is not None else None
    total = builder.zero
    for rate, factor in zip((a, b, c), _partials(builder, number, code), strict=False):
        if rate is not None:
            total = total + rate * factor
    return total


def _partials(builder: Builder, number: int, code: int) -> tuple[Any, ...]:
    operands = [Node(builder, builder.operands[k][number]) for k in range(ARITY[code])]
    partials = OPERATIONS[code].partials
    assert partials is not None, OPERATIONS[code].name  # every row with operands has them
    return partials(*operands, Node(builder, number))


def _system(builder: Builder, number: int) -> tuple[list[list[Node]], list[Node], bool]:
    size, symmetric, *entries = builder.systems[builder.operands[0][number]]
    nodes = [Node(builder, entry) for entry in entries]
    return (
        [nodes[size * i : size * (i + 1)] for i in range(size)],
        nodes[size * size :],
        bool(symmetric),
    )


def _components(builder: Builder, number: int) -> tuple[Node, ...]:
    matrix, right, symmetric = _system(builder, number)
    return builder.solve(matrix, right, symmetric=symmetric)


def _solution_rates(
    builder: Builder, number: int, rates: Mapping[int, Node]
) -> tuple[Node, ...] | None:
    """x' of equation (3)."""
    matrix, right, symmetric = _system(builder, number)
    if not any(entry.number in rates for row in (*matrix, right) for entry in row):
        return None
    x = _components(builder, number)
    zero = builder.zero
    sides = []
    for row, entry in zip(matrix, right, strict=True):
        side = rates.get(entry.number, zero)
        for factor, component in zip(row, x, strict=True):
            if factor.number in rates:
                side = side - rates[factor.number] * component
        sides.append(side)
    return builder.solve(matrix, sides, symmetric=symmetric)


def gradient(
    outputs: Sequence[Node], weights: Sequence[Node | int], inputs: Sequence[Node]
) -> list[Node]:
    """sum_j w_j dy_j/dx_k for every x_k, equation (2).

    Parameters
    ----------
    outputs, weights : sequences of equal length
    inputs : sequence of Node
        Any nodes; what they are computed from is not looked into.

    Returns
    -------
    list of Node
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
            for k, factor in enumerate(_partials(builder, number, code)):
                operand = builder.operands[k][number]
                if operand in varying:
                    accumulate(operand, weight * factor)
    return [adjoints.get(x.number, builder.zero) for x in inputs]


def _varying(builder: Builder, order: Sequence[int], inputs: set[int]) -> set[int]:
    """Nodes that depend on the inputs."""
    found = set(inputs)
    for number in order:
        code = builder.operations[number]
        if code == SOLVE:
            operands: Sequence[int] = builder.systems[builder.operands[0][number]][2:]
        else:
            operands = [builder.operands[k][number] for k in range(ARITY[code])]
        if any(operand in found for operand in operands):
            found.add(number)
    return found


def _accumulate_solve(
    builder: Builder, number: int, weights: Mapping[int, Node], accumulate: Any
) -> None:
    """The reverse half of equation (3)."""
    matrix, right, symmetric = _system(builder, number)
    size = len(right)
    transposed = matrix if symmetric else [list(column) for column in zip(*matrix, strict=True)]
    sides = [weights.get(i, builder.zero) for i in range(size)]
    adjoint = builder.solve(transposed, sides, symmetric=symmetric)
    x = _components(builder, number)
    for i in range(size):
        accumulate(right[i].number, adjoint[i])
        for j in range(size):
            accumulate(matrix[i][j].number, -(adjoint[i] * x[j]))
