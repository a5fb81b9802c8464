"""Integers of C beside unsigned ones: refused where they leave the integers.

    -1 < 1u  is false,      (1u - 2) * x  is 4294967295 x,      -7 / 2u  is 2147483644

C makes both sides unsigned, modulo 2^32. As long as no side and no result is negative that changes
nothing, and sums and products beyond an int are refused anyway. So in a text that has unsigned
integers a negative one may only be a literal, ``-2``, beside a real number or in a signed variable.
"""

from __future__ import annotations

from typing import Any

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.exact.c.condition import Choice, Decision
from mechanics.exact.c.parse import Source
from mechanics.exact.c.statements import Statements
from mechanics.exact.c.types import Type, declared
from mechanics.exact.c.values import Real, Value
from mechanics.exact.c.whole import Whole

NAMES = frozenset({"unsigned", "size_t", "uint32_t", "uint64_t"})


def has_unsigned(source: Source) -> bool:
    """Whether a function of a text has unsigned integers."""
    return any(_has(node) for node in source.functions.values())


def _has(node: Any) -> bool:
    if isinstance(node, c_ast.IdentifierType) and NAMES & set(node.names):
        return True
    if isinstance(node, c_ast.Constant) and "unsigned" in node.type:
        return True
    return any(_has(child) for _, child in node.children())


class Integers(Statements):
    """Statements whose integers stay what they are for mathematics.

    Attributes
    ----------
    unsigned : bool
        Whether the text has unsigned integers.
    """

    def __init__(self, unsigned: bool) -> None:
        super().__init__()
        self.unsigned = unsigned

    def combined(self, op: str, left: Value, right: Value, where: Any) -> Value:
        """left op right; no integer of it is negative beside unsigned ones."""
        result = super().combined(op, left, right, where)
        if not (isinstance(left, Real) or isinstance(right, Real)):
            self._natural(where, left, right, result)
        return result

    def converted(self, value: Value | None, kind: Type, where: Any) -> Value:
        """A value as a variable of a type holds it."""
        if NAMES & set(kind.words.split()):
            self._natural(where, value)
        return super().converted(value, kind, where)

    def _unary(self, node: Any) -> Value:
        result = super()._unary(node)
        if node.op == "-" and isinstance(result, Whole):
            literal = isinstance(node.expr, c_ast.Constant) and not _has(node.expr)
            self._natural(node.coord, *(() if literal else (self.value(node.expr), result)))
        return result

    def _ternary(self, node: Any) -> Value:
        result = super()._ternary(node)
        if not isinstance(result, Real):
            self._natural(node.coord, result)
            self._natural(node.coord, self.value(node.iftrue), self.value(node.iffalse))
        return result

    def _cast(self, node: Any) -> Value:
        result = super()._cast(node)
        if NAMES & set(declared(node.to_type).words.split()):
            self._natural(node.coord, result)
        return result

    def _natural(self, where: Any, *values: Value | None) -> None:
        """Refuse negative integers in a text with unsigned ones."""
        if self.unsigned and any(_is_negative(value) for value in values):
            raise ExpressionError(
                f"{where}: a negative integer in a text with unsigned integers, beside which C"
                " makes it 4294967296 larger: write int, without u"
            )


def _is_negative(value: Value | None) -> bool:
    if isinstance(value, Choice):
        return _least(value) < 0
    return isinstance(value, Whole) and value.known is not None and value.known < 0


def _least(decision: Decision) -> int:
    if isinstance(decision, Choice):
        return min(_least(decision.yes), _least(decision.no))
    return decision
