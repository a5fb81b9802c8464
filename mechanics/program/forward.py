"""Derivatives of nodes forward along a direction.

    tangent    y' = sum_k (dy/dx_k) x_k'                            (1)
    solve      M x = f:   x' = M^-1 (f' - M' x)                     (2)

Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, chapter 3; (2): section 2.2 of
Giles, Collected matrix derivative results for forward and reverse mode AD, 2008.
"""

from collections.abc import Mapping, Sequence

from mechanics.program.builder import Builder, Node
from mechanics.program.derivatives import components, partials, system
from mechanics.program.operations import ADD, ARITY, ENTRY, MULTIPLY, NEGATE, SOLVE, SUBTRACT
from mechanics.program.program import reachable


def tangent(outputs: Sequence[Node], directions: Mapping[Node, Node]) -> list[Node]:
    """Derivatives of the outputs along a direction, equation (1).

    Parameters
    ----------
    directions : mapping of Node to Node
        x_k' for each x_k that changes; any node may be one of them, and is then not looked into.
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
    for rate, factor in zip((a, b, c), partials(builder, number, code), strict=False):
        if rate is not None:
            total = total + rate * factor
    return total


def _solution_rates(
    builder: Builder, number: int, rates: Mapping[int, Node]
) -> tuple[Node, ...] | None:
    """x' of equation (2)."""
    matrix, right, symmetric = system(builder, number)
    if not any(entry.number in rates for row in (*matrix, right) for entry in row):
        return None
    x = components(builder, number)
    zero = builder.zero
    sides = []
    for row, entry in zip(matrix, right, strict=True):
        side = rates.get(entry.number, zero)
        for factor, component in zip(row, x, strict=True):
            if factor.number in rates:
                side = side - rates[factor.number] * component
        sides.append(side)
    return builder.solve(matrix, sides, symmetric=symmetric)
