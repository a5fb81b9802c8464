"""A mechanism as a tree of joints with one freedom each, where it is one.

A link is what moves with one coordinate: a frame that turns about an axis by it, or a point that
slides along one. Its root is the point that it turns about or has slid to. The root moves with the
parent link; whether the link turns with it as well depends on the frame in which it was oriented:
angles of a chain may be counted from the ground, each for itself.

    alpha = alpha_parent + e u',    a_root = a_parent + alpha_parent x c + ...       turning with it
    alpha =                e u',    a_root = a_parent + alpha_parent x c + ...       from the ground
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mechanics.mechanism import GROUND, Mass, Mechanism, inputs_of
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.vectors import Matrix, Vector, add, product, scale, transpose, zeros
from mechanics.recursions.frames import common, express, lineage, rigid_steps
from mechanics.recursions.pseudo_inertia import Moments, outer


@dataclass(frozen=True)
class Link:
    """What moves with one coordinate.

    Attributes
    ----------
    coordinate : int
        Its number among q and u.
    parent : int
        Link that its root moves with; GROUND for none.
    turning : bool
        Whether it turns; else it slides.
    carried : bool
        Whether it also turns with its parent.
    frame : int
        Frame of its components: that which turns, or for a slide that of the parent.
    axis : Vector
        Of the motion, times its rate per unit of u.
    offset : Vector
        Of the root from that of the parent, in the parent's frame, m.
    mass : Node
        In kg; what counts of it after grouping.
    first : Vector
        First moment about the root, kg m.
    second : Matrix
        Second moment about the root, kg m^2.
    """

    coordinate: int
    parent: int
    turning: bool
    carried: bool
    frame: int
    axis: Vector
    offset: Vector
    mass: Node
    first: Vector
    second: Matrix


@dataclass(frozen=True)
class Spot:
    """A place on a link: `offset` from its root in its frame; on the ground from the origin."""

    link: int
    offset: Vector


@dataclass(frozen=True)
class JointTree:
    """Links, parents first, and where frames and points are.

    Attributes
    ----------
    carriers : mapping of int to int
        Link of each frame that turns by a coordinate, GROUND for the inertial one.
    roots : mapping of int to Spot
        Where on its parent the root of such a frame is.
    rigid : tuple of int
        The frame of `carriers` to which each frame is fixed.
    spots : mapping of int to Spot
        Of points that are fixed on a link.
    """

    links: tuple[Link, ...]
    carriers: Mapping[int, int]
    roots: Mapping[int, Spot]
    rigid: tuple[int, ...]
    spots: Mapping[int, Spot]


def joint_tree(mechanism: Mechanism, moments: Moments) -> tuple[Link, ...] | None:
    """Links, parents first; None where the mechanism is no such tree.

    Parameters
    ----------
    moments : Moments
        Of its masses: as they are, or grouped.
    """
    tree = placed_joint_tree(mechanism, moments)
    return None if tree is None else tree.links


def placed_joint_tree(mechanism: Mechanism, moments: Moments) -> JointTree | None:
    """The same, and where its frames and points are.

    Parameters
    ----------
    moments : Moments
        Of its masses: as they are, or grouped.
    """
    if mechanism.constraints or mechanism.frictions or mechanism.u != mechanism.qd:
        return None
    if any(entry in mechanism.given_rates for entry in _geometry(mechanism)):
        return None
    return _Recognition(rigid_steps(mechanism)).tree(moments)


def _geometry(mechanism: Mechanism) -> set[Node]:
    nodes = [entry for frame in mechanism.frames for row in frame.rotation for entry in row]
    nodes += [e for place in mechanism.points for _, column in place.step for e in column]
    return inputs_of(nodes)


@dataclass
class _Draft:
    coordinate: int
    parent: int
    turning: bool
    carried: bool
    frame: int
    axis: Vector
    offset: Vector


class _Unlike(Exception):
    """The mechanism is no tree of such joints."""


class _Recognition:
    """The tables that grow along the trees of frames and points."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.drafts: list[_Draft] = []
        self.link_of_frame: dict[int, int] = {0: GROUND}
        self.root_of_frame: dict[int, Spot] = {}
        self.coordinates = {q: i for i, q in enumerate(mechanism.q)}
        self.spots = {0: Spot(GROUND, zeros(mechanism.builder))}

    def tree(self, moments: Moments) -> JointTree | None:
        try:
            for body in self.mechanism.bodies:
                self.place(body.centre)
            for body in self.mechanism.bodies:
                self.turn(body)
            links = self.loaded(moments)
        except _Unlike:
            return None
        for point in range(len(self.mechanism.points)):
            self.find(point)
        rigid = tuple(map(self.rigid, range(len(self.mechanism.frames))))
        return JointTree(links, self.link_of_frame, self.root_of_frame, rigid, self.spots)

    def find(self, point: int) -> None:
        """Where a point is that carries no mass, if it is fixed on a link."""
        place = self.mechanism.points[point]
        if point in self.spots or place.parent not in self.spots:
            return
        spot = self.spots[place.parent]
        for frame, column in sorted(place.step, key=lambda part: part[0]):
            rigid = self.rigid(frame)
            if self.moving(column) or rigid not in self.link_of_frame:
                return
            if rigid != self.rigid(self.frame_of(spot.link)):
                if self.root_of_frame.get(rigid) != spot:
                    return
                spot = Spot(self.link_of_frame[rigid], zeros(self.mechanism.builder))
            own = express(self.mechanism, column, frame, self.frame_of(spot.link))
            spot = Spot(spot.link, add(spot.offset, own))
        self.spots[point] = spot

    def moving(self, nodes: Sequence[Node]) -> list[int]:
        """Coordinates that nodes depend on."""
        return sorted(self.coordinates[n] for n in inputs_of(nodes) if n in self.coordinates)

    def rigid(self, frame: int) -> int:
        """The frame that turns, or the inertial one, to which a frame is fixed."""
        while frame != 0:
            own = self.mechanism.frames[frame]
            if self.moving([entry for row in own.rotation for entry in row]):
                break
            frame = own.parent
        return frame

    def frame_of(self, link: int) -> int:
        return 0 if link == GROUND else self.drafts[link].frame

    def new(self, draft: _Draft) -> int:
        if any(draft.coordinate == other.coordinate for other in self.drafts):
            raise _Unlike
        self.drafts.append(draft)
        return len(self.drafts) - 1

    def enter(self, frame: int, spot: Spot) -> int:
        """The link of a frame that turns, whose root is at a spot."""
        if frame in self.link_of_frame:
            if frame == 0:
                raise _Unlike
            if self.root_of_frame[frame] != spot:
                raise _Unlike
            return self.link_of_frame[frame]
        own = self.mechanism.frames[frame]
        outer_frame = self.rigid(own.parent)
        origin = zeros(self.mechanism.builder)
        if outer_frame == self.rigid(self.frame_of(spot.link)):
            parent, offset, carried = spot.link, spot.offset, True
        elif outer_frame == 0:
            parent, offset, carried = spot.link, spot.offset, False
        else:
            parent, offset, carried = self.enter(outer_frame, spot), origin, True
        if own.turn is None:
            raise _Unlike
        coordinates = self.moving([own.turn.angle])
        if len(coordinates) != 1:
            raise _Unlike
        (rate,) = tangent([own.turn.angle], {self.mechanism.q[coordinates[0]]: origin[0] + 1})
        if rate.constant is None:
            raise _Unlike
        axis = scale(rate, own.turn.axis)
        link = self.new(_Draft(coordinates[0], parent, True, carried, frame, axis, offset))
        self.link_of_frame[frame], self.root_of_frame[frame] = link, spot
        return link

    def place(self, point: int) -> Spot:
        """Where a point is, and what its way needs; points without a body may move in any way."""
        if point not in self.spots:
            place = self.mechanism.points[point]
            spot = self.place(place.parent)
            for frame, column in sorted(place.step, key=lambda part: part[0]):
                spot = self.step(spot, frame, column)
            self.spots[point] = spot
        return self.spots[point]

    def turn(self, body: Mass) -> None:
        """A body on which no point lies but its centre turns about that: a wheel, a rotor."""
        rigid = GROUND if body.frame is None else self.rigid(body.frame)
        if rigid not in (GROUND, 0) and rigid not in self.link_of_frame:
            self.enter(rigid, self.spots[body.centre])

    def step(self, spot: Spot, frame: int, column: Vector) -> Spot:
        rigid = self.rigid(frame)
        if rigid != self.rigid(self.frame_of(spot.link)):
            spot = Spot(self.enter(rigid, spot), zeros(self.mechanism.builder))
        own = self.frame_of(spot.link)
        column = express(self.mechanism, column, frame, own)
        coordinates = self.moving(column)
        if not coordinates:
            return Spot(spot.link, add(spot.offset, column))
        for coordinate in coordinates:
            one = self.mechanism.builder.one
            axis = tuple(tangent(column, {self.mechanism.q[coordinate]: one}))
            if self.moving(axis):
                raise _Unlike
            if coordinate != coordinates[-1]:
                # The last of several slides in one step has the whole way as its offset.
                spot = Spot(self.slide(coordinate, spot, axis), zeros(self.mechanism.builder))
        offset = add(spot.offset, column)
        link = self.slide(coordinates[-1], Spot(spot.link, offset), axis)
        return Spot(link, zeros(self.mechanism.builder))

    def slide(self, coordinate: int, spot: Spot, axis: Vector) -> int:
        frame = self.frame_of(spot.link)
        return self.new(_Draft(coordinate, spot.link, False, True, frame, axis, spot.offset))

    def loaded(self, moments: Moments) -> tuple[Link, ...]:
        """The links with their masses."""
        mechanism = self.mechanism
        frames: list[tuple[int, Vector, Matrix]] = []
        none = zeros(mechanism.builder)
        empty = (none, none, none)
        for (frame, point), first in moments.first.items():
            rigid = self.rigid(frame)
            spot = self.spots[point]
            if rigid == 0:
                continue
            if self.frame_of(spot.link) != rigid:
                spot = Spot(self.enter(rigid, spot), none)
            first = express(mechanism, first, frame, rigid)
            across = outer(spot.offset, first)
            pairs = zip(across, transpose(across), strict=True)
            frames.append((spot.link, first, tuple(add(a, b) for a, b in pairs)))
        for frame, second in moments.second.items():
            rigid = self.rigid(frame)
            if rigid == 0:
                continue
            if rigid not in self.link_of_frame:
                raise _Unlike
            turned = rotated(mechanism, second, frame, rigid)
            frames.append((self.link_of_frame[rigid], none, turned))
        if len(self.drafts) != len(mechanism.q):
            raise _Unlike
        masses = [mechanism.builder.zero] * len(self.drafts)
        for point, mass in moments.mass.items():
            spot = self.spots[point]
            if spot.link == GROUND:
                continue
            masses[spot.link] = masses[spot.link] + mass
            first = scale(mass, spot.offset)
            frames.append((spot.link, first, outer(first, spot.offset)))
        found = []
        for number, draft in enumerate(self.drafts):
            own = [part for part in frames if part[0] == number]
            seconds = [second for _, _, second in own]
            second = tuple(
                add(none, *(matrix[k] for matrix in seconds)) if seconds else empty[k]
                for k in range(3)
            )
            found.append(
                Link(
                    draft.coordinate, draft.parent, draft.turning, draft.carried, draft.frame,
                    draft.axis, draft.offset, masses[number],
                    add(none, *(first for _, first, _ in own)), second,
                )
            )  # fmt: skip
        return tuple(found)


