"""Numbers written in C: the exact value that a literal has once it is rounded to its type.

0x1.8p+1 -> 3,    0.1 -> 3602879701896397 / 2^55,    0.1f -> 13421773 / 2^27,    010 -> 8
"""

import re
import struct
from fractions import Fraction
from typing import NamedTuple

from mechanics.errors import ExpressionError

WHOLE = re.compile(r"(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)[uU]?(?:[lL]|ll|LL)?[uU]?\Z")
DECIMAL = re.compile(r"(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?([fFlL]?)\Z")
HEXADECIMAL = re.compile(
    r"0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)[pP][+-]?\d+([fFlL]?)\Z"
)
LONGEST = 1200
"""Characters of a literal: more digits than any double has."""


class Literal(NamedTuple):
    """A number and its type: ``int``, ``double`` or ``float``."""

    kind: str
    value: Fraction


def literal(text: str) -> Literal:
    """Value and type of a literal.

    Raises
    ------
    ExpressionError
        If it is a long double, too large for its type, or no number.
    """
    if len(text) > LONGEST:
        raise ExpressionError(f"the literal {text[:20]}... is longer than any double")
    if match := WHOLE.match(text):
        digits = match[1]
        octal = digits[0] == "0" and digits[1:].isdigit()
        return Literal("int", Fraction(int(digits, 8) if octal else int(digits, 0)))
    match = HEXADECIMAL.match(text) or DECIMAL.match(text)
    if match is None:
        raise ExpressionError(f"{text} is no number of C that is known here")
    if match[1] in ("l", "L"):
        raise ExpressionError(f"{text} is a long double: only double and float are known here")
    kind = "float" if match[1] else "double"
    digits = text[:-1] if match[1] else text
    exact = _hexadecimal(digits) if digits[:2] in ("0x", "0X") else Fraction(digits)
    return Literal(kind, rounded(exact, kind, text))


def _hexadecimal(text: str) -> Fraction:
    mantissa, exponent = re.split("[pP]", text[2:])
    whole, _, part = mantissa.partition(".")
    number = Fraction(int(whole + part or "0", 16), 16 ** len(part))
    if abs(int(exponent)) > 20_000:
        raise ExpressionError(f"{text} has an exponent that no type has")
    return number * Fraction(2) ** int(exponent)


def rounded(value: Fraction, kind: str, words: str = "") -> Fraction:
    """The nearest double or float, ties to even.

    Raises
    ------
    ExpressionError
        If it is beyond the largest number.
    """
    try:
        if kind == "double":
            return Fraction(float(value))
        return _nearest_float(value)
    except OverflowError:
        raise ExpressionError(f"{words or value} is beyond the largest {kind}") from None


def _nearest_float(value: Fraction) -> Fraction:
    """Rounded once: by way of a double a tie could be made that there is not."""
    single = struct.unpack("f", struct.pack("f", float(value)))[0]
    (bits,) = struct.unpack("I", struct.pack("f", single))
    around = [struct.unpack("f", struct.pack("I", max(bits + d, 0)))[0] for d in (-1, 0, 1)]
    known = [Fraction(x) for x in around if x - x == 0]
    even = {Fraction(single): bits % 2 == 0}
    return min(known, key=lambda x: (abs(x - value), not even.get(x, bits % 2 == 1)))
