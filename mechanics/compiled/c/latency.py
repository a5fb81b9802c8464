"""Products in the order in which their factors are ready.

    ((m a) b) r   ->   (m a b) r            where r, a reciprocal, is known last

A processor works at several lanes at a time, but not at enough of them to hide a long chain of
operations that wait for each other. Of a product of many factors the two that are known first are
multiplied first, so that the last one is waited for once. What all states share comes before all.
"""

import heapq
from collections.abc import Sequence

import casadi as ca

from mechanics.compiled.c.flow import constant, users
from mechanics.compiled.program import Node, Program
from mechanics.compiled.rewriting import Rewriting

CYCLES = {
    ca.OP_INPUT: 5, ca.OP_DIV: 16, ca.OP_INV: 16, ca.OP_SQRT: 20, ca.OP_SIN: 60, ca.OP_COS: 60,
}  # fmt: skip
"""From operands to result, about; for the inline sine from its text."""
USUAL = 4
"""Of a sum, a product or both in one."""


def early_products(code: Program, shared: Sequence[str]) -> Program:
    """The program with the factors of every product in another order.

    Parameters
    ----------
    shared : inputs that are the same for all states
    """
    used, same = users(code), constant(code, shared)
    inside = {
        i
        for k, node in enumerate(code.nodes)
        if _is_product(node) and not same[k]
        for i in node.operands
        if _is_product(code.nodes[i]) and len(used[i]) == 1 and not same[i]
    }
    new, ready = Rewriting(code.nodes), dict[int, int]()
    for k, node in enumerate(code.nodes):
        if k in inside:
            continue
        if _is_product(node) and not same[k]:
            factors = [new.of[i] for i in _factors(code, k, inside)]
            new.of[k] = _multiplied(factors, new, ready)
        else:
            at = new.keep(k)
            ready[at] = 0 if same[k] else _ready(new.nodes[at], ready)
    return new.program(code)


def _multiplied(factors: Sequence[int], new: Rewriting, ready: dict[int, int]) -> int:
    """Multiply the two factors that are ready first until there is one; of no state's own first."""
    heap = [(ready[i], i) for i in factors]
    heapq.heapify(heap)
    while len(heap) > 1:
        (early, first), (late, second) = heapq.heappop(heap), heapq.heappop(heap)
        if first == second:
            node = Node(ca.OP_SQ, (first,), None)
        else:
            node = Node(ca.OP_MUL, (first, second), None)
        product = new.add(node)
        ready[product] = _ready(node, ready) if early or late else 0
        heapq.heappush(heap, (ready[product], product))
    return heap[0][1]


def _ready(node: Node, ready: dict[int, int]) -> int:
    """When a value is known, in cycles from the start of a lane."""
    operands = () if node.operation == ca.OP_INPUT else node.operands
    return max((ready[i] for i in operands), default=0) + CYCLES.get(node.operation, USUAL)


def _is_product(node: Node) -> bool:
    return node.operation in (ca.OP_MUL, ca.OP_SQ)


def _factors(code: Program, k: int, inside: set[int]) -> list[int]:
    """The factors of a product, with those of products that nothing else uses."""
    node = code.nodes[k]
    operands = node.operands * 2 if node.operation == ca.OP_SQ else node.operands
    found: list[int] = []
    for i in operands:
        found += _factors(code, i, inside) if i in inside else [i]
    return found
