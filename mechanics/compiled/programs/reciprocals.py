"""Several quotients by one divisor as products with its reciprocal.

    x / d, y / d, ...   ->   r = 1 / d,  x r, y r, ...

With |delta| <= u = 2^-53 for every rounding (2^-24 in single precision), fl(x / d) is the quotient
times 1 + delta and fl(x fl(1 / d)) is it times (1 + delta)(1 + delta'): off by at most 2 u + u^2
of the value, 1.5 units in the last place instead of 0.5. It holds where d, 1 / d and the results
are normal numbers; 1 / d is one for 2^-1022 <= |d| <= 2^1022. Divisors that are powers of two lose
nothing.
"""

from collections import Counter

from mechanics.compiled.programs.rewriting import Rewriting
from mechanics.program.operations import DIVIDE, MULTIPLY
from mechanics.program.routine import Routine


def with_reciprocals(code: Routine, least: int = 2) -> Routine:
    """The program with one division for each divisor that has at least so many quotients."""
    counts = quotients(code)
    new = Rewriting(code.nodes)
    reciprocals: dict[int, int] = {}
    for k, node in enumerate(code.nodes):
        if node.operation != DIVIDE or counts[node.operands[1]] < least:
            new.keep(k)
            continue
        above, divisor = node.operands
        if divisor not in reciprocals:
            reciprocals[divisor] = new.add(DIVIDE, new.one(), new.of[divisor])
        inverse = reciprocals[divisor]
        if code.nodes[above].constant == 1:
            new.of[k] = inverse
        else:
            new.of[k] = new.add(MULTIPLY, new.of[above], inverse)
    return new.routine(code)


def quotients(code: Routine) -> Counter[int]:
    """How often something is divided by a node, for the divisors that are no numbers."""
    divisors = (node.operands[1] for node in code.nodes if node.operation == DIVIDE)
    return Counter(k for k in divisors if code.nodes[k].constant is None)
