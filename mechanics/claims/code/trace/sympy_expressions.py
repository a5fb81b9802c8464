"""Straight-line code as SymPy's expressions.

x = sin(2 (a + b))   ->   sin(2 a + 2 b)        arguments are written out, as SymPy compares them
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import casadi
import sympy
from sympy import Expr, Piecewise, S

from mechanics.claims.code.constants import constant_from
from mechanics.claims.functions import magnitude
from mechanics.errors import ExpressionError
from mechanics.program.casadi_reader import Instruction

LARGEST_ARGUMENT = 64
"""Terms of an argument that is written out; a longer one stays as it is."""


class Constants:
    """Constants as what they stand for; `notes` list those that were computed beforehand."""

    def __init__(self) -> None:
        self.notes: list[str] = []

    def __call__(self, number: Fraction) -> Expr:
        """One constant."""
        value, note = constant_from(number)
        if note and note not in self.notes:
            self.notes.append(note)
        return value


def expressions(
    nodes: Sequence[Instruction],
    inputs: Sequence[Sequence[Expr]],
    constants: Callable[[Fraction], Expr],
) -> list[Expr]:
    """The expression of every value.

    Parameters
    ----------
    nodes : sequence of Instruction
    inputs : sequence of sequence of Expr
        Entries of each input.
    constants : callable
        What a constant is.

    Raises
    ------
    ExpressionError
        If an operation is not supported.
    """
    found: list[Expr] = []
    for node in nodes:
        if node.constant is not None:
            found.append(constants(node.constant))
        elif node.op == casadi.OP_INPUT:
            group, entry = node.operands
            found.append(inputs[group][entry])
        elif node.op in OPERATIONS:
            found.append(OPERATIONS[node.op](*[found[i] for i in node.operands]))
        else:
            raise ExpressionError(
                f"casadi operation {_name(node.op)} has no exact meaning: write the expression"
                " without it"
            )
    return found


def _name(op: int) -> str:
    names = [n for n in dir(casadi) if n.startswith("OP_") and getattr(casadi, n) == op]
    return names[0] if names else str(op)


def _argument(x: Expr) -> Expr:
    expanded = sympy.expand(x)
    return expanded if len(sympy.Add.make_args(expanded)) <= LARGEST_ARGUMENT else x


def _of_argument(function: Any) -> Callable[[Expr], Expr]:
    return lambda x: function(_argument(x))


def _truth(relation: Any) -> Callable[[Expr, Expr], Expr]:
    """1 where a relation to 0 holds."""
    return lambda x, y: Piecewise((1, relation(x - y, 0)), (0, True))


def _side(x: Expr) -> Expr:
    """1 or -1; of zero 1, as of C's 0.0."""
    return 1 - 2 * _truth(sympy.StrictLessThan)(x, S.Zero)


def _whole_part(x: Expr) -> Expr:
    return sympy.sign(x) * sympy.floor(magnitude(x))


OPERATIONS: dict[int, Callable[..., Expr]] = {
    casadi.OP_ASSIGN: lambda x: x,
    casadi.OP_ADD: lambda x, y: x + y,
    casadi.OP_SUB: lambda x, y: x - y,
    casadi.OP_MUL: lambda x, y: x * y,
    casadi.OP_DIV: lambda x, y: x / y,
    casadi.OP_NEG: lambda x: -x,
    casadi.OP_SQ: lambda x: x * x,
    casadi.OP_TWICE: lambda x: x + x,
    casadi.OP_INV: lambda x: 1 / x,
    casadi.OP_SQRT: sympy.sqrt,
    casadi.OP_POW: lambda x, y: x**y,
    casadi.OP_CONSTPOW: lambda x, y: x**y,
    casadi.OP_SIN: _of_argument(sympy.sin),
    casadi.OP_COS: _of_argument(sympy.cos),
    casadi.OP_TAN: lambda x: sympy.sin(_argument(x)) / sympy.cos(_argument(x)),
    casadi.OP_EXP: _of_argument(sympy.exp),
    casadi.OP_EXPM1: lambda x: sympy.exp(_argument(x)) - 1,
    casadi.OP_SINH: lambda x: _grown(x, lambda e: (e - 1 / e) / 2),
    casadi.OP_COSH: lambda x: _grown(x, lambda e: (e + 1 / e) / 2),
    casadi.OP_TANH: lambda x: _grown(x, lambda e: (e * e - 1) / (e * e + 1)),
    casadi.OP_LOG: sympy.log,
    casadi.OP_LOG1P: lambda x: sympy.log(1 + x),
    casadi.OP_ASIN: sympy.asin,
    casadi.OP_ACOS: sympy.acos,
    casadi.OP_ATAN: sympy.atan,
    casadi.OP_ATAN2: sympy.atan2,
    casadi.OP_ASINH: sympy.asinh,
    casadi.OP_ACOSH: sympy.acosh,
    casadi.OP_ATANH: sympy.atanh,
    casadi.OP_ERF: sympy.erf,
    casadi.OP_FLOOR: sympy.floor,
    casadi.OP_CEIL: sympy.ceiling,
    casadi.OP_FABS: magnitude,
    casadi.OP_SIGN: sympy.sign,
    casadi.OP_FMAX: lambda x, y: (x + y + magnitude(x - y)) / 2,
    casadi.OP_FMIN: lambda x, y: (x + y - magnitude(x - y)) / 2,
    casadi.OP_HYPOT: lambda x, y: sympy.sqrt(x * x + y * y),
    casadi.OP_FMOD: lambda x, y: x - y * _whole_part(x / y),
    casadi.OP_COPYSIGN: lambda x, y: magnitude(x) * _side(y),
    casadi.OP_LT: _truth(sympy.StrictLessThan),
    casadi.OP_LE: _truth(sympy.LessThan),
    casadi.OP_EQ: _truth(sympy.Equality),
    casadi.OP_NE: lambda x, y: 1 - _truth(sympy.Equality)(x, y),
    casadi.OP_AND: lambda x, y: x * y,
    casadi.OP_OR: lambda x, y: x + y - x * y,
    casadi.OP_NOT: lambda x: 1 - x,
    casadi.OP_IF_ELSE_ZERO: lambda c, x: c * x + (1 - c) * S.Zero,
}


def _grown(x: Expr, of: Callable[[Expr], Expr]) -> Expr:
    return of(sympy.exp(_argument(x)))
