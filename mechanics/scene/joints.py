"""Joints: what places a body, moves it, and transmits forces to it.

A joint stands at a point and in a frame of the parent, with an axis e where it has one. It gives a
frame and a point of the child, on which the child's body is placed:

    pin           R(e, angle)                                5 reactions
    slide         at + distance e                            5
    cylindrical   R(e, angle), at + distance e               4
    universal     R(e1, angle1) R(e2, angle2)                4
    planar        R(e, angle), at + x e1 + y e2              3
    ball          R(e1, a) R(e2, b) R(e3, c)                 3
    weld          nothing moves                              6
    free          ball, at + x e1 + y e2 + z e3              0

Reactions are forces along the axes of the parent's frame that the joint holds, and couples about
those directions about which it does not turn; their names are the joint's name and a direction.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, sqrt
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import kind_of
from mechanics.scene.reactions import Constraint, Reaction, holonomic, reaction, reaction_couple
from mechanics.scene.rotations import Rotation

AXES = "xyz"


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between a parent and a child: made by `pin`, `slide` and the others.

    Attributes
    ----------
    name : str
    parent : str or None
        Body that carries the joint; None for the ground.
    child : str
        Body that it carries.
    frame : ReferenceFrame
        Turns with the child.
    point : Point
        Moves with the child.
    coordinates : tuple of dynamic symbols
    reactions : tuple of Reaction
        Of the parent on the child.
    constraints : tuple of Constraint
        Of a joint that closes a loop.
    rotations : tuple of Rotation
        Quaternions, with their coordinates and speeds.
    """

    name: str
    parent: str | None
    child: str
    frame: ReferenceFrame
    point: Point
    coordinates: tuple[Expr, ...]
    reactions: tuple[Reaction, ...]
    constraints: tuple[Constraint, ...] = ()
    rotations: tuple[Rotation, ...] = ()

    @property
    def closes(self) -> bool:
        """Whether it closes a loop of bodies that other joints carry."""
        return bool(self.constraints)


@dataclass(frozen=True)
class Euler:
    """Three turns in a row, each about an axis of the frame that the one before has turned.

    Attributes
    ----------
    order : str
        Axes, such as ``"zxz"``; neighbours differ.
    angles : tuple of three dynamic symbols
        In rad. The rates of the first and the third are the same turn where the second is 0 (axes
        such as zxz) or a quarter turn (such as xyz): choose the order so that motions stay away.
    """

    order: str
    angles: tuple[Expr, ...]


def euler(order: str, *angles: Expr) -> Euler:
    """A rotation by Euler angles: see `Euler`.

    Raises
    ------
    SceneError
        When these are not three axes with three angles, or neighbours are the same axis.
    """
    order = order.lower()
    if len(order) != 3 or len(angles) != 3 or not {*order} <= {*AXES}:
        raise SceneError(
            f"euler: {order!r} with {len(angles)} angles: give three axes and three angles,"
            ' as in euler("zxz", phi, theta, psi)'
        )
    if order[0] == order[1] or order[1] == order[2]:
        raise SceneError(f"euler: {order!r} turns twice about the same axis: let neighbours differ")
    return Euler(order, angles)


def pin(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector,
    angle: Expr | None = None, onto: Point | None = None,
) -> Joint:  # fmt: skip
    """A hinge: the child turns about an axis.

    Parameters
    ----------
    name : str
    parent : str or None
        Body, or None for the ground.
    child : str
        Body.
    at : Point
        Of the parent, on the axis.
    axis : Vector
        Constant in a frame of the parent.
    angle : dynamic symbol
        In rad, about the axis.
    onto : Point, optional
        In place of `angle`, of a child that other joints carry already: its point that stays at
        `at`. The loop lies in the plane normal to the axis, in which two forces close it.

    Raises
    ------
    SceneError
        When the axis has no length or stands in several frames.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O, q = ReferenceFrame("N"), Point("O"), dynamicsymbols("q")
    >>> shoulder = pin("shoulder", None, "arm", at=O, axis=N.z, angle=q)
    >>> [reaction.name for reaction in shoulder.reactions]
    ['shoulder_x', 'shoulder_y', 'shoulder_z', 'shoulder_mx', 'shoulder_my']
    """
    base, along = _axis(name, "axis", axis)
    if onto is not None:
        return _closed(name, parent, child, at, onto, base, along)
    frame = base.orientnew(name, "Axis", (_coordinate(name, "angle", angle), axis))
    forces = _forces(name, parent, child, at, base.x, base.y, base.z)
    couples = _couples(name, parent, child, *_normals(base, along))
    return Joint(name, parent, child, frame, at, (angle,), forces + couples)


