"""A person's own equations, checked against what the engine derives from the scene.

statements  --ledger-->  PROVED, CERTIFIED, REFUTED with a witness, UNDECIDED
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from mechanics.checks.ledger import check_row
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, wanted
from mechanics.exact import Finding, Verdict
from mechanics.reading.names import Match
from mechanics.reading.read import Reading, read_file, read_source
from mechanics.reading.statement import Statement
from mechanics.scene import Scene
from mechanics.scene.system import System


@dataclass(frozen=True)
class Judged:
    """A statement and its verdict.

    Attributes
    ----------
    statement : Statement
    finding : Finding
    right_if : tuple of str
        Changes of convention under which a refuted statement is right.
    """

    statement: Statement
    finding: Finding
    right_if: tuple[str, ...] = ()


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
    """

    scene: Scene
    judged: tuple[Judged, ...]
    names: tuple[Match, ...]
    remarks: tuple[str, ...]

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


@lru_cache(maxsize=8)
def derived(scene: Scene) -> Equations:
    """What statements about a scene are compared with: the route that has the reactions."""
    return derive(scene, "free_body")


def check(
    scene: Scene | System | Equations,
    equations: Any,
    *,
    names: Mapping[str, str] | None = None,
    notation: str | None = None,
    about: str | None = None,
) -> Check:
    """Check a person's equations of motion, energies, reactions or mass matrix.

    Parameters
    ----------
    scene : Scene, System or Equations
        What they are about; equations that were derived already save that time.
    equations : str, Path, or a sequence of them
        LaTeX, or text in SymPy's or MATLAB's notation.
    names : mapping of str to str, optional
        The person's names and the scene's: ``{"phi": "theta", "w": "theta_dot"}``. What is not
        given is the same name, or the best guess, which the result tells.
    notation : str, optional
        ``"latex"`` or ``"text"``, where that is not plain.
    about : str, optional
        What they are, where that is not plain: ``"kinetic energy"``, ``"mass matrix"``, ...

    Returns
    -------
    Check

    Raises
    ------
    InputError
        When nothing can be read, by line and column.
    """
    wanted(scene, (Scene, System, Equations), "check", "pass a scene, or one of systems.ALL")
    if isinstance(scene, Equations):
        truth = scene
    else:
        truth = derived(scene.scene() if isinstance(scene, System) else scene)
    options = {"names": names, "notation": notation, "about": about}
    readings = [_read(truth.scene, part, options) for part in _parts(equations)]
    judged = tuple(
        Judged(statement, _judge(truth, statement))
        for reading in readings
        for statement in reading.statements
    )
    matches = {match.name: match for reading in readings for match in reading.names}
    remarks = tuple(dict.fromkeys(r for reading in readings for r in reading.remarks))
    return Check(truth.scene, judged, tuple(matches.values()), remarks)


def _parts(equations: Any) -> Sequence[Any]:
    return equations if isinstance(equations, list | tuple) else [equations]


def _read(scene: Scene, equations: Any, options: Mapping[str, Any]) -> Reading:
    if isinstance(equations, Path):
        return read_file(scene, equations, **options)
    wanted(equations, str, "check", "pass LaTeX, text or a Path")
    return read_source(scene, equations, **options)


def _judge(truth: Equations, statement: Statement) -> Finding:
    subject = f"{statement.tag}: {statement.source}"
    if statement.doubt or statement.row is None:
        return Finding(subject, Verdict.UNDECIDED, statement.doubt)
    try:
        return check_row(truth.scene, statement.row, truth)
    except (InputError, SceneError, ExpressionError) as error:
        return Finding(subject, Verdict.UNDECIDED, str(error))
