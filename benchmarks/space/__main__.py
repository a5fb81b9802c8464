"""How long mechanisms in space take, how that grows, and what compiled outputs cost.

    python -m benchmarks.space
    python -m benchmarks.space --only "arm of 7" --json -

Four routes are derived as programs and all pairs decided, each scene in a process of its own;
processor times in seconds, imports aside. Growth is the exponent from 10 to 50 bodies of a tree.
Operations are counted after sharing, those that depend on parameters only apart. Prints Markdown.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys

from benchmarks.space.counts import costs, ratios
from benchmarks.space.deriving import LIMITS, Limit, derivation

SMALL, LARGE = "tree of 10 bodies", "tree of 50 bodies"


def in_process(limit: Limit) -> dict:
    """The derivation of a scene, measured in a fresh process."""
    command = [sys.executable, "-m", "benchmarks.space", "--one", limit.name]
    ran = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(ran.stdout)


def seconds(found: dict) -> float:
    return found["lower"] + found["derive"] + found["decide"]


def growth(table: dict[str, dict]) -> float | None:
    """Exponent of the time from 10 to 50 bodies."""
    if SMALL not in table or LARGE not in table:
        return None
    return math.log(seconds(table[LARGE]) / seconds(table[SMALL])) / math.log(5)


def times(table: dict[str, dict]) -> str:
    limits = {limit.name: limit for limit in LIMITS}
    lines = [
        "| scene | scene, s | lower, s | derive, s | decide, s | limit, s | MB | limit, MB | "
        "free_body / moving_point / kane / lagrange, operations | verdicts |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name, found in table.items():
        limit = limits[name]
        operations = " / ".join(str(found["operations"][r]) for r in
                                ("free_body", "moving_point", "kane", "lagrange"))  # fmt: skip
        verdicts = ", ".join(sorted(set(found["verdicts"].values())))
        lines.append(
            f"| {name} | {found['scene']:.2f} | {found['lower']:.2f} | {found['derive']:.2f} "
            f"| {found['decide']:.2f} | {limit.seconds or '-'} | {found['megabytes']} "
            f"| {limit.megabytes or '-'} | {operations} | {verdicts} |"
        )
    return "\n".join(lines)


def counts(rows: list[dict]) -> str:
    lines = [
        "| work | multiplications + additions | sines, cosines | parameters only | others | goal |",
        "|---|---|---|---|---|---|",
    ]
    lines += [
        f"| {row['work']} | {row['multiplications']} + {row['additions']} = "
        f"{row['multiplications'] + row['additions']} | {row['functions']} | {row['parameters']} "
        f"| {row['others'] or '-'} | {row['goal'] or '-'} |"
        for row in rows
    ]
    return "\n".join(lines)


def factors(rows: list[dict]) -> str:
    lines = [
        "| scene | inverse dynamics | its Jacobians by q and u | ratio |", "|---|---|---|---|"
    ]  # fmt: skip
    lines += [
        f"| {row['scene']} | {row['inverse dynamics']} | {row['Jacobians']} "
        f"| {row['Jacobians'] / row['inverse dynamics']:.2f} |"
        for row in rows
    ]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.space", description=__doc__)
    names = [limit.name for limit in LIMITS]
    parser.add_argument("--only", nargs="*", choices=names, help="scenes; by default all")
    parser.add_argument("--json", metavar="FILE", help="figures as JSON; - for standard output")
    parser.add_argument("--one", choices=names, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        (limit,) = (limit for limit in LIMITS if limit.name == given.one)
        print(json.dumps(derivation(limit.make)))
        return
    table = {
        limit.name: in_process(limit)
        for limit in LIMITS
        if given.only is None or limit.name in given.only
    }
    whole = {
        "times": table, "growth": growth(table), "operations": costs(), "ratios": ratios()
    }  # fmt: skip
    if given.json:
        text = json.dumps(whole, indent=2)
        if given.json == "-":
            print(text)
            return
        with open(given.json, "w", encoding="utf-8") as out:
            out.write(text + "\n")
    print(times(table))
    if whole["growth"] is not None:
        print(f"\nGrowth from 10 to 50 bodies: n^{whole['growth']:.2f}")
    print("\n" + counts(whole["operations"]))
    print("\n" + factors(whole["ratios"]))


if __name__ == "__main__":
    main()
