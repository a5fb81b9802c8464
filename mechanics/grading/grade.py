"""The grade of a submission, from what became of its statements.

score = statements that are right / (all statements + equations of motion that are missing)

What follows from others, as twice an equation, or a quantity that is given again, counts once.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from mechanics.blame.reference import Reference
from mechanics.errors import InputError
from mechanics.judge.check import check
from mechanics.judge.complete import determined, independent
from mechanics.judge.sources import COMPUTED
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.page import check_html
from mechanics.scene.quantities import EquationOfMotion, Identity

REQUIRE: dict[str, str] = {
    "all": "all that is written is right, and it determines the motion",
    "motion": "what is right determines the motion",
    "right": "all that is written is right",
}
"""What a submission has to be."""

RIGHT, WRONG, INCOMPLETE, DOUBT, UNJUDGED = (
    "right", "wrong", "incomplete", "in doubt", "not judged",
)  # fmt: skip


NO_CHANGE = "its sides differ, and no small change makes it right"


@dataclass(frozen=True)
class Line:
    """One statement of a submission.

    Attributes
    ----------
    tag, source, place : str
        As in `mechanics.check`.
    verdict : str
        Name of a `Verdict`.
    change : str
        The smallest change that makes it right; empty where there is none or it is right.
    mistake : str
        What kind of mistake that undoes: ``"the sign is reversed"``.
    hint : str
        Where to look, without the answer.
    accepted : tuple of str
        How it was read.
    """

    tag: str
    source: str
    place: str
    verdict: str
    change: str = ""
    mistake: str = ""
    hint: str = ""
    accepted: tuple[str, ...] = ()


@dataclass(frozen=True)
class Grade:
    """What became of a submission.

    Attributes
    ----------
    name : str
    verdict : str
        ``"right"``, ``"wrong"``, ``"incomplete"``, ``"in doubt"`` or ``"not judged"``.
    score : float or None
        From 0 to 1; None for what is not judged.
    lines : tuple of Line
    missing : str
        What the motion needs besides; empty where nothing is missing.
    remarks : tuple of str
    page : str
        The answer as HTML, where it was asked for.
    unjudged : tuple of str
        Sentences that were compared with nothing.
    """

    name: str
    verdict: str
    score: float | None
    lines: tuple[Line, ...] = ()
    missing: str = ""
    remarks: tuple[str, ...] = ()
    page: str = ""
    unjudged: tuple[str, ...] = ()

    @property
    def change(self) -> str:
        """The first smallest change."""
        return next((line.change for line in self.lines if line.change), "")

    @property
    def hint(self) -> str:
        """The first hint, or what is missing or not judged."""
        hints = (line.hint for line in self.lines if line.hint)
        missing = self.missing and f"something is missing: {self.missing}"
        numbers = next((words for words in self.unjudged if words.endswith(COMPUTED)), "")
        return next(hints, missing or (numbers and f"not judged: {numbers}"))

    def to_json(self) -> dict[str, Any]:
        """As plain data, without the page."""
        found = asdict(self)
        del found["page"]
        return {**found, "change": self.change, "hint": self.hint}


def grade(
    reference: Reference, name: str, things: Sequence[Any], *, require: str = "all",
    page: bool = False, options: Mapping[str, Any] | None = None,
) -> Grade:  # fmt: skip
    """The grade of one submission.

    Parameters
    ----------
    reference : Reference
        The key.
    things : sequence
        As for `mechanics.check`.
    require : str
        One of `REQUIRE`.
    page : bool
        Whether the answer is written as a page, too.
    options : mapping, optional
        For `mechanics.check`.

    Raises
    ------
    InputError
        When nothing can be read.
    """
    found = check(reference, list(things), **(options or {}))
    lines = tuple(_line(entry) for entry in found.told)
    if not lines:
        raise InputError(f"there is nothing to check: {'; '.join(found.remarks)}")
    _, rank, freedoms = determined(reference.truth, found.judged)
    lacking = 0 if require == "right" else max(0, freedoms - rank)
    missing = max(0, lacking - sum(map(_tried, found.judged)))
    shown = _said(reference, found.judged)
    others = sum(not entry.finding.shown for entry in found.judged)
    return Grade(
        name,
        _verdict(found, require, lacking),
        shown / max(1, shown + others + missing),
        lines,
        f"{missing} of {freedoms} independent equations of motion" if missing else "",
        found.remarks,
        check_html(found) if page else "",
        found.unjudged,
    )


def _said(reference: Reference, judged: Sequence[Judged]) -> int:
    """How many statements that are right say something new."""
    new = independent(reference.truth, judged)
    rows = [e.statement.row for e in judged if e.finding.shown]
    others = [row for row in rows if row is None or not isinstance(row.quantity, EquationOfMotion)]
    again = [row.quantity for row in others if row and not isinstance(row.quantity, Identity)]
    return new + len(others) - len(again) + len(dict.fromkeys(map(repr, again)))


def _tried(entry: Judged) -> bool:
    """Whether it is an equation of motion that is not right: it is not missing, too."""
    row = entry.statement.row
    moves = row is not None and isinstance(row.quantity, EquationOfMotion)
    return moves and not entry.finding.shown


def _verdict(found: Check, require: str, lacking: int) -> str:
    if require == "motion" and not lacking:
        return RIGHT
    if found.verdict is Verdict.REFUTED:
        return WRONG
    if not found.ok or found.beside:
        return DOUBT
    return INCOMPLETE if lacking else RIGHT


def _line(entry: Judged) -> Line:
    statement, blame = entry.statement, entry.blame
    accepted = (*statement.notes, *(f"right if {words}" for words in entry.right_if))
    repair = blame.repairs[0] if blame is not None and blame.repairs else None
    edits = repair.edits if repair is not None else ()
    change = "; ".join(_change(e.written, e.right, e.definition) for e in edits)
    mistake = "; ".join(dict.fromkeys(e.mistake.value for e in edits))
    wrong = entry.verdict is Verdict.REFUTED
    why = blame.explanations[0] if blame is not None and blame.explanations else mistake
    unmended = NO_CHANGE if entry.finding.witness is not None else entry.finding.evidence
    hint = f"{statement.tag}: {why or unmended}" if wrong else ""
    if statement.unsure and entry.open:
        hint = f"{statement.tag}: right if {statement.unsure[0]}"
    return Line(
        statement.tag, statement.source, statement.place, entry.verdict.name, change,
        mistake or (why if wrong else ""), hint or statement.doubt, accepted,
    )  # fmt: skip


def _change(written: str, right: str, definition: str) -> str:
    where = f" in {definition}" if definition else ""
    if not written:
        return f"add {right}{where}"
    if not right:
        return f"leave out {written}{where}"
    return f"write {right} for {written}{where}"
