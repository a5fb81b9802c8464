"""What errors are measured against, and in which units.

error at t = max_i |y_i - reference_i| / scale_i,   scale_i = max over the motion |reference_i|
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.reference import Reference, scale_of

Array = NDArray[np.float64]

NORM = (
    "the largest, over coordinates and speeds, of |error| divided by the largest magnitude of that"
    " coordinate or speed along the reference"
)


@dataclass(frozen=True, eq=False)
class Truth:
    """A solution to compare with.

    Attributes
    ----------
    scale : array, shape (n + m,)
    difference : callable
        |states - solution| at the first k times, shape (k, n + m).
    doubt : float
        What the solution itself may be wrong by, in the stated norm.
    """

    scale: Array
    difference: Callable[[Array], Array] = field(repr=False)
    doubt: float = 0.0

    def errors(self, states: Array) -> Array:
        """Error at the first k times in the stated norm, shape (k,); infinite where not finite."""
        relative = np.max(self.difference(states) / self.scale, axis=1)
        return np.where(np.isfinite(relative), relative, np.inf)


def at_rows(truth: Truth, rows: NDArray[np.intp]) -> Truth:
    """The same for states of which only some, at the given rows, are compared."""

    def difference(states: Array) -> Array:
        return truth.difference(states[rows[rows < len(states)]])

    return replace(truth, difference=difference)


def from_reference(found: Reference) -> Truth:
    """A solution with many digits."""
    return Truth(found.scale, found.errors)


def from_states(states: Array) -> Truth:
    """A solution in doubles, by the most accurate choice that was measured.

    Behind the time at which that gave up, errors are not known to be finite.
    """

    def difference(found: Array) -> Array:
        gaps = np.full(found.shape, np.inf)
        known = min(len(found), len(states))
        gaps[:known] = np.abs(found[:known] - states[:known])
        return gaps

    return Truth(scale_of(states), difference)
