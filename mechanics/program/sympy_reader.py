"""SymPy expressions as nodes.

A float is the dyadic rational that it is; every branch of a `Piecewise` stands under its condition;
factors with negative powers are one divisor.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any, NamedTuple

import sympy
from mpmath.libmp import to_rational
from sympy import S

from mechanics.errors import ExpressionError
from mechanics.program.branches import Choice, Parts, Walk
from mechanics.program.builder import Builder, Node
from mechanics.program.operations import OPERATIONS


class _Rest(NamedTuple):
    """A `Piecewise` from its k-th case on."""

    piecewise: Any
    place: int


def read(
    builder: Builder,
    expressions: Sequence[Any],
    symbols: Mapping[Any, Node] | None = None,
) -> tuple[Node, ...]:
    """Nodes of SymPy expressions.

    Parameters
    ----------
    expressions : sequence of sympy.Basic
        Numbers, symbols, elementary functions, cases and relations.
    symbols : mapping of sympy.Basic to Node, optional
        Nodes of symbols, or of whole subexpressions such as theta(t); any other symbol becomes the
        input of its name.

    Returns
    -------
    tuple of Node
        One for each expression.

    Raises
    ------
    ExpressionError
        If an expression holds something else, which is named; or if two different symbols without a
        node have one name.

    Examples
    --------
    >>> from sympy import sin, symbols
    >>> b, (x, y) = Builder(), symbols("x y")
    >>> (node,) = read(b, [x / y + sin(x) / 3])
    >>> b.program({"f": [node]})
    <program of 4 operations: f>
    """
    return Reader(builder, symbols or {}).walk.nodes(expressions)


class Reader:
    """Reads one expression after the other: what they share is read once.

    Parameters
    ----------
    symbols : mapping of sympy.Basic to Node
        As for `read`.
    rules : mapping of type to callable, optional
        How else heads are taken apart.
    """

    def __init__(
        self, builder: Builder, symbols: Mapping[Any, Node],
        rules: Mapping[Any, Callable[[Any], Parts | Choice]] | None = None,
    ) -> None:  # fmt: skip
        self.builder = builder
        self.symbols: dict[str, Any] = {}
        own: dict[Any, Callable[[Any], Parts | Choice]] = {
            _Rest: self.case,
            sympy.Add: lambda e: Parts(e.args, self.sum),
            sympy.Mul: self.product,
            sympy.Pow: self.power,
            sympy.Symbol: self.symbol,
            sympy.Dummy: self.symbol,
            sympy.Float: self.float,
            sympy.Piecewise: lambda e: Parts((_Rest(e, 0),), lambda number: number),
            sympy.ITE: lambda e: Choice(*e.args),
        }
        self.expansions = own | dict(rules or {})
        self.walk = Walk(builder, self.expand, symbols)

    def read(self, expression: Any) -> Node:
        """The node of an expression."""
        (node,) = self.walk.nodes([expression])
        return node

    def define(self, symbol: Any, node: Node) -> bool:
        """Let a symbol be a node; False if it has been read or defined already."""
        known = self.walk.scopes[0]
        if symbol in known:
            return False
        known[symbol] = node.number
        return True

    def expand(self, expression: Any) -> Parts | Choice:
        """One expression as an operation on others."""
        # A subclass, such as a parameter that knows its unit, is read as what it is.
        for head in type(expression).__mro__:
            if head in self.expansions:
                return self.expansions[head](expression)
            if head in _RULES:
                return Parts(expression.args, self.function(_RULES[head]))
        if getattr(expression, "is_Rational", False):
            value = Fraction(int(expression.p), int(expression.q))
            return self.leaf(self.builder.number_of(value))
        raise ExpressionError(
            f"{type(expression).__name__} in {str(expression)[:60]!r} is not supported:"
            " write the expression without it"
        )

    def leaf(self, number: int) -> Parts:
        """A node without operands."""
        return Parts((), lambda: number)

    def symbol(self, symbol: Any) -> Parts:
        """The input of its name."""
        other = self.symbols.setdefault(symbol.name, symbol)
        if other != symbol:
            raise ExpressionError(
                f"two different symbols are called {symbol.name}: rename one, or say its node"
            )
        return self.leaf(self.builder.input(symbol.name).number)

    def float(self, number: Any) -> Parts:
        """The dyadic rational that it is."""
        if not number.is_finite:
            raise ExpressionError(f"constant {number}: a finite number is needed")
        return self.leaf(self.builder.number_of(Fraction(*map(int, to_rational(number._mpf_)))))

    def function(self, function: Callable[..., Node]) -> Callable[..., int]:
        """A function of nodes as one of their numbers."""
        b = self.builder

        def apply(*numbers: int) -> int:
            return function(b, *[Node(b, number) for number in numbers]).number

        return apply

    def sum(self, *numbers: int) -> int:
        """The sum of nodes."""
        return reduce(self.builder.add, numbers)

    def power(self, expression: Any) -> Parts:
        """A power; an exponent that is a number is no node."""
        b = self.builder
        base, exponent = expression.args
        if exponent.is_Rational:
            value = Fraction(int(exponent.p), int(exponent.q))
            return Parts((base,), lambda number: b.power(Node(b, number), value).number)
        return Parts((base, exponent), lambda x, y: b.power(Node(b, x), Node(b, y)).number)

    def product(self, expression: Any) -> Parts:
        """A product: coefficient, factors, and divisors with their exponents."""
        b, coefficient = self.builder, Fraction(1)
        factors: list[Any] = []
        divisors: list[Any] = []
        exponents: list[Fraction] = []
        for factor in expression.args:
            if factor.is_Rational:
                coefficient *= Fraction(int(factor.p), int(factor.q))
            elif factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative:
                divisors.append(factor.base)
                exponents.append(Fraction(-int(factor.exp.p), int(factor.exp.q)))
            else:
                factors.append(factor)
        count = len(factors)

        def apply(*numbers: int) -> int:
            above = reduce(b.multiply, numbers[:count], b.one_number)
            above = b.multiply(b.number_of(coefficient), above)
            powers = zip(numbers[count:], exponents, strict=True)
            below = [b.power(Node(b, n), exponent).number for n, exponent in powers]
            return b.divide(above, reduce(b.multiply, below)) if below else above

        return Parts((*factors, *divisors), apply)

    def case(self, rest: _Rest) -> Choice:
        """One case of a `Piecewise`."""
        cases, place = rest.piecewise.args, rest.place
        value, condition = cases[place].args
        later = _Rest(rest.piecewise, place + 1) if place + 1 < len(cases) else None
        return Choice(condition, value, later)


def _heaviside(b: Builder, x: Node, at_zero: Node) -> Node:
    return b.less(0, x).choose(1, b.call("equal", x, 0).choose(at_zero, 0))


def _chain(name: str) -> Callable[..., Node]:
    """An operation on any number of operands, one after the other."""
    return lambda b, *xs: reduce(lambda x, y: b.call(name, x, y), xs)


def _least(b: Builder, *xs: Node) -> Node:
    return reduce(lambda x, y: b.less(x, y).choose(x, y), xs)


def _greatest(b: Builder, *xs: Node) -> Node:
    return reduce(lambda x, y: b.less(x, y).choose(y, x), xs)


def _named(name: str) -> Callable[..., Node]:
    return lambda b, *operands: b.call(name, *operands)


_RULES: dict[Any, Callable[..., Node]] = {
    getattr(sympy, row.sympy): _named(row.name) for row in OPERATIONS if row.sympy and row.arity
} | {
    type(S.Pi): lambda b: b.pi,
    type(S.Exp1): lambda b: b.one.exp(),
    type(S.GoldenRatio): lambda b: (b.constant(5).sqrt() + 1) / 2,
    type(S.true): lambda b: b.one,
    type(S.false): lambda b: b.zero,
    sympy.And: _chain("and"),
    sympy.Or: _chain("or"),
    sympy.StrictGreaterThan: lambda b, x, y: b.less(y, x),
    sympy.GreaterThan: lambda b, x, y: b.call("not_greater", y, x),
    sympy.Unequality: lambda b, x, y: b.call("not", b.call("equal", x, y)),
    sympy.Min: _least,
    sympy.Max: _greatest,
    sympy.ceiling: lambda b, x: -b.call("floor", -x),
    sympy.frac: lambda b, x: x - b.call("floor", x),
    sympy.Mod: lambda b, x, y: x - y * b.call("floor", x / y),
    sympy.Heaviside: _heaviside,
    sympy.cot: lambda b, x: x.cos() / x.sin(),
    sympy.sec: lambda b, x: 1 / x.cos(),
    sympy.csc: lambda b, x: 1 / x.sin(),
    sympy.coth: lambda b, x: x.cosh() / x.sinh(),
    sympy.sech: lambda b, x: 1 / x.cosh(),
    sympy.csch: lambda b, x: 1 / x.sinh(),
}
"""What a head means; SymPy's sqrt is a power, and select a `Piecewise`."""
