"""Right statements about every system: what people derive, print and program.

published equations of motion and reactions        M u' = f + B lambda, row by row, of every route
u'_i = explicit                                    T, V, T + V, T - V, the mass matrix, reactions

Each is shown to be right at the states of `states` before it is used; published rows that are wrong
(those of the known misprints) are left out.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property

import sympy
from flint import arb
from sympy import Matrix

from benchmarks.detection.states import BITS, Numbers, States, states, value, vanishes
from benchmarks.detection.tree import Tree, read, symbol, symbols
from mechanics.blame.reference import Reference
from mechanics.checks.ledger import plain_side
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.kernel.balls import precision
from mechanics.scene import Scene
from mechanics.scene.potential import potential
from mechanics.scene.quantities import EquationOfMotion, ReactionValue
from mechanics.scene.system import System
from mechanics.symbolic import canonical
from systems import ALL

ROUTES = ("free_body", "moving_point", "kane", "lagrange")
LARGEST = 260
"""Nodes of a side: people do not write longer ones by hand."""
MOST_SOLVED = 3
"""Speeds of a scene whose accelerations are solved for explicitly."""

UNKNOWN_UP_TO_A_CONSTANT = ("potential energy", "energy", "Lagrangian")


@dataclass(frozen=True, eq=False)
class Row:
    """A right statement.

    Attributes
    ----------
    name : str
        ``"published (6)"``, ``"kane 2"``, ``"explicit theta_ddot"``.
    about : str
        ``"motion"``, ``"acceleration"``, ``"reaction"``, ``"mass matrix"``, or the words for an
        energy.
    trees : tuple of Tree
        Two sides; one of an energy; the entries of the mass matrix row by row.
    """

    name: str
    about: str
    trees: tuple[Tree, ...]

    @property
    def equation(self) -> bool:
        """Whether it has two sides."""
        return self.about in ("motion", "acceleration", "reaction")


@dataclass(frozen=True, eq=False)
class Subject:
    """A system with everything that is the same for all statements about it."""

    system: System
    scene: Scene
    reference: Reference
    kane: Equations
    states: States

    @property
    def free_body(self) -> Equations:
        """The truth."""
        return self.reference.truth

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Right statements, none twice."""
        found: dict[tuple[str, tuple[Tree, ...]], Row] = {}
        for row in self._all():
            empty = row.equation and row.trees[0] == row.trees[1]
            if not empty and max(t.size for t in row.trees) <= LARGEST and self._known(row):
                found.setdefault((row.about, row.trees), row)
        return tuple(row for row in found.values() if holds(self, row, row.trees))

    def _all(self) -> Iterator[Row]:
        yield from _published(self)
        for route in ROUTES:
            yield from _derived(self, route)
        yield from _explicit(self)
        yield from _reactions(self)
        yield from _energies(self)

    def _known(self, row: Row) -> bool:
        return set().union(*map(symbols, row.trees)) <= self.states.all[0].keys()


@cache
def subject(name: str) -> Subject:
    """A system by its name."""
    (system,) = (system for system in ALL if system.name == name)
    scene = system.scene()
    kane, free_body = derive(scene, "kane"), derive(scene, "free_body")
    return Subject(system, scene, Reference(free_body), kane, states(scene, kane, free_body))


def holds(about: Subject, row: Row, trees: tuple[Tree, ...]) -> bool | None:
    """Whether a statement like `row` with these trees is true; None where numbers cannot tell.

    Energies are compared with the right ones up to a constant, which may depend on parameters.
    """
    with precision(BITS):
        if row.about in UNKNOWN_UP_TO_A_CONSTANT:
            errors = [[_error(row, trees, state)[0] for state in pair]
                      for pair in about.states.pairs]  # fmt: skip
            told = [vanishes(one - two) for one, two in errors]
        else:
            told = [vanishes(e) for state in about.states.all for e in _error(row, trees, state)]
    if False in told:
        return False
    return None if None in told else True


