"""Faults planted one at a time: does the cross-check notice, without published equations?

    python -m benchmarks.faults --processes 2
    python -m benchmarks.faults --scenes elastic_pendulum arm --only "gravity pushes up"
    python -m benchmarks.faults --only joints.roll joints.rope
    python -m benchmarks.faults --scenes shipped --budget 100

Each fault is one change in the text of one function, made in a process of its own, and planted in
the scenes that call the function: every shipped system, where trials take no more than a budget
(see `benchmarks.faults.plan`), and scenes made for faults. It counts for a scene if it changes a
number there: accelerations, multipliers and reactions of a route, the potential energy, matrices
about an operating point, or the verdict on a statement that is known to be true or false. It is
noticed if something is no longer shown, or is refused. Prints Markdown.
"""

import argparse
import json
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict

from benchmarks.faults.fault import Fault
from benchmarks.faults.plan import Plan, plans
from benchmarks.faults.scenes import GROUPS, SCENES
from benchmarks.faults.summary import Trial, scenes_table, summary
from benchmarks.faults.table import FAULTS
from benchmarks.workers import add_options, team
from mechanics.cluster import Team, spread

PART = 40
"""Faults that a process takes at a time."""
BUDGET = 500
"""Millions of calls of Python functions for all trials in one shipped system."""


Asked = Sequence[tuple[Fault | None, Sequence[str]]]
"""Faults with the scenes in which they are planted."""


def answers(asked: Asked, clean: dict | None) -> list[dict[str, dict]]:
    """What a process says about each fault and scene."""
    request = [(fault and asdict(fault), scenes) for fault, scenes in asked]
    ran = subprocess.run(
        [sys.executable, "-m", "benchmarks.faults.trial"],
        input=json.dumps({"asked": request, "clean": clean}),
        stdout=subprocess.PIPE, text=True, check=True,
    )  # fmt: skip
    said = {
        (line["fault"], line["scene"]): line for line in map(json.loads, ran.stdout.splitlines())
    }
    # What ends early has answered nothing that somebody could take for right.
    missing = {"changed": True, "noticed": "no end"}
    return [
        {name: said.get((fault.what if fault else "", name), missing) for name in scenes}
        for fault, scenes in asked
    ]


def tried(asked: Asked, clean: dict) -> list[Trial]:
    """Plant some faults, one after the other."""
    return [
        _trial(fault, found)
        for (fault, _), found in zip(asked, answers(asked, clean), strict=True)
        if fault is not None
    ]


def _trial(fault: Fault, found: dict[str, dict]) -> Trial:
    changed = [name for name, entry in found.items() if entry["changed"]]
    noticed = tuple(name for name in changed if found[name]["noticed"])
    return Trial(
        fault,
        noticed,
        tuple(name for name in changed if name not in noticed),
        tuple(name for name in found if name not in changed),
        found[noticed[0]]["noticed"] if noticed else "",
    )


def clean_runs(scenes: Sequence[str], workers: Team | None = None) -> dict[str, dict]:
    """Of each scene without a fault: its numbers, the functions that it calls, and how often."""
    many = workers.size() if workers else 1
    shares = [[(None, scenes[i::many])] for i in range(min(many, len(scenes)))]
    runs = spread(workers, answers, shares, None)
    found = {name: entry for (run,) in runs for name, entry in run.items()}
    silent = [name for name in scenes if "numbers" not in found[name]]
    if silent:
        raise SystemExit(
            f"{', '.join(silent)}: no numbers without a fault; the reason stands above"
        )
    return {name: found[name] for name in scenes}


def campaign(
    faults: Sequence[Fault],
    clean: dict[str, dict],
    made: Sequence[Plan],
    workers: Team | None = None,
) -> Iterator[Trial]:
    """Plant each of the faults, in order, in the scenes of the plan."""
    numbers = {name: entry["numbers"] for name, entry in clean.items()}
    asked = [(fault, [p.scene for p in made if fault in p.planted]) for fault in faults]
    parts = [asked[i : i + PART] for i in range(0, len(asked), PART)]
    for found in spread(workers, tried, parts, numbers):
        yield from found


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_options(parser)
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=[*GROUPS, *SCENES],
                        metavar="SCENE", help=f"of {', '.join([*GROUPS, *SCENES])}")  # fmt: skip
    parser.add_argument(
        "--only", nargs="+", default=(), help="faults by a part of their module or words"
    )
    parser.add_argument(
        "--budget", type=int, default=BUDGET, metavar="MILLIONS",
        help="calls that the trials in one shipped system may take (default: %(default)s)",
    )  # fmt: skip
    options = parser.parse_args()
    faults = [
        fault for fault in FAULTS
        if not options.only
        or any(part in f"{fault.module}: {fault.what}" for part in options.only)
    ]  # fmt: skip
    scenes = [name for each in options.scenes for name in GROUPS.get(each, (each,))]
    with team(options) as some:
        clean = clean_runs(scenes, some)
        made = plans(faults, clean, options.budget * 10**6)
        trials = [*campaign(faults, clean, made, some)]
    print(summary(trials, made), scenes_table(trials, made), sep="\n\n")


if __name__ == "__main__":
    main()
