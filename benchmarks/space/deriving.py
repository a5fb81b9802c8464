"""One scene in one process: the four routes derived as programs, and all pairs decided."""

from __future__ import annotations

import resource
from collections.abc import Callable
from dataclasses import asdict, dataclass
from itertools import combinations, pairwise
from time import process_time

from benchmarks.space import scenes
from mechanics.kernel import Finding, Range, Statement, decide
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Node
from mechanics.program.residues import PRIME, Residues
from mechanics.routes.programs import free_body, kane, lagrange, moving_point
from mechanics.routes.programs.rows import Rows, acceleration_forms, coefficients, remainder
from mechanics.scene import Scene

ROUTES = (free_body, moving_point, kane, lagrange)
SIGNS = {"positive": Range.POSITIVE, "nonnegative": Range.NONNEGATIVE}


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
    findings = pairs(mechanism, routes)
    times.append(process_time())
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    building, lowering, deriving, deciding = (b - a for a, b in pairwise(times))
    counts = {rows.route: mechanism.builder.program({"rows": rows.values}).count for rows in routes}
    verdicts = {pair: finding.verdict.name for pair, finding in findings.items()}
    return asdict(Derivation(building, lowering, deriving, deciding, memory, counts, verdicts))


def pairs(mechanism: Mechanism, routes: list[Rows]) -> dict[str, Finding]:
    """Whether each two routes give the same accelerations, as the kernel decides."""
    filter_ = Residues(mechanism.builder)
    solved: dict[str, tuple[Node, ...]] = {}
    found = {}
    for one, two in combinations(routes, 2):
        left, right = matched(filter_, one, two) or ((), ())
        if not left:
            for rows in (one, two):
                if rows.route not in solved:
                    solved[rows.route] = accelerations(mechanism, rows)
            left, right = solved[one.route], solved[two.route]
        pair = f"{one.route} = {two.route}"
        program = mechanism.builder.program({"left": left, "right": right})
        signs = {name: SIGNS[sign] for name, sign in mechanism.signs.items()}
        found[pair] = decide(Statement(pair, program, signs), try_normal=False)
    return found


def matched(
    filter_: Residues, one: Rows, two: Rows
) -> tuple[tuple[Node, ...], tuple[Node, ...]] | None:
    """Rows in pairs that are equal at a point, up to sign; then the kernel decides on the rows."""
    places = dict(zip(filter_.values(two.values), two.values, strict=True))
    left, right = [], []
    for residue, row in zip(filter_.values(one.values), one.values, strict=True):
        if residue in places:
            right.append(places[residue])
        elif -residue % PRIME in places:
            right.append(-places[-residue % PRIME])
        else:
            return None
        left.append(row)
    return tuple(left), tuple(right)


def accelerations(mechanism: Mechanism, rows: Rows) -> tuple[Node, ...]:
    """u' as the solution of the rows and the constraints."""
    unknowns = [*mechanism.ud, *rows.multipliers]
    every = [*rows.values, *acceleration_forms(mechanism)]
    matrix = coefficients(every, unknowns)
    rest = remainder(mechanism.builder, every, unknowns)
    solution = mechanism.builder.solve(matrix, [-entry for entry in rest])
    return solution[: len(mechanism.u)]
