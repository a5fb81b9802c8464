"""What an ensemble gives back: states of many motions, how each ended, and what it took."""

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.nearest import instead


class Status(Enum):
    """How a motion ended; the value says it."""

    FINISHED = "the whole duration was integrated"
    NOT_FINITE = "the state or its rates are not finite: the motion is singular there"
    STALLED = "no step meets the tolerance: the motion is singular there"
    TOO_LONG = "more steps were needed than allowed"


CODES = tuple(Status)
"""In the order of their numbers in C."""


@dataclass(frozen=True, eq=False)
class Ensemble:
    """Motions of one model from many initial states, with parameters of their own.

    Attributes
    ----------
    title : str
        Name of the scene.
    times : array, shape (N,)
        In s.
    states : array, shape (batch, N, n + m)
        Coordinates, then speeds; not-a-number at the samples that a motion did not reach.
    names : tuple of str
        Of the entries of a state.
    status : tuple of Status
        One a motion.
    reached : array, shape (batch,)
        Number of samples.
    steps, evaluations : array, shape (batch,)
        Steps that were accepted, and evaluations of the right-hand side: a step of a series of
        order n, accepted or not, counts as n.
    method : str
        What integrated, in words.
    """

    title: str
    times: NDArray[np.float64]
    states: NDArray[np.float64] = field(repr=False)
    names: tuple[str, ...]
    status: tuple[Status, ...] = field(repr=False)
    reached: NDArray[np.int64] = field(repr=False)
    steps: NDArray[np.int64] = field(repr=False)
    evaluations: NDArray[np.int64] = field(repr=False)
    method: str

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """One coordinate or speed of all motions, shape (batch, N)."""
        if name not in self.names:
            names = instead(name, self.names, "coordinates and speeds")
            raise InputError(f"{name!r}: {names}")
        return self.states[..., self.names.index(name)]

    @property
    def complete(self) -> bool:
        """Whether every motion was integrated to its end."""
        return all(status is Status.FINISHED for status in self.status)

    @property
    def note(self) -> str:
        """How many motions ended how, in a line."""
        counts = [f"{self.status.count(s)} of {len(self.status)}: {s.value}" for s in Status
                  if s in self.status]  # fmt: skip
        return "; ".join([self.method, *counts])
