"""The methods: what each is compiled from, and how it is called."""

import ctypes
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853

from mechanics.compiled.step import Tableau
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.simulate.ensembles.explicit import dop853_source, fixed_source
from mechanics.simulate.ensembles.library import Library, Source, at, library
from mechanics.simulate.ensembles.motions import Motions
from mechanics.simulate.ensembles.outcome import CODES, Status
from mechanics.simulate.ensembles.taylor import order, taylor_source
from mechanics.simulate.integrators.loop import plan

Array = NDArray[np.float64]
Counts = NDArray[np.int64]
ADAPTIVE = ("taylor", "dop853")
FIXED = tuple(tableau.name.lower() for tableau in TABLEAUX)
"""Names of the methods."""
STAGES = DOP853.n_stages
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


def adaptive(motions: Motions, name: str, tolerance: float, budget: int, threads: int) -> Run:
    """Every motion with steps of its own.

    Parameters
    ----------
    name : str
        One of `ADAPTIVE`.
    tolerance : float
        Error of a step.
    budget : int
        Steps that a motion may try.
    """
    sources: dict[str, Source] = {"taylor": taylor_source, "dop853": dop853_source}
    method = library(motions.model, sources[name])
    by = Control(tolerance, order(tolerance), budget)
    found = integrated(method, *_given(motions), motions.times, by, threads)
    words, cost = f"Taylor series of order {by.order}", by.order
    if name == "dop853":
        words, cost = "DOP853", STAGES
    return Run(
        found.states[..., : motions.start.shape[1]],
        tuple(CODES[k] for k in found.status.tolist()), found.reached, found.steps,
        found.tries * cost, f"{words}, error of a step {tolerance:.3g}",
    )  # fmt: skip


class Control(NamedTuple):
    """Error of a step, order of a series, and steps that a motion may try."""

    tolerance: float
    order: int
    budget: int


class Found(NamedTuple):
    """States (batch, N, size), and a number a motion: status, samples reached, steps, tries."""

    states: Array
    status: Counts
    reached: Counts
    steps: Counts
    tries: Counts


def integrated(
    method: Library, start: Array, held: Array, times: Array, by: Control, threads: int
) -> Found:
    """What an adaptive method finds.

    Parameters
    ----------
    start, held : arrays, shapes (batch, size) and (batch, k)
        Contiguous.
    times : array, shape (N,)
        Increasing from 0.
    """
    count, size = start.shape
    numbers = (np.zeros(count, dtype=np.int64) for _ in range(4))
    found = Found(np.full((count, len(times), size), np.nan), *numbers)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        march(
            many, ctypes.c_int64(len(times)), at(times), *rows, ctypes.c_double(by.tolerance),
            ctypes.c_int64(by.order), ctypes.c_int64(by.budget), room,
        )  # fmt: skip

    method.march([start, held, *found], call, threads)
    return found


def fixed(motions: Motions, tableau: Tableau, step: float, threads: int) -> Run:
    """All motions with the same steps, which end at the times."""
    start, held = _given(motions)
    found = np.full((len(motions), len(motions.times), start.shape[1]), np.nan)
    spans = plan(motions.times, step)
    counts = np.array([number for number, _ in spans], dtype=np.int64)
    lengths = np.array([length for _, length in spans])
    reached = np.zeros(len(motions), dtype=np.int64)

    def call(march: Any, many: Any, rows: list[Any], room: Any) -> None:
        samples = ctypes.c_int64(len(motions.times))
        march(many, samples, at(counts), at(lengths), *rows, room)

    method = library(motions.model, partial(fixed_source, tableau=tableau))
    method.march([start, held, found, reached], call, threads)
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
    if motions.model.right_hand_side.timed:
        at_time = motions.model.entries["inputs"].index("t")
        start = np.column_stack([start, inputs[:, at_time]])
        inputs = np.delete(inputs, at_time, axis=1)
    return np.ascontiguousarray(start), np.ascontiguousarray(np.hstack([inputs, motions.p]))
