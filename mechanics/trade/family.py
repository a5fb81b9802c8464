"""States to start from that are like the example, but are not the example.

    y_i = start_i + spread * r_i * scale_i,    r_i uniform in (-1, 1)

`scale_i` is the largest magnitude that the coordinate or speed reaches along the motion from the
example, so coordinates and speeds all vary by the same share of what the motion runs through, and
energies vary with them. In a scene with constraints the nearest state that satisfies them is taken;
a draw beside which there is none is drawn again.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.measure import prepared
from mechanics.trade.truth import Truth, from_states

Array = NDArray[np.float64]

SPREAD = 0.1
"""Share of the motion by which states are varied."""
TRAINING = 20260101
"""Seed of the states that a pick is tuned on."""
DRAWS = 20


class Solution(NamedTuple):
    """From one state.

    Attributes
    ----------
    states : array, shape (k, n + m)
    doubt : float
        What it may be wrong by, in the stated norm.
    """

    states: Array
    doubt: float


@dataclass(frozen=True, eq=False)
class Family:
    """States around the example on which picks are tuned.

    Attributes
    ----------
    starts : array, shape (count, n + m)
    first, second : Choice
        What errors are measured against, and what shows how far it can be trusted.
    solutions : tuple of Solution
        By these, for each state.
    elsewhere : callable, optional
        Errors of choices on the first so many states, by workers; without it they are computed
        here.
    """

    starts: Array = field(repr=False)
    first: Choice
    second: Choice
    solutions: tuple[Solution, ...] = field(repr=False)
    spread: float
    seed: int
    elsewhere: Callable[[Sequence[Choice], int], list[Array]] | None = field(
        default=None, repr=False
    )

    @cached_property
    def truths(self) -> tuple[Truth, ...]:
        """What errors are measured against, for each state."""
        return tuple(map(truth_of, self.solutions))

    @property
    def words(self) -> str:
        """What the states are."""
        return (
            f"{len(self.starts)} states, each coordinate and speed of the start varied uniformly by"
            f" up to {self.spread:.0%} of its largest magnitude along the motion"
        )

    @property
    def doubt(self) -> float:
        """Largest difference of the two solutions."""
        return max(solution.doubt for solution in self.solutions)


def family(
    case: Case, scale: Array, count: int, seed: int = TRAINING, spread: float = SPREAD
) -> Array:
    """States around the start of a case.

    Parameters
    ----------
    scale : array, shape (n + m,)
        Largest magnitude of each entry along the motion from the start.
    seed : int
        Of the pseudo-random numbers.
    spread : float
        Share of the scale.

    Returns
    -------
    array, shape (count, n + m)

    Raises
    ------
    InputError
        If no draw of many satisfies the constraints.
    """
    random = np.random.default_rng(seed)
    return np.array([_drawn(case, scale, spread, random) for _ in range(count)])


def _drawn(case: Case, scale: Array, spread: float, random: np.random.Generator) -> Array:
    for _ in range(DRAWS):
        varied = case.start + spread * random.uniform(-1, 1, len(scale)) * scale
        state = case.manifold.project(0.0, varied)
        if np.all(np.isfinite(state)):
            return state
    raise InputError(
        f"{case.equations.scene.name}: none of {DRAWS} states around the start satisfies the"
        f" constraints: vary them by less than {spread:g} of the motion"
    )


def solutions(case: Case, starts: Array, first: Choice, second: Choice) -> list[Solution]:
    """By the most accurate choice for each state; its difference from the second is its doubt."""
    found = []
    for start in starts:
        one, other = (prepared(case, choice, start)().states for choice in (first, second))
        truth = from_states(one)
        doubt = float(np.max(truth.errors(other))) if len(one) == len(other) else np.inf
        found.append(Solution(one, doubt))
    return found


def truth_of(solution: Solution) -> Truth:
    """What errors are measured against."""
    return replace(from_states(solution.states), doubt=solution.doubt)
