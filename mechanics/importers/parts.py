"""The parts of a scene while it grows along the tree of a robot: names, numbers, frames, loads."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from keyword import iskeyword

from sympy import Expr, ImmutableMatrix, Rational
from sympy.physics.mechanics import Point, ReferenceFrame
from sympy.physics.vector import Vector

from mechanics.importers.robot import STRAIGHT, Robot
from mechanics.scene import Condition, Joint, RigidBody, condition, force, parameters, torque
from mechanics.scene.loads import Load
from mechanics.scene.reactions import Constraint, Reaction

ENDS = ("", "_dot", "_ddot", "_x", "_y", "_z", "_mx", "_my", "_mz", "_1", "_2", "_m1", "_m2",
         "_e0", "_e1", "_e2", "_e3", "_wx", "_wy", "_wz", "_angle", "_mimic")  # fmt: skip


@dataclass(frozen=True)
class Spot:
    """Where a link is: the body that carries it (None: the ground), its origin and frame."""

    body: str | None
    point: Point
    frame: ReferenceFrame


@dataclass(frozen=True)
class Drive:
    """The motion of a joint of one freedom, and what acts along it."""

    q: Expr
    joint: Joint
    along: Vector
    turning: bool

    @property
    def ends(self) -> tuple[str, str | None]:
        """The body that it moves, and the one that carries it."""
        return self.joint.child, self.joint.parent


@dataclass
class Parts:
    """What a scene is made of, as far as it is known.

    Attributes
    ----------
    robot : Robot
    symbolic : frozenset of str
        Kinds of numbers that become parameters.
    ground : Spot
    pull : three Expr
        Acceleration of gravity.
    names, links : dict of str to str
        Identifiers of joints and of links.
    taken : set of str
        Names that coordinates, speeds and reactions have.
    spots : dict of str to Spot
        By link.
    drives : dict of str to Drive
        By joint, of those with one freedom.
    """

    robot: Robot
    symbolic: frozenset[str]
    ground: Spot
    pull: tuple[Expr, Expr, Expr]
    names: dict[str, str] = field(default_factory=dict)
    taken: set[str] = field(default_factory=lambda: {"t", "g"})
    links: dict[str, str] = field(default_factory=dict)
    spots: dict[str, Spot] = field(default_factory=dict)
    drives: dict[str, Drive] = field(default_factory=dict)
    bodies: list[RigidBody] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    reactions: list[Reaction] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    conditions: list[Condition] = field(default_factory=list)
    inputs: list[Expr] = field(default_factory=list)
    example: dict[str, float] = field(default_factory=dict)

    def name(self, name: str) -> str:
        """An identifier for a joint, such that its coordinates and reactions have names, too."""
        tried = numbered(
            identifier(name), lambda one: any(f"{one}{end}" in self.taken for end in ENDS)
        )
        self.taken |= {f"{tried}{end}" for end in ENDS}
        self.names[name] = tried
        return tried

    def link(self, name: str) -> str:
        """An identifier for a link."""
        used = set(self.links.values())
        return self.links.setdefault(name, numbered(identifier(name), used.__contains__))

    def known(self, name: str) -> bool:
        """Whether outputs of that name would collide."""
        return f"{name}_position" in self.taken or f"{name}_orientation" in self.taken

    def value(self, kind: str, name: str, unit: str, number: Expr, positive: bool = False) -> Expr:
        """A number, or the parameter that stands for it."""
        if kind not in self.symbolic or not isinstance(number, Rational) or number == 0:
            return number
        name = numbered(name, self.taken.__contains__)
        self.taken.add(name)
        (symbol,) = parameters(name, unit, str(number), positive=positive)
        return symbol

    def step(self, spot: Spot, column: tuple[Expr, ...], name: str, of: str) -> Point:
        """A point of a link."""
        if not any(column):
            return spot.point
        x, y, z = (
            self.value("lengths", f"{axis}_{of}", "m", entry)
            for axis, entry in zip("xyz", column, strict=True)
        )
        frame = spot.frame
        return spot.point.locatenew(name, x * frame.x + y * frame.y + z * frame.z)

    def load(self, name: str, size: Expr, drive: Drive) -> None:
        """A couple or force along a joint."""
        on, by = drive.ends
        acting = (
            torque(name, size * drive.along, on=on, by=by)
            if drive.turning
            else force(name, drive.joint.point, size * drive.along, on=on, by=by)
        )
        self.loads.append(acting)

    def limit(self, name: str, relation: Expr, otherwise: str) -> None:
        """A condition of validity."""
        self.conditions.append(condition(name, relation, otherwise))


def action(name: str, drive: Drive, factor: Expr) -> Reaction:
    """A couple or force of unknown size along a joint, times a factor."""
    at = None if drive.turning else drive.joint.point
    return Reaction(name, *drive.ends, factor * drive.along, at)


def turned(parent: ReferenceFrame, matrix: ImmutableMatrix, name: str) -> ReferenceFrame:
    """A frame that is fixed in another: v_parent = R v_frame."""
    if matrix == STRAIGHT:
        return parent
    frame = ReferenceFrame(name)
    frame.orient_explicit(parent, matrix)
    return frame


def numbered(name: str, known: Callable[[str], bool]) -> str:
    """The name, or with the first number with which it is not known yet."""
    return next(
        one for one in (name, *(f"{name}_n{k}" for k in range(2, 10_000))) if not known(one)
    )


def identifier(name: str) -> str:
    """Letters, digits and underscores of a name."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII).strip("_") or "part"
    return f"n{plain}" if not plain[0].isalpha() or iskeyword(plain) else plain
