"""A case, judged: its verdict, whether the mistake is named, and the time it took."""

import re
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import process_time

from benchmarks.corpus.load import SUFFIXES, Case, scene_of
from mechanics import check
from mechanics.blame.result import Edit
from mechanics.errors import MechanicsError
from mechanics.grading.submission import things_in
from mechanics.report.answer.check import Check

SIGNS = re.compile(r"^[-+]")
SPACES = re.compile(r"\\[,;! ]|\\left|\\right|[\s{}*]|\\cdot")


@dataclass(frozen=True)
class Trial:
    """What became of a case.

    Attributes
    ----------
    case : Case
    verdict : str
        Of the whole answer; ``"not read"`` where an error was raised.
    words : str
    named : int
        At which place the true mistake is named, from 1; 0 for nowhere.
    seconds : float
        Of processor time, the derivation included.
    """

    case: Case
    verdict: str
    words: str
    named: int
    seconds: float


def tried(case: Case, *, with_options: bool = False) -> Trial:
    """Judge a case as a file that somebody hands in."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"statement{SUFFIXES[case.input]}"
        path.write_text(case.text, encoding="utf-8")
        scene = scene_of(case.scene, case.function)
        start = process_time()
        try:
            things = things_in(path, run_python=True)
            found = check(scene, things, **(case.options if with_options else {}))
        except MechanicsError as error:
            return Trial(case, "not read", str(error), 0, process_time() - start)
        seconds = process_time() - start
    words = "; ".join(_words(found))
    return Trial(case, found.verdict.name, words, _place(case, found), seconds)


def _words(found: Check) -> list[str]:
    return [
        f"{e.verdict.name}: {e.statement.doubt or e.finding.evidence}"
        + "".join(f" (right if {words})" for words in e.right_if)
        for e in found.judged
        if not (e.finding.shown and not e.open)
    ]


def _place(case: Case, found: Check) -> int:
    """Where among the repairs of a statement the true mistake is named.

    An edit names it where it stands at the mistake, or puts there what it has to be.
    """
    places = [0]
    for entry in found.told if not case.right else ():
        if entry.of_dimension:
            places.append(1)
        for place, repair in enumerate(entry.blame.repairs if entry.blame else (), start=1):
            if any(_names(case, entry.statement.source, edit) for edit in repair.edits):
                places.append(place)
                break
    return min((place for place in places if place), default=0)


def _names(case: Case, source: str, edit: Edit) -> bool:
    written, mended = plain(case.written), plain(case.mended)
    one, other = plain(edit.written), plain(edit.right)
    if one and one in written and other in mended:
        return True
    if mended and not written:
        return SIGNS.sub("", other) in mended and bool(other)
    flat = " ".join(source.split())
    at = flat.find(" ".join(case.written.split())) if case.written else -1
    if edit.span is not None and at >= 0:
        return edit.span[0] < at + len(case.written) and at < edit.span[1]
    return bool(written) and (written in one or mended in other) and len(one) < 2 * len(written) + 9


def plain(text: str) -> str:
    """A text without what only spaces it."""
    return SPACES.sub("", text)
