"""Many motions of the elastic pendulum: ensembles beside heyoka, one by one and in batches.

10 s from x = 0.1, theta = 2.5, released at rest; starts and parameters differ a little from motion
to motion. Contenders run in turn in one process on one core; times are medians over the rounds,
errors the largest over coordinates, speeds and motions at the end, against a run at 1e-15.

    python -m benchmarks.kernels.ensembles --motions 10000 --rounds 5
"""

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from statistics import median
from time import process_time
from typing import Any

import numpy as np

from benchmarks.kernels.case import Array
from benchmarks.kernels.lanes import missing
from mechanics.compiled import Model, compile
from mechanics.crosscheck import derive
from mechanics.simulate import ensemble
from mechanics.simulate.integrators.heyoka import equations
from systems import elastic_pendulum

DURATION = 10.0
TOLERANCES = (1e-6, 1e-8, 1e-9, 1e-12)
STEPS = (1e-2, 2e-3)
BATCHES = (8, 16, 32)
"""States that heyoka integrates at a time."""
FAST = {"fast_math": True, "force_avx512": True}
"""Settings that make heyoka faster on some machines; it does without them unless asked."""
SPREAD = 0.01
FINEST = 1e-15


@dataclass(frozen=True)
class Entry:
    """A row of the table.

    Attributes
    ----------
    seconds : float
        Median time of one motion.
    error : float
        Largest at the end.
    middle : float
        Median over the motions of the largest at the end.
    """

    name: str
    seconds: float
    error: float
    middle: float


@dataclass(frozen=True, eq=False)
class Motions:
    """Starts (batch, 4) and parameters (batch, 5), in the order of the model."""

    model: Model
    start: Array
    p: Array

    @property
    def named(self) -> dict[str, Any]:
        """As `mechanics.ensemble` takes them."""
        known = self.model.quantities
        return {
            "initial": {e.name: column for e, column in zip((*known.q, *known.u), self.start.T,
                                                            strict=True)},
            "parameters": {e.name: column for e, column in zip(known.p, self.p.T, strict=True)},
        }  # fmt: skip


@cache
def motions(count: int) -> Motions:
    """The same ones every time."""
    model = compile(derive(elastic_pendulum.scene(), "free_body"), flags="-O3 -march=native")
    random = np.random.default_rng(4)
    start = np.zeros((count, 4))
    start[:, :2] = np.array([0.1, 2.5]) + SPREAD * random.uniform(-1, 1, (count, 2))
    p = model.typical * (1 + SPREAD * random.uniform(-1, 1, (count, len(model.typical))))
    return Motions(model, start, p)


def ours(given: Motions, threads: int = 1, **setting: Any) -> Array:
    """States at the end, by `mechanics.ensemble`."""
    found = ensemble(given.model, DURATION, threads=threads, **given.named, **setting)
    return found.states[:, -1]


class OneByOne:
    """heyoka's adaptive Taylor integrator for one motion after the other."""

    def __init__(self, given: Motions, tolerance: float, **settings: bool) -> None:
        import heyoka as hy

        known = given.model.right_hand_side
        written = equations(known.program, known.entries["y"])
        self._given = given
        self._solver = hy.taylor_adaptive(written, given.start[0].copy(), tol=tolerance, **settings)

    def __call__(self) -> Array:
        solver, found = self._solver, np.empty_like(self._given.start)
        for start, p, end in zip(self._given.start, self._given.p, found, strict=True):
            solver.time = 0.0
            solver.state[:] = start
            solver.pars[:] = p[: len(solver.pars)]
            solver.propagate_until(DURATION)
            end[:] = solver.state
        return found


class InBatches:
    """heyoka's integrator for `size` motions at a time; what is left over is filled up."""

    def __init__(self, given: Motions, tolerance: float, size: int, **settings: bool) -> None:
        import heyoka as hy

        known = given.model.right_hand_side
        written = equations(known.program, known.entries["y"])
        rest = -len(given.start) % size
        rows = [np.concatenate([a, a[:rest]]) for a in (given.start, given.p)]
        self._start, self._p = (np.ascontiguousarray(a.T) for a in rows)
        self._count, self._size = len(given.start), size
        first = np.ascontiguousarray(self._start[:, :size])
        self._solver = hy.taylor_adaptive_batch(written, first, tol=tolerance, **settings)

    def __call__(self) -> Array:
        solver, found = self._solver, np.empty_like(self._start)
        for at in range(0, self._start.shape[1], self._size):
            part = slice(at, at + self._size)
            solver.set_time(0.0)
            solver.state[:] = self._start[:, part]
            solver.pars[:] = self._p[: len(solver.pars), part]
            solver.propagate_until(DURATION)
            found[:, part] = solver.state
        return found.T[: self._count]


def contenders(given: Motions, tolerances: Sequence[float]) -> dict[str, Callable[[], Array]]:
    """Calls by name, compiled already."""
    found: dict[str, Callable[[], Array]] = {}
    for tolerance in tolerances:
        end = f", {tolerance:.0e}"
        found[f"ensemble, taylor{end}"] = partial(ours, given, tolerance=tolerance)
        found[f"ensemble, dop853{end}"] = partial(ours, given, method="dop853", tolerance=tolerance)
        if missing("heyoka"):
            continue
        for words, settings in (("", {}), (", fast_math, 512 bit", FAST)):
            found[f"heyoka{words}, one by one{end}"] = OneByOne(given, tolerance, **settings)
            for size in BATCHES:
                batch = InBatches(given, tolerance, size, **settings)
                found[f"heyoka{words}, batch of {size}{end}"] = batch
    for step in STEPS:
        found[f"ensemble, rk4, h = {step:g} s"] = partial(ours, given, method="rk4", step=step)
        found[f"ensemble, rk8, h = {step:g} s"] = partial(ours, given, method="rk8", step=step)
    return found


def measured(
    count: int = 10_000, rounds: int = 5, tolerances: Sequence[float] = TOLERANCES
) -> list[Entry]:
    """Every contender on every motion, in turn.

    Parameters
    ----------
    count : int
        Number of motions.
    """
    given = motions(count)
    truth = OneByOne(given, FINEST)() if not missing("heyoka") else ours(given, tolerance=FINEST)
    runs = contenders(given, tolerances)
    # What is compiled on first use is compiled here.
    errors = {name: np.max(np.abs(run() - truth), axis=1) for name, run in runs.items()}
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            begin = process_time()
            run()
            times[name].append((process_time() - begin) / count)
    return [
        Entry(name, median(times[name]), float(np.max(e)), float(np.median(e)))
        for name, e in errors.items()
    ]


def table(entries: Sequence[Entry]) -> str:
    """As Markdown."""
    return "\n".join([
        "| 10 s of the elastic pendulum | us a motion | largest error | median error |",
        "|---|---|---|---|",
        *(f"| {e.name} | {e.seconds * 1e6:.2f} | {e.error:.1e} | {e.middle:.1e} |"
          for e in entries),
    ])  # fmt: skip


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--motions", type=int, default=10_000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--tolerances", type=float, nargs="+", default=list(TOLERANCES))
    given = parser.parse_args()
    print(table(measured(given.motions, given.rounds, given.tolerances)))


if __name__ == "__main__":
    main()