def slide(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector, distance: Expr
) -> Joint:
    """A slider: the child moves along an axis and does not turn.

    Parameters
    ----------
    name, parent, child, at, axis
        As for `pin`.
    distance : dynamic symbol
        In m, of the child's point from `at` along the axis.
    """
    base, along = _axis(name, "axis", axis)
    distance = _coordinate(name, "distance", distance)
    point = at.locatenew(name, distance * along)
    forces = _forces(name, parent, child, point, *_normals(base, along))
    couples = _couples(name, parent, child, base.x, base.y, base.z)
    return Joint(name, parent, child, base, point, (distance,), forces + couples)


def cylindrical(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector, angle: Expr,
    distance: Expr,
) -> Joint:  # fmt: skip
    """A sleeve on a shaft: the child turns about an axis and moves along it; see `pin`, `slide`."""
    base, along = _axis(name, "axis", axis)
    coordinates = (
        _coordinate(name, "angle", angle), _coordinate(name, "distance", distance),
    )  # fmt: skip
    point = at.locatenew(name, distance * along)
    frame = base.orientnew(name, "Axis", (angle, axis))
    normals = _normals(base, along)
    forces = _forces(name, parent, child, point, *normals)
    couples = _couples(name, parent, child, *normals)
    return Joint(name, parent, child, frame, point, coordinates, forces + couples)


def universal(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    axes: str = "xy", angles: Sequence[Expr],
) -> Joint:  # fmt: skip
    """Cardan's joint: a turn about an axis of the parent, then one about an axis of the cross.

    Parameters
    ----------
    name, parent, child, at
        As for `pin`.
    frame : ReferenceFrame
        Of the parent.
    axes : str
        Two different axes: the first of `frame`, the second of the frame that it has turned.
    angles : two dynamic symbols
        In rad.
    """
    axes = axes.lower()
    if len(axes) != 2 or len({*axes} & {*AXES}) != 2 or len(angles) != 2:
        raise SceneError(
            f"joint {name}: axes {axes!r} with {len(angles)} angles: give two different axes and"
            ' two angles, as in axes="xy", angles=(alpha, beta)'
        )
    first, second = (_coordinate(name, "angles", angle) for angle in angles)
    cross = frame.orientnew(f"{name}_cross", "Axis", (first, getattr(frame, axes[0])))
    outer = cross.orientnew(name, "Axis", (second, getattr(cross, axes[1])))
    (third,) = {*AXES} - {*axes}
    forces = _forces(name, parent, child, at, frame.x, frame.y, frame.z)
    couples = _couples(name, parent, child, getattr(cross, third))
    return Joint(name, parent, child, outer, at, (first, second), forces + couples)


def planar(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    coordinates: Sequence[Expr], angle: Expr,
) -> Joint:  # fmt: skip
    """The child slides and turns in the plane of x and y of a frame of the parent.

    Parameters
    ----------
    name, parent, child, at
        As for `pin`.
    frame : ReferenceFrame
        Of the parent.
    coordinates : two dynamic symbols
        In m, along x and y.
    angle : dynamic symbol
        In rad, about z.
    """
    if len(coordinates) != 2:
        raise SceneError(f"joint {name}: {len(coordinates)} coordinates: give two, along x and y")
    x, y = (_coordinate(name, "coordinates", one) for one in coordinates)
    turned = frame.orientnew(name, "Axis", (_coordinate(name, "angle", angle), frame.z))
    point = at.locatenew(name, x * frame.x + y * frame.y)
    reactions = _forces(name, parent, child, point, frame.z)
    reactions += _couples(name, parent, child, frame.x, frame.y)
    return Joint(name, parent, child, turned, point, (x, y, angle), reactions)


def ball(
    name: str,
    parent: str | None,
    child: str,
    *,
    at: Point,
    frame: ReferenceFrame,
    rotation: Euler | Rotation,
) -> Joint:
    """The child turns about a point in every direction.

    Parameters
    ----------
    name, parent, child, at
        As for `pin`.
    frame : ReferenceFrame
        Of the parent.
    rotation : Euler or Rotation
        Of the child against `frame`: `euler(...)`, or `quaternion(...)`, which has no singularity.
    """
    turned, angles, rotations = _turned(name, frame, rotation)
    forces = _forces(name, parent, child, at, frame.x, frame.y, frame.z)
    return Joint(name, parent, child, turned, at, angles, forces, rotations=rotations)


def weld(name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame) -> Joint:
    """The child is fixed to the parent; six reactions say what the joint has to bear."""
    forces = _forces(name, parent, child, at, frame.x, frame.y, frame.z)
    couples = _couples(name, parent, child, frame.x, frame.y, frame.z)
    return Joint(name, parent, child, frame, at, (), forces + couples)


