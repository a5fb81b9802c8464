"""Random states and parameters, wide enough to find what rounds badly.

    masses, lengths, stiffness, speeds     +-10^e,  e uniform in [-6, 6]
    angles                                 uniform, or k pi/2 +- 10^e,  e uniform in [-15, 0]

Signs are random where the scene does not declare a quantity positive.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.quantities import Quantities, Quantity

DECADES = 6.0
TURNS = 2
FINEST = -15.0


@dataclass(frozen=True)
class States:
    """N states: each array is N x its number of entries."""

    q: NDArray[np.float64]
    u: NDArray[np.float64]
    inputs: NDArray[np.float64]
    p: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.q)

    def rounded(self, kind: type[np.floating]) -> "States":
        """The same states rounded to a precision, still stored as doubles."""
        return States(*(group.astype(kind).astype(np.float64) for group in self.groups))

    @property
    def groups(self) -> tuple[NDArray[np.float64], ...]:
        """(q, u, inputs, p)."""
        return self.q, self.u, self.inputs, self.p


def sample(quantities: Quantities, count: int, seed: int, decades: float = DECADES) -> States:
    """Draw `count` states for the quantities of a model; the same seed gives the same states.

    Sizes are 10**e with e uniform in [-decades, decades].
    """
    random = np.random.default_rng(seed)
    return States(
        *(
            _columns(random, group, count, decades)
            for group in (quantities.q, quantities.u, quantities.inputs, quantities.p)
        )
    )


def ordinary(quantities: Quantities, count: int, seed: int) -> States:
    """Draw states away from special ones: angles anywhere, sizes between a half and two."""
    random = np.random.default_rng(seed)

    def column(quantity: Quantity) -> NDArray[np.float64]:
        if quantity.unit == "rad":
            return random.uniform(-np.pi, np.pi, count)
        sizes = 2.0 ** random.uniform(-1.0, 1.0, count)
        return sizes if quantity.positive else sizes * random.choice((-1.0, 1.0), count)

    def columns(group: Sequence[Quantity]) -> NDArray[np.float64]:
        return np.array([column(quantity) for quantity in group]).reshape(-1, count).T

    q = quantities
    return States(columns(q.q), columns(q.u), columns(q.inputs), columns(q.p))


def _columns(
    random: np.random.Generator, group: Sequence[Quantity], count: int, decades: float
) -> NDArray[np.float64]:
    if not group:
        return np.zeros((count, 0))
    return np.stack(
        [
            _angles(random, count) if g.unit == "rad" else _sizes(random, g, count, decades)
            for g in group
        ],
        axis=1,
    )


def _sizes(
    random: np.random.Generator, quantity: Quantity, count: int, decades: float
) -> NDArray[np.float64]:
    sizes = 10.0 ** random.uniform(-decades, decades, count)
    return sizes if quantity.positive else sizes * random.choice((-1.0, 1.0), count)


def _angles(random: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Half of them anywhere, half beside a multiple of pi/2, where sines and cosines vanish."""
    uniform = random.uniform(-TURNS * np.pi, TURNS * np.pi, count)
    quarter = random.integers(-2 * TURNS, 2 * TURNS + 1, count) * (np.pi / 2)
    offset = 10.0 ** random.uniform(FINEST, 0.0, count) * random.choice((-1.0, 1.0), count)
    return np.where(random.random(count) < 0.5, uniform, quarter + offset)
