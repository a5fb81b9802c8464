"""Random points of a large prime field, with the accelerations of the truth put in.

    every symbol a residue modulo p of 127 bits,    u' and reactions as the derived equations give

What holds there holds everywhere but for a chance of 2**-100; what is found is proved afterwards.
Points come in families: the same values but for one symbol that is doubled, or but for the state.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TypeVar

from sympy import Expr, Symbol, cos

from mechanics.checks.ledger_compare import define
from mechanics.checks.ledger_motion import put_motion
from mechanics.checks.manifold import project
from mechanics.checks.solution import put_solution
from mechanics.equations import Equations
from mechanics.kernel import Range
from mechanics.kernel.draws import Draws
from mechanics.kernel.field import Inadmissible, Residues
from mechanics.kernel.primes import MODULUS, draw_prime
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.symbolic import Kinematics
from mechanics.program import Node
from mechanics.symbolic import Arithmetic
from mechanics.symbolic.point import BITS
from mechanics.symbolic.point import Point as Values

SEED = "blame"
TRIES = 40

T = TypeVar("T")


@cache
def prime() -> int:
    """The prime; the same in every run, so that blame is.

    Two is a square modulo it (p = 7 mod 8), so that what is positive stays so when it is doubled.
    """
    return draw_prime(BITS, MODULUS, Draws(SEED))


@dataclass(frozen=True)
class Family:
    """Which point: in which way it differs from the first one.

    Attributes
    ----------
    moving : bool
        Whether accelerations and reactions are those of the motion, or free.
    doubled : tuple of Symbol
        Symbols whose values are doubled, as often as they stand there.
    other_state : bool
        Whether coordinates and speeds are others; parameters and inputs stay.
    still : bool
        Whether all speeds are zero.
    free : bool
        Whether constraints are left aside, as for energies, which are right without them, too.
    """

    moving: bool
    doubled: tuple[Symbol, ...] = ()
    other_state: bool = False
    still: bool = False
    free: bool = False


@dataclass(frozen=True, eq=False)
class Motion:
    """What symbols stand for, as nodes that the points of some families share.

    Attributes
    ----------
    arithmetic : Arithmetic
    angles : list of Node
        Cosines of the coordinates that are free.
    """

    kinematics: Kinematics
    arithmetic: Arithmetic
    angles: list[Node]
    _plain: dict[Expr, Node] = field(default_factory=dict)

    def node(self, expression: Expr) -> Node:
        """An expression, in which rates of coordinates and momenta may stand."""
        if expression not in self._plain:
            plain = self.kinematics.scene.plain(momenta_written_out(self.kinematics, expression))
            self._plain[expression] = self.arithmetic.value(plain)
        return self._plain[expression]


@dataclass(frozen=True, eq=False)
class Point:
    """A point: what expressions in plain symbols are worth there.

    Attributes
    ----------
    motion : Motion
    values : mechanics.symbolic.point.Point
    family : Family
    attempt : int
        Points of one attempt belong together.
    prime : int
        The modulus.
    """

    motion: Motion
    values: Values
    family: Family
    attempt: int
    prime: int

    def value(self, expression: Expr) -> int:
        """Residue of an expression, in which rates of coordinates and momenta may stand.

        Raises
        ------
        Inadmissible
            Where it has no value.
        """
        return self.values.value(self.motion.node(expression))


@dataclass(frozen=True, eq=False)
class Points:
    """The points of one derivation, each made when it is first asked for."""

    truth: Equations
    _motions: dict[tuple[bool, bool, bool], Motion] = field(default_factory=dict)
    _made: dict[tuple[Family, int], Point] = field(default_factory=dict)
    _dependent: list[frozenset[Symbol]] = field(default_factory=list)

    @property
    def dependent(self) -> frozenset[Symbol]:
        """What the constraints determine, once the rest is chosen."""
        if not self._dependent:
            a = Arithmetic()
            project(a, self.truth.kinematics, accelerations=True)
            self._dependent.append(frozenset(a.assigned))
        return self._dependent[0]

    def like(self, point: Point, family: Family) -> Point:
        """The point of another family that belongs to a point.

        Raises
        ------
        Inadmissible
            Where it will not do.
        """
        return self._point(family, point.attempt)

    def together(self, families: Sequence[Family], use: Callable[[list[Point]], T]) -> T:
        """What a function makes of points that belong together; others are tried if it has to be.

        Raises
        ------
        Inadmissible
            When no point will do.
        """
        reason = ""
        for attempt in range(TRIES):
            try:
                return use([self._point(family, attempt) for family in families])
            except Inadmissible as inadmissible:
                reason = str(inadmissible)
        raise Inadmissible(f"no admissible point was found: {reason}")

    def _motion(self, family: Family) -> Motion:
        # Where a quantity is doubled the reactions need not press: the terms grow all the same.
        pressing = family.moving and not family.doubled
        key = (family.free, family.moving, pressing)
        if key not in self._motions:
            self._motions[key] = self._new_motion(*key)
        return self._motions[key]

    def _new_motion(self, free: bool, moving: bool, pressing: bool) -> Motion:
        a, scene = Arithmetic(), self.truth.scene
        if not free:
            project(a, self.truth.kinematics, accelerations=not moving)
        define(a, scene)
        if moving:
            (put_motion if pressing else put_solution)(a, self.truth)
        angles = [a.value(cos(q)) for q in scene.q if q not in a.assigned]
        return Motion(self.truth.kinematics, a, angles)

    def _point(self, family: Family, attempt: int) -> Point:
        key = family, attempt
        if key not in self._made:
            self._made[key] = self._new_point(family, attempt)
        return self._made[key]

    def _new_point(self, family: Family, attempt: int) -> Point:
        motion, scene = self._motion(family), self.truth.scene
        a = motion.arithmetic
        draws = Draws(SEED, str(attempt), str(family.other_state))
        domain = Residues(prime(), MODULUS, draws, signs=True)
        state = {s.name for s in (*scene.q, *scene.u, *scene.ud)} if family.other_state else set()
        still = {s.name for s in scene.u} if family.still else set()
        doubled = [s.name for s in family.doubled]

        def drawn(name: str) -> int:
            """A value that the name tells, so that points of a family agree in it."""
            if name in still:
                return 0
            kind = "other" if name in state else ""
            residue = 1 + Draws(SEED, str(attempt), name, kind).below(prime() - 1)
            known = a.signs.get(name, Range.FREE)
            if known is not Range.FREE:
                residue = residue * residue * (-1 if known is Range.NEGATIVE else 1)
            return residue * 2 ** doubled.count(name) % prime()

        values = Values(a.builder, domain, drawn)
        # Angles get their points of the circle in one order; parts of them may be asked for.
        for angle in motion.angles:
            values.value(angle)
        for node in a.positive:
            domain.positive(values.value(node))
        for node in a.assigned.values():
            values.value(node)
        return Point(motion, values, family, attempt, prime())
