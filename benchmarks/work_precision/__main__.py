"""Work and precision on problems of the IFToMM library, the Test Set and SciML.

    python -m benchmarks.work_precision [PROBLEM...] [--points] [--only METHOD]

A table a problem: for each method the cheapest of its settings that reaches a level of the measure
of the collection, with processor time and evaluations of the right-hand side. `--points` prints
every setting: scd, mescd, energy, constraints, evaluations, Jacobians, time. Peers that are not
installed are named: pip install heyoka diffrax.
"""

import argparse
from collections.abc import Sequence

from benchmarks.work_precision.measure import Point, Posed, points, posed, timed
from benchmarks.work_precision.methods import METHODS
from benchmarks.work_precision.problems import ENERGY, PROBLEMS, Problem

NAMES = tuple(problem.name for problem in PROBLEMS)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("problems", nargs="*", metavar="PROBLEM", help=", ".join(NAMES))
    parser.add_argument("--points", action="store_true", help="every setting")
    parser.add_argument("--only", action="append", choices=[m.name for m in METHODS])
    asked = parser.parse_args()
    if unknown := set(asked.problems) - set(NAMES):
        parser.error(f"no problem {', '.join(sorted(unknown))}: there are {', '.join(NAMES)}")
    for problem in PROBLEMS:
        if not asked.problems or problem.name in asked.problems:
            of = posed(problem)
            print(f"\n{heading(of)}\n", flush=True)
            found, absent = measured(of, asked.only or [m.name for m in METHODS])
            print(every(of, found) if asked.points else levels(problem, found))
            print("".join(f"\n{name}: {why}" for name, why in absent.items()), flush=True)


def heading(of: Posed) -> str:
    """What is integrated, and how well its solution is known."""
    problem, size = of.problem, len(of.case.start)
    operations = of.case.model().right_hand_side.rate.routine.operations
    return (
        f"**{problem.name}** ({problem.collection}): {problem.duration:.4g} s, {size} entries of"
        f" the state, {len(of.case.equations.scene.constraints)} constraints, {operations}"
        f" operations an evaluation; reference: {of.doubt}"
    )


def measured(of: Posed, names: Sequence[str]) -> tuple[dict[str, list[Point]], dict[str, str]]:
    """Points by method, those of the levels timed side by side; and why a method has none."""
    found, absent = {}, {}
    for member in METHODS:
        if member.name in names:
            able = points(of, member)
            if isinstance(able, str):
                absent[member.name] = able
            else:
                found[member.name] = list(able)
    cheapest = {id(p): p for able in found.values() for level in of.problem.levels
                if (p := first(of.problem, able, level)) is not None}  # fmt: skip
    again = dict(zip(cheapest, timed(list(cheapest.values())), strict=True))
    return {name: [again.get(id(p), p) for p in able] for name, able in found.items()}, absent


def first(problem: Problem, able: Sequence[Point], level: float) -> Point | None:
    """The point with the fewest evaluations that reaches a level."""
    meeting = [p for p in able if p.reaches(problem, level)]
    return min(meeting, key=lambda p: p.evaluations, default=None)


def levels(problem: Problem, found: dict[str, list[Point]]) -> str:
    """The table: milliseconds and evaluations at each level."""
    unit = "{:.0e} J" if problem.measure == ENERGY else "{:g} digits"
    wanted = [unit.format(level) for level in problem.levels]
    with_constraints = any(p.constraint == p.constraint for able in found.values() for p in able)
    heads = ["method", *wanted, "best", *(["constraints"] if with_constraints else [])]
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for name, able in found.items():
        cells = []
        for level in problem.levels:
            point = first(problem, able, level)
            cells.append("-" if point is None else f"{_time(point.seconds)}, {point.evaluations}")
        if problem.measure == ENERGY:
            best = min(able, key=lambda p: p.energy)
            cells.append(f"{best.energy:.0e} J")
        else:
            best = max(able, key=lambda p: p.digits(problem))
            cells.append(f"{best.digits(problem):.1f}")
        cells += [f"{best.constraint:.0e}"] if with_constraints else []
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines)


def every(of: Posed, found: dict[str, list[Point]]) -> str:
    """Every setting in a row."""
    heads = ("method", "setting", "scd", "mescd", "energy, J", "constraints", "f", "Jacobians",
             "time")  # fmt: skip
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for name, able in found.items():
        for p in able:
            size = p.setting.tolerance or p.setting.step
            lines.append(
                f"| {name} | {size:.1e} | {p.scd:.2f} | {p.mescd:.2f} | {p.energy:.1e} |"
                f" {p.constraint:.1e} | {p.evaluations} | {p.jacobians} | {_time(p.seconds)} |"
            )
    return "\n".join(lines)


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.2g} ms" if seconds >= 1e-3 else f"{seconds * 1e6:.2g} us"


if __name__ == "__main__":
    main()
