"""Which of many changes of convention can help: all of them at one point of a field, at once.

    statement, its symbols standing for others, at the point  =  what is derived there

The motion is put in once for all changes, and no expression is built: symbols and angles get the
values of what they stand for. What passes has to be proved; what does not is wrong, but for a
chance of 2^-80.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache

from sympy import Expr, Symbol, cos, sin
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import settle_defined
from mechanics.checks.ledger_energy import SHARES, kinetic_energy, mass_matrix
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Number
from mechanics.exact.field_trial import look
from mechanics.exact.signals import Inadmissible
from mechanics.kinematics.manifold import settle_accelerations
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.potential import potential
from mechanics.scene.published import Published

Pairs = list[tuple[Number, Number]]
Table = Mapping[Symbol, Expr]


def glance(truth: Equations, rows: Sequence[Published], tables: Sequence[Table]) -> list[bool]:
    """Whether all rows can be right under each change.

    Parameters
    ----------
    truth : Equations
    rows : sequence of Published
        With sides in plain symbols.
    tables : sequence of mapping of Symbol to Expr
        What the symbols of the rows stand for, one for each change.

    Returns
    -------
    list of bool
        True too where the look does not tell: roots, which have two signs, and quantities that only
        the ledger compares.
    """
    possible = [True] * len(tables)
    for moving in (True, False):
        some = [r for r in rows if isinstance(r.quantity, MOVING) is moving]
        if some:
            _look(truth, some, tables, possible, moving)
    return possible


MOVING = (q.EquationOfMotion, q.ReactionValue)
"""What holds along the motion only."""


def _look(
    truth: Equations, rows: Sequence[Published], tables: Sequence[Table], possible: list[bool],
    moving: bool,
) -> None:  # fmt: skip
    """Rule out changes by rows along the motion, or by all others."""
    wrong: list[int] = []

    def experiment(a: Arithmetic) -> Pairs:
        settle_defined(truth.scene, a)
        if moving:
            put_motion(a, truth)
        else:
            settle_accelerations(truth.scene, a)
        derived = [_derived(a, truth.scene, row) for row in rows]
        pairs = list(zip(rows, derived, strict=True))
        wrong[:] = [
            k
            for k, table in enumerate(tables)
            if possible[k] and any(_differs(a, truth.scene, *pair, table) for pair in pairs)
        ]
        return [(a.rational(0), a.rational(0))]

    try:
        look(experiment)
    except (ExpressionError, ValueError):
        return  # the full check will say what is wrong
    for k in wrong:
        possible[k] = False


def _differs(
    a: Arithmetic, scene: Scene, row: Published, derived: Sequence[Number], table: Table
) -> bool:
    """Whether a row is not right at a point."""
    before = _unsure(a)
    try:
        sides = _sides(a, scene, row, table)
        targets, sides = (derived, sides) if derived else (sides[0], sides[1:])
        wrong = any(
            not a.is_zero(left - right)
            for side in sides
            for left, right in zip(side, targets, strict=True)
        )
    except (Inadmissible, ExpressionError):
        return False
    # Roots and moduli have a sign, which one point does not tell.
    return wrong and _unsure(a) == before


def _unsure(a: Arithmetic) -> tuple[int, int]:
    return getattr(a, "square_roots", 0), len(getattr(a, "kinks", ()))


def _derived(a: Arithmetic, scene: Scene, row: Published) -> list[Number]:
    """What every side has to be; nothing where the sides have to be each other."""
    match row.quantity:
        case q.ReactionValue(name=name):
            return [a.value(scene.reaction(name).symbol)]
        case q.KineticEnergy():
            return [a.value(kinetic_energy(scene))]
        case q.MassMatrix():
            return [a.value(entry) for entry in mass_matrix(scene)]
        case q.PotentialEnergy() | q.TotalEnergy() | q.Lagrangian():
            kinetic, stored = SHARES[type(row.quantity)]
            energy = kinetic * kinetic_energy(scene) + stored * potential(scene)
            return [a.value(energy) - _value(a, energy, _elsewhere(scene))]
    return []


def _sides(a: Arithmetic, scene: Scene, row: Published, table: Table) -> list[list[Number]]:
    """Values of the typed sides, entry by entry; of an energy less what it is elsewhere."""
    entries = [list(s) if isinstance(s, MatrixBase) else [s] for s in row.sides]
    values = [[_value(a, entry, table) for entry in side] for side in entries]
    if type(row.quantity) not in SHARES:
        return values
    there = _elsewhere(scene)
    moved = there | {s: expr.xreplace(there) for s, expr in table.items()}
    return [[side[0] - _value(a, e[0], moved)] for side, e in zip(values, entries, strict=True)]


@lru_cache(maxsize=32)
def _elsewhere(scene: Scene) -> dict[Symbol, Expr]:
    """Another point with the same parameters."""
    moving = (*scene.q, *scene.u, *scene.ud)
    return {s: Symbol(f"{s.name} elsewhere", real=True) for s in moving}


def _value(a: Arithmetic, expr: Expr, table: Table) -> Number:
    """What an expression is worth with its symbols standing for others."""
    symbols, angles = _held(expr)
    memo: dict[object, Number] = {s: a.value(table.get(s, s)) for s in symbols}
    for angle in angles:
        moved = angle.xreplace(table)
        memo["circle", angle] = (a.value(cos(moved)), a.value(sin(moved)))
    kept, a.memo = a.memo, memo
    try:
        return a.value(expr)
    finally:
        a.memo = kept


@lru_cache(maxsize=256)
def _held(expr: Expr) -> tuple[tuple[Symbol, ...], tuple[Expr, ...]]:
    """Symbols, and arguments of sines and cosines, in an order that no hash decides."""
    angles = {function.args[0] for function in expr.atoms(TrigonometricFunction)}
    return tuple(sorted(expr.free_symbols, key=str)), tuple(sorted(angles, key=str))
