"""A statement with what became of it: its verdict, and where it is wrong, the blame."""

from dataclasses import dataclass

from mechanics.blame.result import Blame
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding, Verdict
from mechanics.scene.dimensions import BY_DIMENSION


@dataclass(frozen=True, repr=False)
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
    open : bool
        Whether it is refuted under the likeliest reading only, and right under another.
    """

    statement: Statement
    finding: Finding
    right_if: tuple[str, ...] = ()
    blame: Blame | None = None
    open: bool = False

    def __repr__(self) -> str:
        return f"<{self.verdict.name} {self.statement.source[:160]}>"

    @property
    def verdict(self) -> Verdict:
        """Of the finding; UNDECIDED where another reading is right."""
        return Verdict.UNDECIDED if self.open else self.finding.verdict

    @property
    def of_dimension(self) -> bool:
        """Whether its dimension alone refutes it; then no state does."""
        return of_dimension(self.finding)

    @property
    def says_why(self) -> bool:
        """Whether the evidence of the finding says what a reader wants to know."""
        finding = self.finding
        plain = finding.verdict in (Verdict.PROVED, Verdict.REFUTED)
        return bool(finding.evidence) and (self.of_dimension or finding.undefined or not plain)


def of_dimension(finding: Finding) -> bool:
    """Whether a dimension alone refutes; then no state does."""
    return finding.evidence.startswith(BY_DIMENSION)


def differs(finding: Finding) -> bool:
    """Whether the sides differ at a state where both have values."""
    wrong = finding.verdict is Verdict.REFUTED and not finding.undefined
    return wrong and not of_dimension(finding)
