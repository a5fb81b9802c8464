"""Faults planted one at a time: does the cross-check notice, without published equations?

    python -m benchmarks.faults --jobs 2
    python -m benchmarks.faults --scenes elastic_pendulum arm --only "gravity pushes up"
    python -m benchmarks.faults --only joints.roll joints.rope

Each fault is one change in the text of one function, made in a process of its own, and planted in
the scenes that call the function. It counts for a scene if it changes a number there:
accelerations, multipliers and reactions of a route, the potential energy, matrices about an
operating point, or the verdict on a statement that is known to be true or false. It is noticed if
something is no longer shown, or is refused. Prints Markdown.
"""

import argparse
import json
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from functools import partial

from benchmarks.faults.fault import Fault, place_of, planted
from benchmarks.faults.scenes import SCENES
from benchmarks.faults.table import FAULTS

PART = 8
"""Faults that a process takes at a time."""


@dataclass(frozen=True)
class Trial:
    """What one fault did.

    Attributes
    ----------
    fault : Fault
    noticed, unnoticed, harmless : tuple of str
        Scenes, by what became of the fault there; harmless where no number changed.
    by : str
        Who noticed it first.
    """

    fault: Fault
    noticed: tuple[str, ...]
    unnoticed: tuple[str, ...]
    harmless: tuple[str, ...]
    by: str


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
    missing = {"changed": True, "noticed": "no answer"}
    return [
        {name: said.get((fault.what if fault else "", name), missing) for name in scenes}
        for fault, scenes in asked
    ]


def tried(asked: Asked, scenes: Sequence[str], clean: dict) -> list[Trial]:
    """Plant some faults, one after the other."""
    harmless = {name: {"changed": False, "noticed": ""} for name in scenes}
    return [
        _trial(fault, {**harmless, **found})
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


def campaign(faults: Sequence[Fault], scenes: Sequence[str], jobs: int = 1) -> Iterator[Trial]:
    """Plant each of the faults, in order, in the scenes that call what it changes."""
    (found,) = answers([(None, scenes)], None)
    clean = {name: entry["numbers"] for name, entry in found.items()}
    calls = {name: frozenset(entry["calls"]) for name, entry in found.items()}
    asked = []
    for fault in faults:
        place = place_of(planted(fault)[0].__code__)
        asked.append((fault, [name for name in scenes if place in calls[name]]))
    parts = [asked[i : i + PART] for i in range(0, len(asked), PART)]
    with ThreadPoolExecutor(jobs) as pool:
        for part in pool.map(partial(tried, scenes=scenes, clean=clean), parts):
            yield from part


def summary(trials: Sequence[Trial]) -> str:
    """Share noticed, and lists of what was not, in Markdown."""
    at_work = [trial for trial in trials if trial.noticed or trial.unnoticed]
    pairs = sum(len(trial.noticed) + len(trial.unnoticed) for trial in at_work)
    seen = sum(len(trial.noticed) for trial in at_work)
    whole = sum(not trial.unnoticed for trial in at_work)
    lines = [
        f"{len(trials)} faults, of which {len(at_work)} change a number; noticed wherever they do:"
        f" {whole} of {len(at_work)}; by scene: {seen} of {pairs}.",
        "",
        "| first noticed by | faults |",
        "| --- | --- |",
    ]
    makers = Counter(_who(trial.by) for trial in at_work if trial.by)
    lines += [f"| {who} | {count} |" for who, count in makers.most_common()]
    for title, rows in (
        (
            "Unnoticed",
            [f"{t.fault.what}: {', '.join(t.unnoticed)}" for t in at_work if t.unnoticed],
        ),
        ("No number changes", [t.fault.what for t in trials if t not in at_work]),
    ):
        if rows:
            lines += ["", f"{title}:", *(f"- {row}" for row in rows)]
    return "\n".join(lines)


def _who(words: str) -> str:
    """The check without its route, or the exception."""
    for known in ("virtual power", "declared", "Error", "no end"):
        if known in words:
            return {"declared": "powers of the declared loads", "Error": "refused"}.get(
                known, known
            )
    return words.rpartition(":")[0] or words


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time")
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=list(SCENES))
    parser.add_argument(
        "--only", nargs="+", default=(), help="faults by a part of their module or words"
    )
    options = parser.parse_args()
    faults = [
        fault for fault in FAULTS
        if not options.only
        or any(part in f"{fault.module}: {fault.what}" for part in options.only)
    ]  # fmt: skip
    trials = []
    for trial in campaign(faults, options.scenes, options.jobs):
        trials.append(trial)
        state = f"UNNOTICED in {', '.join(trial.unnoticed)}" if trial.unnoticed else trial.by
        print(f"{trial.fault.what}: {state or 'no number changes'}", file=sys.stderr, flush=True)
    print(summary(trials))


if __name__ == "__main__":
    main()
