"""One random point of a large prime field, with the accelerations of the truth put in.

    every symbol a residue modulo p of 127 bits,    u' and reactions as the derived equations give

What holds there holds everywhere but for a chance of 2**-100; what is found is proved afterwards.
Points come in families: the same values but for one symbol that is doubled, or but for the state.
"""

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from typing import TypeVar

from sympy import Expr, Symbol, cos

from mechanics.checks.ledger_compare import ordered
from mechanics.checks.ledger_motion import put_motion, put_solution
from mechanics.equations import Equations
from mechanics.exact.arithmetic import Number
from mechanics.exact.field import FieldArithmetic
from mechanics.exact.field_number import FieldNumber
from mechanics.exact.field_size import Memory
from mechanics.exact.primes import draw_prime
from mechanics.exact.signals import Inadmissible, Restart
from mechanics.kinematics.manifold import settle, settle_accelerations
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import plain_symbol

BITS = 127
SEED = "blame"
TRIES = 40


@cache
def prime() -> int:
    """The prime; the same in every run, so that blame is.

    Two is a square modulo it (p = 7 mod 8), so that what is positive stays so when it is doubled.
    """
    source = random.Random(SEED)
    while (drawn := draw_prime(BITS, source)) % 8 != 7:
        pass
    return drawn


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
class Point:
    """A point: what expressions in plain symbols are worth there.

    Attributes
    ----------
    scene : Scene
    arithmetic : FieldArithmetic
    family : Family
    attempt : int
        Points of one attempt belong together.
    """

    scene: Scene
    arithmetic: FieldArithmetic
    family: Family
    attempt: int
    _plain: dict[Expr, int] = field(default_factory=dict)

    @property
    def prime(self) -> int:
        """The modulus."""
        return self.arithmetic.prime

    def value(self, expression: Expr) -> int:
        """Residue of an expression, in which rates of coordinates and momenta may stand.

        Raises
        ------
        Inadmissible, Restart
            As the arithmetic does.
        """
        if expression not in self._plain:
            plain = self.scene.plain(momenta_written_out(self.scene, expression))
            number = self.arithmetic.value(plain)
            self._plain[expression] = number.residue
        return self._plain[expression]


@lru_cache(maxsize=8)
def _memory(truth: Equations) -> Memory:
    """What has been learnt about angles; all points of these equations share it."""
    return Memory()


@lru_cache(maxsize=160)
def _point(truth: Equations, family: Family, attempt: int) -> Point:
    scene = truth.scene
    held = not family.free
    source = random.Random(f"{SEED} {attempt} {family.other_state}")
    a = FieldArithmetic(prime(), source, _memory(truth), signs=True)
    given = [s for s in _free(scene, family.moving) if not (held and s in dependent(scene))]
    for symbol in given:
        a.assign(symbol, _drawn(a, scene, symbol, family, attempt))
    for coordinate in scene.q:
        # Angles get their points of the circle in one order; half of them may be asked for.
        if coordinate in given:
            a.value(cos(coordinate / 2))
    if held:
        settle(scene, a)
        if not family.moving:
            settle_accelerations(scene, a)
    for symbol, expression in ordered(scene.definitions):
        a.assign(symbol, a.value(expression))
    if family.moving:
        # Where a quantity is doubled the reactions need not press: the terms grow all the same.
        (put_solution if family.doubled else put_motion)(a, truth)
    return Point(scene, a, family, attempt)


class _Recording(FieldArithmetic):
    """Remembers what is assigned."""

    def assign(self, symbol: Symbol, number: Number) -> None:
        """Let a symbol stand for a number."""
        super().assign(symbol, number)
        self.kept = {*getattr(self, "kept", ()), symbol}


@lru_cache(maxsize=16)
def dependent(scene: Scene) -> frozenset[Symbol]:
    """What the constraints determine, once the rest is chosen."""
    if not scene.constraints:
        return frozenset()
    source, memory = random.Random(SEED), Memory()
    for _ in range(TRIES):
        a = _Recording(prime(), source, memory, signs=True)
        try:
            settle(scene, a)
            settle_accelerations(scene, a)
        except (Restart, Inadmissible):
            continue
        return frozenset(getattr(a, "kept", ()))
    raise Inadmissible("no admissible point was found")


def _free(scene: Scene, moving: bool) -> list[Symbol]:
    """What is drawn: everything but what definitions and the motion give."""
    inputs = [plain_symbol(f, order) for f in scene.inputs for order in range(3)]
    given = [s for s in scene.parameters if s not in scene.definitions]
    found = [*scene.q, *scene.u, *given, *inputs, TIME, *([] if moving else scene.ud)]
    return list(dict.fromkeys(found))


def _drawn(
    a: FieldArithmetic, scene: Scene, symbol: Symbol, family: Family, attempt: int
) -> FieldNumber:
    """The value of a symbol, which its name tells, so that points of a family agree in it."""
    other = family.other_state and symbol in (*scene.q, *scene.u, *scene.ud)
    source = random.Random(f"{SEED} {attempt} {symbol.name}{' other' if other else ''}")
    residue = source.randrange(1, a.prime)
    if symbol.is_nonnegative or symbol.is_negative:
        residue = residue * residue * (-1 if symbol.is_negative else 1) % a.prime
    if family.still and symbol in scene.u:
        return a.rational(0)
    residue = residue * 2 ** family.doubled.count(symbol) % a.prime
    return FieldNumber(a, residue, 1.0, 0.0, 0.0, 0)


def points_like(truth: Equations, point: Point, families: Sequence[Family]) -> list[Point]:
    """The points of other families that belong to a point.

    Raises
    ------
    Inadmissible, Restart
        Where one of them will not do.
    """
    return [_point(truth, family, point.attempt) for family in families]


T = TypeVar("T")


def at_points(truth: Equations, families: Sequence[Family], use: Callable[[list[Point]], T]) -> T:
    """What a function makes of points that belong together; others are tried where it has to be.

    Raises
    ------
    Inadmissible
        When no point will do.
    """
    attempt = 0
    for _ in range(TRIES):
        try:
            return use([_point(truth, family, attempt) for family in families])
        except Restart:
            _point.cache_clear()  # the angles need a finer base: all points are made anew
        except Inadmissible:
            attempt += 1
    raise Inadmissible("no admissible point was found")
