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

from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.euler import Euler
from mechanics.scene.joints.arguments import arguments
from mechanics.scene.joints.axes import along_axes
from mechanics.scene.joints.ends import Ends
from mechanics.scene.joints.joint import Joint
from mechanics.scene.rotations import Rotation


def pin(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector,
    angle: Expr | None = None, onto: Point | tuple[Point, Vector] | None = None,
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
        Of any length, constant in a frame, and fixed in the parent.
    angle : dynamic symbol
        In rad, about the axis, from the frame in which that is written: absolute with an axis of
        the ground, if a parent turns about it.
    onto : Point or (Point, Vector), optional
        In place of `angle`, of a child that other joints carry already: its point that stays at
        `at`, for a loop in the plane normal to the axis, in which two forces close it. In space
        also the axis in the child: three forces and two couples.

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
    ends = Ends(name, parent, child, at, arguments("pin", axis, angle, onto))
    line = ends.axis(axis)
    if onto is not None:
        ends.alone(angle)
        if isinstance(onto, Point):
            return ends.closes(line.frame, onto, line.across, (), ())
        return ends.closes_about(line, onto, along_axes(line.frame))
    angle = ends.coordinate("angle", angle)
    return ends.carries(
        line.turned(name, angle), at, (angle,), along_axes(line.frame), line.across
    )  # fmt: skip


def slide(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector,
    distance: Expr | None = None, onto: tuple[Point, ReferenceFrame] | None = None,
) -> Joint:  # fmt: skip
    """A slider: the child moves along an axis and does not turn.

    Parameters
    ----------
    name, parent, child, at, axis
        As for `pin`.
    distance : dynamic symbol
        In m, of the child's point from `at` along the axis.
    onto : (Point, ReferenceFrame), optional
        In place of `distance`, where the joint closes a loop: the child's point that stays on the
        axis, and its frame that stays parallel to that of the axis.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> rail = slide("rail", None, "cart", at=O, axis=N.x, distance=dynamicsymbols("s"))
    >>> rail.point.pos_from(O)
    s(t)*N.x
    """
    ends = Ends(name, parent, child, at, arguments("slide", axis, distance, onto))
    line = ends.axis(axis)
    if onto is not None:
        ends.alone(distance)
        return ends.closes_parallel(line.frame, onto, line.across)
    distance = ends.coordinate("distance", distance)
    point = at.locatenew(name, distance * line.unit)
    couples = along_axes(line.frame)
    return ends.carries(line.frame, point, (distance,), line.across, couples)


def cylindrical(
    name: str, parent: str | None, child: str, *, at: Point, axis: Vector,
    angle: Expr | None = None, distance: Expr | None = None,
    onto: tuple[Point, Vector] | None = None,
) -> Joint:  # fmt: skip
    """A sleeve on a shaft: the child turns about an axis and moves along it; see `pin`, `slide`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> q, s = dynamicsymbols("q s")
    >>> sleeve = cylindrical("sleeve", None, "tube", at=O, axis=N.z, angle=q, distance=s)
    >>> sleeve.coordinates, [reaction.name for reaction in sleeve.reactions]
    ((q(t), s(t)), ['sleeve_x', 'sleeve_y', 'sleeve_mx', 'sleeve_my'])
    """
    ends = Ends(name, parent, child, at, arguments("cylindrical", axis, angle, distance, onto))
    line = ends.axis(axis)
    if onto is not None:
        ends.alone(angle, distance)
        return ends.closes_about(line, onto, line.across)
    angle, distance = ends.coordinate("angle", angle), ends.coordinate("distance", distance)
    point = at.locatenew(name, distance * line.unit)
    frame = line.turned(name, angle)
    return ends.carries(frame, point, (angle, distance), line.across, line.across)


def universal(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    axes: str = "xy", angles: Sequence[Expr] | None = None,
    onto: tuple[Point, Vector] | None = None,
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
    onto : (Point, Vector), optional
        In place of `angles`, where the joint closes a loop: the child's point that stays at `at`,
        and its axis, about which it turns in the cross; the second of `axes` is of no effect.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> cross = universal("cross", None, "shaft", at=O, frame=N, angles=dynamicsymbols("q1 q2"))
    >>> [reaction.name for reaction in cross.reactions]
    ['cross_x', 'cross_y', 'cross_z', 'cross_mz']
    """
    ends = Ends(name, parent, child, at, arguments("universal", frame, axes, angles, onto))
    own = dict(along_axes(ends.frame(frame)))
    letters = axes.lower()
    if len(letters) != 2 or len({*letters} & {*own}) != 2:
        raise SceneError(
            f'{ends.title}: axes {axes!r}: give two different axes, as in axes="xy",'
            " angles=(alpha, beta)"
        )
    (third,) = {*own} - {*letters}
    if onto is not None:
        ends.alone(angles)
        point, axis = ends.onto(onto, Vector, "axis, as in onto=(P, frame.y)")
        second = ends.axis(axis, "the axis of onto")
        held = ((own[letters[0]], second.unit),)
        return ends.closes(second.frame, point, tuple(own.items()), ((third, own[third]),), held)
    first, second = ends.several("angles", angles, "two", 2)
    cross = frame.orientnew(f"{name}_cross", "Axis", (first, own[letters[0]]))
    turned = dict(along_axes(cross))
    outer = cross.orientnew(name, "Axis", (second, turned[letters[1]]))
    couples = ((third, turned[third]),)
    return ends.carries(outer, at, (first, second), along_axes(frame), couples)


def planar(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    coordinates: Sequence[Expr] | None = None, angle: Expr | None = None,
    onto: tuple[Point, Vector] | None = None,
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
    onto : (Point, Vector), optional
        In place of these, where the joint closes a loop: the child's point that stays in the plane
        through `at`, and its axis that stays normal to it.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> x, y, q = dynamicsymbols("x y q")
    >>> table = planar("table", None, "puck", at=O, frame=N, coordinates=(x, y), angle=q)
    >>> [reaction.name for reaction in table.reactions]
    ['table_z', 'table_mx', 'table_my']
    """
    ends = Ends(name, parent, child, at, arguments("planar", frame, coordinates, angle, onto))
    first, second, normal = along_axes(ends.frame(frame))
    if onto is not None:
        ends.alone(coordinates, angle)
        return ends.closes_about(ends.axis(frame.z), onto, (normal,))
    x, y = ends.several("coordinates", coordinates, "two, along x and y", 2)
    angle = ends.coordinate("angle", angle)
    turned = frame.orientnew(name, "Axis", (angle, frame.z))
    point = at.locatenew(name, x * frame.x + y * frame.y)
    return ends.carries(turned, point, (x, y, angle), (normal,), (first, second))


def ball(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    rotation: Euler | Rotation | None = None, onto: Point | None = None,
) -> Joint:  # fmt: skip
    """The child turns about a point in every direction.

    Parameters
    ----------
    name, parent, child, at
        As for `pin`.
    frame : ReferenceFrame
        Of the parent.
    rotation : Euler or Rotation
        Of the child against `frame`: `euler(...)`, or `quaternion(...)`, which has no singularity.
    onto : Point, optional
        In place of `rotation`, where the joint closes a loop: the child's point that stays at `at`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> turn = quaternion("e0 e1 e2 e3", "wx wy wz")
    >>> shoulder = ball("shoulder", None, "arm", at=O, frame=N, rotation=turn)
    >>> [reaction.name for reaction in shoulder.reactions]
    ['shoulder_x', 'shoulder_y', 'shoulder_z']
    """
    ends = Ends(name, parent, child, at, arguments("ball", frame, rotation, onto))
    forces = along_axes(ends.frame(frame))
    if onto is not None:
        ends.alone(rotation)
        return ends.closes(frame, onto, forces, (), ())
    turning = ends.rotation(rotation)
    return ends.carries(turning.orient(name, frame), at, (), forces, (), turning)


def weld(
    name: str, parent: str | None, child: str, *, at: Point, frame: ReferenceFrame,
    onto: tuple[Point, ReferenceFrame] | None = None,
) -> Joint:  # fmt: skip
    """The child is fixed to the parent; six reactions say what the joint has to bear.

    Parameters
    ----------
    name, parent, child, at
        As for `pin`.
    frame : ReferenceFrame
        Of the parent, parallel to the child's.
    onto : (Point, ReferenceFrame), optional
        Where the joint closes a loop: the child's point and frame that are held.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> clamp = weld("clamp", None, "beam", at=O, frame=N)
    >>> len(clamp.coordinates), len(clamp.reactions)
    (0, 6)
    """
    ends = Ends(name, parent, child, at, arguments("weld", frame, onto))
    axes = along_axes(ends.frame(frame))
    if onto is not None:
        return ends.closes_parallel(frame, onto, axes)
    return ends.carries(frame, at, (), axes, axes)


def free(
    name: str, child: str, *, at: Point, frame: ReferenceFrame,
    coordinates: Sequence[Expr] | None = None, rotation: Euler | Rotation | None = None,
    onto: None = None,
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
    rotation : Euler or Rotation, optional
        Of the child against `frame`: `euler(...)`, or `quaternion(...)`, which has no singularity;
        a particle has none.
    onto : None
        Of other joints: what holds nothing closes no loop.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> base = free("base", "ball", at=O, frame=N, coordinates=dynamicsymbols("x y z"))
    >>> base.coordinates, base.reactions
    ((x(t), y(t), z(t)), ())
    """
    ends = Ends(name, None, child, at, arguments("free", frame, coordinates, rotation))
    if onto is not None:
        raise SceneError(f"{ends.title}: it holds nothing, so it closes no loop: leave it out")
    x, y, z = ends.several("coordinates", coordinates, "three", 3)
    turned = ends.frame(frame)
    if rotation is not None:
        turned = ends.rotation(rotation).orient(name, frame)
    point = at.locatenew(name, x * frame.x + y * frame.y + z * frame.z)
    return ends.carries(turned, point, (x, y, z), (), (), rotation)
