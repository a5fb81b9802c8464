"""Rolling: a wheel, a ball or an ellipsoid on a plane, a wheel in or on another.

    d = -S n / sqrt(n . S n)            from the centre C to the contact Q, n normal to the plane
    gap = n . (r_C + d)                 0 where they touch
    slip = v_C + omega x d              0 where nothing slips

S = a^2 e1 e1 + b^2 e2 e2 + c^2 e3 e3 of an ellipsoid, r^2 (1 - a a) of a thin wheel of axle a, r^2
of a ball. Velocities are those against the frame of the plane. The contact presses along n, and
is tangential along the axes of the plane, where the conditions of a wheel are solved for x' and y'
at every heading, or, where its velocities forward and to the side are speeds, in these directions.
Each force has the power of its condition.

A wheel that stands nowhere else is placed on the plane, so that its gap is none:

    x, y, yaw, lean, spin               x and y of Q;   omega . a = spin' + yaw' sin(lean)
    x, angle                            upright: x' = +-r angle'
    phi, angle                          in a ring R: C at R - r, (R - r) phi' + r angle' = 0
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Add, Expr, cos, sin, sqrt
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene.declared import scalar
from mechanics.scene.geometry import frame_path, relative_rotation
from mechanics.scene.joints.arguments import arguments
from mechanics.scene.joints.axes import along_axes, constant_column, read_axis
from mechanics.scene.joints.ends import Ends
from mechanics.scene.joints.joint import Joint
from mechanics.scene.reactions import (
    Constraint,
    Reaction,
    holonomic,
    nonholonomic,
    reaction,
    reaction_couple,
)

_T = dynamicsymbols._t
FORWARD, SIDE, NORMAL = "forward", "side", "normal"
"""What the names of the forces end in."""


def roll(
    name: str, parent: str | None, child: str, *, at: Point, radius: Any,
    normal: Vector | None = None, axis: Vector | None = None, inside: Expr | None = None,
    outside: Expr | None = None, coordinates: Sequence[Expr] = (), angles: Sequence[Expr] = (),
    speeds: Sequence[Expr] = (), onto: tuple[Point, ReferenceFrame] | None = None,
) -> Joint:  # fmt: skip
    """A wheel, ball or ellipsoid that rolls without slip.

    Parameters
    ----------
    name, parent, child
        As for `pin`.
    at : Point
        Of the parent: in the plane, or the centre of the ring.
    radius : Expr, or three Expr
        In m. Three are the semi-axes of an ellipsoid along x, y and z of the child's frame.
    normal : Vector
        Of the plane, along an axis of a frame of the parent, to the side where the child is. With
        `inside` or `outside`: from the centre of the ring to the contact where the first angle is
        0.
    axis : Vector, optional
        Axle of a wheel: with `onto` of the child, else of the parent, along an axis of its frame.
    inside, outside : Expr, optional
        Radius of a ring of the parent, in m, in which or on which a wheel rolls.
    coordinates : dynamic symbols
        Of the contact in the plane, in m, along the axes of the frame: two of a wheel that leans,
        one of a wheel that stays upright.
    angles : dynamic symbols
        In rad. Three of a wheel that leans: yaw about the axis of the normal, lean about where it
        heads, spin about its axle. One of an upright wheel, about `axis`. Two in a ring: that of
        the line of centres, and that of the wheel, both about `axis` and against the ring.
    speeds : dynamic symbols, optional
        Of a wheel that leans: its total spin rate in rad/s, which is the angular velocity along
        the axle, and then the velocities of the contact forward and to the side, in m/s. With all
        three the friction stands in the directions of the wheel, and equations are shortest.
    onto : (Point, ReferenceFrame), optional
        In place of coordinates and angles, of a child that other joints carry: its centre and its
        frame. The contact is then a condition, maintained by the normal force.

    Returns
    -------
    Joint
        With `contact`, and `hub`: the frame that yaws and leans with the wheel, or turns with the
        line of centres, but does not spin.

    Raises
    ------
    SceneError
        Names the joint, and what does not go together.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> x, y, yaw, lean, spin = dynamicsymbols("x y yaw lean spin")
    >>> disc = roll("disc", None, "disc", at=O, normal=N.z, radius=1, coordinates=(x, y),
    ...             angles=(yaw, lean, spin))
    >>> [reaction.name for reaction in disc.reactions]
    ['disc_normal', 'disc_x', 'disc_y']
    """
    given = arguments(
        "roll", radius, normal, axis, inside, outside, coordinates, angles, speeds, onto
    )  # fmt: skip
    ends = Ends(name, parent, child, at, given)
    base = _base(ends, normal)
    if onto is not None:
        ends.alone(*coordinates, *angles, *speeds, inside, outside)
        return _touching(ends, base, radius, onto, axis)
    length = scalar(radius, f"{ends.title}: the radius")
    if inside is not None or outside is not None:
        return _in_a_ring(ends, base, length, axis, inside, outside, angles)
    if axis is not None:
        return _upright(ends, base, length, axis, coordinates, angles)
    return _leaning(ends, base, length, coordinates, angles, speeds)


@dataclass(frozen=True)
class _Base:
    """A frame of the parent, and its axes so that the third is along the normal, with the sign."""

    frame: ReferenceFrame
    place: int
    sign: int

    def axes(self, frame: ReferenceFrame) -> list[Vector]:
        """The axes of a frame in that order."""
        own = [axis for _, axis in along_axes(frame)]
        return [own[(self.place + 1 + k) % 3] for k in range(3)]

    @property
    def letters(self) -> tuple[str, str]:
        """Of the axes in the plane."""
        first, second = ("xyz"[(self.place + 1 + k) % 3] for k in range(2))
        return first, second

    @property
    def normal(self) -> Vector:
        """Unit vector."""
        return self.sign * self.axes(self.frame)[2]


def _base(ends: Ends, normal: Any) -> _Base:
    return _Base(*_along(f"{ends.title}: normal", normal))


def _along(what: str, vector: Any) -> tuple[ReferenceFrame, int, int]:
    """Frame, number and sign of the axis that a vector is along."""
    line = read_axis(what, vector)
    column, frame = constant_column(what, line.unit)
    if line.matrix is not None:
        raise SceneError(
            f"{what} = {vector} is along no axis of {line.frame.name}: orient a frame by fixed"
            " turns, and take one of its axes"
        )
    (place,) = (k for k in range(3) if column[k] != 0)
    return frame, place, int(column[place])


def _leaning(
    ends: Ends, base: _Base, r: Expr, coordinates: Sequence[Expr], angles: Sequence[Expr],
    speeds: Sequence[Expr],
) -> Joint:  # fmt: skip
    """A thin wheel on a plane, which stands on nothing else."""
    x, y = ends.several("coordinates", coordinates, "two, of the contact in the plane", 2)
    yaw, lean, spin = ends.several("angles", angles, "three: yaw, lean and spin", 3)
    name, frame = ends.name, base.frame
    heading = frame.orientnew(f"{name}_heading", "Axis", (yaw, base.axes(frame)[2]))
    hub = heading.orientnew(f"{name}_hub", "Axis", (lean, base.axes(heading)[0]))
    wheel = hub.orientnew(name, "Axis", (spin, base.axes(hub)[1]))
    e1, e2, _ = base.axes(frame)
    contact = ends.at.locatenew(f"{name}_contact", x * e1 + y * e2)
    centre = contact.locatenew(name, base.sign * r * base.axes(hub)[2])
    forward, side, _ = base.axes(heading)
    # The hub turns about the contact: what of the wheel is there has its velocity less r spin'.
    ahead = x.diff(_T) * cos(yaw) + y.diff(_T) * sin(yaw)
    across = y.diff(_T) * cos(yaw) - x.diff(_T) * sin(yaw)
    rolled = base.sign * r * spin.diff(_T)
    rows = {FORWARD: (forward, ahead - rolled), SIDE: (side, across)}
    if len(speeds) < 3:
        # These are solved for x' and y' at every heading, those for the other two speeds.
        first, second = base.letters
        rows = {first: (e1, x.diff(_T) - rolled * cos(yaw)),
                second: (e2, y.diff(_T) - rolled * sin(yaw))}  # fmt: skip
    total = spin.diff(_T) + yaw.diff(_T) * sin(lean)
    own = tuple(zip((spin, x, y), speeds, (total, ahead, across), strict=False))
    if len(speeds) > len(own):
        raise SceneError(
            f"{ends.title}: {len(speeds)} speeds: give at most three, the total spin rate and the"
            " velocities of the contact forward and to the side"
        )
    for _, u, _ in own:
        ends.coordinate("speeds", u)
    forces, constraints = _slipless(ends, contact, rows)
    press = reaction(f"{name}_{NORMAL}", contact, ends.child, ends.parent, base.normal)
    return Joint(
        name, ends.parent, ends.child, ends.at, wheel, centre, (x, y, yaw, lean, spin),
        (press, *forces), (base.normal, *(force.along for force in forces)), constraints, own=own,
        hub=hub, contact=contact, given=ends.given,
    )  # fmt: skip


def _upright(
    ends: Ends, base: _Base, r: Expr, axis: Any, coordinates: Sequence[Expr],
    angles: Sequence[Expr],
) -> Joint:  # fmt: skip
    """A wheel on a plane that neither yaws nor leans."""
    (x,) = ends.several("coordinates", coordinates, "one, of the contact", 1)
    (angle,) = ends.several("angles", angles, "one, about the axis", 1)
    axle = _axle(ends, base, axis)
    along = next(e for e in base.axes(base.frame)[:2] if e.dot(axle) == 0)
    wheel = base.frame.orientnew(ends.name, "Axis", (angle, axle))
    contact = ends.at.locatenew(f"{ends.name}_contact", x * along)
    centre = contact.locatenew(ends.name, r * base.normal)
    slip = x.diff(_T) - r * angle.diff(_T) * axle.cross(base.normal).dot(along)
    return _guided(
        ends, (wheel, base.frame), centre, contact, (x, angle), base.normal, along, axle, slip
    )


def _in_a_ring(
    ends: Ends, base: _Base, r: Expr, axis: Any, inside: Any, outside: Any,
    angles: Sequence[Expr],
) -> Joint:  # fmt: skip
    """A wheel in or on a ring: `base` is along the line of centres at the angle 0."""
    if inside is not None and outside is not None:
        raise SceneError(f"{ends.title}: it has inside= and outside=: it rolls on one side")
    phi, angle = ends.several("angles", angles, "two: of the line of centres, and of the wheel", 2)
    axle = _axle(ends, base, axis)
    big = scalar(outside if inside is None else inside, f"{ends.title}: the radius of the ring")
    side = -1 if inside is None else 1
    line = base.frame.orientnew(f"{ends.name}_line", "Axis", (phi, axle))
    wheel = base.frame.orientnew(ends.name, "Axis", (angle, axle))
    out = base.sign * base.axes(line)[2]
    contact = ends.at.locatenew(f"{ends.name}_contact", big * out)
    centre = ends.at.locatenew(ends.name, (big - side * r) * out)
    slip = (big - side * r) * phi.diff(_T) + side * r * angle.diff(_T)
    (column, _), *_ = axle.cross(base.normal).args
    along = sum((column[k] * e for k, (_, e) in enumerate(along_axes(line))), Vector(0))
    return _guided(
        ends, (wheel, line), centre, contact, (phi, angle), -side * out, along, axle, slip
    )


def _axle(ends: Ends, base: _Base, axis: Any) -> Vector:
    what = f"{ends.title}: axis"
    frame, place, sign = _along(what, axis)
    if frame != base.frame or place == base.place:
        raise SceneError(
            f"{what} = {axis} is not across normal = {base.normal}: give another axis of"
            f" {base.frame.name}"
        )
    return sign * along_axes(frame)[place][1]


def _guided(
    ends: Ends, frames: tuple[ReferenceFrame, ReferenceFrame], centre: Point, contact: Point,
    coordinates: tuple[Expr, ...], press: Vector, along: Vector, axle: Vector, slip: Expr,
) -> Joint:  # fmt: skip
    """A wheel whose axle keeps its direction, held by what a plane of motion leaves out."""
    name, on, by = ends.name, ends.child, ends.parent
    forces, constraints = _slipless(ends, contact, {FORWARD: (along, slip)})
    held = (
        reaction(f"{name}_{NORMAL}", contact, on, by, press),
        *forces,
        reaction(f"{name}_{SIDE}", contact, on, by, axle),
        reaction_couple(f"{name}_m{FORWARD}", on, by, along),
        reaction_couple(f"{name}_m{NORMAL}", on, by, press),
    )
    wheel, hub = frames
    return Joint(
        name, by, on, ends.at, wheel, centre, coordinates, held,
        (press, along, axle, along, press), constraints, hub=hub, contact=contact, given=ends.given,
    )  # fmt: skip


def _touching(ends: Ends, base: _Base, radius: Any, onto: Any, axis: Any) -> Joint:
    """The contact of a body that other joints carry."""
    centre, frame = ends.onto(onto, ReferenceFrame, "frame, as in onto=(C, frame)")
    n, place = base.normal, ends.between(centre)
    shape = _round(ends, base, radius, frame) if axis is None else _wheel(
        ends, base, radius, frame, axis)  # fmt: skip
    contact, moving = centre.locatenew(f"{ends.name}_contact", shape.way), place.dt(base.frame)
    rows = {
        letter: (along, moving.dot(along) + shape.turning.dot(along))
        for letter, along in zip(base.letters, base.axes(base.frame)[:2], strict=True)
    }
    forces, constraints = _slipless(ends, contact, rows)
    press = reaction(f"{ends.name}_{NORMAL}", contact, ends.child, ends.parent, n)
    gap = holonomic(f"{ends.name}_touches", place.dot(n) - shape.height, press.name)
    return Joint(
        ends.name, ends.parent, ends.child, ends.at, frame, centre, (), (press, *forces),
        (n, *(force.along for force in forces)), (gap, *constraints), carries=False,
        hub=base.frame, contact=contact, given=ends.given,
    )  # fmt: skip


@dataclass(frozen=True)
class _Shape:
    """What touches: height of C, d, and omega x d."""

    height: Expr
    way: Vector
    turning: Vector


def _round(ends: Ends, base: _Base, radius: Any, frame: ReferenceFrame) -> _Shape:
    """A ball, or an ellipsoid."""
    n, omega = base.normal, frame.ang_vel_in(base.frame)
    if isinstance(radius, tuple | list):
        if len(radius) != 3:
            raise SceneError(
                f"{ends.title}: {len(radius)} radii: give one, or the three semi-axes of an"
                " ellipsoid"
            )
        sizes = [scalar(size, f"{ends.title}: a semi-axis") for size in radius]
        parts = [(a**2 * n.dot(e), e) for a, (_, e) in zip(sizes, along_axes(frame), strict=True)]
        height = sqrt(Add(*(part * n.dot(e) for part, e in parts)))
        way = sum((-part / height * e for part, e in parts), Vector(0))
    else:
        height = scalar(radius, f"{ends.title}: the radius")
        way = -height * n
    return _Shape(height, way, omega.cross(way))


def _wheel(ends: Ends, base: _Base, radius: Any, frame: ReferenceFrame, axis: Any) -> _Shape:
    """A thin wheel, s^2 = 1 - (n . a)^2, in which no spin angle stands:

    omega x d = r/s (-(omega . a) a x n + (omega . a x n) (a - (n . a) n))
    """
    axle = _outermost(base.frame, read_axis(f"{ends.title}: the axis", axis).unit)
    ((_, hub),) = axle.args
    r, n = scalar(radius, f"{ends.title}: the radius"), base.normal
    slope, ahead = n.dot(axle), axle.cross(n)
    steep, across = sqrt(1 - slope**2), axle - slope * n
    rolling = -frame.ang_vel_in(base.frame).dot(axle) * ahead
    leaning = hub.ang_vel_in(base.frame).dot(ahead) * across
    way = -r / steep * (n - slope * axle)
    return _Shape(r * steep, way, r / steep * (rolling + leaning))


def _outermost(root: ReferenceFrame, axle: Vector) -> Vector:
    """The axle in the outermost frame in which it has the same components: what it spins about."""
    ((column, frame),) = axle.args
    way = frame_path(root, frame)
    while len(way) > 1 and relative_rotation(way[-2], way[-1]) * column == column:
        way = way[:-1]
    return Vector([(column, way[-1])])


def _slipless(
    ends: Ends, contact: Point, rows: dict[str, tuple[Vector, Expr]]
) -> tuple[tuple[Reaction, ...], tuple[Constraint, ...]]:
    """Forces along the contact, and the conditions that they maintain."""
    forces = {
        word: reaction(f"{ends.name}_{word}", contact, ends.child, ends.parent, along)
        for word, (along, _) in rows.items()
    }
    constraints = tuple(
        nonholonomic(f"{force.name}_rolls", rows[word][1], force.name)
        for word, force in forces.items()
    )
    return tuple(forces.values()), constraints
