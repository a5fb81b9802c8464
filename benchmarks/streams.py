"""Ensembles that are written as they are computed, beside memory and beside the disk.

    python -m benchmarks.streams                                 a tenth of it: half a minute
    python -m benchmarks.streams --motions 1000000 --sampled 100000 --processes 2

First the last states of so many motions of the elastic pendulum over 10 s, from theta between 2.4
and 2.6 rad: in memory by `mechanics.ensemble` (a block of it, as often as is needed), then streamed
to a folder. Then 1,001 samples of fewer motions, beside what the disk takes of plain files of the
same size, each of them synchronised, by turns. Processor time tells what a core could do on a quiet
machine. Memory is the largest of the process, and of its workers.
At the end what the process that leads does for a motion, from which the plan for 1e9 follows.
"""

import argparse
import os
import resource
import shutil
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter, process_time
from typing import Any, NamedTuple

import numpy as np

from mechanics.cluster import Team, workers
from mechanics.compiled import Model, compile
from mechanics.crosscheck import derive
from mechanics.simulate import ensemble, write_ensemble
from mechanics.simulate.ensembles.grid import read_grid
from mechanics.simulate.ensembles.motions import read_motions
from mechanics.simulate.ensembles.stream import BYTES, WRITERS
from mechanics.simulate.ensembles.tables import packed
from systems import elastic_pendulum

DURATION, SAMPLES, ROUNDS = 10.0, 1001, 10
BLOCK = 20_000
"""Motions in memory at a time."""
LARGE, ROWS = 10**9, 100_000


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--motions", type=int, default=100_000)
    parser.add_argument("--sampled", type=int, default=10_000)
    parser.add_argument("--processes", type=int, default=None, help="workers, by Dask")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--folder", type=Path, default=None, help="on the disk that is measured")
    asked = parser.parse_args()
    model = compile(derive(elastic_pendulum.scene(), "kane"))
    ensemble(model, DURATION)  # compiled
    side = asked.processes or asked.threads
    with (
        tempfile.TemporaryDirectory(dir=asked.folder) as scratch,
        _team(asked.processes, asked.threads) as team,
    ):
        folder = Path(scratch)
        write_ensemble(model, DURATION, folder / "warm", {"theta": (2.4, 2.6, 1000)},
                       executor=team.executor, workers=team.size, here=team.here)  # fmt: skip
        used = process_time()
        memory = in_memory(model, asked.motions, side)
        cores = process_time() - used
        _line(f"{asked.motions} last states, in memory", memory,
              f"{1e6 * memory / asked.motions:.2f} us a motion, {side} threads")  # fmt: skip
        used = process_time()
        stream = streamed(model, folder / "ends", asked.motions, 2, team)
        leads = process_time() - used
        size = bytes_in(folder / "ends")
        parts = len([*(folder / "ends" / "motions").glob("part-*")])
        share = f"{memory / stream:.0%} of the speed in memory"
        _line("the same, streamed", stream, f"{share}, {size / asked.motions:.0f} bytes a motion")
        samples(model, folder, asked.sampled, side, team, bool(asked.processes))
    own, others = (resource.getrusage(who).ru_maxrss / 1e3
                   for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))  # fmt: skip
    print(f"largest memory: {own:.0f} MB, of a worker or a compiler {others:.0f} MB")
    if asked.processes:
        plan(model, asked.motions, cores, leads, size, parts)


