"""What a cross-check of one system found: the data that reports and JSON are made from."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from mechanics.equations import Equations
from mechanics.exact import Finding
from mechanics.scene import Scene
from mechanics.scene.published import Published


@dataclass(frozen=True)
class RouteResult:
    """One derivation: the equations, how long they took, and how large they are.

    `operations` counts the operations of M and f after common subexpressions are shared.
    """

    equations: Equations
    seconds: float
    operations: int


@dataclass(frozen=True)
class LedgerResult:
    """One published row and what became of it."""

    row: Published
    finding: Finding


@dataclass(frozen=True)
class ResidualResult:
    """Largest residual of a published equation at the accelerations that compiled code returns.

    Attributes
    ----------
    subject : str
        Route, equation and precision.
    max_eps : float
        Largest |residual| / (machine epsilon * sum of the magnitudes of the typed terms).
    states : int
        Number of random states.
    """

    subject: str
    max_eps: float
    states: int


@dataclass(frozen=True)
class Modes:
    """Natural frequencies and shapes about an equilibrium, or poles.

    `rows` are (label, symbolic value or None, number as text).
    """

    title: str
    rows: tuple[tuple[str, Any, str], ...]


@dataclass(frozen=True)
class Motion:
    """A simulated motion: `columns` maps time, coordinates, speeds and energies to samples."""

    title: str
    columns: Mapping[str, Any]
    note: str = ""


@dataclass(frozen=True)
class SystemResult:
    """Everything that a cross-check of one system found."""

    name: str
    scene: Scene
    routes: Mapping[str, RouteResult]
    findings: tuple[Finding, ...]
    published: tuple[LedgerResult, ...] = ()
    compiled: tuple[ResidualResult, ...] = ()
    modes: tuple[Modes, ...] = ()
    motion: Motion | None = None
    remarks: tuple[str, ...] = field(default=())

    @property
    def ok(self) -> bool:
        """Whether every finding and every published row is PROVED or CERTIFIED."""
        rows = [*self.findings, *(entry.finding for entry in self.published)]
        return bool(rows) and all(finding.shown for finding in rows)
