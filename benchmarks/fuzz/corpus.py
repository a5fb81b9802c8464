"""The corpus: documents that reach some part of the readers, one a line, with what they are for.

    tests/claims/corpus/latex.jsonl        {"why": "...", "input": "..."}

Bytes that are no UTF-8 stand as lone surrogates, so that any bytes can be kept, and read.
"""

import json
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "tests" / "claims" / "corpus"
NOTATIONS = ("latex", "text", "c")


@dataclass(frozen=True)
class Entry:
    """A document, and why it is kept."""

    why: str
    data: bytes


def load(notation: str, folder: Path = FOLDER) -> list[Entry]:
    """Every document of a notation."""
    lines = (folder / f"{notation}.jsonl").read_text(encoding="utf-8").splitlines()
    return [_entry(json.loads(line)) for line in lines]


def _entry(found: dict[str, str]) -> Entry:
    return Entry(found["why"], found["input"].encode("utf-8", "surrogateescape"))


def add(notation: str, entries: list[Entry], folder: Path = FOLDER) -> int:
    """Append documents that are not there yet; how many they were."""
    known = {entry.data for entry in load(notation, folder)}
    new = [e for e in {e.data: e for e in entries}.values() if e.data not in known]
    with (folder / f"{notation}.jsonl").open("a", encoding="utf-8") as file:
        for entry in new:
            line = {"why": entry.why, "input": entry.data.decode("utf-8", "surrogateescape")}
            file.write(json.dumps(line, ensure_ascii=True) + "\n")
    return len(new)
