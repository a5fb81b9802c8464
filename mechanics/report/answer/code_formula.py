"""Code that is wrong, as the formula that was read from it, so that a reader sees what to change.

simulator.py:rate, theta_ddot    ->    theta_ddot = -g*cos(theta)/l
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from mechanics.blame.result import Repair
from mechanics.blame.search.notation import sides_of
from mechanics.blame.search.repair import assigned
from mechanics.claims.claim import Written, row_trees
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.place import Refused
from mechanics.claims.spelling import Spelling
from mechanics.claims.statement import Statement
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.places import placed
from mechanics.scene import Scene

TITLE = re.compile(r"[^()=*]+: [^()=*]+")
"""How statements of code are called; SymPy's objects are called by their formulas."""

LONGEST = 1000
"""Characters of a formula that a reader would look at."""


def spelled(entry: Judged, scene: Scene) -> Judged:
    """A statement of code with its formula as the source, and the edits with their places in it.

    What was read from a text, code that is not blamed, and what is too long, stays as it is.
    """
    statement, blame = entry.statement, entry.blame
    titled = TITLE.fullmatch(statement.source) is not None
    if statement.row is None or _is_text(statement) or (blame is None and titled):
        return entry
    formula = _assigned(entry) or _formula(statement, scene)
    if not formula or len(formula) > LONGEST:
        return entry
    title = statement.source if titled else ""
    place = ", ".join(words for words in (title, statement.place) if words)
    written = statement.written or _code(scene)
    statement = replace(statement, source=formula, place=place, written=written)
    if blame is None:
        return replace(entry, statement=statement)
    repairs = tuple(
        replace(repair, edits=placed(formula, repair.edits, repair.repaired))
        for repair in blame.repairs
    )
    return replace(entry, statement=statement, blame=replace(blame, repairs=repairs))


def once(entry: Judged) -> Judged:
    """A statement without edits that are those before them on the other side of the equation."""
    if entry.blame is None:
        return entry
    kept: list[Repair] = []
    for repair in entry.blame.repairs:
        if not any(_opposite(repair, other) for other in kept):
            kept.append(repair)
    return replace(entry, blame=replace(entry.blame, repairs=tuple(kept)))


def _opposite(one: Repair, other: Repair) -> bool:
    """Whether two repairs add the same term with different signs."""
    edits = (*one.edits, *other.edits)
    if len(edits) != 2 or any(edit.written for edit in edits):
        return False
    first, second = (edit.right.strip() for edit in edits)
    return {first[:1], second[:1]} == {"+", "-"} and first[1:].strip() == second[1:].strip()


def numbered(entries: Sequence[Judged]) -> tuple[Judged, ...]:
    """Statements that were passed one by one, and are all called 1, by their places."""
    tags = [entry.statement.tag for entry in entries]
    if len(set(tags)) == len(tags) or not all(tag.isdigit() for tag in tags):
        return tuple(entries)
    return tuple(
        replace(entry, statement=replace(entry.statement, tag=str(number)))
        for number, entry in enumerate(entries, start=1)
    )


def _is_text(statement: Statement) -> bool:
    return statement.written is not None and statement.written.notation != "code"


def _code(scene: Scene) -> Written:
    return Written((), (), Naming(Vocabulary(scene)), "code", "")


def _assigned(entry: Judged) -> str:
    """The assignments of code that the smallest repair changes, where it changes nothing else."""
    written = entry.statement.written
    repairs = entry.blame.repairs if entry.blame is not None else ()
    names = list(dict.fromkeys(edit.definition for r in repairs[:1] for edit in r.edits))
    if written is None or not names or not all(name in written.places for name in names):
        return ""
    return assigned(written, names)


def _formula(statement: Statement, scene: Scene) -> str:
    """The sides as the edits spell them; empty where they cannot be spelled."""
    written = statement.written or _code(scene)
    row = statement.row
    if row is None:
        return ""
    try:
        trees = row_trees(row, written)
    except (Untreeable, Refused):
        return ""
    return " = ".join(sides_of(map(Spelling(written, frozenset()), trees), row))
