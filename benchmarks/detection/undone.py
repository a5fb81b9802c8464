"""Whether the first repair that the blame names undoes a mistake.

exactly     every side of the repaired statement equals that of the right one, in normal form
as good     proved, true at states that the checker did not choose, and no larger than the mistake

A sign, number, function, symbol or power is one edit of the smallest size; a term that is missing
or too many is larger; a term that is wrong altogether is larger still. Objects of SymPy and CasADi
simplify what they are made of: there a mistake is as large as what is left of it to be seen.
"""

from dataclasses import dataclass

from sympy import Add, Expr, Mul
from sympy.matrices import MatrixBase

from benchmarks.detection.case import Case
from benchmarks.detection.rows import holds
from benchmarks.detection.tree import read, written
from mechanics.blame.result import Mistake, Repair
from mechanics.judge.check import Judged
from mechanics.scene.published import Published
from mechanics.symbolic import canonical

SIZES = {Mistake.MISSING: 2, Mistake.EXTRA: 2, Mistake.TERM: 3}
"""Of edits; all others have size 1."""
SIMPLIFIED = ("SymPy object", "CasADi function")
MADE = {"dropped term": 2, "off-by-one sum": 2}
"""Sizes of mistakes; all others have size 1."""


@dataclass(frozen=True)
class Undone:
    """What the blame says of a mutant.

    Attributes
    ----------
    how : str
        ``"exactly"``, ``"as good"``, or why not.
    edits : tuple of str
        Of the first repair.
    repairs : int
        How many are shown.
    again : str
        Verdict of the repaired text when it is read again; empty where it is no text.
    """

    how: str
    seconds: float
    edits: tuple[str, ...]
    repairs: int
    again: str = ""

    @property
    def success(self) -> bool:
        """Whether the mistake is undone."""
        return self.how in ("exactly", "as good")


def undone(drawn: Case, entry: Judged, seconds: float) -> Undone:
    """Judge the first repair of a mutant."""
    blame = entry.blame
    if blame is None or not blame.repairs:
        searched = blame.searched if blame else "no blame"
        return Undone(f"no repair: {searched}", seconds, (), 0)
    first = blame.repairs[0]
    edits = tuple(f"{e.mistake.name}: {e.written!r} -> {e.right!r}" for e in first.edits)
    return Undone(_how(drawn, first), seconds, edits, len(blame.repairs))


def _how(drawn: Case, repair: Repair) -> str:
    row: Published | None = repair.row
    if row is None:
        return "the repair has no row"
    if not repair.finding.shown:
        return f"the repair is {repair.finding.verdict.name}"
    sides = [entry for side in row.sides for entry in _entries(side)]
    if _same(drawn, sides):
        return "exactly"
    if not _true(drawn, sides):
        return "the repair is shown, but wrong at independent states"
    if len(repair.edits) > len(drawn.kinds):
        return f"{len(repair.edits)} edits for {len(drawn.kinds)} mistakes"
    sizes = sorted((SIZES.get(edit.mistake, 1) for edit in repair.edits), reverse=True)
    made = sorted(_made(drawn), reverse=True)
    if all(size <= mistake for size, mistake in zip(sizes, made, strict=False)):
        return "as good"
    return f"edits of sizes {sizes} for mistakes of sizes {made}"


def _made(drawn: Case) -> list[int]:
    """Sizes of the mistakes."""
    made = [MADE.get(kind, 1) for kind in drawn.kinds]
    if drawn.form not in SIMPLIFIED:
        return made
    trees = zip(drawn.trees, drawn.row.trees, strict=True)
    seen = sum(distance(written(one), written(two)) for one, two in trees)
    return [max(size, seen - sum(made) + size) for size in made]


def distance(one: Expr, two: Expr) -> int:
    """Size of the edits that lead from one expression to another, by what they have in common."""
    if one == two:
        return 0
    for kind, size in ((Add, SIZES[Mistake.EXTRA]), (Mul, 1)):
        if isinstance(one, kind) or isinstance(two, kind):
            parts, others = kind.make_args(one), kind.make_args(two)
            here = [part for part in parts if part not in others]
            there = [part for part in others if part not in parts]
            if len(here) == len(there) == 1:
                return distance(here[0], there[0])
            return size * (len(here) + len(there))
    if one.func == two.func and one.args:
        return sum(distance(a, b) for a, b in zip(one.args, two.args, strict=False))
    return 1 if one.args == two.args else SIZES[Mistake.TERM]


def _entries(side: object) -> list:
    return list(side) if isinstance(side, MatrixBase) else [side]


def _right(drawn: Case, count: int) -> list:
    """The right statement, with as many sides as the repaired one has."""
    sides = [written(tree) for tree in drawn.row.trees]
    if drawn.row.equation and count == 1:
        return sides[1:]
    return sides


def _same(drawn: Case, sides: list) -> bool:
    """Whether every side is the right one; a residual is the difference of two."""
    right = _right(drawn, len(sides))
    plain = [drawn.about.scene.plain(side) for side in sides]
    if len(plain) != len(right):
        return False
    if all(canonical(a - b) == 0 for a, b in zip(plain, right, strict=True)):
        return True
    if not drawn.row.equation or len(right) != 2:
        return False
    return canonical((plain[0] - plain[1]) - (right[0] - right[1])) == 0


def _true(drawn: Case, sides: list) -> bool:
    """Whether the repaired statement holds at the states of the campaign."""
    plain = tuple(read(drawn.about.scene.plain(side)) for side in sides)
    if drawn.row.equation and len(plain) == 1:
        plain = (drawn.row.trees[0], *plain)
    return holds(drawn.about, drawn.row, plain) is True
