"""The functions that a text may call, by every name that people give them."""

from collections.abc import Callable
from typing import Any

import sympy
from sympy import Abs, Max, Min

Made = Callable[..., Any]


def _one(function: Any) -> tuple[int, int, Made]:
    return 1, 1, function


def _extreme(function: Any) -> Made:
    """The largest or smallest, as it was written: SymPy would compare every pair for long."""
    return lambda *given: function(*given, evaluate=False) if len(given) > 1 else given[0]


def magnitude(of: Any) -> Any:
    """The absolute value; that of a formula as it was written: SymPy would factor it for long."""
    return Abs(of, evaluate=of.is_Atom or of.is_number)


def modulo(a: Any, b: Any) -> Any:
    """a - b floor(a/b), of the sign of b."""
    return a - b * sympy.floor(quotient(a, b))


def remainder(a: Any, b: Any) -> Any:
    """a - b times the whole part of a/b, of the sign of a."""
    ratio = quotient(a, b)
    return a - b * sympy.sign(ratio) * sympy.floor(sympy.Abs(ratio))


def quotient(a: Any, b: Any) -> Any:
    """a / b; by 0 it has no value, which is what it asks for, and any number may stand for it."""
    return a / b if b != 0 else sympy.S.Zero


def _length(a: Any, b: Any) -> Any:
    return sympy.sqrt(a**2 + b**2)


_ALIASES: dict[Any, str] = {
    sympy.sin: "sin sen", sympy.cos: "cos", sympy.tan: "tan tg", sympy.cot: "cot ctg",
    sympy.sec: "sec", sympy.csc: "csc cosec",
    sympy.asin: "asin arcsin", sympy.acos: "acos arccos", sympy.atan: "atan arctan",
    sympy.sinh: "sinh", sympy.cosh: "cosh", sympy.tanh: "tanh", sympy.coth: "coth",
    sympy.asinh: "asinh arcsinh arsinh", sympy.acosh: "acosh arccosh arcosh",
    sympy.atanh: "atanh arctanh artanh",
    sympy.exp: "exp", sympy.log: "ln log", sympy.sqrt: "sqrt",
    magnitude: "abs Abs fabs absolute", sympy.sign: "sign sgn",
}  # fmt: skip

FUNCTIONS: dict[str, tuple[int, int, Made]] = {
    **{name: _one(f) for f, names in _ALIASES.items() for name in names.split()},
    "atan2": (2, 2, sympy.atan2),
    "arctan2": (2, 2, sympy.atan2),
    "hypot": (2, 2, _length),
    **{name: (2, 2, modulo) for name in ("mod", "Mod")},
    **{name: (2, 2, remainder) for name in ("rem", "fmod")},
    **{name: (2, 6, _extreme(Max)) for name in ("max", "Max")},
    **{name: (2, 6, _extreme(Min)) for name in ("min", "Min")},
    **{name: (2, 2, _extreme(Max)) for name in ("maximum", "fmax")},
    **{name: (2, 2, _extreme(Min)) for name in ("minimum", "fmin")},
}  # fmt: skip
"""Least and largest number of arguments, and what makes the expression."""

INVERSES: dict[str, str] = {
    "sin": "asin", "cos": "acos", "tan": "atan", "sinh": "asinh", "cosh": "acosh", "tanh": "atanh",
}  # fmt: skip
"""What sin^{-1} means."""
