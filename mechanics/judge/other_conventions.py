"""Under which change of convention refuted equations are right.

    REFUTED as written,   but with q -> q + pi in all of them: PROVED    ->    "right if ..."

One change, the same for all statements: those that are right have to stay right.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from mechanics.checks.admissible import check_admissible
from mechanics.checks.ledger import check_row
from mechanics.claims.convention import POINT_MASS, Change, Table
from mechanics.claims.conventions import combined_table, conventions
from mechanics.claims.statement import Statement
from mechanics.crosscheck.routes import derive_textbook
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, MechanicsError, SceneError
from mechanics.judge.convention_filter import may_hold
from mechanics.judge.converted_rows import in_plain_symbols, moved, moves_more
from mechanics.kernel import Finding
from mechanics.routes import free_body
from mechanics.routes.derivation import as_program
from mechanics.scene import RigidBody, Scene
from mechanics.scene.published import Published


def helpful_changes(truth: Equations, statements: Sequence[Statement]) -> list[Change]:
    """Every change of convention that makes all statements right.

    The simplest comes first; none holds another with more besides. Several are the same change seen
    from elsewhere: a pendulum in a mirror.

    Parameters
    ----------
    statements : sequence of Statement
        With a row each; at least one of them is refuted as it is written.
    """
    rows = _distinct([s.row for s in statements if s.row is not None])
    changes = _changes(truth.scene)
    if not any(moves_more(truth.scene, row) for row in rows):
        written = [in_plain_symbols(truth.kinematics, row) for row in rows]
        held = set().union(*(side.free_symbols for row in written for side in row.sides))
        # What the statements do not hold cannot matter to them.
        trimmed = (
            tuple(c for c in x if c.kind != "size" or held & c.table.keys()) for x in changes
        )
        whole = (x for x in trimmed if all(c is POINT_MASS or held & c.table.keys() for c in x))
        changes = list({tuple(c.name for c in x): x for x in whole if x}.values())
    plain = _likely(truth, rows, [change for change in changes if POINT_MASS not in change])
    right = _with_shown(truth, rows, plain, [])
    if (lighter := _without_inertia(truth)) is not None:
        likely = _likely(lighter, rows, [change for change in changes if POINT_MASS in change])
        others = [change for change in likely if not _holds_one(change, right)]
        if others and (target := _point_masses(truth.scene)) is not None:
            right = _with_shown(target, rows, others, right)
    return right


def _distinct(rows: Sequence[Published]) -> list[Published]:
    """Rows without those that say what an earlier one says."""
    distinct: list[Published] = []
    for row in rows:
        if all((row.quantity, row.sides) != (one.quantity, one.sides) for one in distinct):
            distinct.append(row)
    return distinct


def _with_shown(
    target: Equations, rows: Sequence[Published], changes: Iterable[Change], right: list[Change]
) -> list[Change]:
    """What is right, and changes besides under which all rows are shown."""
    for change in changes:
        if not _holds_one(change, right):
            findings = (_judged(target, row, combined_table(change)) for row in rows)
            if all(finding is not None and finding.shown for finding in findings):
                right = [*right, change]
    return right


def _holds_one(change: Change, simpler: Sequence[Change]) -> bool:
    """Whether a change is one of others, with more besides."""
    return any(all(c in change for c in one) for one in simpler)


def targets_of(truth: Equations, changes: Sequence[Change]) -> list[Equations | None]:
    """What statements are compared with under changes; None where the scene has no such thing."""
    lighter = _point_masses(truth.scene) if any(POINT_MASS in c for c in changes) else None
    return [lighter if POINT_MASS in change else truth for change in changes]


def _likely(truth: Equations, rows: Sequence[Published], changes: list[Change]) -> Iterator[Change]:
    """Changes under which all rows can be right, at a point of a field."""
    more = [row for row in rows if moves_more(truth.scene, row)]
    few = [row for row in rows if not moves_more(truth.scene, row)]
    quick = [in_plain_symbols(truth.kinematics, row) for row in few]
    tables = [combined_table(change) for change in changes]
    looked = may_hold(truth, quick, tables) if quick else [True] * len(tables)
    for change, table, possible in zip(changes, tables, looked, strict=True):
        if possible and all(_possible(truth, row, table) for row in more):
            yield change


def _possible(truth: Equations, row: Published, table: Table) -> bool:
    """Whether a row of whom more than symbols changes can be right."""
    try:
        plain = in_plain_symbols(truth.kinematics, moved(truth.scene, row, table))
    except (InputError, SceneError, ExpressionError):
        return False
    return all(may_hold(truth, [plain], [{}]))


def _changes(scene: Scene) -> list[Change]:
    plain = conventions(scene)
    singles = [change for change in plain if len(change) == 1]
    return [*plain, (POINT_MASS,), *((POINT_MASS, *change) for change in singles)]


def _judged(truth: Equations, row: Published, table: Table) -> Finding | None:
    try:
        return check_row(truth.scene, moved(truth.scene, row, table), truth)
    except (InputError, SceneError, ExpressionError):
        return None


def _without_inertia(truth: Equations) -> Equations | None:
    """The equations, as a program, of the bodies as point masses; None as for `_point_masses`."""
    if not _heavy(truth.scene):
        return None
    mechanism = truth.kinematics.mechanism
    none = ((mechanism.builder.zero,) * 3,) * 3
    bodies = (
        body if body.inertia is None else replace(body, inertia=none, scalar=True)
        for body in mechanism.bodies
    )
    lighter = replace(mechanism, bodies=tuple(bodies))
    try:
        check_admissible(lighter)
        return as_program(truth.scene, lighter, free_body.derive(lighter))
    except MechanicsError:
        return None


def _point_masses(scene: Scene) -> Equations | None:
    """The equations of the scene with point masses for its bodies, where that is another scene."""
    if not _heavy(scene):
        return None
    bodies = tuple(
        replace(body, inertia=0) if isinstance(body, RigidBody) else body for body in scene.bodies
    )
    try:
        return derive_textbook(replace(scene, bodies=bodies), "free_body")
    except MechanicsError:
        return None  # without inertia the scene does not move as it should


def _heavy(scene: Scene) -> bool:
    """Whether a body has a moment of inertia."""
    return any(isinstance(body, RigidBody) and body.inertia != 0 for body in scene.bodies)