def free(
    name: str, child: str, *, at: Point, frame: ReferenceFrame, coordinates: Sequence[Expr],
    rotation: Euler | Rotation,
) -> Joint:  # fmt: skip
    """Nothing holds the child: three coordinates of its point, and its rotation.

    Parameters
    ----------
    name, child
        As for `pin`.
    at : Point
    frame : ReferenceFrame
        From which and in which the position is counted.
    coordinates : three dynamic symbols
        In m, along x, y and z of `frame`.
    rotation : Euler or Rotation
        Of the child against `frame`: `euler(...)`, or `quaternion(...)`, which has no singularity.
    """
    if len(coordinates) != 3:
        raise SceneError(f"joint {name}: {len(coordinates)} coordinates: give three")
    x, y, z = (_coordinate(name, "coordinates", one) for one in coordinates)
    turned, angles, rotations = _turned(name, frame, rotation)
    point = at.locatenew(name, x * frame.x + y * frame.y + z * frame.z)
    position = (x, y, z, *angles)
    return Joint(name, None, child, turned, point, position, (), rotations=rotations)


def _coordinate(name: str, what: str, value: Expr | None) -> Expr:
    """A dynamic symbol."""
    if not isinstance(value, Expr) or not value.is_Function:
        raise SceneError(
            f"joint {name}: {what} is {kind_of(value)}: give a dynamic symbol, as in"
            f' {what}=dynamicsymbols("q")'
        )
    return value


def _axis(name: str, what: str, axis: Vector) -> tuple[ReferenceFrame, Vector]:
    """The frame of an axis, and its unit vector."""
    if not isinstance(axis, Vector):
        raise SceneError(f"joint {name}: {what} is {kind_of(axis)}: give a vector, such as frame.z")
    if not axis.args:
        raise SceneError(f"joint {name}: the {what} has no length: give a vector, such as frame.z")
    if len(axis.args) > 1:
        frames = ", ".join(frame.name for _, frame in axis.args)
        raise SceneError(
            f"joint {name}: the {what} stands in several frames ({frames}): write it in the frame"
            " of the parent"
        )
    ((column, base),) = axis.args
    return base, axis / sqrt(sum(entry**2 for entry in column))


def _normals(base: ReferenceFrame, along: Vector) -> tuple[Vector, Vector]:
    """Two unit vectors normal to another one, axes of the frame where it is one of them."""
    axes = (base.x, base.y, base.z)
    if along in axes:
        first, second = (axis for axis in axes if axis != along)
        return first, second
    ((column, _),) = along.args
    # An axis that it does not have is normal to it; where it has all three, none is parallel.
    other = next((a for a, entry in zip(axes, column, strict=True) if entry == 0), base.x)
    first = along.cross(other).normalize()
    return first, along.cross(first)


def _turned(
    name: str, frame: ReferenceFrame, rotation: Euler | Rotation
) -> tuple[ReferenceFrame, tuple[Expr, ...], tuple[Rotation, ...]]:
    """The frame after a rotation; its angles, or the quaternion."""
    if isinstance(rotation, Rotation):
        return rotation.orient(name, frame), (), (rotation,)
    if not isinstance(rotation, Euler):
        raise SceneError(
            f"joint {name}: rotation is {kind_of(rotation)}: give"
            ' euler("zxz", phi, theta, psi) or quaternion("e0 e1 e2 e3", "wx wy wz")'
        )
    outer = frame
    for k, (axis, angle) in enumerate(zip(rotation.order, rotation.angles, strict=True)):
        own = name if k == 2 else f"{name}_{k + 1}"
        angle = _coordinate(name, "rotation", angle)
        outer = outer.orientnew(own, "Axis", (angle, getattr(outer, axis)))
    return outer, rotation.angles, ()


def _forces(
    name: str, parent: str | None, child: str, at: Point, *along: Vector
) -> tuple[Reaction, ...]:
    return tuple(
        reaction(f"{name}_{word}", at=at, on=child, by=parent, along=direction)
        for word, direction in zip(_words(along), along, strict=True)
    )


def _couples(name: str, parent: str | None, child: str, *along: Vector) -> tuple[Reaction, ...]:
    return tuple(
        reaction_couple(f"{name}_m{word}", child, parent, direction)
        for word, direction in zip(_words(along), along, strict=True)
    )


def _words(directions: Sequence[Vector]) -> list[str]:
    """x, y, z for axes of a frame, 1, 2 for other directions."""
    words = []
    for k, direction in enumerate(directions, start=1):
        ((_, base),) = direction.args
        axes = dict(zip(AXES, (base.x, base.y, base.z), strict=True))
        words.append(next((word for word, axis in axes.items() if axis == direction), str(k)))
    return words


def _closed(
    name: str, parent: str | None, child: str, at: Point, onto: Point, base: ReferenceFrame,
    along: Vector,
) -> Joint:  # fmt: skip
    """A hinge that closes a loop in the plane normal to its axis."""
    normals = _normals(base, along)
    forces = _forces(name, parent, child, at, *normals)
    gap = onto.pos_from(at)
    constraints = tuple(
        holonomic(f"{force.name}_closes", gap.dot(normal), force.name)
        for force, normal in zip(forces, normals, strict=True)
    )
    return Joint(name, parent, child, base, onto, (), forces, constraints)
