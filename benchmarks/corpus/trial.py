"""A case, judged: its verdict, whether the mistake is named, and the time it took."""

import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from random import Random
from time import process_time
from typing import Any

from sympy import N
from sympy.matrices import MatrixBase

from benchmarks.corpus.load import SUFFIXES, Case, cases, scene_of, sealed
from mechanics import check
from mechanics.blame.result import Edit, Mistake
from mechanics.errors import MechanicsError
from mechanics.grading.submission import things_in
from mechanics.report.answer.check import Check

CLOSE = 1e-9
"""Relative, of values at a state."""

Rows = Mapping[str, Sequence[Any]]
"""Sides by the tag of their statement."""

SIGNS = re.compile(r"^[-+]")
NAMES = re.compile(r"[^\W\d]\w*|[\d.]+|\*\*|[^\s()\[\]{}]")
LETTERS = re.compile(r"\\[a-zA-Z]+|[\d.]+|[^\s()\[\]{}]")
"""Tokens of code, and of formulas, in which each letter is a name. Brackets are none: a notation
asks for them."""
SPACING = re.compile(r"\\[,;! ]|\\left|\\right|\\cdot")
SPACES = re.compile(r"\\[,;! ]|\\left|\\right|[\s{}*]|\\cdot")


@dataclass(frozen=True)
class Trial:
    """What became of a case.

    Attributes
    ----------
    verdict : str
        Of the whole answer; ``"not read"`` where an error was raised, ``"crashed"`` where that was
        none of ours.
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


def tried(case: Case, *, with_options: bool = False, blame: bool = True) -> Trial:
    """Judge a case as a file that somebody hands in; without blame no mistake is named."""
    scene_of(case.scene, case.function)
    start = process_time()
    try:
        options = case.options if with_options else {}
        found = _checked(case, case.text, blame=blame, **options)
    except MechanicsError as error:
        return Trial(case, "not read", str(error), 0, process_time() - start)
    except Exception as error:  # a defect of ours: it counts, and the other cases are still tried
        return Trial(case, "crashed", repr(error), 0, process_time() - start)
    seconds = process_time() - start
    words = "; ".join(_words(found))
    named = _place(case, found, _mended_rows(case)) if blame else 0
    return Trial(case, found.verdict.name, words, named, seconds)


def tried_all(names: Sequence[str], closed: bool) -> tuple[list[Trial], list[Trial]]:
    """Cases by name, without options, and again with those that they have."""
    trials, again = [], []
    for case in sealed() if closed else cases():
        if case.name in names:
            trials.append(tried(case))
            again += [tried(case, with_options=True)] if case.options else []
    return trials, again


def _checked(case: Case, text: str, **options: Any) -> Check:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"statement{SUFFIXES[case.input]}"
        path.write_text(text, encoding="utf-8")
        things = things_in(path, run_python=True)
        return check(scene_of(case.scene, case.function), things, **options)


def _words(found: Check) -> list[str]:
    return [
        f"{e.verdict.name}: {e.statement.doubt or e.finding.evidence}"
        + "".join(f" (right if {words})" for words in e.right_if)
        for e in found.judged
        if not (e.finding.shown and not e.open)
    ]


def _place(case: Case, found: Check, mended: Rows) -> int:
    """Where among the repairs of a statement the true mistake is named.

    An edit names it where it stands at the mistake, or puts there what it has to be; and where it
    is no larger, and makes of the statement what the true change makes of it, in whatever words.
    To exchange two outputs is one change, however large they are.
    """
    places = [0]
    for entry in found.told if not case.right else ():
        if entry.of_dimension:
            places.append(1)
        source, tag = entry.statement.source, entry.statement.tag
        for place, repair in enumerate(entry.blame.repairs if entry.blame else (), start=1):
            same = repair.row is not None and _same(repair.row.sides, mended.get(tag))
            small = same and sum(
                _size(case, e.written, e.right)
                for e in repair.edits
                if e.mistake is not Mistake.ORDER
            ) <= 2 + _size(case, case.written, case.mended)
            if small or any(_names(case, source, edit) for edit in repair.edits):
                places.append(place)
                break
    return min((place for place in places if place), default=0)


def _names(case: Case, source: str, edit: Edit) -> bool:
    written, mended = plain(case.written), plain(case.mended)
    one, other = plain(edit.written), plain(edit.right)
    if one and one in written and (other in mended or _bare(other) in mended):
        return True
    if mended and not written:
        return SIGNS.sub("", other) in mended and bool(other)
    if edit.span is not None and written in plain(source):
        before, inside = plain(source[: edit.span[0]]), plain(source[: edit.span[1]])
        return _meets(plain(source), written, len(before), len(inside))
    if edit.definition and one in plain(case.text):
        at = plain(case.text).find(one)
        return bool(written) and _meets(plain(case.text), written, at, at + len(one))
    return bool(written) and (written in one or mended in other) and len(one) < 2 * len(written) + 9


def _meets(text: str, part: str, start: int, end: int) -> bool:
    """Whether a part of a text stands in a span, or beside it: a sign stands before its term."""
    places = [m.start() for m in re.finditer(f"(?={re.escape(part)})", text)]
    return any(start <= at + len(part) and at <= end for at in places)


def _mended_rows(case: Case) -> Rows:
    """What would be said without the mistake, by the tags of the statements."""
    if case.right:
        return {}
    text = case.text
    parts = [(case.written, case.mended)]
    if case.written not in text:  # mistakes in several lines
        parts = list(zip(case.written.split("\n"), case.mended.split("\n"), strict=True))
    for written, mended in parts:
        text = text.replace(written, mended, 1)
    try:
        found = _checked(case, text, blame=False)
    except MechanicsError:
        return {}  # nothing to compare with: an edit has to stand at the mistake
    return {e.statement.tag: e.statement.row.sides for e in found.judged if e.statement.row}


def _same(sides: Sequence[Any], others: Sequence[Any] | None) -> bool:
    """Whether sides have the same values at some state."""
    if others is None or len(sides) != len(others):
        return False
    source = Random(0)
    pairs = [
        pair
        for a, b in zip(sides, others, strict=True)
        for pair in zip(_entries(a), _entries(b), strict=True)
    ]
    symbols = sorted(set().union(*(e.free_symbols for pair in pairs for e in pair)), key=str)
    state = {symbol: source.uniform(0.5, 1) for symbol in symbols}
    values = [(N(a.subs(state)), N(b.subs(state))) for a, b in pairs]
    if all(abs(b) < CLOSE for _, b in values):
        return False  # what is zero without the mistake says nothing of the edit
    return all(abs(a - b) < CLOSE * (1 + abs(a)) for a, b in values)


def _entries(side: Any) -> list[Any]:
    return list(side) if isinstance(side, MatrixBase) else [side]


def _size(case: Case, one: str, other: str) -> int:
    """How many tokens a change exchanges, without what both begin and end with.

    A name counts as one, however long: traced code has another for what a person calls y(4).
    """
    tokens = LETTERS if case.input in ("latex", "text") else NAMES
    left, right = (tokens.findall(SPACING.sub(" ", text)) for text in (one, other))
    start = _alike(left, right)
    left, right = left[start:], right[start:]
    return max(len(left), len(right)) - _alike(left[::-1], right[::-1])


def _bare(text: str) -> str:
    """A text without the brackets around all of it."""
    return text[1:-1] if text[:1] == "(" and text.find(")") == len(text) - 1 else text


def _alike(one: Sequence[str], other: Sequence[str]) -> int:
    """With how many equal tokens two texts begin."""
    pairs = takewhile(lambda pair: pair[0] == pair[1], zip(one, other, strict=False))
    return sum(1 for _ in pairs)


def plain(text: str) -> str:
    """A text without what only spaces it."""
    return SPACES.sub("", text)
