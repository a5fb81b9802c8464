"""Operations of other languages that have no row in the table: written in those that have one."""

from collections.abc import Callable
from typing import NamedTuple

from mechanics.program.builder import Builder, Node


class Composed(NamedTuple):
    """What such an operation means, and of how many operands."""

    arity: int
    build: Callable[..., Node]


def _fmod(b: Builder, x: Node, y: Node) -> Node:
    quotient = b.call("divide", x, y)
    whole = b.call("floor", b.call("abs", quotient))
    return x - y * b.less(quotient, 0).choose(-whole, whole)


COMPOSED = {
    "expm1": Composed(1, lambda b, x: x.exp() - 1),
    "log1p": Composed(1, lambda b, x: (1 + x).log()),
    "ceil": Composed(1, lambda b, x: -b.call("floor", -x)),
    "hypot": Composed(2, lambda b, x, y: (x * x + y * y).sqrt()),
    "copysign": Composed(2, lambda b, x, y: b.less(y, 0).choose(-abs(x), abs(x))),
    "fmod": Composed(2, _fmod),
    "fmax": Composed(2, lambda b, x, y: b.less(x, y).choose(y, x)),
    "fmin": Composed(2, lambda b, x, y: b.less(x, y).choose(x, y)),
    "not_equal": Composed(2, lambda b, x, y: b.call("not", b.call("equal", x, y))),
}


def build(b: Builder, name: str, *operands: Node) -> Node:
    """The node of an operation, by its name in the table or here."""
    composed = COMPOSED.get(name)
    return composed.build(b, *operands) if composed else b.call(name, *operands)
