"""Expressions as data: a list of nodes, each made of earlier ones.

    ["symbol", 3]  ["number", "2/3"]  ["constant", "pi"]  ["add", 0, 4]  ["power", 2, 1]  ["sin", 5]

What is read is looked up in tables and nothing is evaluated as a program; a node that is in none of
the tables is refused.
"""

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import sympy
from sympy import Expr, Symbol
from sympy.logic.boolalg import Boolean, BooleanFalse, BooleanTrue

from mechanics.errors import ExpressionError
from mechanics.symbolic.decimals import float_as_rational

Record = list[Any]

NUMBER = re.compile(r"-?\d{1,4000}(/[1-9]\d{0,3999})?\Z")
LARGEST_POWER = 100_000
"""Binary digits of a power of numbers."""

CONSTANTS = {
    "pi": sympy.pi, "e": sympy.E, "golden_ratio": sympy.GoldenRatio,
    "euler_gamma": sympy.EulerGamma, "catalan": sympy.Catalan,
    "true": sympy.true, "false": sympy.false,
}  # fmt: skip
MANY: dict[str, Any] = {
    "add": sympy.Add, "multiply": sympy.Mul, "maximum": sympy.Max, "minimum": sympy.Min,
    "and": sympy.And, "or": sympy.Or,
}  # fmt: skip
ONE: dict[str, Any] = {
    name: getattr(sympy, name)
    for name in (
        "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "sinh", "cosh", "tanh",
        "coth", "asinh", "acosh", "atanh", "exp", "log", "erf", "floor", "ceiling", "sign",
    )
} | {"absolute": sympy.Abs, "not": sympy.Not}  # fmt: skip
TWO: dict[str, Any] = {
    "power": sympy.Pow, "atan2": sympy.atan2, "<": sympy.StrictLessThan, "<=": sympy.LessThan,
    ">": sympy.StrictGreaterThan, ">=": sympy.GreaterThan, "==": sympy.Equality,
    "!=": sympy.Unequality,
}  # fmt: skip
PIECEWISE = "piecewise"
NAMES = {kind: name for table in (MANY, ONE, TWO) for name, kind in table.items()}
NAMED = {number: name for name, number in CONSTANTS.items()}

SIGNS = ("positive", "negative", "nonnegative", "nonpositive", "real")
"""What is known about a symbol; the first that holds."""


class Writer:
    """Collects expressions that share their parts.

    Attributes
    ----------
    symbols : list of [str, str]
        Name and sign of each symbol.
    nodes : list
    """

    def __init__(self) -> None:
        self.symbols: list[list[str]] = []
        self.nodes: list[Record] = []
        self._symbols: dict[Symbol, int] = {}
        self._places: dict[sympy.Basic, int] = {}

    def symbol(self, symbol: Symbol) -> int:
        """Number of a symbol."""
        if symbol not in self._symbols:
            self._symbols[symbol] = len(self.symbols)
            sign = next((s for s in SIGNS if getattr(symbol, f"is_{s}")), "complex")
            self.symbols.append([symbol.name, sign])
        return self._symbols[symbol]

    def add(self, expression: Expr) -> int:
        """Number of the node of an expression; the stack keeps deep ones safe.

        Raises
        ------
        ExpressionError
            If an operation is in none of the tables.
        """
        root = sympy.sympify(expression)
        stack = [root]
        while stack:
            node = stack[-1]
            parts = _parts(node)
            missing = [part for part in parts if part not in self._places]
            if node in self._places or not missing:
                stack.pop()
                if node not in self._places:
                    self._places[node] = len(self.nodes)
                    self.nodes.append(self._record(node, [self._places[p] for p in parts]))
            else:
                stack.extend(missing)
        return self._places[root]

    def _record(self, node: sympy.Basic, parts: Sequence[int]) -> Record:
        if isinstance(node, Symbol):
            return ["symbol", self.symbol(node)]
        if isinstance(node, sympy.Float):
            node = float_as_rational(node)
        if isinstance(node, sympy.Rational):
            return ["number", str(Fraction(int(node.p), int(node.q)))]
        if node in NAMED:
            return ["constant", NAMED[node]]
        if isinstance(node, sympy.Piecewise):
            return [PIECEWISE, *parts]
        if type(node) in NAMES:
            return [NAMES[type(node)], *parts]
        raise ExpressionError(
            f"{type(node).__name__} in {str(node)[:60]} cannot be written to a file of evidence"
        )


