"""An experiment as a statement of the kernel: an arithmetic whose numbers are nodes of a builder.

The experiment runs once. What it asks of a point (a rank, whether something is zero) is answered at
a random point of a field, where a wrong answer has a chance below 2^-90.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy

from mechanics.errors import ExpressionError
from mechanics.exact.arithmetic import Arithmetic, Term, as_fraction
from mechanics.exact.signals import DivisionHere, Inadmissible
from mechanics.kernel import Range, Statement
from mechanics.kernel.field import Inadmissible as NoPoint
from mechanics.kernel.independence import generic_rank, zeros
from mechanics.kernel.statement import LEFT, POSITIVE, RIGHT
from mechanics.program import Builder, Node


class NodeNumber:
    """A node that mixes with Python and SymPy rationals."""

    __slots__ = ("node",)

    def __init__(self, node: Node) -> None:
        self.node = node

    def _lift(self, other: Any) -> Node:
        return node_of(self.node.builder, other)

    def __add__(self, other: Any) -> NodeNumber:
        return NodeNumber(self.node + self._lift(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> NodeNumber:
        return NodeNumber(self.node - self._lift(other))

    def __rsub__(self, other: Any) -> NodeNumber:
        return NodeNumber(self._lift(other) - self.node)

    def __mul__(self, other: Any) -> NodeNumber:
        return NodeNumber(self.node * self._lift(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> NodeNumber:
        return NodeNumber(_divided(self.node, self._lift(other)))

    def __rtruediv__(self, other: Any) -> NodeNumber:
        return NodeNumber(_divided(self._lift(other), self.node))

    def __neg__(self) -> NodeNumber:
        return NodeNumber(-self.node)

    def __pow__(self, exponent: int) -> NodeNumber:
        if exponent < 0:
            return NodeNumber(_divided(self.node.builder.one, self.node.power(-exponent)))
        return NodeNumber(self.node.power(exponent))


def _divided(above: Node, below: Node) -> Node:
    if below.is_zero:
        raise DivisionHere("division by zero")
    return above / below


def node_of(builder: Builder, number: Any) -> Node:
    """A number of this arithmetic, or an exact rational, as a node."""
    return number.node if isinstance(number, NodeNumber) else builder.node(as_fraction(number))


FUNCTIONS = {
    "log", "asin", "acos", "atan", "atan2", "asinh", "acosh", "atanh", "erf", "floor", "power",
}  # fmt: skip


class NodeArithmetic(Arithmetic):
    """Arithmetic that builds a program."""

    def __init__(self) -> None:
        super().__init__()
        self.builder = Builder()
        self.signs: dict[str, Range] = {}
        self.positive: list[Node] = []
        self._names: dict[str, sympy.Basic] = {}

    def _call(self, name: str, *operands: Any) -> NodeNumber:
        nodes = [node_of(self.builder, operand) for operand in operands]
        return NodeNumber(self.builder.call(name, *nodes))

    def rational(self, number: int | Fraction) -> NodeNumber:
        """A constant."""
        return NodeNumber(self.builder.node(as_fraction(number)))

    def symbol(self, symbol: sympy.Symbol) -> NodeNumber:
        """An input of its name, or of a longer one where another symbol has that."""
        if not isinstance(symbol, sympy.Symbol):
            raise ExpressionError(f"{symbol} is no symbol")
        name = str(symbol)
        while self._names.setdefault(name, symbol) != symbol:
            name += "'"
        known = Range.FREE
        if symbol.is_positive:
            known = Range.POSITIVE
        elif symbol.is_nonnegative:
            known = Range.NONNEGATIVE
        elif symbol.is_negative:
            known = Range.NEGATIVE
        self.signs[name] = known
        return NodeNumber(self.builder.input(name))

    def constant(self, constant: sympy.Expr) -> NodeNumber:
        """Pi, e, and what is made of roots."""
        if constant is sympy.S.Pi:
            return NodeNumber(self.builder.pi)
        if constant is sympy.S.Exp1:
            return NodeNumber(self.builder.one.exp())
        if constant is sympy.S.GoldenRatio:
            return NodeNumber((self.builder.constant(5).sqrt() + 1) / 2)
        raise ExpressionError(f"constant {constant} has no enclosure: declare it as a symbol")

    def _sum(self, terms: Sequence[Term]) -> Node:
        total = self.builder.zero
        for factor, number in terms:
            total = total + node_of(self.builder, number) * factor
        return total

    def circle(self, terms: Sequence[Term]) -> tuple[NodeNumber, NodeNumber]:
        """Cosine and sine of the sum."""
        total = self._sum(terms)
        return NodeNumber(total.cos()), NodeNumber(total.sin())

    def exponential(self, terms: Sequence[Term]) -> NodeNumber:
        """The exponential of the sum."""
        return NodeNumber(self._sum(terms).exp())

    def root_power(self, number: Any, exponent: Fraction) -> NodeNumber:
        """A rational power."""
        return NodeNumber(node_of(self.builder, number).power(exponent))

    def absolute(self, number: Any) -> NodeNumber:
        """The absolute value."""
        return self._call("abs", number)

    def sign(self, number: Any) -> NodeNumber:
        """The sign."""
        return self._call("sign", number)

    def indicator(self, relation: str, difference: Any) -> NodeNumber:
        """A comparison with zero."""
        names = {"<": "less", "<=": "not_greater", "==": "equal"}
        return self._call(names[relation], difference, 0)

    def select(self, condition: Any, yes: Any, no: Any) -> NodeNumber:
        """A choice."""
        return self._call("select", condition, yes, no)

    def function(self, name: str, arguments: Sequence[Any]) -> NodeNumber:
        """An operation of the table, or one that is known by congruence only.

        An unknown function f(x, y) is erf(a + b x + c y) with a, b, c of its own: equal for equal
        arguments, different for others, and a real function for a witness.
        """
        if name == "ceil":
            return -self._call("floor", -arguments[0])
        if name in FUNCTIONS:
            return self._call(name, *arguments)
        total = self.builder.input(f"{name}: 0")
        for place, argument in enumerate(arguments, 1):
            factor = self.builder.input(f"{name}: {place}")
            total = total + factor * node_of(self.builder, argument)
        return NodeNumber(self.builder.call("erf", total))

    def solve(self, rows: Sequence[Sequence[Any]], rhs: Sequence[Any]) -> list[NodeNumber]:
        """One linear system."""
        matrix = [[node_of(self.builder, entry) for entry in row] for row in rows]
        right = [node_of(self.builder, entry) for entry in rhs]
        return [NodeNumber(node) for node in self.builder.solve(matrix, right)]

    def _asked(self, ask: Callable[..., Any], nodes: Sequence[Node], *columns: int) -> Any:
        program = self.builder.program({"asked": nodes, POSITIVE: self.positive})
        try:
            return ask(program, "asked", *columns, self.signs)
        except NoPoint as reason:
            raise Inadmissible(str(reason)) from reason

    def rank(self, rows: Sequence[Sequence[Any]]) -> int:
        """The rank at a point."""
        entries = [node_of(self.builder, entry) for row in rows for entry in row]
        if not entries:
            return 0
        rank: int = self._asked(generic_rank, entries, len(rows[0]))
        return rank

    def is_zero(self, number: Any) -> bool:
        """Whether it is zero at a point."""
        node = node_of(self.builder, number)
        if node.constant is not None:
            return node.is_zero
        answer: bool = self._asked(zeros, [node])[0]
        return answer

    def require_positive(self, number: Any) -> None:
        """State that it is positive."""
        self.positive.append(node_of(self.builder, number))


Experiment = Callable[[Arithmetic], Sequence[tuple[Any, Any]]]
"""Returns pairs of numbers that should be equal."""


def statement(subject: str, experiment: Experiment, target: float) -> Statement:
    """The statement that all pairs of an experiment are equal.

    Raises
    ------
    ValueError
        If it compares nothing.
    Inadmissible
        If the experiment says that no state is admissible.
    """
    a = NodeArithmetic()
    pairs = list(experiment(a))
    outputs: Mapping[str, list[Node]] = {
        LEFT: [node_of(a.builder, left) for left, _ in pairs],
        RIGHT: [node_of(a.builder, right) for _, right in pairs],
        POSITIVE: a.positive,
        **{
            str(symbol): [number.node]
            for symbol, number in a.memo.items()
            if isinstance(symbol, sympy.Symbol) and not isinstance(symbol, sympy.Dummy)
            and isinstance(number, NodeNumber) and str(symbol) not in a.signs
        },
    }  # fmt: skip
    return Statement(subject, a.builder.program(outputs), a.signs, target=target)
