"""Values at a witness state with as many digits as a reader needs to see that they differ.

[3.01911975476323715 +/- 8.91e-18], 0    ->    3.01912, 0
"""

import re
from decimal import Decimal
from math import isfinite

ZERO = re.compile(r"^\[?\s*\+/-")
MIDPOINT = re.compile(r"^\[?\s*(?P<middle>[-+]?[\d.]+(?:e[-+]?\d+)?)\s*(?:\+/-|\])?")
FEWEST, MOST = 6, 17


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


def short_value(text: str) -> str:
    """One enclosure or decimal with few digits."""
    value = _middle(text)
    return text if value is None else _short(text, value, FEWEST)


def _short(text: str, value: float, digits: int) -> str:
    return f"0 {text.strip('[] ')}" if ZERO.match(text) else f"{value:.{digits}g}"


def _middle(text: str) -> float | None:
    """The middle of an enclosure; None where it has none, or a double cannot hold it."""
    if ZERO.match(text):
        return 0.0
    found = MIDPOINT.match(text)
    if found is None:
        return None
    value = float(found["middle"])
    lost = not isfinite(value) or (value == 0) is not (Decimal(found["middle"]) == 0)
    return None if lost else value
