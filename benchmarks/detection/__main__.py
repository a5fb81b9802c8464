"""How good the checker is, on mutants and rewritings of right equations.

    python -m benchmarks.detection --count 20000 --processes 2
    python -m benchmarks.detection --only m17 r4

Every case is drawn from its number and the seed alone, so that a miss is seen again with --only.
Prints Markdown.
"""

import argparse
import json
import platform
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from itertools import islice
from pathlib import Path

from benchmarks.detection.figures import line, missed, summary, tables
from benchmarks.detection.trial import Result
from benchmarks.detection.whole import WHOLE, judged_all
from benchmarks.workers import add_options, spread_alone, team
from mechanics.cluster import Team
from systems import ALL

PART = 50
"""Cases that a worker takes at a time."""


def names(count: int, rewritings: int, conventions: int, whole: int) -> list[str]:
    """Names of all cases of a run."""
    numbers = (("m", count), ("r", rewritings), ("c", conventions),
               *((kind, whole) for kind in WHOLE))  # fmt: skip
    return [f"{kind}{i}" for kind, most in numbers for i in range(most)]


def run(
    wanted: Sequence[str], seed: int, systems: Sequence[str], blamed: int,
    errors: int | None = None, workers: Team | None = None,
) -> Iterator[Result]:  # fmt: skip
    """Results of cases, in order; the first `blamed` mutants are blamed too."""
    rest = iter(wanted)
    parts = iter(lambda: list(islice(rest, PART)), [])
    for found in spread_alone(workers, judged_all, parts, seed, tuple(systems), blamed, errors):
        yield from found


def _told(result: Result) -> str:
    """A case in full."""
    lines = [line(result, 60), "", result.text, "", f"{result.verdict}: {result.words}"]
    lines += [f"mistake made, {words}" for words in result.made]
    lines += [f"right if {words}" for words in result.right_if]
    if result.undone:
        lines += [f"first repair, {result.undone.how}:", *result.undone.edits]
    return "\n".join(lines)


def main() -> None:
    """Print the figures and every miss."""
    known = [system.name for system in ALL]
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    parser.add_argument("--count", type=int, default=2000, help="wrong mutants")
    parser.add_argument("--rewritings", type=int, help="right rewritings; a quarter of the mutants")
    parser.add_argument("--conventions", type=int, help="undeclared ones; a fortieth")
    parser.add_argument("--whole", type=int, help="models, wrong and right boxes; a fortieth each")
    parser.add_argument("--blame", type=int, default=200, help="mutants that are blamed too")
    parser.add_argument("--errors", type=int, help="mistakes of a mutant; one or two")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--systems", nargs="+", choices=known, default=known, metavar="SYSTEM")
    add_options(parser)
    parser.add_argument("--only", nargs="+", metavar="ID", help="these cases, in full")
    parser.add_argument("--json", type=Path, help="file for all results")
    options = parser.parse_args()
    if options.only:
        for result in run(
            options.only, options.seed, options.systems, 10**9, errors=options.errors
        ):
            print(_told(result), "\n")
        return
    count = options.count
    rewritings = count // 4 if options.rewritings is None else options.rewritings
    conventions = count // 40 if options.conventions is None else options.conventions
    whole = count // 40 if options.whole is None else options.whole
    wanted = names(count, rewritings, conventions, whole)
    results = []
    with team(options) as some:
        for result in run(
            wanted, options.seed, options.systems, options.blame, options.errors, some
        ):
            results.append(result)
            if len(results) % 1000 == 0:
                print(f"{len(results)} of {len(wanted)}", file=sys.stderr, flush=True)
    print(f"{platform.machine()}, seed {options.seed}, {len(options.systems)} systems:"
          f" {', '.join(options.systems)}\n")  # fmt: skip
    print("\n".join(summary(results)))
    print("\n".join(tables(results)))
    misses = [result for result in results if missed(result)]
    print(f"\n{len(misses)} misses; each is seen again with"
          f" python -m benchmarks.detection --seed {options.seed} --only ID")  # fmt: skip
    for result in misses:
        print(f"- {line(result)}")
    if options.json:
        options.json.write_text(json.dumps([asdict(r) for r in results], indent=1) + "\n")


if __name__ == "__main__":
    main()