def rotated(mechanism: Mechanism, matrix: Matrix, source: int, target: int) -> Matrix:
    """R matrix R^T of a symmetric matrix, from one frame to another.

    A turn about z by the double angle, d = a_xx - a_yy, p = d s^2 + 2 a_xy s c:

        a_xx - p,   a_yy + p,   a_xy + d s c - 2 a_xy s^2,   R (a_xz, a_yz)
    """
    meet = common(mechanism, (source, target))
    up, down = lineage(mechanism, source), lineage(mechanism, target)
    for index in up[: up.index(meet)]:
        matrix = _turned(mechanism, matrix, index, mechanism.frames[index].rotation)
    for index in reversed(down[: down.index(meet)]):
        matrix = _turned(mechanism, matrix, index, transpose(mechanism.frames[index].rotation))
    return matrix


def _turned(mechanism: Mechanism, matrix: Matrix, index: int, rotation: Matrix) -> Matrix:
    one = mechanism.builder.one
    axis = next((k for k in range(3) if rotation[k][k] == one), None)
    if axis is None:
        return product(product(rotation, matrix), transpose(rotation))
    return _double_angle(matrix, rotation, axis)


def _double_angle(a: Matrix, rotation: Matrix, z: int) -> Matrix:
    x, y = (z + 1) % 3, (z + 2) % 3
    c, s = rotation[x][x], rotation[y][x]
    square, product_ = s * s, s * c
    difference, twice = a[x][x] - a[y][y], a[x][y] * 2
    part = difference * square + twice * product_
    across = a[x][y] + difference * product_ - twice * square
    xz, yz = c * a[x][z] - s * a[y][z], s * a[x][z] + c * a[y][z]
    entries = {
        (x, x): a[x][x] - part, (y, y): a[y][y] + part, (z, z): a[z][z],
        (x, y): across, (x, z): xz, (y, z): yz,
    }  # fmt: skip
    return tuple(
        tuple(entries[i, j] if (i, j) in entries else entries[j, i] for j in range(3))
        for i in range(3)
    )