def samples(model: Model, folder: Path, count: int, side: int, team: Team, elsewhere: bool) -> None:
    """Samples and as many bytes of plain files, by turns, since what a disk takes changes."""
    block, turns = -(-count // ROUNDS), list[Turn]()
    for k in range(ROUNDS):
        place = folder / f"samples{k}"
        computed, cores = spent(in_memory, model, block, side, SAMPLES)
        seconds, used = spent(streamed, model, place, block, SAMPLES, team)
        amount = bytes_in(place)
        shutil.rmtree(place)
        disk, plain = spent(written, folder / "disk", amount)
        turns.append(Turn(amount / 1e6, computed, cores, seconds, used, disk, plain))
    one = Turn(*map(sum, zip(*turns, strict=True)))
    low, middle, high = np.quantile([turn.disk / turn.streamed for turn in turns], (0, 0.5, 1))
    _line(f"{count} motions, {SAMPLES} samples, in memory", one.computed,
          f"{one.amount / one.computed:.0f} MB/s")  # fmt: skip
    _line("as many bytes as plain files", one.disk, f"{one.amount / one.disk:.0f} MB/s")
    _line("streamed", one.streamed,
          f"{one.amount / 1e3:.2f} GB, {one.amount / one.streamed:.0f} MB/s,"
          f" {one.computed / one.streamed:.0%} of the speed in memory,"
          f" {one.disk / one.streamed:.0%} of what the disk takes"
          f" ({low:.0%} to {high:.0%} in {ROUNDS} turns, {middle:.0%} in the middle)")  # fmt: skip
    if not elsewhere:
        print("processor time, and what a core does: in memory"
              f" {one.cores:.1f} s, {one.amount / one.cores:.0f} MB/s; streamed {one.used:.1f} s,"
              f" {one.amount / one.used:.0f} MB/s; plain files {one.plain:.1f} s,"
              f" {one.amount / one.plain:.0f} MB/s")  # fmt: skip


class Turn(NamedTuple):
    """MB, and seconds and processor time in memory, streamed, and of plain files."""

    amount: float
    computed: float
    cores: float
    streamed: float
    used: float
    disk: float
    plain: float


def spent(call: Callable[..., float], *given: Any) -> tuple[float, float]:
    """Seconds, and processor time of this process."""
    used = process_time()
    seconds = call(*given)
    return seconds, process_time() - used


def _line(what: str, seconds: float, words: str) -> None:
    print(f"{what:40s}{seconds:8.1f} s  {words}", flush=True)


def plan(model: Model, motions: int, cores: float, leads: float, size: int, parts: int) -> None:
    """What 1e9 motions take.

    Workers and bytes by proportion; the process that leads so much for each part, whatever its
    size, and for each row of initial values. It has work for so many cores, and is the first limit.
    """
    used, times = process_time(), np.array([0.0, DURATION])
    columns = read_grid({"theta": (2.4, 2.6, LARGE)}).columns(0, ROWS)
    for array in read_motions(model, times, columns, {}, {}).rows:
        packed(array)
    row = (process_time() - used) / ROWS
    each, many = cores / motions, LARGE * size / motions / BYTES
    one = row + leads / parts * many / LARGE
    print(f"\n{LARGE:.0e} motions: {size / motions * LARGE / 1e9:.0f} GB,"
          f" {each * LARGE / 3600:.1f} hours of one core ({1e6 * each:.1f} us a motion);"
          f" the process that leads {1e6 * row:.2f} us a motion and {1e3 * leads / parts:.0f} ms a"
          f" part: {one * LARGE / 3600:.2f} hours, work for {each / one:.0f} cores")  # fmt: skip


@contextmanager
def _team(processes: int | None, threads: int) -> Iterator[Team]:
    if processes:
        with workers(processes=processes) as team:
            yield team
    else:
        with ThreadPoolExecutor(threads) as pool:
            yield Team(pool, lambda: threads)


def timed(call: Callable[[], object]) -> float:
    start = perf_counter()
    call()
    return perf_counter() - start


def in_memory(model: Model, count: int, threads: int, samples: int = 2) -> float:
    """Seconds, block by block; nothing is kept."""
    grid = read_grid({"theta": (2.4, 2.6, count)})
    times = np.linspace(0.0, DURATION, samples)
    block = BLOCK if samples == 2 else threads * BYTES // (32 * samples)

    def run() -> None:
        for first in range(0, count, block):
            columns = grid.columns(first, min(first + block, count))
            ensemble(model, DURATION, initial=columns, times=times, threads=threads)

    return timed(run)


def streamed(model: Model, folder: Path, count: int, samples: int, team: Team) -> float:
    """Seconds until everything is on the disk."""
    vary = {"theta": (2.4, 2.6, count)}
    return timed(lambda: write_ensemble(
        model, DURATION, folder, vary, samples=samples, executor=team.executor,
        workers=team.size, here=team.here,
    ))  # fmt: skip


def written(folder: Path, amount: int) -> float:
    """Seconds for so many bytes as plain files, synchronised, and as many at a time, as parts."""
    folder.mkdir()
    content = np.random.default_rng(1).bytes(BYTES)

    def write(k: int) -> None:
        with (folder / str(k)).open("wb") as stream:
            stream.write(content[: min(BYTES, amount - k * BYTES)])
            stream.flush()
            os.fsync(stream.fileno())

    with ThreadPoolExecutor(WRITERS) as pool:
        seconds = timed(lambda: list(pool.map(write, range(-(-amount // BYTES)))))
    shutil.rmtree(folder)
    return seconds


def bytes_in(folder: Path) -> int:
    return sum(file.stat().st_size for file in folder.rglob("*.parquet"))


if __name__ == "__main__":
    main()
