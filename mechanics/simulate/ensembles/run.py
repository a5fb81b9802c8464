"""The methods: what each is compiled from, and how it is called."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.program import Program
from mechanics.compiled.step import TABLEAUX, Tableau
from mechanics.errors import ExpressionError
from mechanics.simulate.ensembles.explicit import dop853_source, fixed_source
from mechanics.simulate.ensembles.library import Library, at, ensemble_program, timed
from mechanics.simulate.ensembles.motions import Motions
from mechanics.simulate.ensembles.outcome import CODES, Status
from mechanics.simulate.ensembles.recurrences import Recurrences
from mechanics.simulate.ensembles.taylor import order, taylor_source
from mechanics.simulate.integrators.loop import plan

Array = NDArray[np.float64]
Counts = NDArray[np.int64]
ADAPTIVE = ("taylor", "dop853")
FIXED = tuple(tableau.name.lower() for tableau in TABLEAUX)
"""Names of the methods."""
STAGES = 12
"""Evaluations that a step of DOP853 takes."""


@dataclass(frozen=True, eq=False)
class Run:
    """What a method gives: see `mechanics.simulate.ensembles.outcome.Ensemble`."""

    states: Array
    status: tuple[Status, ...]
    reached: Counts
    steps: Counts
    evaluations: Counts
    method: str


def best(code: Program) -> str:
    """Name of the adaptive method that is the fastest for a program."""
    try:
        Recurrences(code)
    except ExpressionError:
        return "dop853"
    return "taylor"


def adaptive(motions: Motions, name: str, tolerance: float, budget: int, threads: int) -> Run:
    """Every motion with steps of its own.

    Parameters
    ----------
    name : str
        One of `ADAPTIVE`.
    budget : int
        Steps that a motion may try.
    """
    sources: dict[str, Callable[[Program], str]]
    sources = {"taylor": taylor_source, "dop853": dop853_source}
    count, found = len(motions), _room(motions)
    status, reached, steps, tries = (np.zeros(count, dtype=np.int64) for _ in range(4))
    degree = order(tolerance)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        march(
            many, ctypes.c_int64(len(motions.times)), at(motions.times), *rows,
            ctypes.c_double(tolerance), ctypes.c_int64(degree), ctypes.c_int64(budget), room,
        )  # fmt: skip

    library = Library(motions.model, name, sources[name])
    arrays: list[Any] = [*_given(motions), found, status, reached, steps, tries]
    library.march(arrays, call, threads)
    words, cost = f"Taylor series of order {degree}", degree
    if name == "dop853":
        words, cost = "DOP853", STAGES
    return Run(
        found[..., : motions.start.shape[1]], tuple(CODES[k] for k in status.tolist()), reached,
        steps, tries * cost, f"{words}, tolerance {tolerance:g}",
    )  # fmt: skip


def fixed(motions: Motions, tableau: Tableau, step: float, threads: int) -> Run:
    """All motions with the same steps, which end at the times."""
    count, found = len(motions), _room(motions)
    spans = plan(motions.times, step)
    counts = np.array([number for number, _ in spans], dtype=np.int64)
    lengths = np.array([length for _, length in spans])
    reached = np.zeros(count, dtype=np.int64)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        samples = ctypes.c_int64(len(motions.times))
        march(many, samples, at(counts), at(lengths), *rows, room)

    library = Library(motions.model, tableau.name, partial(fixed_source, tableau=tableau))
    arrays: list[Any] = [*_given(motions), found, reached]
    library.march(arrays, call, threads)
    ended = reached == len(motions.times)
    steps = np.concatenate([[0], np.cumsum(counts)])[np.maximum(reached - 1, 0)]
    return Run(
        found[..., : motions.start.shape[1]],
        tuple(Status.FINISHED if done else Status.NOT_FINITE for done in ended.tolist()), reached,
        steps, steps * len(tableau.a), f"{tableau.name}, steps of at most {step:g} s",
    )  # fmt: skip


def _given(motions: Motions) -> tuple[Array, Array]:
    """States, with the time as the last entry if the equations hold it; and what is held."""
    start, inputs = motions.start, motions.inputs
    if timed(motions.model):
        at_time = motions.model.entries["inputs"].index("t")
        start = np.column_stack([start, inputs[:, at_time]])
        inputs = np.delete(inputs, at_time, axis=1)
    return np.ascontiguousarray(start), np.ascontiguousarray(np.hstack([inputs, motions.p]))


def _room(motions: Motions) -> Array:
    size = ensemble_program(motions.model).inputs[0][1]
    return np.full((len(motions), len(motions.times), size), np.nan)
