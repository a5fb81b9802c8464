"""The operations of a CasADi graph: how each is written in C and computed with NumPy."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from mechanics.errors import ExpressionError


class Operation(NamedTuple):
    """One operation.

    Attributes
    ----------
    text : str
        C, with {0} and {1} for the operands and {one} for the literal 1 of the precision. Functions
        are written ``sin(...)`` and take their suffix from the precision.
    level : int
        How tightly it binds: 1 sum, 2 product, 3 sign, 4 call or atom.
    numpy : callable
    """

    text: str
    level: int
    numpy: Callable[..., Any]


SUM, PRODUCT, SIGN, ATOM = 1, 2, 3, 4


def _call(name: str, numpy: Callable[..., Any], arity: int = 1) -> Operation:
    arguments = ", ".join(f"{{{i}}}" for i in range(arity))
    return Operation(f"{name}{{f}}({arguments})", ATOM, numpy)


def _test(symbol: str, numpy: Callable[..., Any]) -> Operation:
    return Operation(
        f"({{0}} {symbol} {{1}} ? {{one}} : {{zero}})", ATOM, lambda x, y: _number(numpy(x, y), x)
    )


def _number(condition: Any, like: Any) -> Any:
    return np.asarray(condition).astype(np.asarray(like).dtype)


OPERATIONS: dict[int, Operation] = {
    ca.OP_ASSIGN: Operation("{0}", ATOM, lambda x: x),
    ca.OP_ADD: Operation("{0} + {1}", SUM, np.add),
    ca.OP_SUB: Operation("{0} - {1}", SUM, np.subtract),
    ca.OP_MUL: Operation("{0} * {1}", PRODUCT, np.multiply),
    ca.OP_DIV: Operation("{0} / {1}", PRODUCT, np.divide),
    ca.OP_NEG: Operation("-{0}", SIGN, np.negative),
    ca.OP_SQ: Operation("{0} * {0}", PRODUCT, lambda x: x * x),
    ca.OP_TWICE: Operation("{two} * {0}", PRODUCT, lambda x: x + x),
    ca.OP_INV: Operation("{one} / {0}", PRODUCT, lambda x: _number(1, x) / x),
    ca.OP_SQRT: _call("sqrt", np.sqrt),
    ca.OP_FABS: _call("fabs", np.abs),
    ca.OP_SIN: _call("sin", np.sin),
    ca.OP_COS: _call("cos", np.cos),
    ca.OP_TAN: _call("tan", np.tan),
    ca.OP_ASIN: _call("asin", np.arcsin),
    ca.OP_ACOS: _call("acos", np.arccos),
    ca.OP_ATAN: _call("atan", np.arctan),
    ca.OP_ATAN2: _call("atan2", np.arctan2, 2),
    ca.OP_SINH: _call("sinh", np.sinh),
    ca.OP_COSH: _call("cosh", np.cosh),
    ca.OP_TANH: _call("tanh", np.tanh),
    ca.OP_ASINH: _call("asinh", np.arcsinh),
    ca.OP_ACOSH: _call("acosh", np.arccosh),
    ca.OP_ATANH: _call("atanh", np.arctanh),
    ca.OP_EXP: _call("exp", np.exp),
    ca.OP_EXPM1: _call("expm1", np.expm1),
    ca.OP_LOG: _call("log", np.log),
    ca.OP_LOG1P: _call("log1p", np.log1p),
    ca.OP_ERF: _call("erf", np.vectorize(math.erf)),
    ca.OP_POW: _call("pow", np.power, 2),
    ca.OP_CONSTPOW: _call("pow", np.power, 2),
    ca.OP_HYPOT: _call("hypot", np.hypot, 2),
    ca.OP_COPYSIGN: _call("copysign", np.copysign, 2),
    ca.OP_FMAX: _call("fmax", np.fmax, 2),
    ca.OP_FMIN: _call("fmin", np.fmin, 2),
    ca.OP_FLOOR: _call("floor", np.floor),
    ca.OP_CEIL: _call("ceil", np.ceil),
    # Zero and not-a-number stay what they are, as in CasADi.
    ca.OP_SIGN: Operation(
        "({0} > {zero} ? {one} : ({0} < {zero} ? -{one} : {0}))", ATOM, np.sign
    ),
    ca.OP_LT: _test("<", np.less),
    ca.OP_LE: _test("<=", np.less_equal),
    ca.OP_EQ: _test("==", np.equal),
    ca.OP_NE: _test("!=", np.not_equal),
    ca.OP_AND: Operation(
        "({0} != {zero} && {1} != {zero} ? {one} : {zero})", ATOM,
        lambda x, y: _number(np.logical_and(x, y), x),
    ),
    ca.OP_OR: Operation(
        "({0} != {zero} || {1} != {zero} ? {one} : {zero})", ATOM,
        lambda x, y: _number(np.logical_or(x, y), x),
    ),
    ca.OP_NOT: Operation(
        "({0} == {zero} ? {one} : {zero})", ATOM, lambda x: _number(np.logical_not(x), x)
    ),
    ca.OP_IF_ELSE_ZERO: Operation(
        "({0} != {zero} ? {1} : {zero})", ATOM, lambda c, x: np.where(c, x, _number(0, x))
    ),
}  # fmt: skip


def unknown(operation: int) -> ExpressionError:
    """The error for an operation that is not in the table."""
    names = [n for n in dir(ca) if n.startswith("OP_") and getattr(ca, n) == operation]
    return ExpressionError(
        f"CasADi operation {names[0] if names else operation} cannot be written in C:"
        " write the expression without it"
    )
