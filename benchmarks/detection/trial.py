"""A case, judged: the verdict, its time, and whether the blame undoes the mistake."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from time import process_time
from typing import Any

import mechanics
from benchmarks.detection.case import Case, case
from benchmarks.detection.undone import Undone, undone
from mechanics.errors import MechanicsError
from mechanics.judge.check import Check, Judged

TEXTS = ("LaTeX", "MATLAB text", "SymPy text")
"""Forms that a repair is told in."""


@dataclass(frozen=True)
class Result:
    """What became of a case.

    Attributes
    ----------
    kinds, made : tuple of str
        Of mistakes, and what each changed.
    verdict : str
        Of the finding; ``"error"`` where the check ended in one.
    words : str
        Its evidence, doubt or message.
    seconds : float
        Of one core for each statement that was read, without the blame.
    text : str
        The statement as it was given.
    equivalent : tuple of bool
        For mutants that were drawn before and are right: whether the normal form proves it.
    undone : Undone or None
        What the blame says, where it was asked for.
    """

    name: str
    system: str
    row: str
    about: str
    form: str
    kinds: tuple[str, ...]
    made: tuple[str, ...]
    verdict: str
    words: str
    right_if: tuple[str, ...]
    seconds: float
    text: str
    equivalent: tuple[bool, ...] = ()
    undone: Undone | None = None

    @property
    def wrong(self) -> bool:
        """Whether it is a mutant."""
        return self.name.startswith("m")


def judged(
    name: str, seed: int, systems: Sequence[str], blame: bool = False, errors: int | None = None
) -> Result:
    """Draw a case, and check it."""
    drawn = case(name, seed, systems, errors)
    verdict, words = "error", ""
    right_if: tuple[str, ...] = ()
    count, start = 1, process_time()
    try:
        found = _checked(drawn, blame=False)
        count = len(found.judged)
        entry = found.judged[drawn.written.place]
        verdict, right_if = entry.finding.verdict.name, entry.right_if
        words = entry.statement.doubt or entry.finding.evidence
        verdict, words = _others(drawn, found, verdict, words)
    except MechanicsError as error:
        words = f"{type(error).__name__}: {error}"
    seconds = (process_time() - start) / count
    told = None
    if blame and verdict == "REFUTED":
        told = _blamed(drawn, seconds * count)
    made = tuple(mutation.words for mutation in drawn.mutations)
    return Result(
        name, drawn.about.system.name, drawn.row.name, drawn.row.about, drawn.form, drawn.kinds,
        made, verdict, words, right_if, seconds, drawn.written.text, drawn.equivalent, told,
    )  # fmt: skip


def _others(drawn: Case, found: Check, verdict: str, words: str) -> tuple[str, str]:
    """A function has other outputs, which are right: one that is not shown counts as the worst."""
    for i, entry in enumerate(found.judged):
        if i != drawn.written.place and not entry.finding.shown:
            other = entry.finding.verdict.name
            return f"{other} beside", f"{entry.statement.tag}: {entry.finding.evidence}"
    return verdict, words


def _checked(drawn: Case, blame: bool) -> Check:
    options: dict[str, Any] = drawn.written.options
    return mechanics.check(drawn.about.reference, drawn.written.thing, blame=blame, **options)


def _blamed(drawn: Case, without: float) -> Undone:
    start = process_time()
    found = _checked(drawn, blame=True)
    spent = max(process_time() - start - without, 0.0)
    entry: Judged = found.judged[drawn.written.place]
    return replace(undone(drawn, entry, spent), again=_again(drawn, found))


def _again(drawn: Case, found: Check) -> str:
    """The verdict of what the first repair tells, typed as it is told."""
    blame = found.judged[0].blame
    if drawn.form not in TEXTS or len(found.judged) > 1 or blame is None or not blame.repairs:
        return ""
    first = blame.repairs[0]
    if any(edit.definition for edit in first.edits):
        return ""
    options: dict[str, Any] = drawn.written.options
    try:
        again = mechanics.check(drawn.about.free_body, first.repaired, blame=False, **options)
    except MechanicsError as error:
        return f"{type(error).__name__}: {error}"
    return " ".join(entry.finding.verdict.name for entry in again.judged)
