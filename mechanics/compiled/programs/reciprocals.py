"""Several quotients by one divisor as products with its reciprocal.

    x / d, y / d, ...   ->   r = 1 / d,  x r, y r, ...

With |delta| <= u = 2^-53 for every rounding (2^-24 in single precision), fl(x / d) is the quotient
times 1 + delta and fl(x fl(1 / d)) is it times (1 + delta)(1 + delta'): off by at most 2 u + u^2
of the value, 1.5 units in the last place instead of 0.5. It holds where d, 1 / d and the results
are normal numbers; 1 / d is one for 2^-1022 <= |d| <= 2^1022. Divisors that are powers of two lose
nothing.
"""

from collections import Counter

import casadi as ca

from mechanics.compiled.programs.program import Node, Program
from mechanics.compiled.programs.rewriting import Rewriting

ROUNDING = 2
"""Roundings of x (1 / d), at most, in units of u; a quotient has one."""


def with_reciprocals(code: Program, least: int = 2) -> Program:
    """The program with one division for each divisor that has at least so many quotients."""
    counts = quotients(code)
    new = Rewriting(code.nodes)
    reciprocals: dict[int, int] = {}
    for k, node in enumerate(code.nodes):
        divisor = node.operands[-1] if node.operation in (ca.OP_DIV, ca.OP_INV) else None
        if divisor is None or counts[divisor] < least:
            new.keep(k)
            continue
        if divisor not in reciprocals:
            at = (new.of[divisor],)
            reciprocals[divisor] = new.add(Node(ca.OP_INV, at, None))
        inverse = reciprocals[divisor]
        if node.operation == ca.OP_INV:
            new.of[k] = inverse
        else:
            operands = (new.of[node.operands[0]], inverse)
            new.of[k] = new.add(Node(ca.OP_MUL, operands, None))
    return new.program(code)


def quotients(code: Program) -> Counter[int]:
    """How often something is divided by a node, for the divisors that are no numbers."""
    return Counter(
        node.operands[-1]
        for node in code.nodes
        if node.operation in (ca.OP_DIV, ca.OP_INV)
        and code.nodes[node.operands[-1]].constant is None
    )


def divisions(code: Program) -> int:
    """Number of divisions in a program."""
    return sum(node.operation in (ca.OP_DIV, ca.OP_INV) for node in code.nodes)
