"""Statements that are true whatever moves, and so say nothing about a scene.

0 = 0        m = m        sin(q)^2 + cos(q)^2 = 1        not:  omega = theta_dot
"""

from sympy.matrices import MatrixBase

from mechanics.claims.partials import PARTIAL
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Call, Name
from mechanics.kernel import Finding, undecided
from mechanics.scene.quantities import Identity
from mechanics.symbolic import is_zero

WORDS = "it is true whatever moves, so it says nothing about the scene"


def with_content(statement: Statement, finding: Finding) -> Finding:
    """The finding, but UNDECIDED for an identity that holds without anything of the scene.

    One name for another (``omega = theta_dot``) says what the person calls things, and code that
    returns the rate of a coordinate says which it is: these stay.
    """
    row, written = statement.row, statement.written
    if row is None or written is None or not isinstance(row.quantity, Identity):
        return finding
    if written.notation == "code":
        return finding
    if not finding.shown or _names(statement):
        return finding
    first, *others = row.sides
    if any(isinstance(side, MatrixBase) for side in row.sides):
        return finding
    if all(is_zero(first - side) for side in others):
        return undecided(finding.subject, WORDS)
    return finding


def _names(statement: Statement) -> bool:
    """Whether a side is a name of the person's own, or every side a name; no two are the same.

    What is left after definitions cancel (``R + u = F`` for ``R = F - u``) is no excuse: F is the
    scene's.
    """
    written = statement.written
    if written is None or len(written.sides) < 2:
        return False
    own = dict(written.definitions)
    named = [(side.name, side.order) for side in written.sides if isinstance(side, Name)]
    if len(set(named)) < len(named):
        return False
    partial = any(isinstance(s, Call) and s.function == PARTIAL for s in written.sides)
    if partial and len(named) == 1:
        return True  # q' = dH/dp says something about H
    return len(named) == len(written.sides) or any(name in own for name, _ in named)
