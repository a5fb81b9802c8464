"""Code that is wrong, as the formula that was read from it, so that a reader sees what to change.

simulator.py:rate, theta_ddot    ->    theta_ddot = -g*cos(theta)/l
"""

import re
from dataclasses import replace

from mechanics.blame.search.told import sides_of
from mechanics.reading.from_sympy import Untreeable
from mechanics.reading.names import Naming, Vocabulary
from mechanics.reading.place import Refused
from mechanics.reading.spelling import Spelling
from mechanics.reading.statement import Statement
from mechanics.reading.written import Written, row_trees
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.places import placed
from mechanics.scene import Scene

TITLE = re.compile(r"[^()=*]+: [^()=*]+")
"""How statements of code are called; SymPy's objects are called by their formulas."""

LONGEST = 1000
"""Characters of a formula that a reader would look at."""


def spelled(entry: Judged, scene: Scene) -> Judged:
    """A statement of code with its formula as the source, and the edits with their places in it.

    What was read from a text, what is not blamed, and what is too long, stays as it is.
    """
    statement, blame = entry.statement, entry.blame
    if blame is None or statement.row is None or _is_text(statement):
        return entry
    formula = _formula(statement, scene)
    if not formula or len(formula) > LONGEST:
        return entry
    title = statement.source if TITLE.fullmatch(statement.source) else ""
    place = ", ".join(words for words in (title, statement.place) if words)
    written = statement.written or _code(scene)
    repairs = tuple(
        replace(repair, edits=placed(formula, repair.edits, repair.repaired))
        for repair in blame.repairs
    )
    return replace(
        entry,
        statement=replace(statement, source=formula, place=place, written=written),
        blame=replace(blame, repairs=repairs),
    )


def _is_text(statement: Statement) -> bool:
    return statement.written is not None and statement.written.notation != "code"


def _code(scene: Scene) -> Written:
    return Written((), (), Naming(Vocabulary(scene)), "code", "")


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
