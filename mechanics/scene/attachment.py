"""Whether a point or a direction is fixed in a body: what moves it against the body's frame.

c = R^T (r_P - r_C)         constant where P is a point of the body with the centre C
d_B = R^T d                 constant where d is fixed in the body
"""

from collections.abc import Set
from itertools import pairwise

from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.scene.bodies import RigidBody
from mechanics.scene.declaration import Declaration
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.symbols import by_name, name_of
from mechanics.symbolic import canonical


def moved_by(scene: Declaration, body: str | None, point: Point) -> str:
    """Names of the coordinates that move a point against a body; empty where none does.

    Parameters
    ----------
    body : str or None
        None for the ground, which inputs may move.
    """
    start, frame = scene.origin, frame_of(scene, body)
    if body is not None:
        start = scene.body(body).centre
    if not moving(frame, start, point, set(scene.coordinates)):
        return ""
    # What one step brings in another may take away.
    gap = scene.rotation(frame).T * (scene.position(point) - scene.position(start))
    found = set().union(*(canonical(entry).free_symbols for entry in gap)) & set(scene.q)
    return ", ".join(symbol.name for symbol in sorted(found, key=by_name))


def turned_by(scene: Declaration, body: str | None, direction: Vector) -> str:
    """Names of the coordinates that turn a direction against a body; empty where none does.

    Parameters
    ----------
    body : str or None
        None for the ground, which inputs may turn.
    """
    frame, counted = frame_of(scene, body), set(scene.coordinates)
    found: set[Symbol] = set()
    for own, column in components(direction):
        if not _turns(frame, own) & counted:
            continue
        for outer, inner in reversed([*pairwise(frame_path(frame, own))]):
            column = (relative_rotation(outer, inner) * column).applyfunc(
                lambda entry: canonical(scene.plain(entry))
            )
        found |= column.free_symbols & set(scene.q)
    return ", ".join(symbol.name for symbol in sorted(found, key=by_name))


def frame_of(scene: Declaration, body: str | None) -> ReferenceFrame:
    """Of a body; the inertial one for the ground and for particles."""
    own = None if body is None else scene.body(body)
    return own.frame if isinstance(own, RigidBody) else scene.frame


def moving(
    frame: ReferenceFrame, start: Point, end: Point, counted: Set[Expr] | None = None
) -> str:
    """The functions in the first step that moves a point against another; empty if none does."""
    for parent, point in pairwise(point_path(start, end)):
        for own, column in components(step_vector(parent, point)):
            found = column.atoms(AppliedUndef) | _turns(frame, own)
            found = found if counted is None else found & counted
            if found:
                return ", ".join(sorted(map(name_of, found)))
    return ""


def turning(
    first: ReferenceFrame, second: ReferenceFrame, counted: Set[Expr] | None = None
) -> str:  # fmt: skip
    """The functions that turn one frame against another; empty if none does."""
    found = _turns(first, second)
    return ", ".join(sorted(map(name_of, found if counted is None else found & counted)))


def _turns(first: ReferenceFrame, second: ReferenceFrame) -> set[Expr]:
    return {
        function
        for parent, child in pairwise(frame_path(first, second))
        for function in relative_rotation(parent, child).atoms(AppliedUndef)
    }
