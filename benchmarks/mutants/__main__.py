"""Mutants of the trusted part, and how many the tests notice.

    python -m benchmarks.mutants                     what has changed since the last run
    python -m benchmarks.mutants --folder kernel     one folder
    python -m benchmarks.mutants --seed 2 --drawn 100    others than those that tests were made for
    python -m benchmarks.mutants --sample 12         some of the kernel that are known to be noticed
    python -m benchmarks.mutants --processes 2       the same by workers, or by those of a --cluster

Of all mutants 500 are drawn by their names, so that a change in one file draws no others elsewhere.
Each runs the tests that cover its file, the quickest first, up to the first that fails; running out
of time or memory counts as noticed. ``results.json`` keeps what became of them, by the hash of the
file; ``equivalent.json`` names those that change nothing, each with the reason. Survivors run again
each time, since tests may have come. Prints Markdown; exit code 1 if one survives that has no
reason.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Sequence
from hashlib import sha256
from itertools import islice
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.mutants.covering import FOLDERS, tests_of
from benchmarks.mutants.operators import STRICT, Mutant, is_python, mutants
from benchmarks.mutants.trial import ENOUGH, ROOT, tried, try_files, try_functions, warm_up
from benchmarks.workers import add_options, spread_alone, team

if TYPE_CHECKING:
    from mechanics.cluster import Team

HERE = Path(__file__).parent
RESULTS, EQUIVALENT = HERE / "results.json", HERE / "equivalent.json"
DRAWN, SEED = 500, "1"


def draw(count: int, seed: str = SEED) -> list[Mutant]:
    """Some of the mutants of every file of the folders, by the hashes of their names."""
    found: list[Mutant] = []
    for folder in FOLDERS:
        for path in sorted((ROOT / "mechanics" / folder).glob("*.py")):
            name = str(path.relative_to(ROOT / "mechanics"))
            found += mutants(name, text_of(name))
    found.sort(key=lambda mutant: sha256(f"{seed} {mutant.key}".encode()).digest())
    whole = (m for m in found if is_python(m.apply(text_of(m.path))))
    return list(islice(whole, count))


def text_of(path: str) -> str:
    """The text of a file below ``mechanics/``."""
    return (ROOT / "mechanics" / path).read_text(encoding="utf-8")


def hash_of(path: str) -> str:
    """Twelve digits that change with a file."""
    return sha256(text_of(path).encode()).hexdigest()[:12]


def campaign(
    drawn: Sequence[Mutant], results: dict, *, again: bool = False, workers: Team | None = None
) -> dict[str, bool]:
    """Whether each of the mutants survives, by key; what was noticed before is not tried again."""
    outcome: dict[str, bool] = {}
    reasons = json.loads(EQUIVALENT.read_text(encoding="utf-8"))
    asked: list[Mutant] = []
    for mutant in drawn:
        kept = results.get(mutant.path, {})
        if kept.get("file") != hash_of(mutant.path):
            results[mutant.path] = kept = {"file": hash_of(mutant.path), "noticed": [], "alive": []}
        outcome[mutant.key] = mutant.key not in kept["noticed"]
        if mutant.key not in reasons and (again or outcome[mutant.key]):
            asked.append(mutant)

    def report(mutant: Mutant, alive: bool) -> None:
        outcome[mutant.key] = alive
        word = "SURVIVES" if alive else "noticed"
        print(f"{word} {mutant.key} {mutant.path} {mutant.name}", file=sys.stderr, flush=True)
        for word, here in (("noticed", not alive), ("alive", alive)):
            others = {*results[mutant.path][word]} - {mutant.key}
            results[mutant.path][word] = sorted(others | {mutant.key} if here else others)
        if not again:
            RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")

    # Survivors of before come last: they take the longest, and most stay.
    asked.sort(key=lambda m: m.key in results[m.path]["alive"])
    groups: dict[tuple[str, ...], list[Mutant]] = {}
    for mutant in asked:
        if mutant.in_function:
            groups.setdefault(tests_of(mutant.path), []).append(mutant)
    # What was noticed is noticed on slow machines, too.
    enough, whole = inf if again else ENOUGH, [m for m in asked if not m.in_function]
    if workers is None:
        warm_up()
        for tests, group in groups.items():
            try_functions(group, tests, report, enough)
        try_files(whole, report)
        return outcome
    many, by_key = workers.size(), {m.key: m for m in asked}
    parts = [(group[k::many], tests) for tests, group in [*groups.items(), ((), whole)]
             for k in range(min(many, len(group)))]  # fmt: skip
    for found in spread_alone(workers, tried, parts, enough):
        for key, alive in found:
            report(by_key[key], alive)
    return outcome


def summary(drawn: list[Mutant], outcome: dict[str, bool], reasons: dict[str, str]) -> str:
    """Shares by folder and survivors, in Markdown."""
    asked = [m for m in drawn if m.key not in reasons]
    counts, noticed = Counter(m.path.rpartition("/")[0] for m in asked), Counter[str]()
    noticed.update(m.path.rpartition("/")[0] for m in asked if not outcome[m.key])
    lines = ["| folder | mutants | noticed |", "| --- | --- | --- |"]
    lines += [f"| {f} | {n} | {noticed[f]} ({noticed[f] / n:.1%}) |" for f, n in counts.items()]
    whole = sum(noticed.values())
    lines += [f"| all | {len(asked)} | {whole} ({whole / max(len(asked), 1):.1%}) |", ""]
    strict = [m for m in asked if m.path.startswith("kernel/") and m.kind in STRICT]
    seen = sum(not outcome[m.key] for m in strict)
    lines += [f"Of error bounds, signs and comparisons in the kernel: {seen} of {len(strict)}."]
    lines += [f"{len(drawn) - len(asked)} more change nothing, for reasons that are given."]
    alive = [f"- {m.key} {m.path} {m.name}" for m in asked if outcome[m.key]]
    return "\n".join([*lines, *(["", "Survivors:", *alive] if alive else [])])


def main() -> int:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", nargs="+", choices=list(FOLDERS), default=list(FOLDERS))
    parser.add_argument("--drawn", type=int, default=DRAWN, help="mutants to draw of all")
    parser.add_argument("--seed", default=SEED, help="another one draws others")
    parser.add_argument("--strict", action="store_true", help="bounds, signs, comparisons only")
    parser.add_argument("--sample", type=int, help="that many of those known to be noticed")
    add_options(parser)
    options = parser.parse_args()
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    reasons = json.loads(EQUIVALENT.read_text(encoding="utf-8"))
    drawn = [
        m for m in draw(options.drawn, options.seed) if m.path.rpartition("/")[0] in options.folder
    ]
    if options.strict:
        drawn = [m for m in drawn if m.kind in STRICT]
    if options.sample:
        known = {key for kept in results.values() for key in kept["noticed"]}
        here = [m for m in drawn if m.path.startswith("kernel/") and m.in_function]
        drawn = [m for m in here if m.key in known][: options.sample]
    if options.processes or options.cluster:
        with team(options) as some:
            outcome = campaign(drawn, results, again=bool(options.sample), workers=some)
    else:
        outcome = campaign(drawn, results, again=bool(options.sample))
    print(summary(drawn, outcome, reasons))
    return int(any(outcome[m.key] for m in drawn if m.key not in reasons))


if __name__ == "__main__":
    sys.exit(main())
