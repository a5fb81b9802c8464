"""Under which change of convention refuted equations are right.

    REFUTED as written,   but with q -> q + pi in all of them: PROVED    ->    "right if ..."

One change, the same for all statements: those that are right have to stay right.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.checks.ledger import check_row
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, MechanicsError, SceneError
from mechanics.exact import Finding
from mechanics.judge.glance import glance
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.reading.conventions import NAMES, Convention, combined_table, conventions
from mechanics.reading.statement import Statement
from mechanics.scene import RigidBody, Scene
from mechanics.scene.published import Published

POINT_MASS = Convention("point mass", "every rod is a point mass at its mass centre", {})


def declared(names: Sequence[str]) -> tuple[str, ...]:
    """Conventions that a person declares.

    Raises
    ------
    InputError
        For a name that is none.
    """
    found = tuple(part.strip() for name in names for part in name.split(",") if part.strip())
    for name in found:
        if name not in NAMES:
            raise InputError(f"convention {name!r}: it can be {', '.join(NAMES)}")
    return found


def right_if(
    truth: Equations, statements: Sequence[Statement], declared_names: Sequence[str] = ()
) -> list[tuple[tuple[Convention, ...], list[Finding]]]:
    """Every change of convention that makes all statements right, and what they are then.

    The simplest comes first; none holds another with more besides. Several are the same change seen
    from elsewhere: a pendulum in a mirror.

    Parameters
    ----------
    truth : Equations
    statements : sequence of Statement
        With a row each; at least one of them is refuted as it is written.
    declared_names : sequence of str
        Where given, only changes made of exactly these are looked at.
    """
    rows = [in_plain_symbols(truth.scene, s.row) for s in statements if s.row is not None]
    held = set().union(*(side.free_symbols for row in rows for side in row.sides))
    changes = [
        change
        for change in _changes(truth.scene)
        if ({c.name for c in change} == set(declared_names) if declared_names
            # What the statements do not hold cannot matter to them.
            else all(c is POINT_MASS or held & c.table.keys() for c in change))
    ]  # fmt: skip
    right: list[tuple[Change, list[Finding]]] = []
    for target, some in _by_target(truth, changes):
        tables = [combined_table(change) for change in some]
        looked = zip(some, tables, glance(target, rows, tables), strict=True)
        for change, table in [(change, table) for change, table, possible in looked if possible]:
            if any(all(c in change for c in simpler) for simpler, _ in right):
                continue
            findings = [_judged(target, _moved(row, table)) for row in rows]
            if all(finding is not None and finding.shown for finding in findings):
                right.append((change, [finding for finding in findings if finding is not None]))
    return right


Change = tuple[Convention, ...]


def judged_under(
    truth: Equations, statements: Sequence[Statement], names: Sequence[str]
) -> tuple[Change, list[Finding]] | None:
    """The first change made of the declared conventions, and what statements are under it.

    None where the scene has nothing that such a convention could be about.
    """
    rows = [in_plain_symbols(truth.scene, s.row) for s in statements if s.row is not None]
    changes = [c for c in _changes(truth.scene) if {one.name for one in c} == set(names)]
    for target, some in _by_target(truth, changes):
        for change in some:
            moved = [_moved(row, combined_table(change)) for row in rows]
            findings = [_judged(target, row) for row in moved]
            if all(finding is not None for finding in findings):
                return change, [finding for finding in findings if finding is not None]
    return None


def _by_target(truth: Equations, changes: list[Change]) -> Iterator[tuple[Equations, list[Change]]]:
    """Changes with what they are compared with: the scene as it is, then with point masses."""
    yield truth, [change for change in changes if POINT_MASS not in change]
    lighter = [change for change in changes if POINT_MASS in change]
    target = _point_masses(truth.scene) if lighter else None
    if target is not None:
        yield target, lighter


def _changes(scene: Scene) -> list[tuple[Convention, ...]]:
    plain = conventions(scene)
    singles = [change for change in plain if len(change) == 1]
    return [*plain, (POINT_MASS,), *((POINT_MASS, *change) for change in singles)]


def each_side(row: Published, change: Callable[[Expr], Expr]) -> Published:
    """A row with every side changed."""
    sides = (s.applyfunc(change) if isinstance(s, MatrixBase) else change(s) for s in row.sides)
    return replace(row, sides=tuple(sides))


def in_plain_symbols(scene: Scene, row: Published) -> Published:
    """A row in plain symbols."""
    return each_side(row, lambda side: momenta_written_out(scene, scene.plain(side)))


def _moved(row: Published, table: dict) -> Published:
    """A row with the person's symbols replaced; rates of what is replaced follow."""
    return each_side(row, lambda side: side.xreplace(table))


def _judged(truth: Equations, row: Published) -> Finding | None:
    try:
        return check_row(truth.scene, row, truth)
    except (InputError, SceneError, ExpressionError):
        return None


@lru_cache(maxsize=32)
def _lighter(scene: Scene) -> Equations | None:
    bodies = tuple(
        replace(body, inertia=0) if isinstance(body, RigidBody) else body for body in scene.bodies
    )
    try:
        return derive(replace(scene, bodies=bodies), "free_body")
    except MechanicsError:
        return None  # without inertia the scene does not move as it should


def _point_masses(scene: Scene) -> Equations | None:
    """The equations of the scene with point masses for its bodies, where that is another scene."""
    rigid = [body for body in scene.bodies if isinstance(body, RigidBody)]
    if not any(body.inertia != 0 for body in rigid):
        return None
    return _lighter(scene)
