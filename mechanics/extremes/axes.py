"""How far each quantity is walked: by decades, and where sines and cosines vanish.

    parameters, coordinates, speeds      0, 10^e           angles      also k pi/2 and beside

Every value is a number of single precision where there is one of its size, so that both precisions
are measured at the same point.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.compiled.quantities import Quantities, Quantity

SMALLEST, LARGEST = -308, 308

# Exponents (first, last, step) of the decades in pairs and random combinations, by unit.
DECADES: dict[str, tuple[int, int, int]] = {
    "kg": (-12, 12, 2),
    "kg*m^2": (-12, 12, 2),
    "m": (-9, 9, 1),
    "N/m": (-6, 18, 2),
    "N*m/rad": (-6, 18, 2),
}
OTHERS = (-12, 12, 2)
SPEEDS = (
    -300, -200, -100, -50, -30, -20, -15, -10, -5, 0, 5, 10, 15, 20, 30, 50, 75, 100, 125, 150,
)  # fmt: skip
SMALL_ANGLES = (-300, -150, -45, -16, -8, -4, -1)
LARGE_ANGLES = (1, 2, 4, 8, 15)
QUARTERS = 4


@dataclass(frozen=True)
class Axis:
    """Values that one quantity takes.

    Attributes
    ----------
    name : str
    group : str
        ``"q"``, ``"u"``, ``"inputs"`` or ``"p"``.
    column : int
        Among all values of a point.
    unit : str
    walked : tuple of float
        Along a line: every decade that the precision has.
    paired : tuple of float
        In pairs and random combinations, rising.
    """

    name: str
    group: str
    column: int
    unit: str
    walked: tuple[float, ...]
    paired: tuple[float, ...]

    def thinned(self, count: int) -> tuple[float, ...]:
        """About `count` of the paired values, the ends and zero among them."""
        if len(self.paired) <= count:
            return self.paired
        chosen = np.linspace(0, len(self.paired) - 1, count).round().astype(int)
        return tuple(self.paired[i] for i in sorted({0, *chosen.tolist()}))


def axes(quantities: Quantities) -> tuple[Axis, ...]:
    """One axis for every entry of q, u, inputs and p, in this order."""
    groups = ("q", "u", "inputs", "p")
    entries = [(group, entry) for group in groups for entry in getattr(quantities, group)]
    return tuple(_axis(group, entry, column) for column, (group, entry) in enumerate(entries))


def _axis(group: str, entry: Quantity, column: int) -> Axis:
    walked = [0.0, *(decade(e) for e in range(SMALLEST, LARGEST + 1))]
    if entry.unit == "rad":
        exponents = (*SMALL_ANGLES, *LARGE_ANGLES)
        paired = sorted({0.0, *map(decade, exponents), *quarters(beside=False)})
        walked = sorted({*walked, *quarters(beside=False), *quarters(beside=True)})
    else:
        paired = [0.0, *(decade(e) for e in _exponents(group, entry.unit))]
    return Axis(entry.name, group, column, entry.unit, tuple(walked), tuple(paired))


def _exponents(group: str, unit: str) -> Sequence[int]:
    if group == "u":
        return SPEEDS
    first, last, step = DECADES.get(unit, OTHERS)
    return range(first, last + 1, step)


def decade(exponent: int) -> float:
    """10^e, the nearest number of single precision where it is a normal one."""
    value = 10.0**exponent
    single = np.finfo(np.float32)
    if not float(single.tiny) <= value <= float(single.max):
        return value
    return float(np.float32(value))


def quarters(beside: bool) -> list[float]:
    """k pi/2 to the nearest number of each precision, or what lies beside these.

    Beside are the next numbers on both sides, and those 1e-4 off.
    """
    found: list[float] = []
    for k in range(1, QUARTERS + 1):
        for kind in (np.float32, np.float64):
            nearest = kind(k * np.pi / 2)
            if not beside:
                found.append(float(nearest))
                continue
            found += [float(np.nextafter(nearest, kind(end))) for end in (0, np.inf)]
            found += [float(kind(nearest + off)) for off in (-1e-4, 1e-4)]
    return found
