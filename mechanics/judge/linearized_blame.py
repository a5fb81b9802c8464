"""What is wrong with an equation that is linearized: no sine or cosine stands in it.

    theta'' = -3 g theta/(2 l)    "for small angles":    + instead of -, right to first order

No value at a point of the motion tells these edits: the likeliest ones are proved one by one.
"""

from dataclasses import replace
from itertools import islice

from mechanics.blame.reference import Reference
from mechanics.blame.search.candidates import Candidates
from mechanics.blame.search.claim import claim_of, problems
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.find import Solution, words_of
from mechanics.blame.search.repair import edited_row, proved
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.place import Refused
from mechanics.errors import MechanicsError
from mechanics.judge.bounded_blame import LARGEST, nodes
from mechanics.judge.operating_point import operating_point
from mechanics.judge.small_angles import to_first_order
from mechanics.report.answer.judged import Judged
from mechanics.scene.quantities import EquationOfMotion

TRIED = 40
"""Edits that are proved at most."""

TOLD = 3

TO_FIRST_ORDER = "right to first order only, for small angles, which is how it is written"


def linearized(reference: Reference, entry: Judged) -> Judged:
    """The entry; where no edit mends an equation for small angles, those to first order."""
    try:
        return _mended(reference, entry)
    except (MechanicsError, Untreeable, Refused, RecursionError):
        return entry


def _mended(reference: Reference, entry: Judged) -> Judged:
    statement, truth, blame = entry.statement, reference.truth, entry.blame
    row, written = statement.row, statement.written
    if blame is None or row is None or written is None or nodes(statement) > LARGEST:
        return entry
    if any(len(repair.edits) == 1 for repair in blame.repairs):
        return entry
    if not isinstance(row.quantity, EquationOfMotion):
        return entry
    meant = operating_point(truth.scene, written)
    if meant is not None and (meant.place is None or any(meant.place.values()) or meant.hedge):
        return entry
    (own,) = to_first_order(truth, [statement])
    claim = None if own is None else claim_of(reference, statement)
    problem = None if claim is None else next(problems(claim), None)
    if claim is None or problem is None:
        return entry
    maker = Maker(problem.tree, problem.sheets, words_of(claim, problem))
    changes = sorted(Candidates(maker).all(), key=lambda change: change.cost)
    solutions = [Solution(problem, (change,)) for change in changes[:TRIED]]
    rows = [
        (solution, made[0]) for solution in solutions if (made := edited_row(claim, [solution]))
    ]
    findings = to_first_order(truth, [replace(statement, row=other) for _, other in rows])
    repairs = (
        proved(claim, [solution], statement.source, finding)
        for (solution, _), finding in zip(rows, findings, strict=True)
        if finding is not None and finding.shown
    )
    found = tuple(islice(filter(None, repairs), TOLD))
    if not found:
        return entry
    return replace(
        entry, blame=replace(blame, differences=(), repairs=found, searched=TO_FIRST_ORDER)
    )
