"""From which direction a scene counts its angles, and which way round.

c(q)  where a mass centre is        arm = -d2c/dq2        right (arm x dc/dq): counterclockwise

An angle is counted from a fixed direction where some dc/dq holds no other angle. The angle of a
joint is not: the other arm's direction is in it. In space only the height of c tells: a top's theta
is counted from the vertical, its azimuth from no direction that gravity knows.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain

from sympy import Dummy, Expr, Matrix, S, Symbol

from mechanics.claims.kinds import angular
from mechanics.errors import ExpressionError
from mechanics.scene import Gravity, Scene
from mechanics.symbolic import is_zero

DIRECTIONS = ("right horizontal", "upward vertical", "left horizontal", "downward vertical")
"""By quarter turns counterclockwise from the right."""

AXES = (Matrix([1, 0, 0]), Matrix([0, 1, 0]), Matrix([0, 0, 1]))


@dataclass(frozen=True)
class Counted:
    """How a scene counts one angle.

    Attributes
    ----------
    symbol : Symbol
    sense : int
        1 where it grows counterclockwise, -1 clockwise, 0 where nothing tells.
    quarter : int or None
        Where it is zero, a place in `DIRECTIONS`; None for the angle of a joint, and where nothing
        points along an axis there.
    fixed : bool
        Whether it is counted from a fixed direction.
    planar : bool
        Whether the scene keeps to a plane; in space no angle has a sense.
    """

    symbol: Symbol
    sense: int
    quarter: int | None
    fixed: bool
    planar: bool


def counted(scene: Scene) -> tuple[Counted, ...]:
    """How a scene counts its angles, in the order of its coordinates.

    Seen with the first axis of the plane to the right and gravity downwards; without gravity in the
    plane, with its second axis upwards.
    """
    turned = angular(scene)
    angles = tuple(q for q in scene.q if q in turned)
    places = [scene.position(body.centre) for body in scene.bodies]
    view = _view(scene, places)
    if len(view) == 2:
        flat = [Matrix([axis.dot(place) for axis in view]) for place in places]
        return tuple(_in_plane(scene, q, angles, flat, view) for q in angles)
    heights = [axis.dot(place) for axis in view for place in places]
    return tuple(_in_space(scene, q, angles, heights) for q in angles)


def _view(scene: Scene, places: list[Matrix]) -> tuple[Matrix, ...]:
    """To the right and upwards in the plane of a scene; upwards alone, or nothing, in space."""
    moving = {*scene.q}
    plane = [axis for axis in AXES if any(axis.dot(p).free_symbols & moving for p in places)]
    fields = [scene.vector(load.field) for load in scene.loads if isinstance(load, Gravity)]
    along = [axis for axis in AXES if any(axis.dot(field) != 0 for field in fields)]
    up: Matrix | None = None
    if len(along) == 1:
        pulls = [along[0].dot(field) for field in fields]
        if all(pull.is_negative for pull in pulls):
            up = along[0]
        elif all(pull.is_positive for pull in pulls):
            up = -along[0]
    elif along:
        return ()  # gravity is askew
    if len(plane) != 2:
        return () if up is None else (up,)
    if up is None or along[0] not in plane:
        return (plane[0], plane[1])
    return (plane[0] if plane[1] == along[0] else plane[1], up)


def _in_plane(
    scene: Scene, q: Symbol, angles: tuple[Symbol, ...], places: list[Matrix],
    view: tuple[Matrix, ...],
) -> Counted:  # fmt: skip
    """An angle by the first body that it moves, where that body's arm shows its direction."""
    zero = _zero(scene, angles)
    senses, quarters, fixed = [], [], False
    for place in places:
        slope = _slope(place, q)
        arm = -_slope(slope, q)
        if arm.xreplace(zero).is_zero_matrix:
            continue
        there, ahead = arm.xreplace(zero), slope.xreplace(zero)
        senses.append(_sign(there[0] * ahead[1] - there[1] * ahead[0]))
        if not (_alone(slope, q, angles) and _circular(arm, q)):
            continue
        fixed = True
        quarters.append(_quarter(there))
    turns = _turns(scene, q, zero, view)
    sense = next((s for s in chain(senses, turns) if s), 0)
    return Counted(q, sense, next((k for k in quarters if k is not None), None), fixed, True)


def _turns(
    scene: Scene, q: Symbol, zero: dict[Symbol, Expr], view: tuple[Matrix, ...]
) -> Iterator[int]:
    """Which way the bodies turn that an angle turns."""
    right, up = view
    for body in scene.bodies:
        if hasattr(body, "frame"):
            rotation = scene.rotation(body.frame)
            spin = _slope(rotation, q).xreplace(zero) * rotation.T.xreplace(zero)
            yield _sign(up.dot(spin * right))


def _in_space(scene: Scene, q: Symbol, angles: tuple[Symbol, ...], heights: list[Expr]) -> Counted:
    """An angle by the first height that it alone changes."""
    zero = _zero(scene, angles)
    for height in heights:
        slope = height.diff(q)
        arm = -slope.diff(q).xreplace(zero)
        flat = slope.xreplace(zero) == 0
        turns = -Matrix([slope.diff(q)])
        if slope != 0 and _alone(Matrix([slope]), q, angles) and _circular(turns, q):
            up = _sign(arm) if flat else 0
            return Counted(q, 0, {1: 1, -1: 3}.get(up), True, False)
    return Counted(q, 0, None, False, False)


def _zero(scene: Scene, angles: tuple[Symbol, ...]) -> dict[Symbol, Expr]:
    """All angles zero, and lengths that are coordinates positive, as people mean them."""
    return {q: S.Zero if q in angles else Dummy(positive=True) for q in scene.q}


def _slope(matrix: Matrix, q: Symbol) -> Matrix:
    return matrix.applyfunc(lambda entry: entry.diff(q))


def _circular(arm: Matrix, q: Symbol) -> bool:
    """Whether an arm turns by the angle itself, no multiple of it: arm'' = -arm."""
    try:
        return not arm.is_zero_matrix and all(is_zero(e.diff(q, 2) + e) for e in arm)
    except ExpressionError:
        return False


def _alone(slope: Matrix, q: Symbol, angles: tuple[Symbol, ...]) -> bool:
    """Whether no other angle is in how a place moves with an angle."""
    try:
        return all(is_zero(entry.diff(other)) for other in angles if other != q for entry in slope)
    except ExpressionError:
        return False


def _sign(value: Expr) -> int:
    return 1 if value.is_positive else -1 if value.is_negative else 0


def _quarter(arm: Matrix) -> int | None:
    """Which way an arm points; None where that is along no axis."""
    right, up = map(_sign, arm)
    if arm[0] != 0 and arm[1] != 0:
        return None
    return {(1, 0): 0, (0, 1): 1, (-1, 0): 2, (0, -1): 3}.get((right, up))
