"""A builder that folds nothing: what a machine rounds operation by operation, as it was written.

2 * (3 * x) is no 6 x here, x / 3 no product, and pow(x, 2) no x x. Constants change their sign.
"""

from mechanics.program.builder import Builder, Node, Number
from mechanics.program.operations import (
    ADD,
    DIVIDE,
    MULTIPLY,
    NEGATE,
    OPERATIONS,
    POWER,
    SUBTRACT,
)


class AsWritten(Builder):
    """Equal operations on equal nodes are one node; nothing else is simplified."""

    def add(self, a: int, b: int) -> int:
        """a + b."""
        return self._node(ADD, min(a, b), max(a, b))

    def subtract(self, a: int, b: int) -> int:
        """a - b."""
        return self._node(SUBTRACT, a, b)

    def negate(self, a: int) -> int:
        """-a."""
        value = self.constant_at(a)
        return self._node(NEGATE, a) if value is None else self._constant(-value)

    def multiply(self, a: int, b: int) -> int:
        """a b."""
        return self._node(MULTIPLY, min(a, b), max(a, b))

    def divide(self, a: int, b: int) -> int:
        """a / b."""
        return self._node(DIVIDE, a, b)

    def power(self, base: Node, exponent: Node | Number) -> Node:
        """base ** exponent."""
        return Node(self, self._node(POWER, base.number, self.node(exponent).number))

    def _folded(self, code: int, numbers: list[int]) -> int:
        return self._node(code, *(sorted(numbers) if OPERATIONS[code].commutative else numbers))
