"""Time of every route and of the proof that they agree, for a cart with n links, beside SymPy.

Run ``python -m benchmarks.derivation --links 1,2,5,10 --rounds 3`` in the project's root. All that
is compared runs in turn in one process, with SymPy's cache emptied before each; the table shows
medians, and ratios to Kane's method with explicit velocities.
"""

import argparse
import gc
import platform
import sys
from collections.abc import Callable
from statistics import median
from time import perf_counter

import sympy
from sympy.core.cache import clear_cache

from benchmarks import peers
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import derive_rows
from mechanics.kernel import Verdict
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes.derivation import by_route
from systems import pendulum_chain

LARGEST_LAGRANGE = 10
"""Links up to which Lagrange's method is run: SymPy takes over two minutes for twenty."""


def timed(work: Callable[[], object]) -> tuple[float, object]:
    """Seconds and result of one run with an empty cache, and nothing left over to collect."""
    clear_cache()
    gc.collect()
    start = perf_counter()
    result = work()
    return perf_counter() - start, result


def row(links: int, rounds: int) -> dict[str, float | str]:
    """Median seconds of everything for one number of links."""
    routes = ["free_body", "moving_point", "kane"]
    if links <= LARGEST_LAGRANGE:
        routes.append("lagrange")
    times: dict[str, list[float]] = {}
    verdicts: set[Verdict] = set()
    for _ in range(rounds):
        for name in routes:
            # A new scene for each: nobody profits from positions that another has worked out.
            own = pendulum_chain.scene(links)
            seconds, _ = timed(lambda name=name, own=own: by_route(name, own).system)
            times.setdefault(name, []).append(seconds)
        for name, peer in (("SymPy", peers.stock_kane), ("explicit", peers.explicit_kane)):
            seconds, _ = timed(lambda peer=peer: peer(links))
            times.setdefault(name, []).append(seconds)
        mechanism = lower(pendulum_chain.scene(links), Builder())
        seconds, pairs = timed(
            lambda mechanism=mechanism: compare_pairs(derive_rows(mechanism, tuple(routes)).routes)
        )
        times.setdefault("proofs", []).append(seconds)
        verdicts |= {finding.verdict for finding in pairs.values()}
        if links == 1:
            scene = pendulum_chain.scene(links)
            both = by_route("kane", scene), by_route("lagrange", scene)
            seconds, left = timed(lambda both=both: peers.simplified_difference(*both))
            times.setdefault("simplify", []).append(seconds)
            if left != sympy.zeros(*left.shape):
                print("simplify did not find zero", file=sys.stderr)
    result: dict[str, float | str] = {name: median(values) for name, values in times.items()}
    result["verdicts"] = ", ".join(sorted(verdict.name for verdict in verdicts))
    return result


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--links", default="1,2,3,5,8,10,20", help="numbers of links")
    parser.add_argument("--rounds", type=int, default=3, help="runs of each; medians are shown")
    options = parser.parse_args()
    print(f"Python {platform.python_version()}, SymPy {sympy.__version__}, {platform.machine()},")
    print(f"medians of {options.rounds} rounds in s; in brackets: ratio to explicit Kane")
    columns = ("free_body", "moving_point", "kane", "lagrange", "SymPy", "explicit")
    heads = (*columns[:4], "SymPy's Kane model", "SymPy's Kane, explicit velocities")
    print("\n| links | " + " | ".join((*heads, "all pairs", "verdicts", "simplify")) + " |")
    print("|" + "---|" * (len(columns) + 4))
    for text in options.links.split(","):
        found = row(int(text), options.rounds)
        cells = [text]
        for name in columns:
            seconds = found.get(name)
            ratio = None if seconds is None else seconds / found["explicit"]
            cells.append("-" if seconds is None else f"{seconds:.3f} ({ratio:.2f})")
        cells += [f"{found['proofs']:.3f}", str(found["verdicts"])]
        cells.append(f"{found['simplify']:.2f}" if "simplify" in found else "-")
        print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
