"""What each operation of a graph does to Taylor series.

    sqrt   y' = x' / (2 y)            log    y' = x' / x          x^a    y' = x' a y / x
    asin   y' = x' / sqrt(1 - x^2)    atan   y' = x' / (1 + x^2)
    erf    y' = x' 2 exp(-x^2) / sqrt(pi)

Comparisons, magnitudes and roundings have no series: a solution that passes a kink is not analytic
there, and a method of order forty is one of order one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
from flint import arb

from mechanics.errors import ExpressionError

if TYPE_CHECKING:
    from mechanics.simulate.reference_series import Series, Taylor

Operation = Callable[..., "Series"]


@dataclass(frozen=True)
class Function:
    """A function of one number, with all the digits that are wanted.

    Attributes
    ----------
    name : str
        In C.
    exact : callable
    by : Series or None
        The second argument, a constant.
    """

    name: str
    exact: Callable[[arb], arb]
    by: Any = None

    def __call__(self, x: arb) -> arb:
        """Its value."""
        return self.exact(x)


def operation_name(operation: int) -> str:
    """CasADi's name of an operation."""
    names = [n for n in dir(ca) if n.startswith("OP_") and getattr(ca, n) == operation]
    return names[0] if names else str(operation)


def not_analytic(operation: int) -> ExpressionError:
    """The error for an operation that is not in the table."""
    return ExpressionError(
        f"CasADi operation {operation_name(operation)} has no Taylor series, so there is no"
        " reference solution: write the equations without it"
    )


def _root(t: Taylor, x: Series) -> Series:
    return t.chain(x, Function("sqrt", arb.sqrt), lambda y: t.quotient(t.number(0.5), y))


def _power(t: Taylor, x: Series, a: Series) -> Series:
    if not a.constant:
        return _exponential(t, t.product(a, _logarithm(t, x)))
    power = Function("pow", lambda v: v ** (arb(a[0]) / arb(2) ** t.bits), a)
    return t.chain(x, power, lambda y: t.quotient(t.product(a, y), x))


def _exponential(t: Taylor, x: Series) -> Series:
    return t.chain(x, Function("exp", arb.exp), lambda y: y)


def _logarithm(t: Taylor, x: Series) -> Series:
    return t.chain(x, Function("log", arb.log), lambda y: t.quotient(t.number(1.0), x))


def _error_function(t: Taylor, x: Series) -> Series:
    def slope(y: Series) -> Series:
        bell = _exponential(t, t.scaled(t.product(x, x), -1))
        return t.quotient(t.scaled(bell, 2), t.chain(t.number(1.0), ROOT_OF_PI, lambda y: y))

    return t.chain(x, Function("erf", arb.erf), slope)


ROOT_OF_PI = Function("root_of_pi", lambda one: arb.pi().sqrt())


def _inverse(function: Function, one: int, square: int, rooted: bool, sign: int = 1) -> Operation:
    """y' = sign x' / (one + square x^2), or over its root."""

    def operation(t: Taylor, x: Series) -> Series:
        def slope(y: Series) -> Series:
            below = t.sum(t.number(one), t.product(x, x), square)
            return t.quotient(t.number(1.0), _root(t, below) if rooted else below)

        return t.chain(x, function, slope, sign)

    return operation


def _acosh(t: Taylor, x: Series) -> Series:
    def slope(y: Series) -> Series:
        return t.quotient(t.number(1.0), _root(t, t.sum(t.product(x, x), t.number(1.0), -1)))

    return t.chain(x, Function("acosh", arb.acosh), slope)


def _wave(circular: bool, entry: int) -> Operation:
    return lambda t, x: t.wave(x, circular)[entry]


def _ratio(circular: bool) -> Operation:
    return lambda t, x: t.quotient(*t.wave(x, circular))


def _square(t: Taylor, x: Series) -> Series:
    return t.product(x, x)


OPERATIONS: dict[int, Any] = {
    ca.OP_ASSIGN: lambda t, x: x,
    ca.OP_ADD: lambda t, x, y: t.sum(x, y),
    ca.OP_SUB: lambda t, x, y: t.sum(x, y, -1),
    ca.OP_NEG: lambda t, x: t.scaled(x, -1),
    ca.OP_TWICE: lambda t, x: t.scaled(x, 2),
    ca.OP_MUL: lambda t, x, y: t.product(x, y),
    ca.OP_SQ: _square,
    ca.OP_DIV: lambda t, x, y: t.quotient(x, y),
    ca.OP_INV: lambda t, x: t.quotient(t.number(1.0), x),
    ca.OP_SQRT: _root,
    ca.OP_POW: _power,
    ca.OP_CONSTPOW: _power,
    ca.OP_HYPOT: lambda t, x, y: _root(t, t.sum(_square(t, x), _square(t, y))),
    ca.OP_EXP: _exponential,
    ca.OP_EXPM1: lambda t, x: t.sum(_exponential(t, x), t.number(1.0), -1),
    ca.OP_LOG: _logarithm,
    ca.OP_LOG1P: lambda t, x: _logarithm(t, t.sum(x, t.number(1.0))),
    ca.OP_SIN: _wave(True, 0),
    ca.OP_COS: _wave(True, 1),
    ca.OP_TAN: _ratio(True),
    ca.OP_SINH: _wave(False, 0),
    ca.OP_COSH: _wave(False, 1),
    ca.OP_TANH: _ratio(False),
    ca.OP_ASIN: _inverse(Function("asin", arb.asin), 1, -1, True),
    ca.OP_ACOS: _inverse(Function("acos", arb.acos), 1, -1, True, -1),
    ca.OP_ATAN: _inverse(Function("atan", arb.atan), 1, 1, False),
    ca.OP_ASINH: _inverse(Function("asinh", arb.asinh), 1, 1, True),
    ca.OP_ACOSH: _acosh,
    ca.OP_ATANH: _inverse(Function("atanh", arb.atanh), 1, -1, False),
    ca.OP_ERF: _error_function,
}
