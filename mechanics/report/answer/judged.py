"""A statement with what became of it: its verdict, and where it is wrong, the blame."""

from dataclasses import dataclass

from mechanics.blame.result import Blame
from mechanics.kernel import Finding
from mechanics.reading.statement import Statement


@dataclass(frozen=True)
class Judged:
    """A statement and its verdict.

    Attributes
    ----------
    statement : Statement
    finding : Finding
    right_if : tuple of str
        Changes of convention under which a refuted statement is right.
    blame : Blame or None
        Which term is wrong, where the statement is refuted and that was looked for.
    """

    statement: Statement
    finding: Finding
    right_if: tuple[str, ...] = ()
    blame: Blame | None = None
