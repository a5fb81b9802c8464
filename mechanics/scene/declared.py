"""What people type, read strictly: a text is no number, and a decimal is the fraction it prints.

0.1 m L**2    is read as    m L**2 / 10
"""

from typing import Any

from sympy import Expr, Float, Rational, Tuple, nan, oo, sympify, zoo
from sympy.core.sympify import SympifyError

from mechanics.errors import SceneError


def scalar(value: Any, what: str) -> Expr:
    """A scalar expression that a person gave.

    Raises
    ------
    SceneError
        When it is no scalar, or not finite and real; `what` names it.
    """
    try:
        read = None if isinstance(value, str) or value is None else sympify(value)
    except SympifyError:
        read = None
    if not isinstance(read, Expr):
        raise SceneError(
            f"{what} is {value!r}, a {type(value).__name__}: give a number or a SymPy expression"
        )
    if read.has(nan, oo, -oo, zoo) or read.is_real is False:
        raise SceneError(f"{what} is {read}: give a finite real number or expression")
    return decimals(read)


def decimals(expression: Expr) -> Expr:
    """The expression with each float replaced by the decimal that it prints.

    SymPy folds floats with rounding wherever they meet, so that two routes would get coefficients
    that differ in the last digit.
    """
    floats = expression.atoms(Float) if isinstance(expression, Expr) else ()
    return expression.xreplace({number: Rational(str(number)) for number in floats})


def kind_of(value: Any) -> str:
    """How messages call what was found: ``'B', a str``."""
    shown = str(value) if isinstance(value, Expr | Tuple) else repr(value)
    return f"{shown[:60]}, a {type(value).__name__}"
