"""One state of an arm with seven joints in space, in C: ours, CasADi's, Pinocchio's.

    python -m benchmarks.arm --rounds 50

The 7R Panda with general inertias. Ours and CasADi's are one program with the numbers of the robot
in it; Pinocchio reads them from its model at run time, and serves any robot. All are compiled with
-O3 -march=native, shown to compute the same, and timed in turn in one process; medians. What is not
installed is named and left out. Processor time, so that what else runs counts little. Markdown.
"""

import argparse
from collections.abc import Iterator

import numpy as np

from benchmarks.arm.kernels import Run, by_casadi, by_pinocchio, printed, table, timed
from benchmarks.arm.programs import JOINTS, TAU, UD, forward, inverse, numbers
from benchmarks.kernels.robots import no_pinocchio
from mechanics.program import Program

STATES = 256
AGREEMENT = 1e-9
"""Largest difference, relative to the largest value."""
GOALS = {"CasADi's C": 1.0, "Pinocchio": 1 / 3}
WORK = (
    ("inverse dynamics", inverse, UD, "rnea"),
    ("forward dynamics", forward, TAU, "aba"),
)


def race(kernels: dict[str, Run], rounds: int) -> dict[str, float]:
    """ns a state of each kernel; all of them have to compute the same."""
    random = np.random.default_rng(7)
    q, u, given = (random.uniform(-2, 2, (STATES, JOINTS)) for _ in range(3))
    found, times = timed(kernels, q, u, given, rounds)
    first = next(iter(found.values()))
    for name, own in found.items():
        apart = float(np.abs(own - first).max() / np.abs(first).max())
        if not apart < AGREEMENT:
            raise SystemExit(f"{name} computes something else: {apart:.1g} apart")
    return times


def rows(rounds: int) -> Iterator[str]:
    """Lines of the table."""
    for work, make, given, algorithm in WORK:
        program: Program = make()
        kernels = {"ours": printed(program, given), "CasADi's C": by_casadi(program, given)}
        peer = f"Pinocchio {algorithm}"
        if not no_pinocchio():
            kernels[peer] = by_pinocchio(algorithm, table(), float(numbers()["g"]))
        times = race(kernels, rounds)
        ours = times.pop("ours")
        for name, theirs in times.items():
            most = GOALS[name.removesuffix(f" {algorithm}")]
            ratio = ours / theirs
            mark = "reached" if ratio <= most else "not reached"
            shown = f"{ratio:.2f}" if most == 1 else f"1/{1 / ratio:.1f}"
            goal = "1" if most == 1 else f"1/{1 / most:g}"
            yield (
                f"| {work}, {program.count} operations | {name} | {ours:.0f} ns | {theirs:.0f} ns |"
                f" {shown}, {mark} | {goal} |"
            )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=50)
    settings = parser.parse_args()
    print("| one state of the 7R Panda | against | ours | theirs | ratio | goal |")
    print("|---|---|---|---|---|---|")
    for row in rows(settings.rounds):
        print(row, flush=True)
    if why := no_pinocchio():
        print(f"\n{why}")


if __name__ == "__main__":
    main()
