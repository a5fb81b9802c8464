"""Arms by Denavit-Hartenberg parameters.

    standard    T_i = R_z(theta) T_z(d) T_x(a) R_x(alpha)         frame i at the far end of link i
    modified    T_i = R_x(alpha) T_x(a) R_z(theta) T_z(d)         frame i at joint i

theta of a revolute joint, and d of a prismatic one, is the coordinate plus the number of the row.
Sources: Denavit and Hartenberg, J. Applied Mechanics 22 (1955); Craig, Introduction to Robotics
(1986), for the modified form.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Matrix, Rational

from mechanics.errors import InputError
from mechanics.importers.assemble import SYMBOLIC, assemble
from mechanics.importers.decimals import Notes, angle, check_size, exact
from mechanics.importers.robot import (
    STRAIGHT,
    ZERO,
    Column,
    Connection,
    Inertial,
    Link,
    Robot,
)
from mechanics.importers.rotations import about
from mechanics.scene import Scene, parameters
from mechanics.scene.declared import scalar

KEYS = ("a", "alpha", "d", "theta", "joint", "mass", "com", "inertia")
CONVENTIONS = ("standard", "modified")
AXIS = (ZERO, ZERO, Integer(1))


def from_dh(
    table: Sequence[Mapping[str, Any]],
    convention: str = "standard",
    name: str = "arm",
    symbolic: Collection[str] = SYMBOLIC,
    gravity: Sequence[Any] | None = None,
) -> Scene:
    """The scene of an arm.

    Coordinates are q1, q2, ..., inputs tau_q1, ...; the last frame is ``tool``, whose position and
    orientation are outputs.

    Parameters
    ----------
    table : sequence of mappings
        A row a joint, from the ground outwards: numbers, decimals as text, or SymPy expressions in
        parameters. ``a``, ``d`` in m and ``alpha``, ``theta`` in rad, 0 where they are missing;
        ``joint``: ``"revolute"`` (where it is missing) or ``"prismatic"``; ``mass`` in kg, ``com``
        three coordinates in frame i, ``inertia`` three moments or six (xx, yy, zz, xy, yz, xz)
        about the mass centre along the axes of frame i. A mass, centre or inertia that is missing
        becomes parameters without typical values.
    convention : str
        ``"standard"`` or ``"modified"``.
    name : str
    symbolic : tuple of str
        Which numbers become parameters, as in `from_urdf`.
    gravity : three numbers or expressions, optional
        In the frame of the ground, m/s^2; by default g along -z.

    Raises
    ------
    InputError
        Names the row and what is wrong.

    Examples
    --------
    >>> row = {"a": 1, "mass": 2, "com": (-0.5, 0, 0), "inertia": (0, 0, 0.2)}
    >>> arm = from_dh([row, row], symbolic=())
    >>> arm.coordinates, list(arm.outputs)
    ((q1(t), q2(t)), ['tool_position', 'tool_orientation'])
    """
    if convention not in CONVENTIONS:
        raise InputError(f"convention={convention!r}: choose 'standard' or 'modified'")
    if not isinstance(table, Sequence) or not table:
        raise InputError("the table has no rows: give one a joint, such as {'a': 0.3, 'mass': 2}")
    notes = Notes()
    links, joints = [Link("base")], []
    place, turn = (ZERO, ZERO, ZERO), STRAIGHT
    for number, row in enumerate(table, start=1):
        own = _Row(number, row, notes)
        before, after = (STRAIGHT, own.tilt) if convention == "standard" else (own.tilt, STRAIGHT)
        if convention == "modified":
            place, offset, ahead = (own.a, ZERO, ZERO), (ZERO, ZERO, own.d), (ZERO, ZERO, ZERO)
        else:
            offset, ahead = (ZERO, ZERO, ZERO), (own.a, ZERO, own.d)
        joints.append(
            Connection(
                f"q{number}", own.kind, links[-1].name, f"link{number}", place,
                ImmutableMatrix(turn * before * own.twist), AXIS, offset,
            )
        )  # fmt: skip
        links.append(Link(f"link{number}", own.inertial(ahead, after)))
        place, turn = ahead, after
    joints.append(Connection("tool_joint", "fixed", links[-1].name, "tool", place, turn))
    links.append(Link("tool"))
    field = None
    if gravity is not None:
        x, y, z = (_value(entry, f"gravity[{k}]") for k, entry in enumerate(gravity))
        field = (x, y, z)
    return assemble(Robot(name, tuple(links), tuple(joints)), "fixed", symbolic, field,
                    notes.lines())  # fmt: skip


class _Row:
    """A row of a table, checked."""

    def __init__(self, number: int, row: Mapping[str, Any], notes: Notes) -> None:
        self.what, self.number = f"row {number}", number
        if not isinstance(row, Mapping):
            raise InputError(f"{self.what} is a {type(row).__name__}: give a dict such as"
                             " {'a': 0.3, 'alpha': 0, 'mass': 2}")  # fmt: skip
        if unknown := [key for key in row if key not in KEYS]:
            raise InputError(f"{self.what} has {unknown[0]!r}: the keys are {', '.join(KEYS)}")
        kind = row.get("joint", "revolute")
        if kind not in ("revolute", "prismatic"):
            raise InputError(f"{self.what}: joint is {kind!r}: choose 'revolute' or 'prismatic'")
        self.row, self.kind = row, "turn" if kind == "revolute" else "slide"
        self.a, self.d = (_value(row.get(key, 0), f"{self.what}: {key}") for key in ("a", "d"))
        alpha, theta = (
            _angle(row.get(key, 0), f"{self.what}: {key}", notes) for key in ("alpha", "theta")
        )
        self.tilt, self.twist = ImmutableMatrix(about(0, alpha)), ImmutableMatrix(about(2, theta))

    def inertial(self, ahead: Column, turn: ImmutableMatrix) -> Inertial:
        """Mass properties, from frame i to that of the link, which stands at the joint."""
        mass = self._given("mass", "m{}", "kg", 1, True)[0]
        centre = Matrix(self._given("com", "cx{} cy{} cz{}", "m m m", 3, False))
        names = " ".join(f"I{ends}{{}}" for ends in ("xx", "yy", "zz", "xy", "yz", "xz"))
        moments = self._given("inertia", names, " ".join(["kg*m^2"] * 6), 6, False)
        x, y, z = Matrix(ahead) + turn * centre
        return Inertial(mass, (x, y, z), turn, moments)

    def _given(
        self, key: str, names: str, units: str, count: int, positive: bool
    ) -> tuple[Expr, ...]:
        value = self.row.get(key)
        if value is None:
            own = " ".join(name.format(self.number) for name in names.split())
            return parameters(own, units, positive=positive)
        values = tuple(value) if isinstance(value, Sequence) and count > 1 else (value,)
        if count == 6 and len(values) == 3:
            values = (*values, 0, 0, 0)
        if len(values) != count:
            raise InputError(f"{self.what}: {key} has {len(values)} numbers: give {count}")
        return tuple(_value(one, f"{self.what}: {key}") for one in values)


def _value(value: Any, where: str) -> Expr:
    return exact(value, where) if isinstance(value, str) else _sized(value, where)


def _angle(value: Any, where: str, notes: Notes) -> Expr:
    if isinstance(value, float):
        value = repr(value)
    return angle(value, where, notes) if isinstance(value, str) else _sized(value, where)


def _sized(value: Any, where: str) -> Expr:
    """A number or an expression, every number of which a double can hold."""
    found = scalar(value, where)
    for number in found.atoms(Rational):
        check_size(number, where)
    return found
