"""Which branch of a statement told by cases is wrong, and what is wrong in it.

u > 3 ? right : wrong    ->    wrong where u <= 3, right where u > 3, and the blame of that branch
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

from sympy import Expr
from sympy.core.relational import Relational

from mechanics.blame.result import Blame
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.cases import has_parts, in_case, in_words, meets, parts_of
from mechanics.kernel import Finding, Verdict
from mechanics.kernel.field import Inadmissible

Branch = tuple[tuple[Relational, ...], tuple[Expr, ...]]


def blame_by_branch(
    truth: Equations, statement: Statement, finding: Finding, search: Callable[[Statement], Blame]
) -> Blame | None:
    """The blame of the branch that the witness is in; None where nothing is told by cases.

    Parameters
    ----------
    finding : Finding
        That refutes it.
    search : callable
        The blame of a statement without cases.
    """
    row = statement.row
    if row is None or not has_parts(truth, row):
        return None
    wrong: list[Branch] = []
    right: list[str] = []
    for conditions, sides in parts_of(row):
        if conditions is None:
            return None
        try:
            found = in_case(truth, replace(row, sides=sides), conditions)
        except Inadmissible:
            continue
        if found.verdict is Verdict.REFUTED:
            wrong.append((conditions, sides))
        elif found.shown:
            right.append(_where(conditions))
    if not wrong:
        return None
    seen = finding.witness
    conditions, sides = next((b for b in wrong if seen and meets(seen, b[0])), wrong[0])
    written = next((statement.ways[side] for side in sides if side in statement.ways), None)
    blame = search(replace(statement, row=replace(row, sides=sides), written=written))
    others = [_where(c) for c, _ in wrong if c != conditions]
    told = (f"this is the branch {_where(conditions)}",
            *([f"wrong, too, {', '.join(others)}"] if others else []),
            *([f"right {', '.join(right)}"] if right else []), blame.searched)  # fmt: skip
    return replace(blame, searched="; ".join(filter(None, told)))


def _where(conditions: Sequence[Relational]) -> str:
    return f"where {' and '.join(map(in_words, conditions))}"
