"""Under which change of convention refuted equations are right.

    REFUTED as written,   but with q -> q + pi in all of them: PROVED    ->    "right if ..."

One change, the same for all statements: those that are right have to stay right.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

from sympy.matrices import MatrixBase

from mechanics.checks.ledger import check_row
from mechanics.checks.ledger_compare import ordered
from mechanics.checks.ledger_motion import put_motion
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, MechanicsError, SceneError
from mechanics.exact import Arithmetic, Finding
from mechanics.exact.field_trial import Answer, trial
from mechanics.kinematics.manifold import settle
from mechanics.reading.conventions import NAMES, Convention, combined_table, conventions
from mechanics.reading.statement import Statement
from mechanics.scene import RigidBody, Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion

POINT_MASS = Convention("point mass", "every rod is a point mass at its mass centre", {})
QUICK = -20.0
"""Bound, as a power of two, of the first look; what passes it is checked in full."""


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
) -> tuple[tuple[Convention, ...], list[Finding]] | None:
    """The first change of convention that makes all statements right, and what they are then.

    Parameters
    ----------
    truth : Equations
    statements : sequence of Statement
        With a row each; at least one of them is refuted as it is written.
    declared_names : sequence of str
        Where given, only changes made of exactly these are looked at.
    """
    rows = [statement.row for statement in statements if statement.row is not None]
    for change in _changes(truth.scene):
        if declared_names and {c.name for c in change} != set(declared_names):
            continue
        target = truth
        if POINT_MASS in change:
            lighter = _point_masses(truth.scene)
            if lighter is None:
                continue
            target = lighter
        table = combined_table(change)
        moved = [_moved(target.scene, row, table) for row in rows]
        if not all(_glance(target, row) for row in moved):
            continue
        findings = [_judged(target, row) for row in moved]
        if all(finding is not None and finding.shown for finding in findings):
            return change, [finding for finding in findings if finding is not None]
    return None


def _changes(scene: Scene) -> list[tuple[Convention, ...]]:
    plain = conventions(scene)
    singles = [change for change in plain if len(change) == 1]
    return [*plain, (POINT_MASS,), *((POINT_MASS, *change) for change in singles)]


def _moved(scene: Scene, row: Published, table: dict) -> Published:
    """A row with the person's symbols replaced; rates of what is replaced follow."""

    def side(value: object) -> object:
        if isinstance(value, MatrixBase):
            return value.applyfunc(side)
        return scene.plain(value).xreplace(table)

    return replace(row, sides=tuple(side(value) for value in row.sides))


def _glance(truth: Equations, row: Published) -> bool:
    """Whether an equation of motion can be right: its value at one point of a field."""
    if not isinstance(row.quantity, EquationOfMotion):
        return True

    def experiment(a: Arithmetic) -> list:
        settle(truth.scene, a)
        for symbol, expression in ordered(truth.scene.definitions):
            a.assign(symbol, a.value(expression))
        put_motion(a, truth)
        first, *others = row.sides
        return [(a.value(first), a.value(side)) for side in others]

    try:
        return trial(experiment, QUICK, None).answer is Answer.ZERO
    except (ExpressionError, ValueError):
        return True  # the full check will say what is wrong


def _judged(truth: Equations, row: Published) -> Finding | None:
    try:
        return check_row(truth.scene, row, truth)
    except (InputError, SceneError, ExpressionError):
        return None


@lru_cache(maxsize=8)
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
