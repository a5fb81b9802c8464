"""The methods: what each is compiled from, and how it is called.

(right-hand side, method) --> Library --> Found          the same on this machine and on a worker
"""

import ctypes
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853

from mechanics.compiled.tableaus import TABLEAUX
from mechanics.simulate.ensembles.explicit import dop853_source, fixed_source
from mechanics.simulate.ensembles.library import Library, Source, at
from mechanics.simulate.ensembles.outcome import CODES, Status
from mechanics.simulate.ensembles.taylor import order, taylor_source
from mechanics.simulate.integrators.loop import plan

Array = NDArray[np.float64]
Counts = NDArray[np.int64]
SOURCES: dict[str, Source] = {
    "taylor": taylor_source,
    "dop853": dop853_source,
    **{tableau.name.lower(): partial(fixed_source, tableau=tableau) for tableau in TABLEAUX},
}
"""What every method is compiled from, by its name."""
ADAPTIVE = ("taylor", "dop853")
FIXED = tuple(tableau.name.lower() for tableau in TABLEAUX)
"""Names of the methods."""
STAGES = {
    "dop853": DOP853.n_stages,
    **{tableau.name.lower(): len(tableau.a) for tableau in TABLEAUX},
}
"""Evaluations that a step takes."""


class Method(NamedTuple):
    """How motions are integrated.

    Attributes
    ----------
    name : str
        One of `SOURCES`.
    by : float
        Error of a step; with fixed steps their length in s.
    budget : int
        Steps that a motion may try.
    """

    name: str
    by: float
    budget: int

    @property
    def words(self) -> str:
        """For people."""
        if self.name in FIXED:
            return f"{self.name.upper()}, steps of at most {self.by:g} s"
        words = f"Taylor series of order {order(self.by)}" if self.name == "taylor" else "DOP853"
        return f"{words}, error of a step {self.by:.3g}"

    @property
    def cost(self) -> int:
        """Evaluations of a step."""
        return STAGES.get(self.name) or order(self.by)


class Found(NamedTuple):
    """States (batch, N, size), and a number a motion: status, samples reached, steps, tries.

    An entry of the states lies in memory as a column: motions, each with its samples.
    """

    states: Array
    status: Counts
    reached: Counts
    steps: Counts
    tries: Counts


@dataclass(frozen=True, eq=False)
class Run:
    """What a method gives: see `mechanics.simulate.ensembles.outcome.Ensemble`."""

    states: Array
    status: tuple[Status, ...]
    reached: Counts
    steps: Counts
    evaluations: Counts
    method: str


def run_of(found: Found, method: Method, moving: int) -> Run:
    """The same for people: the first entries of the states, and numbers as words."""
    return Run(
        found.states[..., :moving], tuple(CODES[k] for k in found.status.tolist()), found.reached,
        found.steps, found.tries * method.cost, method.words,
    )  # fmt: skip


def integrated(
    library: Library, method: Method, start: Array, held: Array, times: Array, threads: int
) -> Found:
    """What a method finds.

    Parameters
    ----------
    library : Library
        Of the method.
    start, held : arrays, shapes (batch, size) and (batch, k)
        Contiguous.
    times : array, shape (N,)
        Increasing from 0.
    """
    solve = _fixed if method.name in FIXED else _adaptive
    return solve(library, method, start, held, times, threads)


def _adaptive(
    library: Library, method: Method, start: Array, held: Array, times: Array, threads: int
) -> Found:
    """Every motion with steps of its own."""
    count, size = start.shape
    numbers = (np.zeros(count, dtype=np.int64) for _ in range(4))
    found = Found(_columns(count, len(times), size), *numbers)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        march(
            many, *_sizes(found.states), at(times), *rows, ctypes.c_double(method.by),
            ctypes.c_int64(order(method.by)), ctypes.c_int64(method.budget), room,
        )  # fmt: skip

    library.march([start, held, *found], call, threads)
    return found


def _fixed(
    library: Library, method: Method, start: Array, held: Array, times: Array, threads: int
) -> Found:
    """All motions with the same steps, which end at the times."""
    states = _columns(len(start), len(times), start.shape[1])
    spans = plan(times, method.by)
    counts = np.array([number for number, _ in spans], dtype=np.int64)
    lengths = np.array([length for _, length in spans])
    reached = np.zeros(len(start), dtype=np.int64)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        march(many, *_sizes(states), at(counts), at(lengths), *rows, room)

    library.march([start, held, states, reached], call, threads)
    early = np.where(reached == len(times), 0, CODES.index(Status.NOT_FINITE))
    steps = np.concatenate([[0], np.cumsum(counts)])[np.maximum(reached - 1, 0)]
    return Found(states, early.astype(np.int64), reached, steps, steps)


def _columns(count: int, samples: int, size: int) -> Array:
    """States in which nothing stands yet: C writes all of them."""
    return np.empty((size, count, samples)).transpose(1, 2, 0)


def _sizes(states: Array) -> tuple[ctypes.c_int64, ctypes.c_int64]:
    """How many samples, and numbers from one entry to the next."""
    return ctypes.c_int64(states.shape[1]), ctypes.c_int64(states.shape[0] * states.shape[1])