def _parts(node: sympy.Basic) -> tuple[sympy.Basic, ...]:
    if isinstance(node, sympy.Piecewise):
        return tuple(part for pair in node.args for part in pair.args)
    if isinstance(node, Symbol | sympy.Number | sympy.NumberSymbol | BooleanTrue | BooleanFalse):
        return ()
    return tuple(node.args)


def read_symbols(records: Any) -> list[Symbol]:
    """Symbols of a file.

    Raises
    ------
    ExpressionError
        If they are not names and signs.
    """
    found = []
    for record in _list(records, "symbols"):
        if (
            not isinstance(record, list)
            or len(record) != 2
            or not all(isinstance(part, str) for part in record)
            or record[1] not in (*SIGNS, "complex")
        ):
            raise ExpressionError(f"symbol {str(record)[:60]}: a name and a sign are expected")
        name, sign = record
        found.append(Symbol(name) if sign == "complex" else Symbol(name, **{sign: True}))
    return found


def read_nodes(records: Any, symbols: Sequence[Symbol]) -> list[Any]:
    """Expressions of a file, each made of earlier ones.

    Raises
    ------
    ExpressionError
        For a node that is in none of the tables, or is not made of earlier ones.
    """
    found: list[Any] = []
    for number, record in enumerate(_list(records, "nodes")):
        if not isinstance(record, list) or not record or not isinstance(record[0], str):
            raise ExpressionError(f"node {number}: [operation, ...] is expected")
        try:
            found.append(_node(record[0], record[1:], found, symbols))
        except (TypeError, ValueError) as error:
            raise ExpressionError(f"node {number}, {str(record)[:60]}: {error}") from None
    return found


def _node(name: str, given: list[Any], found: list[Any], symbols: Sequence[Symbol]) -> Any:
    if name == "number":
        return _number(given)
    if name == "constant" and len(given) == 1 and given[0] in CONSTANTS:
        return CONSTANTS[given[0]]
    if name == "symbol" and len(given) == 1:
        return symbols[index(given[0], len(symbols))]
    parts = [found[index(place, len(found))] for place in given]
    if name == "power" and len(parts) == 2:
        return _power(*parts)
    if name == PIECEWISE and parts and len(parts) % 2 == 0:
        pairs = zip(_only(parts[::2], Expr), _only(parts[1::2], Boolean), strict=True)
        return sympy.Piecewise(*pairs)
    logical = name in ("and", "or", "not")
    if name in MANY and parts:
        return MANY[name](*_only(parts, Boolean if logical else Expr))
    if name in ONE and len(parts) == 1:
        return ONE[name](*_only(parts, Boolean if logical else Expr))
    if name in TWO and len(parts) == 2:
        return TWO[name](*_only(parts, Expr))
    raise ExpressionError("no such operation")


def _only(parts: Sequence[Any], kind: Any) -> Sequence[Any]:
    for part in parts:
        if not isinstance(part, kind):
            raise ExpressionError(f"{str(part)[:40]} is no operand of it")
    return parts


def _number(given: list[Any]) -> Expr:
    if len(given) != 1 or not isinstance(given[0], str) or not NUMBER.match(given[0]):
        raise ExpressionError("a number is expected as 2/3")
    ratio = Fraction(given[0])
    return sympy.Rational(ratio.numerator, ratio.denominator)


def _power(base: Expr, exponent: Expr) -> Expr:
    """A power, unless it would be a number that fills the memory."""
    _only((base, exponent), Expr)
    if base.is_Rational and exponent.is_Rational:
        digits = max(int(base.p).bit_length(), int(base.q).bit_length())
        if digits * abs(float(exponent)) > LARGEST_POWER:
            raise ExpressionError("the power is too large")
    return sympy.Pow(base, exponent)


def index(value: Any, size: int) -> int:
    """A place in a list.

    Raises
    ------
    ExpressionError
        If it is none.
    """
    if type(value) is not int or not 0 <= value < size:
        raise ExpressionError(f"{str(value)[:40]} is no place among {size}")
    return value


def _list(value: Any, name: str) -> list[Any]:
    if not isinstance(value, list):
        raise ExpressionError(f"{name}: a list is expected")
    return value
