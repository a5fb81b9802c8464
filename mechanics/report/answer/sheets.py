"""What several statements share is told once: an equation of matrices, and how it was read.

1 row 1, 1 row 2, 1 row 3 of one source    ->    the source, and three verdicts
"""

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

from mechanics.report.answer.judged import Judged

ROW = re.compile(r"(?P<whole>.*) (?P<row>row \d+)")


def sheets(judged: Iterable[Judged]) -> list[list[Judged]]:
    """Statements in their order, those together that are rows of one equation."""
    found: list[list[Judged]] = []
    for entry in judged:
        if found and _whole(entry) is not None and _whole(entry) == _whole(found[-1][-1]):
            found[-1].append(entry)
        else:
            found.append([entry])
    return found


def names_of(entry: Judged) -> tuple[str, str]:
    """The name of a statement as a whole, and of its row: ``("1", "row 2")``."""
    parts = ROW.fullmatch(entry.statement.tag)
    return (parts["whole"], parts["row"]) if parts else (entry.statement.tag, "")


def _whole(entry: Judged) -> tuple[str, str, str] | None:
    """What rows of one equation have in common; None for what is no row."""
    whole, row = names_of(entry)
    return (whole, entry.statement.source, entry.statement.place) if row else None


def shared_notes(judged: Sequence[Judged]) -> tuple[tuple[Judged, ...], tuple[str, ...]]:
    """Statements without the notes that stand with several of them, and those notes."""
    counts = Counter(note for entry in judged for note in dict.fromkeys(entry.statement.notes))
    often = tuple(note for note, count in counts.items() if count > 1)
    return tuple(
        replace(
            entry,
            statement=replace(
                entry.statement, notes=tuple(n for n in entry.statement.notes if n not in often)
            ),
        )
        for entry in judged
    ), often
