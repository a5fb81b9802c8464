"""What became of all of a person's equations, to be printed, shown in a notebook, or asked.

print(check)    ->    REFUTED  (7)  ...  write 3 for 12: the factor is wrong
"""

from collections import Counter
from dataclasses import dataclass

from rich.console import Group

from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.report.answer.code_formula import numbered, once, spelled
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.terminal import answer, plain
from mechanics.scene import Scene


@dataclass(frozen=True, repr=False)
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
        What the statements were compared with; None where that stays a program.
    unjudged : tuple of str
        Sentences around the statements that nothing was compared with, and what is beside.
    beside : tuple of str
        Functions and lines of a file of code that are no part of what was judged.
    aside : tuple of str
        Lines and sentences that were set aside, as the person asked.
    suggested : tuple of str
        Which option would give a verdict of what is shown.
    set_aside : tuple of Statement
        The statements among what was set aside.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z = ReferenceFrame("N"), Point("O"), dynamicsymbols("z")
    >>> m, g = parameters("m g", units="kg m/s^2", typical="2 9.81")
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),), loads=(gravity(-g * N.z),))
    >>> answer = check(stone, "m*z_ddot + m*g = 0")
    >>> answer.ok, answer.verdict.name, len(answer.judged)
    (True, 'PROVED', 1)
    """

    scene: Scene
    judged: tuple[Judged, ...]
    names: tuple[Match, ...]
    remarks: tuple[str, ...]
    derived: Equations | None = None
    unjudged: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    aside: tuple[str, ...] = ()
    suggested: tuple[str, ...] = ()
    set_aside: tuple[Statement, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """The worst verdict of all."""
        order = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SUPPORTED, Verdict.CERTIFIED)
        found = {entry.verdict for entry in self.judged}
        for verdict in order:
            if verdict in found:
                return verdict
        return Verdict.PROVED if found else Verdict.UNDECIDED

    @property
    def ok(self) -> bool:
        """Whether everything is PROVED or CERTIFIED, and there is something."""
        return self.verdict in (Verdict.PROVED, Verdict.CERTIFIED)

    @property
    def told(self) -> tuple[Judged, ...]:
        """What was judged, as a reader is shown it: numbered, wrong code as its formula."""
        return numbered([once(spelled(entry, self.scene)) for entry in self.judged])

    def __rich__(self) -> Group:
        remarks = (*self.remarks, *self.suggested)
        return answer(self.told, self.names, remarks, self.scene, self.unjudged, self.aside)

    def __str__(self) -> str:
        return plain(self.__rich__())

    def __repr__(self) -> str:
        counts = Counter(entry.verdict for entry in self.judged)
        words = ", ".join(f"{counts[v]} {v.name}" for v in Verdict if counts[v])
        return f"<Check of {self.scene.name}: {words or 'nothing was checked'}>"
