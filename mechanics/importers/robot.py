"""A robot: links and the joints between them, as model files tell them, and the scene of it.

joint frame = link frame of the parent, moved by `place` and `turn`
link frame of the child = joint frame, moved by the joint and then by `offset`
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from sympy import Expr, ImmutableMatrix, Integer, Rational, eye

from mechanics.errors import InputError
from mechanics.nearest import instead

Column = tuple[Expr, Expr, Expr]
ZERO = Integer(0)
NOWHERE: Column = (ZERO, ZERO, ZERO)
ALONG_X = (Integer(1), ZERO, ZERO)
STRAIGHT = ImmutableMatrix(eye(3))
MOST_LINKS = 400
"""A scene of more would take longer than anybody waits."""


@dataclass(frozen=True)
class Inertial:
    """Mass properties of a link.

    Attributes
    ----------
    mass : Expr
        In kg.
    centre : three Expr
        In the frame of the link, m.
    turn : ImmutableMatrix
        Of the frame of the moments against that of the link.
    moments : six Expr
        xx, yy, zz, xy, yz, xz about the centre, kg m^2.
    """

    mass: Expr
    centre: Column
    turn: ImmutableMatrix
    moments: tuple[Expr, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "moments", tuple(self.moments))

    @property
    def nothing(self) -> bool:
        """Whether it is as if there were none."""
        return self.mass == 0 and not any(self.moments)


@dataclass(frozen=True)
class Link:
    """A rigid part; `inertial` is None where the file gives none."""

    name: str
    inertial: Inertial | None = None


@dataclass(frozen=True)
class Limits:
    """Where a joint may be, how fast, and what its drive can do; None: not stated."""

    lower: Rational | None = None
    upper: Rational | None = None
    rate: Rational | None = None
    effort: Rational | None = None


@dataclass(frozen=True)
class Connection:
    """A joint of the file.

    Attributes
    ----------
    name, parent, child : str
        Parent and child are links.
    kind : str
        ``"fixed"``, ``"turn"``, ``"slide"``, ``"ball"``, ``"planar"`` or ``"floating"``.
    place : three Expr
        Of the joint in the frame of the parent, m.
    turn : ImmutableMatrix
        Of the joint frame against that of the parent: v_parent = R v_joint.
    axis : three rationals
        Of a turn or a slide, or the normal of the plane, in the joint frame.
    offset : three Expr
        From the joint to the origin of the child, in the frame of the child.
    driven : bool
        Whether an input drives it.
    zero : Expr
        Value of the coordinate at which the child stands as the file places it.
    damping, friction, stiffness, rest, armature : Expr
        Loads -damping q', -friction sign(q') and -stiffness (q - rest), and what a drive adds to
        the inertia of q itself, in SI units.
    """

    name: str
    kind: str
    parent: str
    child: str
    place: Column = NOWHERE
    turn: ImmutableMatrix = STRAIGHT
    axis: tuple[Rational, Rational, Rational] = ALONG_X
    offset: Column = NOWHERE
    limits: Limits = field(default_factory=Limits)
    driven: bool = True
    zero: Expr = ZERO
    damping: Expr = ZERO
    friction: Expr = ZERO
    stiffness: Expr = ZERO
    rest: Expr = ZERO
    armature: Expr = ZERO


@dataclass(frozen=True)
class Actuation:
    """What acts along L = sum of coefficient q: a motor, or a tendon over joints.

    F = (gain_0 + gain_1 L + gain_2 L') input + bias_0 + bias_1 L + bias_2 L'

    Attributes
    ----------
    name : str
        Also of the input.
    terms : tuple of (str, Expr)
        Joints with their coefficients.
    gain : three Expr, or None
        None: no input.
    bias : three Expr
    """

    name: str
    terms: tuple[tuple[str, Expr], ...]
    gain: Column | None
    bias: Column


@dataclass(frozen=True)
class Cable:
    """A spring and damper between two points, each a link and a place on it."""

    name: str
    ends: tuple[tuple[str, Column], tuple[str, Column]]
    stiffness: Expr
    length: Expr
    damping: Expr


@dataclass(frozen=True)
class Polynomial:
    """q = rest + sum of c_k (q_other - other_rest)^k; q stays where it is without another."""

    name: str
    joint: str
    other: str | None
    rest: Expr
    other_rest: Expr
    coefficients: tuple[Expr, ...]


@dataclass(frozen=True)
class Closure:
    """What closes a loop: places of two links that stay together, and their frames if welded.

    Attributes
    ----------
    first, second : (str, Column)
        Link and place on it.
    turn : ImmutableMatrix or None
        Of the second link's frame against that of the first; None: free to turn.
    """

    name: str
    first: tuple[str, Column]
    second: tuple[str, Column]
    turn: ImmutableMatrix | None


Coupling = Actuation | Cable | Polynomial | Closure


@dataclass(frozen=True)
class Robot:
    """A tree of links, and what couples them beside its joints."""

    name: str
    links: tuple[Link, ...]
    joints: tuple[Connection, ...]
    couplings: tuple[Coupling, ...] = ()

    def link(self, name: str) -> Link:
        """The link of that name."""
        return next(link for link in self.links if link.name == name)

    def children(self, link: str) -> tuple[Connection, ...]:
        """Joints whose parent it is, in the order of the file."""
        return tuple(joint for joint in self.joints if joint.parent == link)


def ordered(robot: Robot) -> tuple[str, Robot]:
    """The root, and the same robot with its joints from there outwards, each branch to its end.

    Raises
    ------
    InputError
        When it is no tree: names that do not exist or stand twice, a link with two parents, no
        root, or several.
    """
    what = f"robot {robot.name}"
    if len(robot.links) > MOST_LINKS:
        raise InputError(f"{what}: {len(robot.links)} links: at most {MOST_LINKS} are read")
    for kind, names in (
        ("links", [link.name for link in robot.links]),
        ("joints", [joint.name for joint in robot.joints]),
    ):
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise InputError(f"{what}: two {kind} are named {twice!r}: rename one")
    every = {link.name for link in robot.links}
    carrier: dict[str, Connection] = {}
    for joint in robot.joints:
        for role, link in (("parent", joint.parent), ("child", joint.child)):
            if link not in every:
                raise InputError(
                    f"joint {joint.name}: there is no link {link!r}, its {role}:"
                    f" {instead(link, [one.name for one in robot.links], 'links')}"
                )
        other = carrier.setdefault(joint.child, joint)
        if other is not joint:
            raise InputError(
                f"joints {other.name} and {joint.name} both carry link {joint.child!r}:"
                " a loop is no tree, cut it at one of them"
            )
    roots = [link.name for link in robot.links if link.name not in carrier]
    if len(roots) > 1:
        raise InputError(
            f"{what}: links {', '.join(map(repr, roots[:4]))} have no parent: join all but one"
        )
    reached = list(_outwards(robot, roots[0])) if roots else []
    if len(reached) < len(robot.joints) or not roots:
        inside = {joint.name for joint in reached}
        lost = next((joint for joint in robot.joints if joint.name not in inside), None)
        if lost is None:
            raise InputError(f"{what}: it has no link")
        raise InputError(
            f"joint {lost.name}: its links go round in a circle: {_circle(carrier, lost.child)}"
        )
    return roots[0], replace(robot, joints=tuple(reached))


def _outwards(robot: Robot, root: str) -> Iterator[Connection]:
    by_parent: dict[str, list[Connection]] = {}
    for joint in robot.joints:
        by_parent.setdefault(joint.parent, []).append(joint)
    left = list(reversed(by_parent.get(root, [])))
    while left:
        joint = left.pop()
        yield joint
        left += reversed(by_parent.get(joint.child, []))


def _circle(carrier: dict[str, Connection], link: str) -> str:
    way: list[str] = []
    while link not in way:
        way.append(link)
        link = carrier[link].parent
    way = way[way.index(link) :]
    return " < ".join([*way[:6], *(["..."] if len(way) > 6 else []), link])
