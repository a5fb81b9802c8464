"""Formulas on the command line: ``--at r=l/3``, ``--speeds theta_dot=sqrt(M*g/(m*r))``.

Numbers stay exact. Nothing is run: Python's own parser gives the tree, and a table its operations.
"""

import ast
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sympy import Expr, Rational, Symbol, asin, atan, cos, pi, sin, sqrt, tan, zoo

from mechanics.cli.values import pairs, points
from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.program.constants import rational

LONGEST = 400
"""Characters of a formula."""
NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
STEEPEST = 100
"""The largest exponent."""
ACCEPTED = ", pi/2, or a formula in parameters: l/3, sqrt(g/l)"
FUNCTIONS = {f.__name__: f for f in (sqrt, sin, cos, tan, asin, atan)}
OPERATIONS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b, ast.Div: lambda a, b: a / b,
}  # fmt: skip


def formulas(
    entries: Sequence[str], option: str, symbols: Mapping[str, Symbol], more: bool = False
) -> dict[str, Expr]:
    """Read ``name=value`` entries; numbers as for `points`, or formulas in symbols.

    Parameters
    ----------
    symbols : mapping of str to Symbol
        Parameters, by name.
    more : bool
        Whether a name that is not among them is a symbol of its own.

    Raises
    ------
    InputError
        As `points`.
    """
    values: dict[str, Expr] = {}
    for name, text, entry in pairs(entries, option):
        used = {*NAME.findall(text)} - {"pi"}
        formula = used and (more or used & {*symbols} or any(sign in text for sign in "*/^+-("))
        if formula and "=" not in text:
            values[name] = _Reader(f"{option} {entry!r}", text, symbols, more).value()
        else:
            values |= points([entry], option, ACCEPTED)
    return values


class _Reader:
    """One formula."""

    def __init__(self, where: str, text: str, symbols: Mapping[str, Symbol], more: bool) -> None:
        self.where, self.symbols, self.more = where, symbols, more
        self.text = text.replace("^", "**")

    def value(self) -> Expr:
        try:
            if len(self.text) > LONGEST:
                raise self.refusal(self.text[:20] + "...")
            return self.read(ast.parse(self.text, mode="eval").body)
        except SyntaxError:
            raise self.refusal(self.text) from None

    def read(self, node: ast.expr) -> Expr:
        match node:
            case ast.Constant(value=int() | float()):
                return self.number(node)
            case ast.Name(id=name):
                return self.symbol(name)
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return -self.read(inner)
            case ast.UnaryOp(op=ast.UAdd(), operand=inner):
                return self.read(inner)
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                power = self.read(right)
                if not power.is_Rational or abs(power) > STEEPEST:
                    raise self.refusal(self.part(right))
                return self.finite(self.read(left) ** power, right)
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in OPERATIONS:
                both = self.read(left), self.read(right)
                return self.finite(OPERATIONS[type(operator)](*both), right)
            case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
                return self.finite(FUNCTIONS[name](self.read(inner)), inner)
        raise self.refusal(self.part(node))

    def number(self, node: ast.expr) -> Expr:
        try:
            exact = rational(self.part(node))
        except ValueError:
            raise self.refusal(self.part(node)) from None
        return Rational(exact.numerator, exact.denominator)

    def symbol(self, name: str) -> Expr:
        if name == "pi":
            return pi
        if name not in self.symbols and not self.more:
            there = instead(name, self.symbols, "parameters") if self.symbols else ""
            raise self.refusal(name, there)
        return self.symbols.get(name, Symbol(name, real=True))

    def finite(self, value: Expr, part: ast.expr) -> Expr:
        if not value.is_finite and value.has(zoo):
            raise self.refusal(self.part(part))
        return value

    def part(self, node: ast.expr) -> str:
        return ast.get_source_segment(self.text, node) or self.text

    def refusal(self, part: str, there: str = "") -> InputError:
        return InputError(
            f"{self.where}: {part!r} is no number, {'' if self.more else 'parameter, '}or formula"
            f" of {', '.join(FUNCTIONS)}: write 0.5, 1e-3, 1/3{ACCEPTED}"
            + (f"; {there}" if there else "")
        )
