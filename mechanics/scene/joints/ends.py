"""The two ends of a joint, and how it is made from the directions of its reactions.

    gap . e = 0         a force along e              gap: from the parent's point to the child's
    u . v = 0           a couple along u x v         u fixed in the parent, v in the child

A joint that closes a loop has a constraint for each reaction; one that carries its child has none.
The force acts at the child's point: so the power of each reaction is its unknown times the rate of
its constraint, also where the loop is open.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import kind_of
from mechanics.scene.euler import Euler
from mechanics.scene.joints.axes import Axis, Named, along_axes, read_axis
from mechanics.scene.joints.joint import Joint
from mechanics.scene.reactions import holonomic, reaction, reaction_couple
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import name_of

Aligned = tuple[tuple[Vector, Vector], ...]
"""Pairs u and v, one a couple."""


@dataclass(frozen=True)
class Ends:
    """Who is joined, and where on the parent; `given` is what else the user gave.

    Raises
    ------
    SceneError
        Names the joint, and what is no name or no point.
    """

    name: str
    parent: str | None
    child: str
    at: Point
    given: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name:
            raise SceneError(f"a joint has the name {kind_of(self.name)}: give a text")
        for role, value in (("parent", self.parent), ("child", self.child)):
            if not isinstance(value, str) and not (role == "parent" and value is None):
                ground = ", or None for the ground" if role == "parent" else ""
                raise SceneError(
                    f"{self.title}: its {role} is {kind_of(value)}: give the name of a body{ground}"
                )
        if not isinstance(self.at, Point):
            raise SceneError(
                f"{self.title}: at is {kind_of(self.at)}: give a point of the parent, as in"
                ' at=origin.locatenew("P", L * frame.x)'
            )

    @property
    def title(self) -> str:
        """How messages call the joint."""
        return f"joint {self.name}"

    def axis(self, axis: Any, words: str = "the axis") -> Axis:
        """An axis, checked."""
        return read_axis(f"{self.title}: {words}", axis)

    def coordinate(self, what: str, value: Expr | None) -> Expr:
        """A dynamic symbol."""
        try:
            name_of(value)
        except SceneError:
            raise SceneError(
                f"{self.title}: {what} is {kind_of(value)}: give a dynamic symbol, as in"
                f' {what}=dynamicsymbols("q")'
            ) from None
        return value

    def several(self, what: str, values: Any, words: str, count: int) -> tuple[Expr, ...]:
        """So many dynamic symbols."""
        given = tuple(values) if isinstance(values, tuple | list) else (values,)
        if len(given) != count:
            raise SceneError(f"{self.title}: {len(given)} {what}: give {words}")
        return tuple(self.coordinate(what, value) for value in given)

    def frame(self, frame: Any) -> ReferenceFrame:
        """A frame."""
        if not isinstance(frame, ReferenceFrame):
            raise SceneError(
                f"{self.title}: frame is {kind_of(frame)}: give a ReferenceFrame of the body"
            )
        return frame

    def rotation(self, rotation: Any) -> Euler | Rotation:
        """Euler angles or a quaternion."""
        if not isinstance(rotation, Euler | Rotation):
            raise SceneError(
                f"{self.title}: rotation is {kind_of(rotation)}: give"
                ' euler("zxz", phi, theta, psi) or quaternion("e0 e1 e2 e3", "wx wy wz")'
            )
        return rotation

    def carries(
        self,
        frame: ReferenceFrame,
        point: Point,
        coordinates: tuple[Expr, ...],
        forces: Named,
        couples: Named,
        rotation: Euler | Rotation | None = None,
    ) -> Joint:
        """The joint that places its child."""
        reactions = [
            reaction(f"{self.name}_{word}", at=point, on=self.child, by=self.parent, along=along)
            for word, along in forces
        ]
        reactions += [
            reaction_couple(f"{self.name}_m{word}", self.child, self.parent, along)
            for word, along in couples
        ]
        if isinstance(rotation, Euler):
            coordinates = (*coordinates, *rotation.angles)
        return Joint(
            self.name, self.parent, self.child, self.at, frame, point, coordinates,
            tuple(reactions), tuple(along for _, along in (*forces, *couples)),
            rotations=(rotation,) if isinstance(rotation, Rotation) else (), given=self.given,
        )  # fmt: skip

    def closes(
        self, frame: ReferenceFrame, point: Point, forces: Named, couples: Named, aligned: Aligned
    ) -> Joint:
        """The joint of two bodies that others place."""
        gap = self.between(point)
        reactions, sides = [], []
        for word, along in forces:
            name = f"{self.name}_{word}"
            reactions.append(reaction(name, point, self.child, self.parent, along))
            sides.append(gap.dot(along))
        for (word, _), (u, v) in zip(couples, aligned, strict=True):
            name = f"{self.name}_m{word}"
            reactions.append(reaction_couple(name, self.child, self.parent, u.cross(v)))
            sides.append(u.dot(v))
        constraints = tuple(
            holonomic(f"{own.name}_closes", side, own.name)
            for own, side in zip(reactions, sides, strict=True)
        )
        return Joint(
            self.name, self.parent, self.child, self.at, frame, point, (), tuple(reactions),
            tuple(along for _, along in (*forces, *couples)), constraints, carries=False,
            given=self.given,
        )  # fmt: skip

    def between(self, point: Point) -> Vector:
        """From the parent's point to one of the child."""
        try:
            return point.pos_from(self.at)
        except ValueError:
            raise SceneError(
                f"{self.title}: nothing places {point.name} relative to {self.at.name}: place both"
                " from the points of joints that carry the bodies"
            ) from None

    def closes_about(self, line: Axis, onto: Any, forces: Named) -> Joint:
        """The joint that holds the child's axis parallel to the parent's."""
        point, axis = self.onto(onto, Vector, "axis, as in onto=(P, frame.z)")
        own = self.axis(axis, "the axis of onto")
        (_, e1), (_, e2) = line.across
        return self.closes(own.frame, point, forces, line.across, ((e2, own.unit), (e1, own.unit)))

    def closes_parallel(self, frame: ReferenceFrame, onto: Any, forces: Named) -> Joint:
        """The joint that holds the child's frame parallel to the parent's."""
        point, own = self.onto(onto, ReferenceFrame, "frame, as in onto=(P, frame)")
        ours, theirs = along_axes(frame), along_axes(own)
        aligned = tuple((ours[(k + 1) % 3][1], theirs[(k + 2) % 3][1]) for k in range(3))
        return self.closes(own, point, forces, ours, aligned)

    def onto(self, onto: Any, kind: type, words: str) -> tuple[Point, Any]:
        """A point of the child and what else is held of it."""
        given = tuple(onto) if isinstance(onto, tuple | list) else (onto,)
        if len(given) != 2 or not isinstance(given[0], Point) or not isinstance(given[1], kind):
            raise SceneError(
                f"{self.title}: onto is {kind_of(onto)}: give the child's point and {words}"
            )
        return given[0], given[1]

    def alone(self, *coordinates: Any) -> None:
        """A joint that closes a loop has no coordinate of its own."""
        given = [kind_of(value) for value in coordinates if value is not None]
        if given:
            raise SceneError(
                f"{self.title}: it has onto= and {given[0]}: what closes a loop has no coordinate,"
                " leave it out"
            )
