"""What the outputs of straight-line code ask of its operations, and under which conditions.

    c ? sqrt(x) : 0        ->  sqrt of x where c
    x > 0 && sqrt(x) > 1   ->  sqrt of x where x > 0

A node that is reached on several ways is asked for where one of them is taken.
"""

from collections.abc import Iterator, Sequence

import casadi
from sympy import And, Basic, Eq, Expr, Le, Lt, Ne, Not, Or, S

from mechanics.claims.demands import Demand, of_function, of_power
from mechanics.program.casadi_reader import Instruction as Node

MOST_WAYS = 8
"""To one node, each with its conditions; of more ways, what they have in common."""

Way = frozenset[tuple[int, bool]]

ALWAYS: frozenset[Way] = frozenset({frozenset()})

RELATIONS = {
    casadi.OP_LT: Lt, casadi.OP_LE: Le, casadi.OP_EQ: Eq, casadi.OP_NE: Ne,
}  # fmt: skip
FUNCTIONS = {
    casadi.OP_SQRT: "sqrt", casadi.OP_LOG: "log", casadi.OP_TAN: "tan", casadi.OP_ASIN: "asin",
    casadi.OP_ACOS: "acos", casadi.OP_ACOSH: "acosh", casadi.OP_ATANH: "atanh",
}  # fmt: skip


def demands_of(nodes: Sequence[Node], numbers: Sequence[Expr], output: int) -> tuple[Demand, ...]:
    """Demands of one output.

    Parameters
    ----------
    nodes : sequence of Node
        Operands before results.
    numbers : sequence of Expr
        What each node is.
    output : int
        Number of a node.
    """
    ways: dict[int, frozenset[Way]] = {output: ALWAYS}
    found: dict[Demand, None] = {}
    for place in range(output, -1, -1):
        here = ways.pop(place, None)
        if here is None or nodes[place].op in (casadi.OP_INPUT, casadi.OP_CONST):
            continue
        node = nodes[place]
        for operand, added in _needed(node):
            more = _under(here, added)
            ways[operand] = _least(ways.get(operand, frozenset()) | more)
        own = tuple(_asked(node.op, [numbers[i] for i in node.operands]))
        for way in here if own else ():
            conditions = tuple((_truth(nodes, numbers, c), yes) for c, yes in sorted(way))
            found.update(dict.fromkeys(demand.under(conditions) for demand in own))
    return tuple(found)


def _needed(node: Node) -> Iterator[tuple[int, tuple[int, bool] | None]]:
    """Operands, and what has to hold for their values to matter."""
    op, operands = node.op, node.operands
    if op == casadi.OP_IF_ELSE_ZERO:
        yield operands[0], None
        yield operands[1], (operands[0], True)
    elif op in (casadi.OP_AND, casadi.OP_OR):
        # C looks at the second one only where the first does not decide, whichever that is here.
        for one, other in (operands, operands[::-1]):
            yield one, (other, op == casadi.OP_AND)
    else:
        for operand in operands:
            yield operand, None


def _under(ways: frozenset[Way], added: tuple[int, bool] | None) -> frozenset[Way]:
    return ways if added is None else frozenset(way | {added} for way in ways)


def _least(ways: frozenset[Way]) -> frozenset[Way]:
    """Without ways that are taken only where another one is."""
    kept = frozenset(way for way in ways if not any(other < way for other in ways))
    return kept if len(kept) <= MOST_WAYS else frozenset({frozenset.intersection(*kept)})


def _truth(nodes: Sequence[Node], numbers: Sequence[Expr], place: int) -> Basic:
    """What decides, as a comparison."""
    op, operands, _ = nodes[place]
    if op in (casadi.OP_AND, casadi.OP_OR, casadi.OP_NOT):
        parts = [_truth(nodes, numbers, operand) for operand in operands]
        return {casadi.OP_AND: And, casadi.OP_OR: Or, casadi.OP_NOT: Not}[op](*parts)
    if op in RELATIONS:
        return RELATIONS[op](*(numbers[operand] for operand in operands))
    return Ne(numbers[place], 0)


def _asked(op: int, operands: list[Expr]) -> Iterator[Demand]:
    if op == casadi.OP_DIV:
        yield from of_power(operands[1], S.NegativeOne)
    elif op == casadi.OP_INV:
        yield from of_power(operands[0], S.NegativeOne)
    elif op in (casadi.OP_POW, casadi.OP_CONSTPOW):
        yield from of_power(*operands)
    elif op == casadi.OP_LOG1P:
        yield from of_function("log", [1 + operands[0]])
    elif op in FUNCTIONS:
        yield from of_function(FUNCTIONS[op], operands)
