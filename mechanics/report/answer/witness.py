"""Values at a witness state with as many digits as a reader needs to see that they differ.

[3.01911975476323715 +/- 8.91e-18], 0    ->    3.01912, 0
"""

import re

MIDPOINT = re.compile(r"^\[?\s*(?P<middle>[-+]?[\d.]+(?:e[-+]?\d+)?)\s*(?:\+/-|\])?")
FEWEST, MOST = 6, 17


def short_values(left: str, right: str) -> tuple[str, str]:
    """Two enclosures as decimals that tell them apart; unchanged where no digits do.

    Parameters
    ----------
    left, right : str
        As in `Witness`: ``"[1.25 +/- 1e-30]"``, or a number.
    """
    middles = [MIDPOINT.match(text) for text in (left, right)]
    if any(found is None for found in middles):
        return left, right
    a, b = (float(found["middle"]) for found in middles if found is not None)
    for digits in range(FEWEST, MOST + 1):
        short = f"{a:.{digits}g}", f"{b:.{digits}g}"
        if float(f"{a:.{digits - 2}g}") != float(f"{b:.{digits - 2}g}"):
            return short
    return left, right


def short_value(text: str) -> str:
    """One enclosure or decimal with few digits."""
    found = MIDPOINT.match(text)
    return text if found is None else f"{float(found['middle']):.{FEWEST}g}"
