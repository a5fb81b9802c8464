"""How long mechanisms in space take, how that grows, and what compiled outputs cost.

    python -m benchmarks.space
    python -m benchmarks.space --only "arm of 7" --json -

Four routes are derived as programs and all pairs decided, each scene in a process of its own;
processor times in seconds, imports aside. Growth is the exponent from 10 to 50 bodies of a tree,
and from 10 to 40 loops. What does not keep its limit is listed.
Operations are counted after sharing, those that depend on parameters only apart. Prints Markdown.
"""

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
    return _exponent(table, SMALL, LARGE, 5)


def loop_growth(table: dict[str, dict]) -> float | None:
    """Exponent of the time from 10 to 40 loops."""
    return _exponent(table, "10 four-bars", "40 four-bars", 4)


def _exponent(table: dict[str, dict], small: str, large: str, factor: int) -> float | None:
    if small not in table or large not in table:
        return None
    return math.log(seconds(table[large]) / seconds(table[small])) / math.log(factor)


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


def missed(table: dict[str, dict]) -> str:
    """Limits of time and memory that were not kept."""
    limits = {limit.name: limit for limit in LIMITS}
    found = []
    for name, row in table.items():
        limit = limits[name]
        if limit.seconds is not None and seconds(row) > limit.seconds:
            most = max(("lower", "derive", "decide"), key=row.__getitem__)
            found.append(f"{name}: {seconds(row):.2f} s of {limit.seconds} s, most of it to {most}")
        if limit.megabytes is not None and row["megabytes"] > limit.megabytes:
            found.append(f"{name}: {row['megabytes']} MB of {limit.megabytes} MB")
        open_pairs = [pair for pair, verdict in row["verdicts"].items()
                      if verdict not in ("PROVED", "CERTIFIED")]  # fmt: skip
        found += [f"{name}: {pair} is {row['verdicts'][pair]}" for pair in open_pairs]
    return (
        "Not reached:\n" + "\n".join(f"- {line}" for line in found)
        if found
        else ("All limits of time and memory are kept, and all pairs are shown.")
    )


def constrained_rows(rows: list[dict]) -> str:
    lines = ["| loops and rolling: forward dynamics with multipliers | operations | goal |",
             "|---|---|---|"]  # fmt: skip
    lines += [f"| {row['scene']} | {row['operations']} | {row['goal'] or '-'} |" for row in rows]
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
    # Compilers are imported here, so that the processes of scenes do not hold them.
    from benchmarks.space.constrained import constrained

    table = {
        limit.name: in_process(limit)
        for limit in LIMITS
        if given.only is None or limit.name in given.only
    }
    whole = {
        "times": table, "growth": growth(table), "loops": loop_growth(table),
        "operations": costs(), "constrained": constrained(), "ratios": ratios()
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
    if whole["loops"] is not None:
        print(f"\nGrowth from 10 to 40 loops: n^{whole['loops']:.2f}")
    print("\n" + missed(table))
    print("\n" + counts(whole["operations"]))
    print("\n" + constrained_rows(whole["constrained"]))
    print("\n" + factors(whole["ratios"]))


if __name__ == "__main__":
    main()