def _error(row: Row, trees: tuple[Tree, ...], state: Numbers) -> list[arb]:
    """What has to vanish at a state."""
    if row.equation:
        return [value(trees[0], state) - value(trees[1], state)]
    pairs = zip(trees, row.trees, strict=True)
    return [value(one, state) - value(two, state) for one, two in pairs]


def _published(about: Subject) -> Iterator[Row]:
    for row in about.system.published:
        kind = {EquationOfMotion: "motion", ReactionValue: "reaction"}.get(type(row.quantity))
        if kind is None:
            continue
        first, *others = (
            plain_side(about.free_body.kinematics, side, row.tag) for side in row.sides
        )
        if isinstance(row.quantity, ReactionValue):
            first, others = sympy.Symbol(row.quantity.name, real=True), [first, *others]
        for other in others:
            yield Row(f"published {row.tag}", kind, (read(first), read(other)))


def _derived(about: Subject, route: str) -> Iterator[Row]:
    """M u' = f + B lambda, and once more multiplied out with everything on one side."""
    given = {"kane": about.kane, "free_body": about.free_body}
    try:
        equations = given.get(route) or derive(about.scene, route)
    except MechanicsError:
        return  # Lagrange needs u = q', and loads that do not depend on reactions
    left, right = equations.mass * Matrix(about.scene.ud), equations.forcing
    if equations.multipliers:
        right = right + equations.reaction_matrix * Matrix(equations.multipliers)
    for i, (one, other) in enumerate(zip(left, right, strict=True), 1):
        yield Row(f"{route} {i}", "motion", (read(one), read(other)))
        yield Row(f"{route} {i} = 0", "motion", (read(canonical(one - other)), read(sympy.S.Zero)))


def _fractions(about: Subject) -> list[tuple[sympy.Expr, sympy.Expr]]:
    """Numerator and denominator of every acceleration, by Cramer's rule; none for large scenes."""
    left, right = about.free_body.system
    size = len(about.scene.ud)
    if left.rows > size or size > MOST_SOLVED:
        return []
    below = canonical(left.det(method="berkowitz"))
    found = []
    for i in range(size):
        above = left.copy()
        above[:, i] = right
        found.append((canonical(above.det(method="berkowitz")), below))
    return found


def _explicit(about: Subject) -> Iterator[Row]:
    """u'_i = ..., each numerator and the denominator multiplied out, and with factors in front."""
    for u, (above, below) in zip(about.scene.ud, _fractions(about), strict=False):
        for expr in (above / below, sympy.factor_terms(above) / sympy.factor_terms(below)):
            yield Row(f"explicit {u}", "acceleration", (symbol(u), read(expr)))


def _reactions(about: Subject) -> Iterator[Row]:
    """As the free bodies give them, multiplied out, and as functions of the state alone."""
    accelerations = _fractions(about)
    known: dict[sympy.Symbol, sympy.Expr] = {}
    for reaction, expr in about.free_body.reactions:
        forms = [expr, canonical(expr)]
        known[reaction] = whole = expr.xreplace(known)
        if accelerations and not about.scene.constraints:
            below = accelerations[0][1]
            above = whole.xreplace(dict.fromkeys(about.scene.ud, sympy.S.Zero)) * below
            for u, (number, _) in zip(about.scene.ud, accelerations, strict=True):
                above += whole.diff(u) * number
            forms.append(canonical(above) / below)
        for form in forms:
            yield Row(f"reaction {reaction}", "reaction", (symbol(reaction), read(form)))


def _energies(about: Subject) -> Iterator[Row]:
    scene = about.scene
    kinetic, stored = about.free_body.kinematics.kinetic_energy, potential(scene)
    energies = {"kinetic energy": kinetic, "potential energy": stored,
                "energy": kinetic + stored, "Lagrangian": kinetic - stored}  # fmt: skip
    for words, energy in energies.items():
        if energy.free_symbols & {*scene.q, *scene.u}:
            for form in (energy, canonical(energy)):
                yield Row(words, words, (read(form),))
    if len(scene.u) > 1:
        matrix = about.free_body.kinematics.mass_matrix
        yield Row("mass matrix", "mass matrix", tuple(read(canonical(entry)) for entry in matrix))
