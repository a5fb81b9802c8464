"""A program in extended precision with a bound of the error of every value: running error analysis.

    x + y     e_x + e_y + u |x + y|
    x y       |x| e_y + |y| e_x + e_x e_y + u |x y|
    x / y     (e_x + |x / y| e_y) / (|y| - e_y) + u |x / y|
    sqrt x    e_x / sqrt x + u sqrt x
    sin x     min(e_x, 2) + 8 u |sin x|

u is the spacing of numbers at one, twice the error of a rounding; the bounds themselves are
rounded, too, for which they are enlarged. An operation without a bound here has an infinite one.

Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, section 3.3.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from mechanics.compiled.programs.operations import OPERATIONS, unknown
from mechanics.compiled.programs.program import Program

UNIT = np.finfo(np.longdouble).eps
LEAST = np.finfo(np.longdouble).tiny
CALLS = 8
"""Bound of the error of a function of the library, in units; its documents claim one."""
SLACK = 1 + 64 * UNIT
"""For the roundings of a bound, a few operations on numbers that are not negative."""


class Near(NamedTuple):
    """Values, and how far each may be from what it stands for."""

    value: Any
    error: Any


def enclosed(code: Program, columns: Sequence[Sequence[Any]]) -> list[list[Near]]:
    """Evaluate at many states at once.

    Parameters
    ----------
    columns : for every input, for every entry, an array of its values or a `Near`

    Returns
    -------
    For every output, for every entry, a `Near`; an infinite bound where nothing is known.

    Raises
    ------
    ExpressionError
        If the graph holds an operation that is not known here; it is named.
    """
    values: list[Near] = []
    with np.errstate(all="ignore"):
        for node in code.nodes:
            if node.constant is not None:
                values.append(Near(np.longdouble(node.constant), np.longdouble(0)))
            elif node.operation == ca.OP_INPUT:
                group, entry = node.operands
                given = columns[group][entry]
                exact = Near(np.asarray(given, dtype=np.longdouble), np.longdouble(0))
                values.append(given if isinstance(given, Near) else exact)
            elif node.operation in OPERATIONS:
                parts = [values[operand] for operand in node.operands]
                values.append(_applied(node.operation, parts))
            else:
                raise unknown(node.operation)
    return [[values[node] for node in entries] for entries in code.outputs]


def total(terms: Sequence[Near]) -> Near:
    """Sum of terms."""
    found = Near(np.longdouble(0), np.longdouble(0))
    for term in terms:
        found = _rounded(found.value + term.value, found.error + term.error)
    return found


def _applied(operation: int, parts: Sequence[Near]) -> Near:
    value = OPERATIONS[operation].numpy(*(part.value for part in parts))
    if operation not in _ERRORS:
        exact = all(np.all(part.error == 0) for part in parts)
        return Near(value, CALLS * UNIT * np.abs(value) if exact else np.full_like(value, np.inf))
    return _rounded(value, _ERRORS[operation](value, *parts))


def _rounded(value: Any, error: Any) -> Near:
    """One more rounding; a bound that is no number is none."""
    bound = (error + UNIT * np.abs(value) + LEAST) * SLACK
    if not np.isfinite(bound).all():
        bound = np.where(np.isnan(bound), np.inf, bound)
    return Near(value, bound)


def _product(value: Any, x: Near, y: Near) -> Any:
    return np.abs(x.value) * y.error + np.abs(y.value) * x.error + x.error * y.error


def _quotient(value: Any, x: Near, y: Near) -> Any:
    room = np.abs(y.value) - y.error
    return np.where(room > 0, (x.error + np.abs(value) * y.error) / room, np.inf)


def _inverse(value: Any, y: Near) -> Any:
    return _quotient(value, Near(np.longdouble(1), np.longdouble(0)), y)


def _root(value: Any, x: Near) -> Any:
    return np.where(x.error == 0, 0, np.where(x.value > x.error, x.error / value, np.inf))


def _wave(value: Any, x: Near) -> Any:
    return np.minimum(x.error, 2) + CALLS * UNIT * np.abs(value)


_ERRORS: dict[int, Callable[..., Any]] = {
    ca.OP_ASSIGN: lambda value, x: x.error,
    ca.OP_ADD: lambda value, x, y: x.error + y.error,
    ca.OP_SUB: lambda value, x, y: x.error + y.error,
    ca.OP_NEG: lambda value, x: x.error,
    ca.OP_FABS: lambda value, x: x.error,
    ca.OP_TWICE: lambda value, x: 2 * x.error,
    ca.OP_MUL: _product,
    ca.OP_SQ: lambda value, x: _product(value, x, x),
    ca.OP_DIV: _quotient,
    ca.OP_INV: _inverse,
    ca.OP_SQRT: _root,
    ca.OP_SIN: _wave,
    ca.OP_COS: _wave,
}
