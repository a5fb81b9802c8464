"""Values at a witness state with as many digits as a reader needs to see that they differ.

[3.01911975476323715 +/- 8.91e-18], 0    ->    3.01912, 0
"""

import re
from decimal import Decimal
from fractions import Fraction
from math import isfinite

NUMBER = r"[-+]?\d+(?:\.\d*)?(?:e[-+]?\d+)?"
ZERO = re.compile(rf"\[?\s*\+/-\s*{NUMBER}\s*\]?", re.ASCII)
MIDPOINT = re.compile(
    rf"\[?\s*(?P<middle>{NUMBER})\s*(?:\+/-\s*(?P<radius>{NUMBER}))?\s*\]?", re.ASCII
)
NARROW = 1e-6
"""Radius over middle of an enclosure whose first digits say all."""

FEWEST, MOST = 6, 17
LONG = 12


def short_values(left: str, right: str) -> tuple[str, str]:
    """Two enclosures as decimals that tell them apart; unchanged where no digits do.

    Parameters
    ----------
    left, right : str
        As in `Witness`: ``"[1.25 +/- 1e-30]"``, or a number.
    """
    a, b = _middle(left), _middle(right)
    if a is None or b is None:
        return left, right
    for digits in range(FEWEST, MOST + 1):
        if float(f"{a:.{digits - 2}g}") != float(f"{b:.{digits - 2}g}"):
            return _short(left, a, digits), _short(right, b, digits)
    return left, right


def short_state(text: str) -> str:
    """A value of a state; a long fraction that is a double as what reads back as that double."""
    if "/" not in text or len(text) <= LONG:
        return text
    try:
        value = Fraction(text)
        number = float(value)
    except (ValueError, ArithmeticError):
        return text
    return repr(number) if Fraction(number) == value else text


def short_value(text: str) -> str:
    """One enclosure or decimal with few digits."""
    value = _middle(text)
    return text if value is None else _short(text, value, FEWEST)


def _short(text: str, value: float, digits: int) -> str:
    return f"0 {text.strip('[] ')}" if ZERO.fullmatch(text) else f"{value:.{digits}g}"


def _middle(text: str) -> float | None:
    """The middle of a narrow enclosure; None for others, and where a double cannot hold it."""
    if ZERO.fullmatch(text):
        return 0.0
    found = MIDPOINT.fullmatch(text)
    if found is None:
        return None
    value = float(found["middle"])
    lost = not isfinite(value) or (value == 0) is not (Decimal(found["middle"]) == 0)
    wide = float(found["radius"] or 0) > NARROW * abs(value)
    return None if lost or wide else value
