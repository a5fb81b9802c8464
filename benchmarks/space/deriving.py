"""One scene in one process: the four routes derived as programs, and all pairs decided."""

import resource
from collections.abc import Callable
from dataclasses import asdict, dataclass
from itertools import pairwise
from time import process_time

from sympy import Rational

from benchmarks.space import scenes
from benchmarks.space.branches import crossed
from mechanics.checks.agreement import compare_pairs, linear_system
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes import free_body, kane, lagrange, moving_point
from mechanics.scene import Scene
from systems import andrews, bicycle, four_bar, four_bar_chain, rolling_disc

ROUTES = (free_body, moving_point, kane, lagrange)


def distinct(which: str, k: int) -> Rational:
    """Lengths of four-bars that no two neighbours share."""
    base, factor, offset, size = {
        "crank": (100, 3, 0, 2),
        "coupler": (100, 5, 2, 3),
        "ground": (105, 4, 1, 2),
    }[which]
    return Rational(base + (factor * k + offset) % 7 * size, 100)


def near_crossing(which: str, k: int) -> Rational:
    """Distinct lengths, couplers and grounds about twice as long: some loops may be crossed."""
    return (distinct(which, k) - 1) / 10 + (1 if which == "crank" else 2)


@dataclass(frozen=True)
class Limit:
    """A scene with what it may take: processor time in s, memory in MB."""

    name: str
    make: Callable[[], Scene]
    seconds: float | None = None
    megabytes: int | None = None


LIMITS = (
    Limit("arm of 6", lambda: scenes.arm(6), 2, 300),
    Limit("arm of 7", lambda: scenes.arm(7), 2, 300),
    Limit("PUMA 560", scenes.puma560, 2, 300),
    Limit("Panda", scenes.panda, 2, 300),
    Limit("floating base with 12 joints", lambda: scenes.floating(12), 4, 500),
    Limit("floating base with 30 joints", lambda: scenes.floating(30), 12, 500),
    Limit("tree of 10 bodies", lambda: scenes.tree(10)),
    Limit("tree of 50 bodies", lambda: scenes.tree(50), 30, 1000),
    Limit("pendulum_chain 20", lambda: scenes.chain(20), 2, 1000),
    Limit("pendulum_chain 50", lambda: scenes.chain(50), 10, 1000),
    Limit("pendulum_chain 100", lambda: scenes.chain(100), 40, 1000),
    Limit("four-bar linkage", four_bar.scene),
    Limit("1 four-bar", lambda: four_bar_chain.scene(1)),
    Limit("2 four-bars", lambda: four_bar_chain.scene(2)),
    Limit("5 four-bars", lambda: four_bar_chain.scene(5)),
    Limit("10 four-bars", lambda: four_bar_chain.scene(10)),
    Limit("40 four-bars", lambda: four_bar_chain.scene(40), 5),
    Limit("40 four-bars, distinct numbers", lambda: four_bar_chain.scene(40, distinct), 5),
    Limit("40 four-bars, some crossed", lambda: crossed(40, near_crossing), 5),
    Limit("Andrews' mechanism", andrews.scene, 2),
    Limit("rolling disc", rolling_disc.scene),
    Limit("bicycle", bicycle.scene),
)


@dataclass(frozen=True)
class Derivation:
    """Processor times in s, memory in MB, operations of the rows by route, verdicts by pair."""

    scene: float
    lower: float
    derive: float
    decide: float
    megabytes: int
    operations: dict[str, int]
    verdicts: dict[str, str]

    @property
    def seconds(self) -> float:
        """From the declared scene to the verdicts."""
        return self.lower + self.derive + self.decide


def derivation(make: Callable[[], Scene]) -> dict[str, object]:
    """Derive and compare; run in a process of its own, so that the memory is its own."""
    times = [process_time()]
    scene = make()
    times.append(process_time())
    mechanism = lower(scene, Builder())
    times.append(process_time())
    routes = [route.derive(mechanism) for route in ROUTES]
    times.append(process_time())
    _, filter_ = mechanism.filters
    systems = {rows.route: linear_system(mechanism, rows, filter_) for rows in routes}
    findings = compare_pairs(systems)
    times.append(process_time())
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    building, lowering, deriving, deciding = (b - a for a, b in pairwise(times))
    counts = {rows.route: mechanism.builder.program({"rows": rows.values}).count for rows in routes}
    verdicts = {" = ".join(pair): finding.verdict.name for pair, finding in findings.items()}
    return asdict(Derivation(building, lowering, deriving, deciding, memory, counts, verdicts))
