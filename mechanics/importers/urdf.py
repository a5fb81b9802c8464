"""Robots in URDF: the Unified Robot Description Format of ROS.

    joint frame = parent frame moved by xyz, turned by R_z(yaw) R_y(pitch) R_x(roll)
    child frame = joint frame moved by the joint

Meshes, materials and transmissions are not looked at. Source: wiki.ros.org/urdf/XML.
"""

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError, TreeBuilder, XMLParser

from sympy import ImmutableMatrix, Integer, Rational

from mechanics.errors import InputError
from mechanics.importers.assemble import SYMBOLIC, assemble
from mechanics.importers.decimals import Notes, angle, exact, several
from mechanics.importers.robot import (
    MOST_LINKS,
    NOWHERE,
    STRAIGHT,
    ZERO,
    Column,
    Connection,
    Inertial,
    Limits,
    Link,
    Polynomial,
    Robot,
)
from mechanics.importers.rotations import roll_pitch_yaw
from mechanics.scene import Scene

XACRO = "{http://www.ros.org/wiki/xacro}"
"""Begins the tags of macros."""
LARGEST = 16_000_000
"""Of a file, in bytes."""
KINDS = {
    "revolute": "turn", "continuous": "turn", "prismatic": "slide", "fixed": "fixed",
    "floating": "floating", "planar": "planar",
}  # fmt: skip
MOMENTS = ("ixx", "iyy", "izz", "ixy", "iyz", "ixz")


def from_urdf(
    path: str | Path,
    root: str = "fixed",
    symbolic: Collection[str] = SYMBOLIC,
    multiples: bool = True,
) -> Scene:
    """The scene of a robot in a URDF file.

    Coordinates have the names of the joints, inputs ``tau_`` before it; positions and orientations
    of the outermost links are outputs.

    Parameters
    ----------
    path : str or Path
    root : str
        What holds the first link: ``"fixed"`` to the ground, ``"free"`` or ``"planar"``.
    symbolic : tuple of str
        Which numbers become parameters, with the number as typical value: masses, mass centres,
        inertias, and distances between joints. Zeros stay zero.
    multiples : bool
        Whether angles within half a unit of their last digit of a multiple of pi/12 are taken as
        such; `Scene.notes` tells which. False: only those that have all digits of a double.

    Raises
    ------
    InputError
        In one line, for whatever is no robot.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> text = '''<robot name="hinge"><link name="wall"/><link name="door"><inertial>
    ...   <origin xyz="0.4 0 0"/><mass value="20"/>
    ...   <inertia ixx="0.1" iyy="8" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
    ...   <joint name="q" type="continuous"><parent link="wall"/><child link="door"/>
    ...   <axis xyz="0 0 1"/></joint></robot>'''
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder) / "door.urdf"
    ...     _ = file.write_text(text)
    ...     scene = from_urdf(file)
    >>> scene.coordinates, scene.inputs, scene.parameters
    ((q(t),), (tau_q(t),), (Ixx_door, Iyy_door, Izz_door, cx_door, g, m_door))
    """
    notes = Notes()
    robot = read_urdf(path, notes, multiples)
    return assemble(robot, root, symbolic, notes=notes.lines())


def read_urdf(path: str | Path, notes: Notes, multiples: bool = True) -> Robot:
    """The links and joints of a file; see `from_urdf`."""
    path = Path(path)
    if not path.is_file():
        raise InputError(f"file {path}: there is no such file")
    if path.stat().st_size > LARGEST:
        raise InputError(f"file {path}: it is larger than {LARGEST // 1_000_000} MB")
    try:
        top = _parsed(path.read_bytes())
        if top.tag != "robot":
            raise InputError(f"it begins with <{top.tag[:40]}>: a URDF begins with <robot>")
        if any(element.tag.startswith(XACRO) for element in top.iter()):
            raise InputError(f"it is xacro: expand it first: xacro {path.name} > robot.urdf")
        links = top.findall("link")
        if len(links) > MOST_LINKS:
            raise InputError(f"{len(links)} links: at most {MOST_LINKS} are read")
        reader = _Reader(notes, multiples)
        return Robot(
            top.get("name") or path.stem,
            tuple(map(reader.link, links)),
            tuple(map(reader.joint, top.findall("joint"))),
            tuple(tie for joint in top.findall("joint") for tie in reader.mimics(joint)),
        )
    except ParseError as error:
        raise InputError(f"file {path}: it is no XML: {error}") from None
    except InputError as error:
        raise InputError(f"file {path}: {error}") from None


class _Plain(TreeBuilder):
    """XML without a document type, in which entities could be declared."""

    def doctype(self, name: str, public: str | None, system: str | None) -> None:
        raise InputError("it has a DOCTYPE, which a URDF does not need: leave it out")


def _parsed(text: bytes) -> Element:
    parser = XMLParser(target=_Plain())
    parser.feed(text)
    top: Element = parser.close()
    return top


