"""Floats in code, and the numbers that they stand for.

    9.8 -> 49/5      1.3333333333333333 -> 4/3      6.283185307179586 -> 2 pi
    0.8660254037844386 -> sqrt(3)/2

A short decimal is what was typed. A long one was computed before the code was read: it stands for
the simplest fraction, multiple of pi or root of a fraction within 4 units in the last place, and is
listed; else it is the dyadic number that it is.
"""

from fractions import Fraction
from math import isfinite, pi, ulp

import sympy
from sympy import Expr, Rational

from mechanics.errors import InputError

ULPS = 4
TYPED_DIGITS = 12
LARGEST_DENOMINATOR, LARGEST_RADICAND = 1000, 100


def constant_of(value: float) -> tuple[Expr, str]:
    """The number that a float stands for, and a sentence where that is not what it prints.

    Raises
    ------
    InputError
        For infinities and what is no number.
    """
    if not isfinite(value):
        raise InputError(f"the constant {value} has no exact value")
    printed = repr(float(value))
    digits = printed.partition("e")[0].replace("-", "").replace(".", "").strip("0")
    if len(digits) <= TYPED_DIGITS:
        return _rational(Fraction(printed)), ""
    near = Fraction(value).limit_denominator(LARGEST_DENOMINATOR)
    if abs(near - Fraction(value)) <= ULPS * Fraction(ulp(value)):
        return _rational(near), f"{printed} is read as {near}"
    turns = Fraction(value / pi).limit_denominator(LARGEST_DENOMINATOR)
    if turns and abs(float(turns) * pi - value) <= ULPS * ulp(value):
        number = _rational(turns) * sympy.pi
        return number, f"{printed} is read as {number}"
    square = Fraction(value) ** 2
    under = square.limit_denominator(LARGEST_RADICAND)
    if under and abs(under - square) <= 2 * ULPS * abs(Fraction(value)) * Fraction(ulp(value)):
        number = sympy.sqrt(_rational(under)) * (1 if value > 0 else -1)
        return number, f"{printed} is read as {number}"
    return _rational(Fraction(value)), f"{printed} is read as the double that it is"


def constant_from(value: Fraction) -> tuple[Expr, str]:
    """`constant_of` a fraction that may be a double."""
    if value.denominator == 1 or value != Fraction(float(value)):
        return _rational(value), ""
    return constant_of(float(value))


def _rational(number: Fraction) -> Rational:
    return Rational(number.numerator, number.denominator)
