"""Units that no scene has, by what they measure: what is not a coherent unit of the SI."""

ANGLES = (
    "deg", "degs", "degree", "degrees", "arcmin", "arcsec", "rev", "revs", "turns", "revolutions",
)  # fmt: skip
_METRES = tuple(
    f"{part}{metre}{s}"
    for part in ("milli", "centi", "kilo") for metre in ("metre", "meter") for s in ("", "s")
)  # fmt: skip
LENGTHS = (
    "mm", "cm", "km", "um", "micron", "inch", "inches", "ft", "feet", "yd", "mile", "miles",
    *_METRES,
)  # fmt: skip
FORCES = ("kN", "mN", "MN", "kgf", "lbf", "kilonewton", "kilonewtons")
TORQUES = ("kNm", "mNm", "Nmm", "Ncm")
MASSES = ("lb", "lbs", "oz", "ton", "tons", "gram", "grams", "pound", "pounds")
TIMES = ("ms", "minutes", "hours", "milliseconds")
RATES = ("dps", "rpm", "rps", "Hz", "hz", "kHz", "kmh", "kph", "mph", "knots")
SHARES = ("percent", "pct")
ALL = (*ANGLES, *LENGTHS, *FORCES, *TORQUES, *MASSES, *TIMES, *RATES, *SHARES)


def any_of(*units: str) -> str:
    """A pattern of units; capitals count in symbols, in patterns that ignore them elsewhere, too.

    Parameters
    ----------
    units : str
    """
    ordered = sorted(units, key=len, reverse=True)
    return "|".join(unit if len(unit) > 3 else f"(?-i:{unit})" for unit in ordered)
