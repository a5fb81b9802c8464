"""More motions than memory holds: parts of a grid, integrated by workers, to a folder of Parquet.

Grid --part--> rows --worker--> Parquet --> Folder          so many parts at a time
"""

import shutil
from collections.abc import Callable, Mapping
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from contextlib import nullcontext
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.errors import InputError, wanted
from mechanics.simulate.ensembles.folder import PART, Folder, opened, summary
from mechanics.simulate.ensembles.grid import Grid, read_grid
from mechanics.simulate.ensembles.motions import Motions, read_motions
from mechanics.simulate.ensembles.outcome import Status
from mechanics.simulate.ensembles.parts import under_way
from mechanics.simulate.ensembles.settings import (
    AUTO,
    BUDGET,
    read_method,
    refuse_conditions,
    task_of,
    whole,
)
from mechanics.simulate.ensembles.tables import START, Labels, packed, written
from mechanics.simulate.ensembles.task import Task, to_text
from mechanics.simulate.parquet import parquet
from mechanics.simulate.run import equal_times

Array = NDArray[np.float64]
Values = Mapping[str, Any]
WRITERS = 2
"""Threads that write: what one has to wait for on the disk, the other has not."""
BYTES, PARTS, FEW, LANES = 16 * 2**20, 100, 1024, 16
"""A part's size at most; its share of the motions, if these are not few, but a block of lanes."""
MOST_SAMPLES = 10**6
IN_MEMORY = 256 * 2**20
"""Bytes of parts under way, together."""
BESIDE = 6
"""Columns of a motion beside its states and what is varied."""


@dataclass(frozen=True)
class Written:
    """What a folder holds.

    Attributes
    ----------
    folder : Path
    motions : int
    before : int
        Of them in parts that were there already.
    endings : mapping of str to int
        How many motions ended how: names of `Status` in small letters.
    machines : tuple of str
        Kinds of processor and compiler: bits are equal where these are.
    method : str
    """

    folder: Path
    motions: int
    before: int
    endings: Mapping[str, int]
    machines: tuple[str, ...]
    method: str

    @property
    def complete(self) -> bool:
        """Whether every motion was integrated to its end."""
        return set(self.endings) <= {Status.FINISHED.name.lower()}


