"""Units that no scene counts in, by what they measure."""

ANGLES = ("deg", "degs", "degree", "degrees", "arcmin", "arcsec", "mrad")
REVOLUTIONS = ("rev", "revs", "turns", "revolutions")
GRADIANS = ("grad", "grads", "gradian", "gradians")
_METRES = tuple(
    f"{part}{metre}{s}"
    for part in ("milli", "centi", "kilo") for metre in ("metre", "meter") for s in ("", "s")
)  # fmt: skip
LENGTHS = (
    "mm", "cm", "km", "um", "micron", "inch", "inches", "ft", "feet", "yd", "mile", "miles",
    *_METRES,
)  # fmt: skip
FORCES = ("kN", "mN", "MN", "kgf", "kp", "kilopond", "lbf", "kilonewton", "kilonewtons")
TORQUES = ("kNm", "mNm", "Nmm", "Ncm")
MASSES = (
    "lb", "lbs", "oz", "ton", "tons", "tonne", "tonnes", "gram", "grams", "pound", "pounds",
)  # fmt: skip
ENERGIES = ("kJ", "mJ", "kWh", "cal", "kcal")
RATES = ("cycles", "dps", "rpm", "rps", "kmh", "kph", "mph", "knots")
LAST_WORDS = frozenset((
    *ANGLES, *REVOLUTIONS, *LENGTHS, *FORCES, *TORQUES, *MASSES, *ENERGIES, *RATES,
    "Hz", "hz", "kHz", "ms", "minutes", "hours", "milliseconds", "percent", "pct",
))  # fmt: skip
"""Of names that say another quantity: a gradient is no angle there, and no scene has a frequency
beside an angular one.
"""
_BY_CAPITALS = frozenset((*FORCES, *TORQUES, *ENERGIES, "um"))
"""Symbols that capitals tell from others."""


def any_of(*units: str) -> str:
    """A pattern of units; capitals count where they tell symbols apart.

    Parameters
    ----------
    units : str
    """
    ordered = sorted(units, key=len, reverse=True)
    return "|".join(f"(?-i:{unit})" if unit in _BY_CAPITALS else unit for unit in ordered)
