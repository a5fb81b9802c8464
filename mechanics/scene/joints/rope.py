"""A rope over massless pulleys: one length, one tension.

    sum d_k = length                   d_k = |r_{k+1} - r_k|, or along_k . (r_{k+1} - r_k)
    power of the tension T = -T sum d_k'

The rope runs straight from point to point. Where two neighbours are points of one body, it lies on
that body, on its pulley, and its length there does not change. Each straight part pulls its two
ends towards each other with the same T, which is positive where the rope is taut.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

from sympy import Expr, S
from sympy.physics.vector import Point, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import kind_of, scalar
from mechanics.scene.joints.arguments import arguments
from mechanics.scene.reactions import Constraint, Reaction, holonomic
from mechanics.scene.rotations import Rotation

End = tuple[str | None, Point]
"""A body, None for the ground, and a point of it."""


@dataclass(frozen=True, eq=False)
class Rope:
    """What ties bodies by a length; see `rope`.

    Attributes
    ----------
    name : str
    ends : tuple of (str or None, Point)
        Along the rope.
    reactions : tuple of one Reaction
        The tension, in N.
    constraints : tuple of one Constraint
    coordinates, rotations, own : empty tuples
        Of joints.
    given : mapping of str to Any
        What the user gave, as of a `Joint`.
    """

    name: str
    ends: tuple[End, ...]
    reactions: tuple[Reaction, ...]
    constraints: tuple[Constraint, ...]
    coordinates: tuple[Expr, ...] = ()
    rotations: tuple[Rotation, ...] = ()
    own: tuple[tuple[Expr, Expr, Expr], ...] = ()
    given: Mapping[str, Any] = field(default_factory=dict)


def rope(
    name: str, *ends: tuple[str | None, Point], length: Expr,
    along: Sequence[Vector | None] | None = None,
) -> Rope:  # fmt: skip
    """A rope, inextensible and without mass, over massless pulleys that turn freely.

    Parameters
    ----------
    name : str
        Also of its tension.
    ends : (body, Point)
        Where it begins, where it reaches and leaves each pulley, and where it ends; a body is None
        for the ground. A pulley is a point or two of the body that carries it.
    length : Expr
        Of its straight parts together, in m.
    along : sequence of Vector or None, optional
        For each straight part that stays on a line through its first point the unit vector from
        there to its second point; None for others.

    Raises
    ------
    SceneError
        Names the rope, and what is missing.

    Examples
    --------
    Atwood's machine: a pulley on the ground, a mass on each side.

    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, (x, y) = ReferenceFrame("N"), Point("O"), dynamicsymbols("x y")
    >>> one, two = O.locatenew("A", -x * N.y), O.locatenew("B", -y * N.y)
    >>> line = rope("T", ("one", one), (None, O), ("two", two), length=1, along=(N.y, -N.y))
    >>> line.constraints[0].expression
    x(t) + y(t) - 1
    """
    title = f"rope {name}"
    for end in ends:
        if not isinstance(end, tuple | list) or len(end) != 2 or not isinstance(end[1], Point):
            raise SceneError(
                f"{title}: {kind_of(end)} is no end: give a body and a point of it, as in"
                ' ("mass", P), or (None, P) for the ground'
            )
    parts = [(one, two) for one, two in pairwise(ends) if one[0] != two[0]]
    if not parts:
        raise SceneError(f"{title}: it ties no two bodies: give the ends from body to body")
    directions = [None] * len(parts) if along is None else list(along)
    if len(directions) != len(parts):
        raise SceneError(
            f"{title}: {len(directions)} directions for {len(parts)} straight parts: give one each"
        )
    total, pulls = S.Zero, []
    for ((one, first), (two, second)), direction in zip(parts, directions, strict=True):
        span = _between(title, first, second)
        if direction is None and sum(entry != 0 for column, _ in span.args for entry in column) < 2:
            raise SceneError(
                f"{title}: {first.name} and {second.name} stay on one line: give the direction from"
                f" one to the other in along=, as in along=({', '.join(['frame.y'] * len(parts))})"
            )
        distance = span.magnitude() if direction is None else span.dot(direction)
        unit = span / distance if direction is None else direction
        total += distance
        on, by, back = (two, one, -unit) if two is not None else (one, two, unit)
        at = second if two is not None else first
        pulls.append(Reaction(name, str(on), by, back, at))
    tension = replace(pulls[0], parts=tuple(pulls[1:]))
    taut = holonomic(f"{name}_length", total - scalar(length, f"{title}: the length"), name)
    tied = tuple((body, point) for body, point in ends)
    given = arguments("rope", tied, length, along)
    return Rope(name, tied, (tension,), (taut,), given=given)


def _between(title: str, first: Point, second: Point) -> Vector:
    try:
        return second.pos_from(first)
    except ValueError:
        raise SceneError(
            f"{title}: nothing places {second.name} relative to {first.name}: place both from the"
            " origin of the scene"
        ) from None
