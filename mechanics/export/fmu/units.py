"""SI units as powers of the base units: ``N/rad`` = kg m s^-2 rad^-1.

A product of powers, read from left to right; a stroke divides by the one factor that follows it.
"""

import re
from collections.abc import Mapping

BASE = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
DERIVED: Mapping[str, Mapping[str, int]] = {
    "N": {"kg": 1, "m": 1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "Hz": {"s": -1},
}
FACTOR = re.compile(r"\s*([*/ ]?)\s*([A-Za-z]+|1)(?:(?:\^|\*\*)(-?\d+))?")


def base_powers(unit: str) -> dict[str, int] | None:
    """Powers of the base units that are not zero; None for text that is no unit known here.

    Parameters
    ----------
    unit : str
        ``"kg*m^2"``, ``"N m/rad"``, ``"1"``.
    """
    powers = dict.fromkeys(BASE, 0)
    at = 0
    while at < len(unit):
        factor = FACTOR.match(unit, at)
        if factor is None:
            return None
        sign, name, exponent = factor[1], factor[2], int(factor[3] or 1)
        known = {name: 1} if name in BASE else DERIVED.get(name, {} if name == "1" else None)
        if known is None:
            return None
        for base, power in known.items():
            powers[base] += (-1 if sign == "/" else 1) * exponent * power
        at = factor.end()
    return {base: power for base, power in powers.items() if power}
