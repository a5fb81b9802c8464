"""What is varied: each quantity over a range, all combinations, the last quantity the fastest.

    value(i) = low + (high - low) i / (count - 1)        i = 0, ..., count - 1

A motion's values follow from its number alone, so that parts of a grid need nothing of the others.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError

Array = NDArray[np.float64]
MOST = 10**12
"""Motions."""


class Axis(NamedTuple):
    """Equally spaced values from low to high, both of them included."""

    low: float
    high: float
    size: int


@dataclass(frozen=True)
class Grid:
    """All combinations of values.

    Attributes
    ----------
    axes : mapping of str to Axis
        By the name of the quantity.
    """

    axes: Mapping[str, Axis]

    @property
    def count(self) -> int:
        """Number of motions."""
        return math.prod(axis.size for axis in self.axes.values())

    def columns(self, first: int, last: int) -> dict[str, Array]:
        """Values of each quantity for the motions first, ..., last - 1."""
        numbers, stride = np.arange(first, last), 1
        found: dict[str, Array] = {}
        for name, (low, high, count) in reversed([*self.axes.items()]):
            place = numbers // stride % count
            values = low + (high - low) * (place / (count - 1))
            found[name] = np.where(place == count - 1, high, values)
            stride *= count
        return found


def read_grid(vary: Mapping[str, tuple[float, float, int]]) -> Grid:
    """A grid from ``{"theta": (2.4, 2.6, 1000)}``.

    Raises
    ------
    InputError
        For a range that is none, and more than 1e12 motions.
    """
    axes = {}
    for name, given in vary.items():
        try:
            low, high, count = float(given[0]), float(given[1]), given[2]
        except (TypeError, ValueError, IndexError):
            low = high = math.nan
            count = 0
        whole = isinstance(count, int | np.integer) and count >= 2
        if not (math.isfinite(low) and math.isfinite(high) and whole and math.isfinite(high - low)):
            raise InputError(
                f"vary {name}: {given!r} found: two finite numbers and how many values, at least 2,"
                " are needed, as in (2.4, 2.6, 1000)"
            )
        axes[name] = Axis(low, high, int(count))
    grid = Grid(axes)
    if not axes or grid.count > MOST:
        raise InputError(
            f"vary: {grid.count if axes else 'nothing'} found: name at least one quantity, and at"
            f" most {MOST:.0e} motions: all combinations of the values are taken"
        )
    return grid