def write_ensemble(
    model: Model,
    duration: float,
    folder: str | Path,
    vary: Mapping[str, tuple[float, float, int]],
    *,
    initial: Values | None = None,
    parameters: Values | None = None,
    inputs: Values | None = None,
    samples: int = 2,
    tolerance: float | None = None,
    step: float | None = None,
    method: str = AUTO,
    budget: int = BUDGET,
    beyond_domain: bool = False,
    executor: Executor | None = None,
    workers: Callable[[], int] = lambda: 1,
    here: bool = False,
    part: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> Written:
    """Integrate motions of a grid and write them to a folder, whatever their number.

    The same call on the same folder goes on where a run was stopped. Neither parts, nor their
    order, nor the workers change a bit of a result, on processors and compilers of one kind.

    Parameters
    ----------
    model : Model
        From `mechanics.compile`.
    duration : float
        In s.
    folder : str or Path
        New, empty, or of the same run.
    vary : mapping of str to (float, float, int)
        First and last value, and how many: initial values, parameters or inputs by plain name. All
        combinations are integrated, the last quantity the fastest.
    initial, parameters, inputs : mapping of str to float
        What is not varied, as for `mechanics.simulate`.
    samples : int
        Times of which states are written, the start and the end among them; with 2 the end only.
    tolerance, step, method, budget, beyond_domain
        As for `mechanics.ensemble`.
    executor : concurrent.futures.Executor, optional
        Where parts are integrated; by default in a thread of this process.
    workers : callable
        How many parts the executor works on at a time; twice as many are under way.
    here : bool
        Whether the executor's workers can write to the folder, as threads and processes of this
        machine; else what they have written comes back as bytes.
    part : int, optional
        Motions in a part.
    progress : callable, optional
        It is told the share that is done.

    Returns
    -------
    Written

    Raises
    ------
    InputError
        For names, values or ranges that are wrong, a folder of something else, a disk that is too
        small, pyarrow that is not installed, or workers that ended.
    CompilerError
        Where a worker has no C compiler.
    """
    wanted(model, Model, "write_ensemble", "pass compile(equations)")
    path = Path(folder)
    parquet(f"folder {path}")
    if isinstance(samples, int) and samples > MOST_SAMPLES:
        raise InputError(
            f"samples: {samples} found: at most {MOST_SAMPLES} of a motion are written"
        )
    times, grid = equal_times(duration, samples), read_grid(vary)
    by = read_method(method, tolerance, step, budget, times)
    refuse_conditions(model, beyond_domain)
    rows = _rows(model, times, grid, _sorted(model, grid, initial, parameters, inputs))
    rows(0, 1)  # Whatever is wrong in names and values is told before anything is written.
    task, labels = task_of(model, by, times), _labels(model, grid)
    size = _part(grid, task, labels) if part is None else part
    whole("part", size)
    about: dict[str, Any] = {
        "format": "mechanics ensemble 1",
        "scene": model.equations.scene.name,
        "vary": {name: list(axis) for name, axis in grid.axes.items()},
        "initial": dict(initial or {}),
        "parameters": dict(parameters or {}),
        "inputs": dict(inputs or {}),
        "duration": float(duration),
        "samples": samples,
        "method": task.method.words,
        "budget": budget,
        "motions": grid.count,
        "columns": {name: labels.units.get(name, "") for name in (*labels.varied, *labels.states)},
        # Of the programs, and of the first motion's numbers.
        "digest": sha256(repr((to_text(task), *map(np.ndarray.tobytes, rows(0, 1).rows))).encode())
        .hexdigest(),
        PART: size,
    }  # fmt: skip
    with opened(path, about) as place:
        _refuse_full(place, grid, task, labels)
        with nullcontext(executor) if executor is not None else ThreadPoolExecutor(1) as pool:
            assert pool is not None
            target = place.path.absolute() if here or executor is None else None
            before = _fill(place, grid, rows, task, labels, target, pool, workers, progress)
        endings, machines = summary(path)
    return Written(path, grid.count, before, endings, machines, task.method.words)


Groups = tuple[dict[str, Any], dict[str, Any], dict[str, Any]]


def _sorted(
    model: Model, grid: Grid, initial: Values | None, parameters: Values | None,
    inputs: Values | None,
) -> Groups:  # fmt: skip
    """What is not varied; nothing is said twice."""
    groups = dict(initial or {}), dict(parameters or {}), dict(inputs or {})
    for name in grid.axes:
        if any(name in group for group in groups):
            raise InputError(f"{name}: it is varied and has a value: give one of them")
    return groups


def _rows(model: Model, times: Array, grid: Grid, fixed: Groups) -> Callable[[int, int], Motions]:
    """Motions from one number to another."""
    scene, known = model.equations.scene, model.quantities
    states = {entry.name for entry in (*known.q, *known.u)}
    signals = {symbol.name for symbol in scene.input_symbols}

    def rows(first: int, last: int) -> Motions:
        initial, parameters, inputs = (dict(group) for group in fixed)
        for name, column in grid.columns(first, last).items():
            group = initial if name in states else inputs if name in signals else parameters
            group[name] = column
        return read_motions(model, times, initial, parameters, inputs)

    return rows


def _labels(model: Model, grid: Grid) -> Labels:
    known = model.quantities
    entries = (*known.q, *known.u)
    states = tuple(entry.name for entry in entries)
    varied = {name: f"{name}{START}" if name in states else name for name in grid.axes}
    units = {entry.name: entry.unit for entry in (*entries, *known.p, *known.inputs)}
    every = {**units, "t": "s", **{new: units.get(old, "") for old, new in varied.items()}}
    columns = [*varied.values(), *states, "t", "motion", "ending", "steps", "evaluations"]
    twice = [name for name in columns if columns.count(name) > 1]
    if twice:
        raise InputError(
            f"{model.equations.scene.name}: two columns would be called {twice[0]}: give the"
            " quantity another name in the scene"
        )
    return Labels(states, tuple(varied.values()), every)


def _size(task: Task, labels: Labels) -> int:
    """Bytes of a motion, at most."""
    sampled = len(task.times) * len(labels.states) if len(task.times) > 2 else 0
    return 8 * (sampled + len(labels.states) + len(labels.varied) + BESIDE)


def _part(grid: Grid, task: Task, labels: Labels) -> int:
    return max(LANES, min(max(FEW, -(-grid.count // PARTS)), BYTES // _size(task, labels)))


def _refuse_full(place: Folder, grid: Grid, task: Task, labels: Labels) -> None:
    left = max(0, grid.count - len(place.done) * place.part)
    needed, free = left * _size(task, labels), shutil.disk_usage(place.path).free
    if needed > free:
        raise InputError(
            f"folder {place.path}: {needed / 1e9:.3g} GB are needed and {free / 1e9:.3g} GB are"
            " free: take fewer motions or samples, or another disk"
        )


def _fill(
    place: Folder, grid: Grid, rows: Callable[[int, int], Motions], task: Task, labels: Labels,
    target: Path | None, executor: Executor, workers: Callable[[], int],
    progress: Callable[[float], None] | None,
) -> int:  # fmt: skip
    """Write the parts that are not there; how many motions were."""
    text, count = to_text(task), -(-grid.count // place.part)
    bytes_of_a_part = place.part * _size(task, labels)

    def bounds(number: int) -> tuple[int, int]:
        return number * place.part, min((number + 1) * place.part, grid.count)

    def submit(number: int) -> "Future[tuple[Any, Any]]":
        first, last = bounds(number)
        start, held = (packed(array) for array in rows(first, last).rows)
        varied = [grid.columns(first, last)[name] for name in grid.axes]
        return executor.submit(
            written, text, labels, (first, last), varied, start, held, len(task.times) > 2, target
        )

    def limit() -> int:
        return min(2 * workers(), max(2, IN_MEMORY // bytes_of_a_part))

    def write(part: tuple[int, tuple[Any, Any]]) -> "Future[None]":
        number, files = part
        return writers.submit(place.add, number, *files)

    before = sum(b - a for a, b in map(bounds, place.done) if a < grid.count)
    left = (number for number in range(count) if number not in place.done)
    done = before
    try:
        with ThreadPoolExecutor(WRITERS) as writers:
            computed = under_way(submit, left, limit)
            for (number, _), _ in under_way(write, computed, lambda: WRITERS):
                first, last = bounds(number)
                done += last - first
                if progress is not None:
                    progress(done / grid.count)
    except BrokenExecutor as error:
        raise InputError(
            f"folder {place.path}: a worker ended ({error}): {done} of {grid.count} motions are"
            " written, and the same call goes on"
        ) from None
    return before
