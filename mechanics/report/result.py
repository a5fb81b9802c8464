"""What a cross-check of one system found: the data that reports and JSON are made from."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from mechanics.equations import Equations, Line, Step
from mechanics.kernel import Finding, Verdict
from mechanics.scene import Scene
from mechanics.scene.published import Published


@dataclass(frozen=True)
class RouteResult:
    """One derivation: the equations, how long they took, and how large they are.

    `equations` is None where they are too long to be written out, and for SymPy's own methods.
    `operations` counts the operations of M and f after common subexpressions are shared, `forward`
    those of forward dynamics, which are written in `form`, one of `mechanics.compiled.FORMS`.
    `absent` says why there is no such derivation, `steps` how it goes, the result last.
    """

    equations: Equations | None
    seconds: float
    operations: int
    form: str = ""
    forward: int = 0
    absent: str = ""
    steps: tuple[Step, ...] = ()


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
class Swing:
    """A mode in numbers: q0 + exp(growth t) Re(a exp(i omega t)).

    Its number, omega in rad/s, amplitudes a by coordinate, complex where they have phases,
    growth in 1/s, negative where it is damped, and the equilibrium q0 where it is not 0.
    """

    number: int
    omega: float
    shape: Mapping[str, complex]
    growth: float = 0.0
    about: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Modes:
    """Natural frequencies and shapes about an equilibrium, or poles.

    `rows` are (label, symbolic value or None, number as text); `swings` are the modes that
    oscillate, at typical values.
    """

    title: str
    rows: tuple[tuple[str, Any, str], ...]
    swings: tuple[Swing, ...] = ()


@dataclass(frozen=True)
class Motion:
    """A simulated motion.

    Attributes
    ----------
    title : str
    columns : mapping of str to array, shape (N,)
        By plain name: ``t``, coordinates, speeds, ``kinetic_energy`` and the like.
    note : str
        What a reader has to know about the quality of the samples.
    units : mapping of str to str
        Of the columns, where they are known.
    """

    title: str
    columns: Mapping[str, Any]
    note: str = ""
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, repr=False)
class SystemResult:
    """Everything that a cross-check of one system found.

    Attributes
    ----------
    pairs : mapping of (str, str) to Finding
        Do two routes give the same accelerations? Each of these is one of `findings`, too.
    remarks : tuple of str
        Sentences for the reader: what was left out, and why.
    witnesses : tuple of Finding
        What numbers say that share no code with the routes: evidence, which cannot be more than
        SUPPORTED, and which fails where it is less.
    sympy : mapping of str to RouteResult
        What SymPy's own methods derive, ``"kane_sympy"`` and ``"lagrange_sympy"``, beside the
        routes of these names. The pairs hold them, too.
    causes : tuple of Finding
        Of the findings those that say why another one is REFUTED.
    form : tuple of Line
        The equations of motion in the form in which every route ends; empty where they are not
        written out.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, z = ReferenceFrame("N"), Point("O"), dynamicsymbols("z")
    >>> m, g = parameters("m g", units="kg m/s^2", typical="2 9.81")
    >>> P = O.locatenew("P", z * N.z)
    >>> stone = Scene("stone", N, O, (z,), (Particle("stone", P, m),), loads=(gravity(-g * N.z),))
    >>> result = crosscheck(stone)
    >>> result.ok, result.name, list(result.routes)
    (True, 'stone', ['free_body', 'moving_point', 'kane', 'lagrange'])
    """

    name: str
    scene: Scene
    routes: Mapping[str, RouteResult]
    findings: tuple[Finding, ...]
    published: tuple[LedgerResult, ...] = ()
    compiled: tuple[ResidualResult, ...] = ()
    modes: tuple[Modes, ...] = ()
    motion: Motion | None = None
    remarks: tuple[str, ...] = field(default=())
    pairs: Mapping[tuple[str, str], Finding] = field(default_factory=dict)
    witnesses: tuple[Finding, ...] = ()
    sympy: Mapping[str, RouteResult] = field(default_factory=dict)
    causes: tuple[Finding, ...] = ()
    form: tuple[Line, ...] = ()

    def __repr__(self) -> str:
        counts = Counter(finding.verdict.name for finding in self.claims)
        said = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
        return f"<cross-check of {self.name}: {said or 'nothing checked'}>"

    @property
    def groups(self) -> dict[str, tuple[Finding, ...]]:
        """What was checked, by kind; the witnesses last."""
        pairs = {id(finding) for finding in self.pairs.values()}
        return {
            "pairs of routes": tuple(self.pairs.values()),
            "laws, reactions and graphs": tuple(f for f in self.findings if id(f) not in pairs),
            "published rows": tuple(entry.finding for entry in self.published),
            "the scene as declared, by numbers": self.witnesses,
        }

    @property
    def columns(self) -> dict[str, RouteResult]:
        """Routes, each with SymPy's own method of that name after it."""
        found: dict[str, RouteResult] = {}
        for name, route in self.routes.items():
            found[name] = route
            if (own := f"{name}_sympy") in self.sympy:
                found[own] = self.sympy[own]
        return found

    @property
    def ok(self) -> bool:
        """Whether every finding and published row is shown, and no witness speaks against it."""
        return bool(self.claims) and not self.open

    @property
    def claims(self) -> tuple[Finding, ...]:
        """What has to be PROVED or CERTIFIED: findings, then published rows."""
        return (*self.findings, *(entry.finding for entry in self.published))

    @property
    def open(self) -> tuple[Finding, ...]:
        """What keeps the result from being right: claims not shown, witnesses not SUPPORTED."""
        against = (w for w in self.witnesses if w.verdict is not Verdict.SUPPORTED)
        return (*(finding for finding in self.claims if not finding.shown), *against)
