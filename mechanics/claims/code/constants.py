"""Floats in code, and the numbers that they stand for.

    9.8 -> 49/5      1.3333333333333333 -> 4/3      6.283185307179586 -> 2 pi
    0.8660254037844386 -> sqrt(3)/2      0.042799000000000004 -> 42799/1000000

A short decimal is what was typed. A long one was computed before the code was read: it stands for
the simplest fraction, decimal of eight digits, multiple of pi or root of a fraction within 4 units
in the last place, and is listed; else it is the dyadic number that it is. The parts of these are
bounded, so that fewer than one in a million of random doubles is next to one.
"""

from fractions import Fraction
from math import isfinite, pi, ulp
from typing import Any

import sympy
from sympy import Expr, Rational

from mechanics.errors import InputError

ULPS = 4
TYPED_DIGITS = 12
DECIMAL_DIGITS, PARTS = 8, (1, 3, 12)
LARGEST_DENOMINATOR, LARGEST_UNDER_ROOT, LARGEST_NUMERATOR = 1000, 100, 10**5


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
    near = _simplest(Fraction(value))
    if near and abs(near - Fraction(value)) <= ULPS * Fraction(ulp(value)):
        return _rational(near), f"{printed} is read as {near}"
    if (sum_or_product := _decimal(value)) is not None:
        return _rational(sum_or_product), f"{printed} is read as {sum_or_product}"
    turns = _simplest(Fraction(value / pi))
    if turns and abs(float(turns) * pi - value) <= ULPS * ulp(value):
        number = _rational(turns) * sympy.pi
        return number, f"{printed} is read as {number}"
    square = Fraction(value) ** 2
    under = _simplest(square, LARGEST_UNDER_ROOT)
    if under and abs(under - square) <= 2 * ULPS * abs(Fraction(value)) * Fraction(ulp(value)):
        number = sympy.sqrt(_rational(under)) * (1 if value > 0 else -1)
        return number, f"{printed} is read as {number}"
    return _rational(Fraction(value)), f"{printed} is read as the double that it is"


def _decimal(value: float) -> Fraction | None:
    """The short decimal, or its third or twelfth, that code has rounded: 0.127*0.337 in doubles.

    Short enough that fewer than one in a million of random doubles is next to one.
    """
    for part in PARTS:
        near = Fraction(f"{value * part:.{DECIMAL_DIGITS - 1}e}") / part
        if abs(near - Fraction(value)) <= ULPS * Fraction(ulp(value)):
            return near
    return None


def _simplest(value: Fraction, denominator: int = LARGEST_DENOMINATOR) -> Fraction | None:
    """The fraction with small parts that is nearest, if it has any."""
    found = value.limit_denominator(denominator)
    return found if 0 < abs(found.numerator) <= LARGEST_NUMERATOR else None


def constant_from(value: Fraction) -> tuple[Expr, str]:
    """`constant_of` a fraction that may be a double."""
    if value.denominator == 1 or value != Fraction(float(value)):
        return _rational(value), ""
    return constant_of(float(value))


def _rational(number: Fraction) -> Rational:
    return Rational(number.numerator, number.denominator)


def exact_in_single(value: float, single: Any) -> None:
    """Refuse a number that a precision below that of doubles has rounded: its formula is another.

    Raises
    ------
    InputError
    """
    if isfinite(value) and float(single) != value:
        raise InputError(
            f"{value!r} is rounded to {float(single)!r} as {type(single).__name__}, which is no"
            " exact formula: write it as a double"
        )
