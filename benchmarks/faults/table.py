"""All faults, from the texts in `rows`: ``@ module``, then what, ``- old`` and ``+ new`` of each.

A row whose text has changed fails in `tests/benchmarks/test_benchmark_faults.py`.
"""

import re
from collections.abc import Iterator
from pathlib import Path

from benchmarks.faults.fault import Fault

ROW = re.compile(r"^(?P<what>[^-+@#\n].*)\n(?P<old>(?:-.*\n)+)(?P<new>(?:\+.*\n)+)", re.MULTILINE)
FILES = ("scene", "motion", "routes", "kernel", "programs", "joints", "rolling", "linear")


def read(text: str) -> Iterator[Fault]:
    """Faults of a text.

    Raises
    ------
    ValueError
        When something in it is neither a heading nor a row.
    """
    for part in text.split("\n@ ")[1:]:
        module, _, rows = part.partition("\n")
        if rest := ROW.sub("", rows).strip():
            raise ValueError(f"{module}: {rest.splitlines()[0]!r} is no row of what, - old, + new")
        for row in ROW.finditer(rows):
            yield Fault(module, _piece(row["old"]), _piece(row["new"]), row["what"])


def _piece(lines: str) -> str:
    return "\n".join(line[2:] for line in lines.splitlines())


FAULTS: tuple[Fault, ...] = tuple(
    fault
    for name in FILES
    for fault in read((Path(__file__).parent / "rows" / f"{name}.txt").read_text("utf-8"))
)
