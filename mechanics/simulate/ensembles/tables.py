"""A part of an ensemble as Parquet, written where it was integrated.

    motions     a row a motion: its number, what is varied, its last state, how it ended
    samples     a row a motion and time: number, t, state

Numbers stand as they are, 8 bytes each; a column that repeats itself takes almost none.
"""

from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.ensembles.files import MOTIONS, SAMPLES, fresh, writable
from mechanics.simulate.ensembles.outcome import CODES
from mechanics.simulate.ensembles.run import Found
from mechanics.simulate.ensembles.task import Task, from_text, integrate, machine
from mechanics.simulate.parquet import parquet

Array = NDArray[np.float64]
Column = float | Array
MOTION, TIME, ENDING, STEPS, EVALUATIONS = "motion", "t", "ending", "steps", "evaluations"
MACHINE = b"machine"
BATCH = 2**18
"""Numbers that the writer of Parquet takes at a time."""
START = "_start"
"""Follows the name of an initial value that is varied: the name itself is the last state's."""


class Labels(NamedTuple):
    """Names of what the columns hold.

    Attributes
    ----------
    states : tuple of str
        Coordinates and speeds.
    varied : tuple of str
        Columns of what is varied.
    units : mapping of str to str
        Of each column that has one.
    """

    states: tuple[str, ...]
    varied: tuple[str, ...]
    units: Mapping[str, str]


def packed(array: Array) -> list[Column]:
    """Columns; one that is the same in all rows is a number."""
    bits = array.view(np.int64)
    return [float(array[0, k]) if np.all(bits[:, k] == bits[0, k]) else array[:, k].copy()
            for k in range(array.shape[1])]  # fmt: skip


def unpacked(columns: Sequence[Column], count: int) -> Array:
    """Rows of columns."""
    found = np.empty((count, len(columns)))
    for k, column in enumerate(columns):
        found[:, k] = column
    return found


def written(
    text: str, labels: Labels, numbers: tuple[int, int], varied: Sequence[Array],
    start: Sequence[Column], held: Sequence[Column], samples: bool, folder: Path | None = None,
) -> tuple[Any, Any]:  # fmt: skip
    """On a worker: motions from one number to another, integrated, as two files.

    Parameters
    ----------
    text : str
        Of a `Task`.
    labels : Labels
    numbers : (int, int)
        Of the first motion, and of the one after the last.
    varied : sequence of array
    start, held : sequences of columns
    samples : bool
        Whether the second file is wanted; else it is None.
    folder : Path, optional
        Where the worker writes fresh files and returns their paths; else it returns buffers.
    """
    count = numbers[1] - numbers[0]
    task = from_text(text)
    found = integrate(text, unpacked(start, count), unpacked(held, count))
    motions = np.arange(*numbers)
    table = _table(_motions(task, labels, motions, varied, found), labels)
    first = _file(table, folder and folder / MOTIONS, (ENDING,), (MOTION,))
    if not samples:
        return first, None
    table = _table(_samples(task, labels, motions, found), labels)
    return first, _file(table, folder and folder / SAMPLES, (MOTION, TIME))


def _motions(
    task: Task, labels: Labels, motions: NDArray[np.int64], varied: Sequence[Array], found: Found
) -> dict[str, Any]:
    pyarrow, _ = parquet("motions")
    words = pyarrow.array([status.name.lower() for status in CODES])
    last = found.states[:, -1].T
    return {
        MOTION: motions,
        **dict(zip(labels.varied, varied, strict=True)),
        **dict(zip(labels.states, map(np.ascontiguousarray, last), strict=False)),
        TIME: task.times[found.reached - 1],
        ENDING: pyarrow.DictionaryArray.from_arrays(found.status.astype(np.int8), words),
        STEPS: found.steps,
        EVALUATIONS: found.tries * task.method.cost,
    }


def _samples(
    task: Task, labels: Labels, motions: NDArray[np.int64], found: Found
) -> dict[str, Any]:
    count = len(task.times)
    flat = found.states.reshape(-1, found.states.shape[2]).T
    return {
        MOTION: np.repeat(motions, count),
        TIME: np.tile(task.times, len(motions)),
        **dict(zip(labels.states, map(np.ascontiguousarray, flat), strict=False)),
    }


def _table(columns: Mapping[str, Any], labels: Labels) -> Any:
    pyarrow, _ = parquet("samples")
    arrays = {name: pyarrow.array(values) for name, values in columns.items()}
    fields = [
        pyarrow.field(name, array.type, nullable=False,
                      metadata={"unit": labels.units.get(name, "")})
        for name, array in arrays.items()
    ]  # fmt: skip
    schema = pyarrow.schema(fields, metadata={MACHINE: machine()})
    return pyarrow.table(list(arrays.values()), schema=schema)


def _file(table: Any, folder: Path | None, few: Sequence[str], rising: Sequence[str] = ()) -> Any:
    """Parquet as a buffer, or the path of a fresh file.

    Columns with few values, or that rise, take little room. Of the others, which are all different,
    there are no statistics: they would take as long as the rest.
    """
    pyarrow, writer = parquet("samples")
    target: Any = pyarrow.BufferOutputStream() if folder is None else fresh(folder)
    with nullcontext() if folder is None else writable(folder):
        writer.write_table(
            table, target, compression="none", use_dictionary=[*few],
            column_encoding={name: "DELTA_BINARY_PACKED" for name in rising},
            write_statistics=[*few, *rising], write_batch_size=BATCH,
        )  # fmt: skip
    return target.getvalue() if folder is None else target
