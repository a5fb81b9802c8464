"""What several statements share is told once: an equation of matrices, how it was read, a reason.

1 row 1, 1 row 2, 1 row 3 of one source    ->    the source, and three verdicts
"""

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from mechanics.kernel import Verdict
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.meaning import meaning

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


@dataclass(frozen=True)
class Reason:
    """Why several statements are UNDECIDED.

    Attributes
    ----------
    tags : tuple of str
        Of these statements.
    words : str
    """

    tags: tuple[str, ...]
    words: str


def shared_reasons(judged: Sequence[Judged]) -> tuple[tuple[Judged, ...], tuple[Reason, ...]]:
    """Statements without the reason that several of them are UNDECIDED for, and those reasons."""
    tags: dict[str, list[str]] = {}
    for entry in judged:
        if entry.finding.verdict is Verdict.UNDECIDED and entry.finding.evidence:
            tags.setdefault(entry.finding.evidence, []).append(entry.statement.tag)
    often = {evidence for evidence, some in tags.items() if len(some) > 1}
    told = tuple(
        replace(entry, finding=replace(entry.finding, evidence=""))
        if entry.finding.verdict is Verdict.UNDECIDED and entry.finding.evidence in often
        else entry
        for entry in judged
    )
    first = {entry.finding.evidence: meaning(entry.finding)[0] for entry in reversed(judged)}
    return told, tuple(Reason(tuple(tags[one]), first[one]) for one in tags if one in often)
