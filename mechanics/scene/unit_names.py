"""Units by name: kg*m^2/s stands for kg^1 m^2 s^-1. Angles have no dimension."""

import re
from collections.abc import Iterator

from sympy import Rational

from mechanics.errors import SceneError

Dimension = tuple[Rational, ...]
"""Exponents of kg, m, s, A and K."""

UNITS: dict[str, tuple[int, int, int, int, int]] = {
    "1": (0, 0, 0, 0, 0), "rad": (0, 0, 0, 0, 0), "kg": (1, 0, 0, 0, 0), "m": (0, 1, 0, 0, 0),
    "s": (0, 0, 1, 0, 0), "A": (0, 0, 0, 1, 0), "K": (0, 0, 0, 0, 1), "Hz": (0, 0, -1, 0, 0),
    "N": (1, 1, -2, 0, 0), "J": (1, 2, -2, 0, 0), "W": (1, 2, -3, 0, 0), "Pa": (1, -1, -2, 0, 0),
    "V": (1, 2, -3, -1, 0), "C": (0, 0, 1, 1, 0), "Ohm": (1, 2, -3, -2, 0),
    "H": (1, 2, -2, -2, 0), "F": (-1, -2, 4, 2, 0), "T": (1, 0, -2, -1, 0),
    "Wb": (1, 2, -2, -1, 0),
}  # fmt: skip
FACTOR = re.compile(r"(?P<name>[A-Za-z]+|1)(?:(?:\^|\*\*)(?P<power>-?\d+))?")


def dimension_of_unit(unit: str, where: str) -> Dimension | None:
    """Exponents of a unit such as ``"kg*m^2/s"``; None for one that is not stated.

    Raises
    ------
    SceneError
        For a name that is no SI unit here; it is named.
    """
    if not unit:
        return None
    total = [Rational(0)] * 5
    for sign, text in _factors(unit):
        found = FACTOR.fullmatch(text)
        if found is None or found["name"] not in UNITS:
            raise SceneError(
                f"{where}: the unit {unit!r} is not known because of {text!r}: write SI units such"
                f" as kg*m^2, N*s/m or m/s^2, of {', '.join(UNITS)}"
            )
        power = sign * int(found["power"] or 1)
        exponents = UNITS[found["name"]]
        total = [old + power * new for old, new in zip(total, exponents, strict=True)]
    return tuple(total)


def _factors(unit: str) -> Iterator[tuple[int, str]]:
    """Sign of the exponent and text of every factor; what follows a stroke is below it."""
    parts = re.split(r"(\*(?!\*)(?<!\*\*)|/)", unit.replace("**", "^").replace("·", "*"))
    for place in range(0, len(parts), 2):
        yield -1 if place and parts[place - 1] == "/" else 1, parts[place].strip()


def words(found: Dimension) -> str:
    """A dimension as a unit: kg*m^2*s^-2."""
    names = ("kg", "m", "s", "A", "K")
    parts = [n if e == 1 else f"{n}^{e}" for n, e in zip(names, found, strict=True) if e != 0]
    return "*".join(parts) or "1"


def is_unit(text: str) -> bool:
    """Whether a text is a coherent unit of the SI."""
    try:
        return dimension_of_unit(text, "") is not None
    except SceneError:
        return False
