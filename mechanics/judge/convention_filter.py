"""Which of many changes of convention can help: all of them at one point of a field, at once.

    statement, its symbols standing for others, at the point  =  what is derived there

The motion is put in once for all changes, and no expression is built: symbols and angles get the
values of what they stand for. What passes has to be proved; what does not is wrong, but for a
chance of 2^-80.
"""

from collections.abc import Mapping, Sequence

from sympy import Expr, Symbol
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import define
from mechanics.checks.ledger_energy import SHARES, energy_of
from mechanics.checks.ledger_motion import put_motion
from mechanics.checks.manifold import project
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kernel.field import Inadmissible
from mechanics.program import Program
from mechanics.program.interpret import include
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.published import Published
from mechanics.symbolic import Arithmetic, Number
from mechanics.symbolic.point import Point

Table = Mapping[Symbol, Expr]
Typed = tuple[Program, dict[str, Symbol]]
"""Expressions as a program, and the symbols that its inputs are."""


def may_hold(truth: Equations, rows: Sequence[Published], tables: Sequence[Table]) -> list[bool]:
    """Whether all rows can be right under each change.

    Parameters
    ----------
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
    a, scene = Arithmetic(), truth.scene
    try:
        project(a, truth.kinematics, accelerations=not moving)
        define(a, scene)
        if moving:
            put_motion(a, truth)
        derived = [_derived(a, truth, row) for row in rows]
        typed = [_read([e for side in _entries(row) for e in side]) for row in rows]
        # What is there before any change is evaluated first: its roots are not the changes'.
        _, point = a.residues([*a.assigned.values(), *(n for some in derived for n in some)])
    except (ExpressionError, ValueError, Inadmissible):
        return  # the full check will say what is wrong
    every = list(zip(rows, typed, derived, strict=True))
    for k, table in enumerate(tables):
        if possible[k] and any(_differs(a, point, scene, *one, table) for one in every):
            possible[k] = False


def _differs(
    a: Arithmetic, point: Point, scene: Scene, row: Published, typed: Typed,
    derived: Sequence[Number], table: Table,
) -> bool:  # fmt: skip
    """Whether a row is not right at a point."""
    before = _unsure(point)
    try:
        sides = _sides(a, scene, row, typed, table)
        targets, sides = (derived, sides) if derived else (sides[0], sides[1:])
        wrong = any(
            point.value(left - right) != 0
            for side in sides
            for left, right in zip(side, targets, strict=True)
        )
    except (Inadmissible, ExpressionError):
        return False
    # Roots and moduli have a sign, which one point does not tell.
    return wrong and _unsure(point) == before


def _unsure(point: Point) -> tuple[int, int]:
    return point.domain.square_roots, len(point.domain.kinks)


def _derived(a: Arithmetic, truth: Equations, row: Published) -> list[Number]:
    """What every side has to be; nothing where the sides have to be each other."""
    match row.quantity:
        case q.ReactionValue(name=name):
            return [a.value(truth.scene.reaction(name).symbol)]
        case q.KineticEnergy():
            return [a.value(energy_of(truth.kinematics, row.quantity))]
        case q.MassMatrix():
            return [a.value(entry) for entry in truth.kinematics.mass_matrix]
        case q.PotentialEnergy() | q.TotalEnergy() | q.Lagrangian():
            energy = energy_of(truth.kinematics, row.quantity)
            (there,) = _values(a, _read([energy]), _elsewhere(truth.scene))
            return [a.value(energy) - there]
    return []


def _entries(row: Published) -> list[list[Expr]]:
    """The typed sides entry by entry."""
    return [list(s) if isinstance(s, MatrixBase) else [s] for s in row.sides]


def _sides(
    a: Arithmetic, scene: Scene, row: Published, typed: Typed, table: Table
) -> list[list[Number]]:  # fmt: skip
    """Values of the typed sides, entry by entry; of an energy less what it is elsewhere."""
    values = iter(_values(a, typed, table))
    if type(row.quantity) in SHARES:
        there = _elsewhere(scene)
        moved = there | {s: expr.xreplace(there) for s, expr in table.items()}
        pairs = zip(values, _values(a, typed, moved), strict=True)
        values = iter([here - elsewhere for here, elsewhere in pairs])
    return [[next(values) for _ in side] for side in _entries(row)]


def _elsewhere(scene: Scene) -> dict[Symbol, Expr]:
    """Another point with the same parameters."""
    moving = (*scene.q, *scene.u, *scene.ud)
    return {s: Symbol(f"{s.name} elsewhere", real=True) for s in moving}


def _read(expressions: Sequence[Expr]) -> Typed:
    """Expressions as a program, and its inputs, in the order of their names."""
    a = Arithmetic()
    program = a.builder.program({"values": [a.value(expression) for expression in expressions]})
    return program, {name: s for s, name in sorted(a.inputs.items(), key=lambda item: item[1])}


def _values(a: Arithmetic, typed: Typed, table: Table) -> Sequence[Number]:
    """What expressions are worth with their symbols standing for others."""
    program, symbols = typed
    given = {name: a.value(table.get(s, s)) for name, s in symbols.items()}
    return include(a.builder, program, given)["values"]
