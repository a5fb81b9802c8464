"""What became of all of a person's equations."""

from dataclasses import dataclass

from mechanics.equations import Equations
from mechanics.exact import Verdict
from mechanics.reading.names import Match
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene


@dataclass(frozen=True)
class Check:
    """What became of a person's equations.

    Attributes
    ----------
    scene : Scene
    judged : tuple of Judged
        One for each statement, in order.
    names : tuple of Match
        What each name was taken for.
    remarks : tuple of str
    derived : Equations or None
        What the statements were compared with.
    """

    scene: Scene
    judged: tuple[Judged, ...]
    names: tuple[Match, ...]
    remarks: tuple[str, ...]
    derived: Equations | None = None

    @property
    def verdict(self) -> Verdict:
        """The worst verdict of all."""
        order = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SUPPORTED, Verdict.CERTIFIED)
        found = {entry.finding.verdict for entry in self.judged}
        for verdict in order:
            if verdict in found:
                return verdict
        return Verdict.PROVED if found else Verdict.UNDECIDED

    @property
    def ok(self) -> bool:
        """Whether everything is PROVED or CERTIFIED, and there is something."""
        return self.verdict in (Verdict.PROVED, Verdict.CERTIFIED)
