"""One notation under Atheris: ``python -m benchmarks.fuzz.target latex FOLDER``, with options of
libFuzzer behind it. Started by ``python -m benchmarks.fuzz``, which reads what it leaves in FOLDER:

    now            the input at hand, should the process end in it
    state.json     executions, verdicts by kind
    found.jsonl    inputs that break the law
"""

import faulthandler
import json
import random
import sys
from collections import Counter
from pathlib import Path
from typing import Any
from zlib import crc32

import atheris  # type: ignore[import-not-found,import-untyped,unused-ignore]

PARTS = ("mechanics.claims", "mechanics.program.c", "mechanics.crosscheck", "mechanics.checks",
         "mechanics.blame", "pycparser")  # fmt: skip

with atheris.instrument_imports(include=list(PARTS), enable_loader_override=False):
    from benchmarks.fuzz import corpus, law
    from benchmarks.fuzz.mutate import mutated
    from mechanics.judge.check import derived
    from systems import elastic_pendulum

HANG = 60
"""Seconds until an input counts as one that hangs; the process ends then."""

BLAMED = 8
"""One wrong input of so many is blamed, too: it takes as long as all the others together."""


class Target:
    """Runs inputs and keeps what they do."""

    def __init__(self, notation: str, folder: Path) -> None:
        self.notation, self.folder = notation, folder
        self.truth = derived(elastic_pendulum.scene())
        self.seeds = [entry.data for entry in corpus.load(notation)]
        self.kinds: Counter[str] = Counter()
        self.known: set[str] = set()

    def run(self, data: bytes) -> None:
        """One execution."""
        (self.folder / "now").write_bytes(data)
        faulthandler.dump_traceback_later(HANG, exit=True)
        found = law.outcome(self.truth, self.notation, data, blame=crc32(data) % BLAMED == 0)
        faulthandler.cancel_dump_traceback_later()
        self.kinds[found.kind] += 1
        words = found.broken or law.over(found)
        if words:
            self.keep(words, data)
        if sum(self.kinds.values()) % 50 == 0:
            (self.folder / "state.json").write_text(json.dumps(self.kinds), encoding="utf-8")

    def keep(self, words: str, data: bytes) -> None:
        """Keep an input that breaks the law, once for every way in which it does."""
        sort = "".join(c for c in words if not c.isdigit())
        if sort not in self.known:
            self.known.add(sort)
            line = {"why": words, "input": data.decode("utf-8", "surrogateescape")}
            with (self.folder / "found.jsonl").open("a", encoding="utf-8") as file:
                file.write(json.dumps(line) + "\n")

    def mutate(self, data: bytes, largest: int, seed: int) -> bytes:
        """Mostly whole words, sometimes bytes."""
        source = random.Random(seed)
        if source.random() < 0.1:
            return bytes(atheris.Mutate(data, largest))
        return mutated(data, self.notation, source, self.seeds)[:largest]


def main() -> None:
    """Run until libFuzzer's own limits end it."""
    notation, folder, *options = sys.argv[1:]
    target = Target(notation, Path(folder))
    arguments: list[Any] = [sys.argv[0], *options]
    atheris.Setup(arguments, target.run, custom_mutator=target.mutate)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
