"""Quotients by one divisor that are added, as one quotient.

    a x / d + b / d   ->   (a x + b) / d

A division less for each. Only what nothing else uses is gathered. The terms share the rounding of
the quotient instead of having one each; products come before the division instead of after it, and
have to be normal numbers as every other value.
"""

from collections import Counter
from dataclasses import dataclass

from mechanics.compiled.programs.rewriting import Rewriting
from mechanics.program.operations import ADD, DIVIDE, INPUT, MULTIPLY, NEGATE, SUBTRACT
from mechanics.program.routine import Node, Routine

SUMS = (ADD, SUBTRACT)


@dataclass(frozen=True)
class _Fractions:
    """By node the divisor of a fraction, and which of its operands are fractions themselves."""

    divisor: dict[int, int]
    inner: dict[int, tuple[int, ...]]


def gathered(code: Routine) -> Routine:
    """The program with sums of quotients by one divisor as quotients."""
    found = _fractions(code)
    tops, within = _marked(code, found)
    if not within:
        return code
    new = Rewriting(code.nodes)
    # A node within a fraction is rewritten as its numerator.
    for k, node in enumerate(code.nodes):
        if k not in within:
            new.keep(k)
            continue
        if node.operation == DIVIDE:
            new.of[k] = new.of[node.operands[0]]
        else:
            new.keep(k)
        if k in tops:
            divisor = new.of[found.divisor[k]]
            new.of[k] = new.add(DIVIDE, new.of[k], divisor)
    return new.routine(code)


def _fractions(code: Routine) -> _Fractions:
    """Quotients, products with one, and sums of two by the same divisor; each used once."""
    uses = Counter(i for node in code.nodes if _computed(node) for i in node.operands)
    uses.update(k for nodes in code.outputs for k in nodes)
    found = _Fractions({}, {})

    def fraction(i: int) -> int | None:
        return found.divisor.get(i) if uses[i] == 1 else None

    for k, node in enumerate(code.nodes):
        if node.operation == DIVIDE and code.nodes[node.operands[1]].constant is None:
            found.divisor[k], found.inner[k] = node.operands[1], ()
        elif node.operation == NEGATE and (of := fraction(node.operands[0])) is not None:
            found.divisor[k], found.inner[k] = of, node.operands
        elif node.operation in (MULTIPLY, *SUMS):
            of, other = map(fraction, node.operands)
            if node.operation in SUMS and of is not None and of == other:
                found.divisor[k], found.inner[k] = of, node.operands
            elif node.operation == MULTIPLY and other is None and of is not None:
                found.divisor[k], found.inner[k] = of, node.operands[:1]
            elif node.operation == MULTIPLY and of is None and other is not None:
                found.divisor[k], found.inner[k] = other, node.operands[1:]
    return found


def _marked(code: Routine, found: _Fractions) -> tuple[set[int], set[int]]:
    """Sums that become quotients, and every node whose numerator is wanted for one."""
    sums = {k for k in found.divisor if code.nodes[k].operation in SUMS}
    tops: set[int] = set()
    within: set[int] = set()
    for k in sorted(sums, reverse=True):
        if k in within:
            continue
        tops.add(k)
        waiting = [k]
        while waiting:
            within.add(i := waiting.pop())
            waiting += found.inner[i]
    return tops, within


def _computed(node: Node) -> bool:
    return node.constant is None and node.operation != INPUT
