"""SymPy expressions as functions of time near one instant: enclosures of their Taylor coefficients.

    x(t) = x_0 + x_1 t + x_2 t^2 + O(t^3)          every x_k a ball that holds the true value

A second reading of what SymPy's objects mean, for a check that must not share an error with the
first: nothing of `mechanics.kernel`, and no derivative of SymPy's. The operations on series and
balls are Arb's (python-flint).
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import reduce
from operator import add, mul, sub
from typing import Any, TypeAlias

import sympy
from flint import arb, arb_mat, arb_series, ctx, fmpq
from sympy import Derivative, Expr, Symbol
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from mechanics.errors import ExpressionError

ORDER = 3
"""Coefficients kept: positions, velocities and half of the accelerations."""

Value: TypeAlias = Any
"""A ball, or a series of them."""

_FUNCTIONS = {
    sympy.sin: "sin", sympy.cos: "cos", sympy.tan: "tan", sympy.exp: "exp", sympy.log: "log",
    sympy.asin: "asin", sympy.acos: "acos", sympy.atan: "atan", sympy.erf: "erf",
}  # fmt: skip
_REWRITTEN = {
    sympy.cot: sympy.tan, sympy.sec: sympy.cos, sympy.csc: sympy.sin, sympy.sinh: sympy.exp,
    sympy.cosh: sympy.exp, sympy.tanh: sympy.exp, sympy.coth: sympy.exp, sympy.asinh: sympy.log,
    sympy.acosh: sympy.log, sympy.atanh: sympy.log,
}  # fmt: skip
_CONSTANTS = {sympy.pi: arb.pi, sympy.E: arb.const_e}


class OutsideDomain(Exception):
    """Something is not defined at this instant, or a comparison cannot be told."""


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with `bits` binary digits and `ORDER` coefficients, which Arb keeps in globals."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = bits, ORDER
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


@dataclass(frozen=True)
class Jet:
    """A matrix that changes with time, as its Taylor coefficients."""

    parts: tuple[arb_mat, ...]

    def __add__(self, other: "Jet") -> "Jet":
        return Jet(tuple(map(add, self.parts, other.parts)))

    def __sub__(self, other: "Jet") -> "Jet":
        return Jet(tuple(map(sub, self.parts, other.parts)))

    def __mul__(self, other: "Jet") -> "Jet":
        one, two = self.parts, other.parts
        return Jet(
            tuple(reduce(add, (one[i] * two[k - i] for i in range(k + 1))) for k in range(ORDER))
        )

    @property
    def T(self) -> "Jet":
        """Transposed."""
        return Jet(tuple(part.transpose() for part in self.parts))


@dataclass(frozen=True)
class Instant:
    """What is known at one instant.

    Attributes
    ----------
    motions : mapping of str to arb_series
        Functions of time by name: coordinates, speeds, inputs, and ``t`` itself.
    number : callable
        Of a symbol that is no function of time.
    """

    motions: Mapping[str, arb_series]
    number: Callable[[Symbol], arb]
    _values: dict[Expr, Value] = field(default_factory=dict)

    def value(self, expression: Expr) -> Value:
        """The expression, each part of it worked out once.

        Raises
        ------
        OutsideDomain
            When it is not defined here.
        ExpressionError
            When it holds an operation that is not known.
        """
        known = self._values
        if expression not in known:
            known[expression] = self._operation(sympy.sympify(expression))
        return known[expression]

    def coefficients(self, expression: Expr) -> list[arb]:
        """x_0, x_1, x_2 of the expression."""
        value = self.value(expression)
        if isinstance(value, arb):
            return [value, arb(0), arb(0)]
        return [value[k] for k in range(ORDER)]

    def matrix(self, rows: int, columns: int, entries: Iterable[Expr]) -> Jet:
        """A matrix of expressions, its entries row by row."""
        parts = zip(*map(self.coefficients, entries), strict=True)
        return Jet(tuple(arb_mat(rows, columns, list(part)) for part in parts))

    def _operation(self, e: Expr) -> Value:
        if isinstance(e, sympy.Float):
            # A decimal that a person typed is the fraction that it prints.
            e = sympy.Rational(str(e))
        if isinstance(e, sympy.Rational):
            return arb(fmpq(int(e.p), int(e.q)))
        if isinstance(e, Symbol):
            return self.motions[e.name] if e.name in self.motions else self.number(e)
        if isinstance(e, AppliedUndef):
            return self.motions[e.func.__name__]
        if e in _CONSTANTS:
            return _CONSTANTS[e]()
        if isinstance(e, Derivative):
            value = self.value(e.expr)
            for _ in range(int(e.derivative_count)):
                value = value.derivative() if isinstance(value, arb_series) else arb(0)
            return value
        if isinstance(e, sympy.Piecewise):
            return next(self.value(part) for part, condition in e.args if self.holds(condition))
        if isinstance(e, sympy.Add):
            return reduce(add, map(self.value, e.args))
        if isinstance(e, sympy.Mul):
            return reduce(mul, map(self.value, e.args))
        if type(e) in _REWRITTEN:
            return self.value(e.rewrite(_REWRITTEN[type(e)]))
        return self._function(e)

    def _function(self, e: Expr) -> Value:
        parts = [self.value(part) for part in e.args]
        if isinstance(e, sympy.Pow):
            return _power(parts[0], e.exp, parts[1])
        if type(e) in _FUNCTIONS:
            return getattr(parts[0], _FUNCTIONS[type(e)])()
        if isinstance(e, sympy.Abs):
            return parts[0] * _sign(parts[0])
        if isinstance(e, sympy.sign):
            return arb(_sign(parts[0]))
        if isinstance(e, sympy.floor | sympy.ceiling):
            side = 1 if isinstance(e, sympy.floor) else -1
            return side * _floor(side * parts[0])
        if isinstance(e, sympy.Mod):
            return parts[0] - parts[1] * _floor(parts[0] / parts[1])
        if isinstance(e, sympy.Max | sympy.Min):
            side = 1 if isinstance(e, sympy.Max) else -1
            return reduce(lambda one, two: one if _sign(one - two) == side else two, parts)
        if isinstance(e, sympy.atan2):
            y, x = parts
            if _sign(x) > 0:
                return (y / x).atan()
            return (y / x).atan() + _sign(y) * arb.pi()
        raise ExpressionError(f"{type(e).__name__} in {str(e)[:80]} is not supported by this check")

    def holds(self, condition: Any) -> bool:
        """Whether a condition of a case holds here."""
        if isinstance(condition, sympy.And):
            return all(self.holds(part) for part in condition.args)
        if isinstance(condition, sympy.Or):
            return any(self.holds(part) for part in condition.args)
        if isinstance(condition, sympy.Not):
            return not self.holds(condition.args[0])
        if isinstance(condition, Relational):
            side = _sign(self.value(condition.lhs - condition.rhs))
            return bool(condition.func(side, 0))
        return bool(condition)


def _natural(base: Value, exponent: int) -> Value:
    """By squaring: the power of Arb has no value for a ball around zero."""
    if exponent == 0:
        return arb(1)
    half = _natural(base, exponent // 2)
    return half * half * base if exponent % 2 else half * half


def _power(base: Value, exponent: Expr, value: Value) -> Value:
    if isinstance(exponent, sympy.Integer):
        if exponent < 0:
            _sign(base)
            return 1 / _natural(base, int(-exponent))
        return _natural(base, int(exponent))
    if exponent in (sympy.S.Half, -sympy.S.Half):
        root = base.sqrt()
        return root if exponent.is_positive else 1 / root
    return (base.log() * value).exp()


def _sign(value: Value) -> int:
    first = value[0] if isinstance(value, arb_series) else value
    if first > 0:
        return 1
    if first < 0:
        return -1
    raise OutsideDomain


def _floor(value: Value) -> arb:
    first = value[0] if isinstance(value, arb_series) else value
    below = first.floor()
    if not below.is_exact() or first == below:
        raise OutsideDomain
    return below
