"""Generated kernels against those written by hand and those of other packages, in one process.

    python -m benchmarks.kernels --rounds 30

Peers that are not installed are left out and named: pip install 'mechanics[bench]' for all of them,
and Eigen's headers and g++ for Pinocchio. Prints Markdown.
"""

import argparse
import platform
from collections.abc import Iterator, Sequence
from statistics import median
from time import perf_counter

import numpy as np

from benchmarks.kernels import c_loops, ensembles, goals, pipeline, python_calls
from benchmarks.kernels.case import case
from benchmarks.kernels.goals import Heat
from benchmarks.kernels.race import Times, race, ratio
from mechanics.compiled.machine.library import find_compiler
from mechanics.errors import CompilerError

FROM_PYTHON = (1, 5)
CALLS = 8
UNITS = ((1e6, "ms"), (1e3, "us"), (1, "ns"))
STREAMS = 7
"""Numbers that a state moves at one link: q1, u1, F read, two accelerations written (and, before
that, read into the cache)."""


def ratios(heat: Heat, times: Times) -> Iterator[str]:
    """Lines of the table of goals."""
    for goal in heat.goals:
        if goal.ours not in times or goal.peer not in times:
            yield f"| {goal.what} | {goal.peer} | - | - | - | {_words(goal.most)} |"
            continue
        ours, peer = median(times[goal.ours]), median(times[goal.peer])
        found = ratio(times, goal.ours, goal.peer)
        yield _row(goal.what, goal.peer, ours, peer, goal.most, found)


def _row(
    what: str, peer: str, ours: float, theirs: float, most: float, found: float | None = None
) -> str:
    """A line; the ratio is that of the times unless it is given."""
    times = found or ours / theirs
    shown = f"{times:.2f}" if most >= 1 else f"1/{1 / times:.1f}"
    mark = "reached" if times <= most else "not reached"
    return (
        f"| {what} | {peer} | {_time(ours)} | {_time(theirs)} | {shown}, {mark} | {_words(most)} |"
    )


def _words(most: float) -> str:
    return f"{most:g}" if most >= 1 else f"1/{1 / most:g}"


def _time(ns: float) -> str:
    return (
        f"{ns:.3g} ns" if ns < 1e3 else f"{ns / 1e3:.3g} us" if ns < 1e6 else f"{ns / 1e6:.3g} ms"
    )


def _told(times: Times) -> str:
    return "; ".join(f"{name} {_time(median(ns))}" for name, ns in times.items())


def growth(rounds: int) -> str:
    """The line about long chains."""
    few, many, most = goals.GROWTH
    kernel = c_loops.generated()
    times = {n: median(race(case(n, 256), (kernel,), rounds)[kernel.name]) for n in (few, many)}
    return _row(
        f"from {few} to {many} links", f"itself, {few} links", times[many], times[few], most
    )


def bandwidth(states: int, rounds: int) -> float:
    """Bytes a second that NumPy's copy of so many states moves, as the kernels do."""
    source, target = np.zeros((3, states)), np.empty((3, states))
    seconds = []
    for _ in range(rounds):
        start = perf_counter()
        np.copyto(target, source)
        seconds.append(perf_counter() - start)
    # A write reads the line into the cache first.
    return 3 * source.nbytes / median(seconds)


def motions(entries: Sequence[ensembles.Entry], count: int) -> Iterator[str]:
    """Lines about ensembles; the one that is nearest in error to heyoka's is ours."""
    ours = next(e for e in entries if e.name.startswith("ensemble, taylor"))
    one = [e for e in entries if e.name.startswith("heyoka, one by one")]
    batches = [e for e in entries if e.name.startswith("heyoka, batch")]
    what = f"{count} motions of 10 s at 1e-9"
    if one:
        yield _row(what, one[0].name, ours.seconds * 1e9, one[0].seconds * 1e9, 1 / 4)
        best = min(batches, key=lambda entry: entry.seconds)
        yield _row(what, best.name, ours.seconds * 1e9, best.seconds * 1e9, 1.0)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    parser.add_argument("--rounds", type=int, default=30, help="of each race; medians are shown")
    parser.add_argument("--motions", type=int, default=10_000, help="of the ensembles")
    options = parser.parse_args()
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler: set CC to one")
    print(
        f"{compiler} {c_loops.FLAGS}, {platform.machine()}, one core, processor time, medians of"
        " rounds in turn\n"
    )
    print("| what | against | ours | theirs | ratio | goal |\n|---|---|---|---|---|---|")
    results = []
    for heat in goals.HEATS:
        absent = [c.name + ": " + c.absent() for c in heat.contenders if c.absent()]
        times = race(case(heat.links, heat.states), heat.contenders, options.rounds)
        results.append((heat, times, absent))
        for line in ratios(heat, times):
            print(line, flush=True)
        if heat.states > 100_000:
            moved = STREAMS * 8 / median(times[goals.LANES.name]) * 1e9
            share = moved / bandwidth(heat.states, options.rounds)
            print(f"| share of the memory's bandwidth | a copy | | | {share:.0%} | - |", flush=True)
    print(growth(options.rounds), flush=True)
    entries = ensembles.measured(options.motions, max(1, options.rounds // 10), (1e-9,))
    for line in motions(entries, options.motions):
        print(line, flush=True)
    work, whole = pipeline.seconds(max(3, options.rounds // 10))
    words = f"{work:.2g} s, with imports {whole:.2g} s"
    print(f"| elastic pendulum generated, proved, compiled | - | {words} | | | 3 s |\n")
    print(ensembles.table(entries), "\n")
    for heat, times, absent in results:
        print(f"{heat.links} links, {heat.states} states: {_told(times)}")
        for words in absent:
            print(f"  left out: {words}")
    for links in FROM_PYTHON:
        times = race(case(links, CALLS), python_calls.contenders(), options.rounds)
        print(f"{links} links, one state from Python: {_told(times)}")


if __name__ == "__main__":
    main()
