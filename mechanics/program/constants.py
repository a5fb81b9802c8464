"""Constants: read from text, and on their way to double precision."""

import re
from fractions import Fraction

from mechanics.errors import RangeError

EXPONENT = re.compile(r"[eE][+-]?0*([\d_]+)\s*\Z")
TURN = re.compile(r"([+-]?)\s*(?:([\d.eE+-]+|\d+/\d+)\s*\*?\s*)?pi(?:\s*/\s*([\d.]+))?")
"""A multiple of pi: its sign, factor and divisor."""
DIGITS = 4
"""Of an exponent: doubles have three, and 10^99999999 takes minutes to be written out."""


def rational(text: str) -> Fraction:
    """The rational that a decimal or a fraction is.

    Raises
    ------
    ValueError
        If it is neither.
    ZeroDivisionError
        For 1/0.
    RangeError
        If its exponent is far beyond those of doubles.
    """
    found = EXPONENT.search(text)
    if found and len(found[1]) > DIGITS:
        float(text)  # what is no number is told first
        raise RangeError(f"{text[:40]}: doubles lie between 1e-308 and 1.8e308")
    return Fraction(text)


def with_pi(text: str) -> tuple[Fraction, bool]:
    """A number, or how many times pi it is; and whether it is a multiple of pi."""
    turn = TURN.fullmatch(text)
    if turn is None:
        return rational(text), False
    sign, factor, divisor = turn.groups()
    return Fraction(f"{sign}1") * rational(factor or "1") / rational(divisor or "1"), True


def unit_fraction(value: Fraction) -> int | None:
    """The whole number n of 1/n, where x / n rounds once and x (1/n) would round twice."""
    divisor = value.denominator * value.numerator
    single = abs(value.numerator) == 1 and value.denominator & (value.denominator - 1)
    return divisor if single and abs(divisor) < 1 << 53 else None


def is_double(value: Fraction) -> bool:
    """Whether a double holds the rational exactly."""
    try:
        return Fraction(float(value)) == value
    except OverflowError:
        return False