class _Reader:
    """Elements of a file; `notes` is told what is read otherwise than it stands."""

    def __init__(self, notes: Notes, multiples: bool) -> None:
        self.notes, self.multiples = notes, multiples

    def link(self, element: Element) -> Link:
        """A link with its mass."""
        name = _name(element, "link")
        own = element.find("inertial")
        if own is None:
            return Link(name)
        what = f"link {name}"
        mass = exact(_attribute(own, "mass", "value", what), f"{what}: its mass")
        if mass < 0:
            raise InputError(f"{what}: its mass {mass} is negative: a mass is zero or more")
        moments = own.find("inertia")
        if moments is None:
            raise InputError(f"{what}: it has a mass and no <inertia>: give its moments")
        entries = [
            exact(moments.get(key, "0"), f"{what}: its {key}") for key in MOMENTS
        ]  # fmt: skip
        self._possible(what, mass, entries)
        place, turn = self._origin(own, what)
        return Link(name, Inertial(mass, place, turn, tuple(entries)))

    def joint(self, element: Element) -> Connection:
        """A joint with its limits and loads."""
        name = _name(element, "joint")
        what, kind = f"joint {name}", element.get("type", "")
        if kind not in KINDS:
            raise InputError(f"{what}: its type is {kind[:40]!r}: choose one of {', '.join(KINDS)}")
        place, turn = self._origin(element, what)
        dynamics = _found(element, "dynamics")
        damping, friction = (
            exact(dynamics.get(key, "0"), f"{what}: its {key}") for key in ("damping", "friction")
        )
        if damping < 0 or friction < 0:
            raise InputError(f"{what}: its damping or friction is negative: give zero or more")
        moving = KINDS[kind] in ("turn", "slide")
        return Connection(
            name, KINDS[kind], _attribute(element, "parent", "link", what),
            _attribute(element, "child", "link", what), place, turn,
            self._axis(element, what, kind), limits=self._limits(element, what, kind),
            driven=moving and element.find("mimic") is None, damping=damping, friction=friction,
        )  # fmt: skip

    def _origin(self, element: Element, what: str) -> tuple[Column, ImmutableMatrix]:
        own = element.find("origin")
        if own is None:
            return NOWHERE, STRAIGHT
        xyz = several(own.get("xyz"), "0 0 0", f"{what}: xyz of its origin")
        turns = several(
            own.get("rpy"), "0 0 0", f"{what}: rpy of its origin",
            lambda text, where: angle(text, where, self.notes, self.multiples),
        )  # fmt: skip
        return (xyz[0], xyz[1], xyz[2]), roll_pitch_yaw(turns) if any(turns) else STRAIGHT

    def _axis(
        self, element: Element, what: str, kind: str
    ) -> tuple[Rational, Rational, Rational]:  # fmt: skip
        own = element.find("axis")
        x, y, z = several(None if own is None else own.get("xyz"), "1 0 0", f"{what}: its axis")
        if own is None and kind in ("revolute", "continuous", "prismatic", "planar"):
            self.notes.add("no axis given, x by URDF's default", what)
        if not any((x, y, z)):
            if kind in ("revolute", "continuous", "prismatic", "planar"):
                raise InputError(f"{what}: its axis is 0 0 0: give a direction, such as 0 0 1")
            x = Integer(1)
        return x, y, z

    def _limits(self, element: Element, what: str, kind: str) -> Limits:
        own = element.find("limit")
        if own is None or kind not in ("revolute", "continuous", "prismatic"):
            return Limits()
        lower, upper, rate, effort = (
            None if own.get(key) is None else exact(own.get(key, ""), f"{what}: its limit {key}")
            for key in ("lower", "upper", "velocity", "effort")
        )
        if kind == "continuous":
            lower = upper = None
        if lower is not None and upper is not None and lower > upper:
            raise InputError(f"{what}: its lower limit {lower} is above its upper limit {upper}")
        return Limits(lower, upper, rate, effort)

    def mimics(self, joint: Element) -> Iterator[Polynomial]:
        """q = multiplier * q of the other joint + offset, where it is said."""
        own = joint.find("mimic")
        if own is not None and KINDS[joint.get("type", "")] in ("turn", "slide"):
            name = _name(joint, "joint")
            what = f"joint {name}"
            numbers = (
                exact(own.get("offset", "0"), f"{what}: its offset"),
                exact(own.get("multiplier", "1"), f"{what}: its multiplier"),
            )
            other = _attribute(joint, "mimic", "joint", what)
            if other == name:
                raise InputError(f"{what}: it mimics itself: name another joint")
            yield Polynomial(name, name, other, ZERO, ZERO, numbers)

    def _possible(self, what: str, mass: Rational, moments: list[Rational]) -> None:
        """No principal moment is negative; where one exceeds the sum of the others it is told."""
        matrix = inertia_matrix(moments)
        if not all(minor >= 0 for minor in _minors(matrix)):
            raise InputError(f"{what}: its inertia has a negative principal moment: correct it")
        if mass == 0 and any(moments):
            self.notes.add("moments of inertia without a mass", what)
        half = matrix.trace() / 2 * STRAIGHT - matrix
        if not all(minor >= 0 for minor in _minors(half)):
            self.notes.add(
                "no body has such an inertia, one principal moment exceeds the sum of the others",
                what,
            )


def inertia_matrix(moments: Iterable[Rational]) -> ImmutableMatrix:
    """3 x 3, of the moments xx, yy, zz, xy, yz, xz."""
    xx, yy, zz, xy, yz, xz = moments
    return ImmutableMatrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _minors(matrix: ImmutableMatrix) -> list[Rational]:
    """Principal minors: none is negative where no eigenvalue is."""
    pairs = [(0, 1), (0, 2), (1, 2)]
    return [
        *(matrix[i, i] for i in range(3)),
        *(matrix[i, i] * matrix[j, j] - matrix[i, j] ** 2 for i, j in pairs),
        matrix.det(),
    ]


def _name(element: Element, kind: str) -> str:
    name = element.get("name", "").strip()
    if not name or len(name) > 200:
        raise InputError(f"a {kind} has the name {name[:40]!r}: give it a name")
    return name


def _found(element: Element, tag: str) -> Element:
    own = element.find(tag)
    return Element(tag) if own is None else own


def _attribute(element: Element, tag: str, key: str, what: str) -> str:
    value = _found(element, tag).get(key)
    if value is None:
        raise InputError(f"{what}: it has no <{tag} {key}=...>: give one")
    return value.strip()
