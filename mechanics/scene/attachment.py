"""Whether a point stays where it is on a body: what moves it against the body's frame.

c = R^T (r_P - r_C)         constant where P is a point of the body with the centre C
"""

from collections.abc import Set
from itertools import pairwise

from sympy import Expr
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Point, ReferenceFrame

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
    scene : Declaration
    body : str or None
        None for the ground, which inputs may move.
    point : Point
    """
    start, frame = scene.origin, scene.frame
    if body is not None:
        own = scene.body(body)
        start, frame = own.centre, own.frame if isinstance(own, RigidBody) else frame
    if not moving(frame, start, point, set(scene.coordinates)):
        return ""
    # What one step brings in another may take away.
    gap = scene.rotation(frame).T * (scene.position(point) - scene.position(start))
    found = set().union(*(canonical(entry).free_symbols for entry in gap)) & set(scene.q)
    return ", ".join(symbol.name for symbol in sorted(found, key=by_name))


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


def turning(first: ReferenceFrame, second: ReferenceFrame) -> str:
    """What turns one frame against another; empty if nothing does."""
    return ", ".join(sorted(map(name_of, _turns(first, second))))


def _turns(first: ReferenceFrame, second: ReferenceFrame) -> set[Expr]:
    return {
        function
        for parent, child in pairwise(frame_path(first, second))
        for function in relative_rotation(parent, child).atoms(AppliedUndef)
    }
