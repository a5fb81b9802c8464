"""Angles of a CasADi graph, traced back to the inputs: sum_i r_i m_i with monomials m_i.

CasADi stores sin(a/2 + b) as nodes. To follow the group law of the unit circle the argument is
expanded over the rationals into monomials of the inputs; a node that is no small polynomial of the
inputs is an atom of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import casadi

from mechanics.program.casadi_reader import Instruction as Node

if TYPE_CHECKING:
    from mechanics.exact.arithmetic import Arithmetic

Monomial = tuple[int, ...]
"""Sorted node numbers whose product it is; the empty product is 1."""

Form = dict[Monomial, Fraction]

LARGEST_FORM = 64
LARGEST_POWER = 64


class Tracer:
    """Expands arguments of sin, cos and exp, each node once; keeps them if they shall be whole."""

    def __init__(
        self,
        a: Arithmetic,
        nodes: Sequence[Node],
        numbers: list[Any],
        inputs: Sequence[Sequence[Any]],
        whole: bool = False,
    ) -> None:
        self._whole = whole
        self._a, self._nodes, self._numbers, self._inputs = a, nodes, numbers, inputs
        self._forms: dict[int, Form] = {}
        self._circles: dict[int, tuple[Any, Any]] = {}

    def circle(self, node: int) -> tuple[Any, Any]:
        """Return cosine and sine of a node."""
        if node not in self._circles:
            self._circles[node] = self._a.circle(self._terms(node))
        return self._circles[node]

    def exponential(self, node: int) -> Any:
        """Return exp of a node."""
        return self._a.exponential(self._terms(node))

    def power(self, base: int, exponent: int) -> Any:
        """Return base ** exponent; a rational constant exponent is an algebraic power."""
        number, ratio = self._numbers[base], self._nodes[exponent].constant
        if ratio is None:
            return self._a.function("power", [number, self._numbers[exponent]])
        if ratio.denominator == 1:
            return number ** int(ratio)
        if ratio.denominator > LARGEST_POWER:
            return self._a.function("power", [number, self._a.rational(ratio)])
        return self._a.root_power(number, ratio)

    def _terms(self, node: int) -> list[tuple[Fraction, Any]]:
        if self._whole:
            return [(Fraction(1), self._numbers[node])]
        return [(factor, self._product(monomial)) for monomial, factor in self._form(node).items()]

    def _product(self, monomial: Monomial) -> Any:
        result = self._a.rational(1)
        for node in monomial:
            result = result * self._numbers[node]
        return result

    def _form(self, root: int) -> Form:
        """Return the expansion of a node; the stack keeps deep graphs safe."""
        stack = [root]
        while stack:
            node = stack[-1]
            operands = self._nodes[node].operands if self._nodes[node].op in _LINEAR else ()
            missing = [operand for operand in operands if operand not in self._forms]
            if missing:
                stack.extend(missing)
                continue
            parts = [self._forms[operand] for operand in operands]
            self._forms[node] = self._combine(node, parts)
            stack.pop()
        return self._forms[root]

    def _combine(self, index: int, parts: list[Form]) -> Form:
        node = self._nodes[index]
        if node.constant is not None:
            return {(): node.constant} if node.constant else {}
        form: Form | None = None
        if node.op in (casadi.OP_ADD, casadi.OP_SUB):
            form = _add(parts[0], parts[1], 1 if node.op == casadi.OP_ADD else -1)
        elif node.op in (casadi.OP_NEG, casadi.OP_TWICE):
            form = _add({}, parts[0], -1 if node.op == casadi.OP_NEG else 2)
        elif node.op in (casadi.OP_MUL, casadi.OP_SQ):
            form = _multiply(parts[0], parts[-1])
        elif node.op == casadi.OP_DIV and parts[1].keys() == {()}:
            form = _add({}, parts[0], 1 / parts[1][()])
        if form is None or len(form) > LARGEST_FORM:
            return {(index,): Fraction(1)}
        return form


_LINEAR = frozenset(
    (casadi.OP_ADD, casadi.OP_SUB, casadi.OP_NEG, casadi.OP_TWICE, casadi.OP_MUL, casadi.OP_SQ,
     casadi.OP_DIV)
)  # fmt: skip


def _add(left: Form, right: Form, factor: int | Fraction) -> Form:
    result = dict(left)
    for monomial, value in right.items():
        total = result.get(monomial, Fraction(0)) + factor * value
        if total:
            result[monomial] = total
        else:
            result.pop(monomial, None)
    return result


def _multiply(left: Form, right: Form) -> Form | None:
    if len(left) * len(right) > LARGEST_FORM:
        return None
    result: Form = {}
    for one, factor in left.items():
        product = {tuple(sorted(one + other)): factor * value for other, value in right.items()}
        result = _add(result, product, 1)
    return result
