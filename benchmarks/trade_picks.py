"""Picks of `mechanics trade` on states that they were not tuned on, beside an exhaustive search.

    python -m benchmarks.trade_picks [SYSTEM...] [--states 50] [--horizon 2] [--processes 2]

For each system, target and ranking (time called from Python; operations of the C): misses among
fresh states of another seed, the median of asked over reached error, and how far apart the errors
of the states are, which no single setting can follow: the largest over the median. For the ranking
by operations also the cost over the least of all numbers of steps of all methods in C, with the
same factor of safety on the same states. With workers each takes a system; counts do not change.
"""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.workers import add_options, team
from mechanics.cluster import spread
from mechanics.crosscheck import derive
from mechanics.errors import MechanicsError
from mechanics.simulate.integrators import INTEGRATORS, Setting
from mechanics.trade import Choice, Variant, trade
from mechanics.trade.case import Case
from mechanics.trade.cost import IN_C, operations
from mechanics.trade.family import Family, family, solutions, truth_of
from mechanics.trade.train import error_of, train
from systems import ALL, EVERY

STATES, HORIZON, SEED = 50, 2.0, 4711
FEW = ("SciPy DOP853", "SciPy LSODA", "SUNDIALS CVODES", "heyoka Taylor", *IN_C)
"""Methods that are measured: the others are not the cheapest of any system that ships."""
COLUMNS = ("system", "target", "ranking", "pick", "misses", "asked/reached", "largest/median",
           "cost")  # fmt: skip
FINER, MOST = 1.05, 1e4
"""Ratio of the steps that a search tries, and the steps in all at which it gives up."""


@dataclass(frozen=True)
class Row:
    """What became of one pick.

    Attributes
    ----------
    system, ranking, choice : str
    target : float
    misses, states : int
    ratio : float
        Median of target over error.
    spread : float
        Largest error over the median.
    cost : float or None
        Over that of the exhaustive search.
    """

    system: str
    ranking: str
    target: float
    choice: str
    misses: int = 0
    states: int = 0
    ratio: float = 0.0
    spread: float = 0.0
    cost: float | None = None


def exhaustive(case: Case, around: Family, target: float) -> float:
    """Fewest operations for a second of motion that meet a target on all states of a family."""
    best = np.inf
    counts = FINER ** np.arange(0, np.log(MOST) / np.log(FINER))
    for name in IN_C:
        for arithmetic in ("double", "single"):
            for count in counts.tolist():
                setting = Setting(name, step=case.horizon / count, arithmetic=arithmetic)
                choice = Choice(Variant(), setting)
                cost = operations(case, choice)
                if cost >= best:
                    break
                if all(train(case, [choice], around, states)[0].bound <= target
                       for states in (1, 24, len(around.starts))):  # fmt: skip
                    best = cost
                    break
    return float(best)


def rows(name: str, states: int, horizon: float) -> list[Row]:
    """The picks of one system."""
    scenes = {system.name: system.scene for system in EVERY}
    members = tuple(m for m in INTEGRATORS if m.name in FEW)
    try:
        equations = derive(scenes[name](), "kane")
        found = trade(equations, horizon, members=members)
    except MechanicsError as error:
        return [Row(name, f"not measured: {error}", 0.0, "")]
    case = Case(equations, found.horizon, found.start, through=True)
    fresh = family(case, found.yardstick.truth.scale, states, seed=SEED)
    around = found.family
    truths = [truth_of(one) for one in solutions(case, fresh, around.first, around.second)]
    result = []
    for ranking, picks in (("Python", found.recommendations), ("C", found.embedded)):
        for pick in picks:
            if pick.choice is None:
                result.append(Row(name, ranking, pick.target, "none"))
                continue
            errors = np.array([error_of(case, pick.choice, start, truth)
                               for start, truth in zip(fresh, truths, strict=True)])  # fmt: skip
            cost = None
            if ranking == "C":
                cost = operations(case, pick.choice) / exhaustive(case, around, pick.target)
            middle = float(np.median(errors))
            result.append(Row(
                name, ranking, pick.target, pick.choice.words, int(np.sum(errors > pick.target)),
                states, pick.target / middle, float(np.max(errors)) / middle, cost,
            ))  # fmt: skip
    return result


def table(found: Sequence[Row]) -> str:
    """For people; what is not measured says why."""
    lines = [f"| {' | '.join(COLUMNS)} |", "|---" * len(COLUMNS) + "|"]
    for row in found:
        if not row.states:
            lines.append(f"| {row.system} | {row.target:.0e} | {row.ranking} | none | | | | |")
            continue
        cost = "" if row.cost is None else f"{row.cost:.2f}"
        lines.append(
            f"| {row.system} | {row.target:.0e} | {row.ranking} | {row.choice} |"
            f" {row.misses} of {row.states} | {row.ratio:.0f} | {row.spread:.0f} | {cost} |"
        )
    return "\n".join(lines)


def summary(found: Sequence[Row]) -> str:
    """The figures of all picks."""
    picks = [row for row in found if row.states]
    costs = [row.cost for row in picks if row.cost is not None]
    systems = len({row.system for row in picks})
    if not picks:
        return "no picks"
    return (
        f"{len(picks)} picks of {systems} systems, {picks[0].states} fresh states each:"
        f" {sum(row.misses for row in picks)} misses of {sum(row.states for row in picks)};"
        f" median asked/reached {np.median([row.ratio for row in picks]):.0f}"
        f" ({sum(row.ratio < 10 for row in picks)} picks below 10); largest over median error of a"
        f" family {np.median([row.spread for row in picks]):.0f} in the middle; cost over"
        f" exhaustive search at most {max(costs, default=np.nan):.2f}"
        f" ({sum(cost <= 1.2 for cost in costs)} of {len(costs)} within 1.2)"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("systems", nargs="*", default=[system.name for system in ALL])
    parser.add_argument("--states", type=int, default=STATES)
    parser.add_argument("--horizon", type=float, default=HORIZON)
    add_options(parser)
    asked = parser.parse_args()
    found = []
    with team(asked) as some:
        groups = spread(some, rows, asked.systems, asked.states, asked.horizon)
        for name, group in zip(asked.systems, groups, strict=True):
            found += group
            print(f"{name} done", flush=True)
    print(table(found))
    print(f"\n{summary(found)}")


if __name__ == "__main__":
    main()
