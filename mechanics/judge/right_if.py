"""Under which change of convention refuted equations are right.

    REFUTED as written,   but with q -> q + pi in all of them: PROVED    ->    "right if ..."

One change, the same for all statements: those that are right have to stay right.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

from mechanics.checks.ledger import check_row
from mechanics.crosscheck.routes import derive_textbook
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, MechanicsError, SceneError
from mechanics.judge.glance import glance
from mechanics.judge.moved import in_plain_symbols, moved, moves_more
from mechanics.kernel import Finding
from mechanics.reading.convention import POINT_MASS, Change
from mechanics.reading.conventions import combined_table, conventions
from mechanics.reading.statement import Statement
from mechanics.scene import RigidBody, Scene
from mechanics.scene.published import Published


def right_if(truth: Equations, statements: Sequence[Statement]) -> list[Change]:
    """Every change of convention that makes all statements right.

    The simplest comes first; none holds another with more besides. Several are the same change seen
    from elsewhere: a pendulum in a mirror.

    Parameters
    ----------
    truth : Equations
    statements : sequence of Statement
        With a row each; at least one of them is refuted as it is written.
    """
    rows = [s.row for s in statements if s.row is not None]
    few = [row for row in rows if not moves_more(truth.scene, row)]
    quick = [in_plain_symbols(truth.kinematics, row) for row in few]
    held = set().union(*(side.free_symbols for row in quick for side in row.sides))
    changes = _changes(truth.scene)
    if len(quick) == len(rows):
        # What the statements do not hold cannot matter to them.
        trimmed = (
            tuple(c for c in x if c.kind != "size" or held & c.table.keys()) for x in changes
        )
        whole = (x for x in trimmed if all(c is POINT_MASS or held & c.table.keys() for c in x))
        changes = list({tuple(c.name for c in x): x for x in whole if x}.values())
    right: list[Change] = []
    for target, some in _by_target(truth, changes):
        tables = [combined_table(change) for change in some]
        looked = glance(target, quick, tables) if quick else [True] * len(tables)
        for change, table, possible in zip(some, tables, looked, strict=True):
            if not possible or any(all(c in change for c in simpler) for simpler in right):
                continue
            findings = [_judged(target, row, table) for row in rows]
            if all(finding is not None and finding.shown for finding in findings):
                right.append(change)
    return right


def target_of(truth: Equations, change: Change) -> Equations | None:
    """What statements are compared with under a change; None where the scene has no such thing."""
    return _point_masses(truth.scene) if POINT_MASS in change else truth


def _by_target(truth: Equations, changes: list[Change]) -> Iterator[tuple[Equations, list[Change]]]:
    """Changes with what they are compared with: the scene as it is, then with point masses."""
    yield truth, [change for change in changes if POINT_MASS not in change]
    lighter = [change for change in changes if POINT_MASS in change]
    target = _point_masses(truth.scene) if lighter else None
    if target is not None:
        yield target, lighter


def _changes(scene: Scene) -> list[Change]:
    plain = conventions(scene)
    singles = [change for change in plain if len(change) == 1]
    return [*plain, (POINT_MASS,), *((POINT_MASS, *change) for change in singles)]


def _judged(truth: Equations, row: Published, table: dict) -> Finding | None:
    try:
        there = moved(truth.scene, row, table)
        if moves_more(truth.scene, row):
            plain = in_plain_symbols(truth.kinematics, there)
            if not all(glance(truth, [plain], [{}])):
                return None
        return check_row(truth.scene, there, truth)
    except (InputError, SceneError, ExpressionError):
        return None


@lru_cache(maxsize=32)
def _lighter(scene: Scene) -> Equations | None:
    bodies = tuple(
        replace(body, inertia=0) if isinstance(body, RigidBody) else body for body in scene.bodies
    )
    try:
        return derive_textbook(replace(scene, bodies=bodies), "free_body")
    except MechanicsError:
        return None  # without inertia the scene does not move as it should


def _point_masses(scene: Scene) -> Equations | None:
    """The equations of the scene with point masses for its bodies, where that is another scene."""
    rigid = [body for body in scene.bodies if isinstance(body, RigidBody)]
    if not any(body.inertia != 0 for body in rigid):
        return None
    return _lighter(scene)
