"""The scene of a robot, made of the joints of `mechanics.scene`: no reaction is typed.

    tau = motor - damping q' - friction sign(q') - stiffness (q - rest)       at each joint   (1)
    q = multiplier q_other + offset                                           mimic           (2)

A link that does not move is the ground; one without mass that is fixed to another is a frame and a
point of that one.
"""

import re
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from keyword import iskeyword

from sympy import Abs, Expr, ImmutableMatrix, Integer, Rational, sign
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from sympy.physics.vector import Vector

from mechanics.errors import InputError
from mechanics.importers.robot import NOWHERE, STRAIGHT, Connection, Inertial, Robot, ordered
from mechanics.importers.rotations import towards
from mechanics.scene import (
    Condition,
    Joint,
    Output,
    RigidBody,
    Scene,
    ball,
    condition,
    force,
    free,
    gravity,
    holonomic,
    orientation,
    parameters,
    pin,
    planar,
    position,
    quaternion,
    slide,
    torque,
    torsion_spring,
    weld,
)
from mechanics.scene.loads import Load
from mechanics.scene.reactions import Constraint, Reaction

SYMBOLIC = ("mass", "com", "inertia", "lengths")
ROOTS = ("fixed", "free", "planar")
MOMENTS = ("xx", "yy", "zz", "xy", "yz", "xz")
_ENDS = ("", "_dot", "_ddot", "_x", "_y", "_z", "_mx", "_my", "_mz", "_1", "_2", "_m1", "_m2",
         "_e0", "_e1", "_e2", "_e3", "_wx", "_wy", "_wz", "_angle", "_mimic")  # fmt: skip
_T = dynamicsymbols._t


def assemble(
    robot: Robot,
    root: str = "fixed",
    symbolic: Collection[str] = SYMBOLIC,
    field: tuple[Expr, Expr, Expr] | None = None,
    notes: tuple[str, ...] = (),
) -> Scene:
    """The scene of a robot.

    Parameters
    ----------
    robot : Robot
    root : str
        What holds its first link: ``"fixed"`` to the ground, ``"free"`` or ``"planar"`` (in the
        plane of x and y).
    symbolic : collection of str
        Which numbers become parameters, with the number as typical value; 0 stays 0.
    field : three Expr, optional
        Acceleration of gravity; by default g downwards along z, a parameter.
    notes : tuple of str
        Of the reader.

    Raises
    ------
    InputError, SceneError
        When it is no tree, or cannot be a system; names the link or joint.
    """
    if root not in ROOTS:
        raise InputError(f"root={root!r}: choose one of {', '.join(map(repr, ROOTS))}")
    unknown = [name for name in symbolic if name not in SYMBOLIC]
    if unknown or isinstance(symbolic, str):
        raise InputError(f"symbolic={symbolic!r}: give a tuple of some of {SYMBOLIC}")
    first, robot = ordered(robot)
    return _Assembly(robot, frozenset(symbolic)).scene(first, root, field, notes)


@dataclass(frozen=True)
class _Spot:
    """Where a link is: the body that carries it (None: the ground), its origin and frame."""

    body: str | None
    point: Point
    frame: ReferenceFrame


@dataclass(frozen=True)
class _Drive:
    """The motion of a joint of one freedom, and what acts along it."""

    q: Expr
    joint: Joint
    along: Vector
    turning: bool


@dataclass
class _Assembly:
    """The parts of a scene while it grows along the tree."""

    robot: Robot
    symbolic: frozenset[str]
    names: dict[str, str] = field(default_factory=dict)
    taken: set[str] = field(default_factory=lambda: {"t", "g"})
    links: dict[str, str] = field(default_factory=dict)
    spots: dict[str, _Spot] = field(default_factory=dict)
    drives: dict[str, _Drive] = field(default_factory=dict)
    bodies: list[RigidBody] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    reactions: list[Reaction] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    conditions: list[Condition] = field(default_factory=list)
    inputs: list[Expr] = field(default_factory=list)
    example: dict[str, float] = field(default_factory=dict)

    def scene(
        self, first: str, root: str, field: tuple[Expr, Expr, Expr] | None, notes: tuple[str, ...]
    ) -> Scene:
        """Everything, from the root outwards."""
        ground, origin = ReferenceFrame("N"), Point("O")
        spot = _Spot(None, origin, ground)
        if root == "fixed":
            self.spots[first] = spot
        else:
            kind = "floating" if root == "free" else "planar"
            axis = (Integer(0), Integer(0), Integer(1))
            taken = {connection.name for connection in self.robot.joints}
            name = next(name for name in ("base", "root", "floating_base") if name not in taken)
            self._join(Connection(name, kind, "", first, axis=axis, driven=False), spot)
        for connection in self.robot.joints:
            self._join(connection, self.spots[connection.parent])
        for connection in self.robot.joints:
            if connection.mimic is not None:
                self._mimic(connection)
        if not self.joints:
            raise InputError(f"robot {self.robot.name}: no joint moves anything")
        if field is None:
            (g,) = parameters("g", "m/s^2", "9.81")
            field = (Integer(0), Integer(0), -g)
        if any(field):
            pull = field[0] * ground.x + field[1] * ground.y + field[2] * ground.z
            self.loads.insert(0, gravity(pull))
        return Scene(
            _identifier(self.robot.name), ground, origin, bodies=tuple(self.bodies),
            joints=tuple(self.joints), loads=tuple(self.loads), reactions=tuple(self.reactions),
            constraints=tuple(self.constraints), conditions=tuple(self.conditions),
            inputs=tuple(self.inputs), example=self.example, outputs=self._outputs(), notes=notes,
        )  # fmt: skip

    # ------------------------------------------------------------------ joints

    def _join(self, own: Connection, spot: _Spot) -> None:
        """What a joint places: the link that it carries."""
        name = self._name(own.name)
        at = self._step(spot, own.place, f"{name}_at", name)
        frame = _turned(spot.frame, own.turn, f"{name}_base")
        inertial = self.robot.link(own.child).inertial
        massive = inertial is not None and not inertial.nothing
        if own.kind == "fixed":
            carried = _Spot(spot.body, at, frame)
            if massive and spot.body is not None:
                body = self._link(own.child)
                joint = weld(name, spot.body, body, at=at, frame=frame)
                self.joints.append(joint)
                carried = _Spot(body, at, joint.frame)
        else:
            body = self._link(own.child)
            joint, frame = self._moving(own, name, body, at, frame, spot)
            carried = _Spot(body, joint.point, frame)
            self.joints.append(joint)
        point = self._step(carried, own.offset, f"{name}_link", f"back_{name}")
        self.spots[own.child] = carried = _Spot(carried.body, point, carried.frame)
        if carried.body is not None and carried.body != spot.body:
            self._body(own.child, carried, inertial)

    def _moving(
        self, own: Connection, name: str, body: str, at: Point, frame: ReferenceFrame, spot: _Spot
    ) -> tuple[Joint, ReferenceFrame]:
        """A joint with freedoms, and the frame of the link on it."""
        parent = spot.body
        turn, k, way = towards(own.axis)
        held = _turned(frame, turn, f"{name}_axis")
        back = turn.T if turn != STRAIGHT else STRAIGHT
        if own.kind in ("turn", "slide"):
            (q,) = dynamicsymbols(f"{name},")
            along = way * (held.x, held.y, held.z)[k]
            joint = (
                pin(name, parent, body, at=at, axis=along, angle=q)
                if own.kind == "turn"
                else slide(name, parent, body, at=at, axis=along, distance=q)
            )
            drive = _Drive(q, joint, along, own.kind == "turn")
            self.drives[own.name] = drive
            self._act(own, name, drive)
            return joint, _turned(joint.frame, back, f"{name}_link")
        if own.kind == "ball":
            rotation = self._quaternion(name)
            joint = ball(name, parent, body, at=at, frame=frame, rotation=rotation)
            self._damp_ball(own, name, joint, rotation.speeds)
            return joint, joint.frame
        if own.kind == "floating":
            if parent is not None:
                raise InputError(
                    f"joint {own.name}: it floats, but {own.parent!r} below it moves: a floating"
                    " joint stands on what does not move"
                )
            places = dynamicsymbols(f"{name}_x {name}_y {name}_z")
            rotation = self._quaternion(name)
            joint = free(name, body, at=at, frame=frame, coordinates=places, rotation=rotation)
            return joint, joint.frame
        # The plane is that of x and y of a frame whose z is the normal.
        upright = ImmutableMatrix(3, 3, lambda i, j: Integer(int((i - j - k - 1) % 3 == 0)))
        if way < 0:
            upright = upright * ImmutableMatrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]])
        flat = _turned(held, upright, f"{name}_plane")
        x, y, angle = dynamicsymbols(f"{name}_x {name}_y {name}_angle")
        joint = planar(name, parent, body, at=at, frame=flat, coordinates=(x, y), angle=angle)
        return joint, _turned(joint.frame, ImmutableMatrix((turn * upright).T), f"{name}_link")

    def _quaternion(self, name: str) -> Expr:
        coordinates = " ".join(f"{name}_e{k}" for k in range(4))
        return quaternion(coordinates, " ".join(f"{name}_w{k}" for k in "xyz"))

    def _act(self, own: Connection, name: str, drive: _Drive) -> None:
        """Loads and limits of a joint of one freedom, equation (1)."""
        q, rate = drive.q, drive.q.diff(_T)
        if own.driven and own.mimic is None:
            (motor,) = dynamicsymbols(f"tau_{name},")
            self.inputs.append(motor)
            self._load(f"motor_{name}", motor, drive)
            if own.limits.effort is not None and own.limits.effort > 0:
                self._limit(f"{name}_effort", Abs(motor) <= own.limits.effort, "asks too much")
        if own.damping:
            self._load(f"damping_{name}", -own.damping * rate, drive)
        if own.friction:
            self._load(f"friction_{name}", -own.friction * sign(rate), drive)
        if own.stiffness and drive.turning:
            ends = (drive.joint.child, drive.joint.parent)
            self.loads.append(
                torsion_spring(f"spring_{name}", q - own.rest, drive.along, own.stiffness, *ends)
            )
        elif own.stiffness:
            self._load(f"spring_{name}", -own.stiffness * (q - own.rest), drive)
        if own.armature:
            self._rotor(own, name, drive)
        lower, upper = own.limits.lower, own.limits.upper
        if lower is not None:
            self._limit(f"{name}_lower", q >= lower, "reaches its lower limit")
        if upper is not None:
            self._limit(f"{name}_upper", q <= upper, "reaches its upper limit")
        if own.limits.rate is not None and own.limits.rate > 0:
            self._limit(f"{name}_rate", Abs(rate) <= own.limits.rate, "moves too fast")
        if lower is not None and upper is not None and not lower <= 0 <= upper:
            self.example[name] = float((lower + upper) / 2)

    def _load(self, name: str, size: Expr, drive: _Drive) -> None:
        on, by = drive.joint.child, drive.joint.parent
        acting = (
            torque(name, size * drive.along, on=on, by=by)
            if drive.turning
            else force(name, drive.joint.point, size * drive.along, on=on, by=by)
        )
        self.loads.append(acting)

    def _limit(self, name: str, relation: Expr, otherwise: str) -> None:
        self.conditions.append(condition(name, relation, otherwise))

    def _damp_ball(
        self, own: Connection, name: str, joint: Joint, speeds: tuple[Expr, ...]
    ) -> None:
        if own.damping:
            axes = (joint.frame.x, joint.frame.y, joint.frame.z)
            couple = sum(
                (-own.damping * u * e for u, e in zip(speeds, axes, strict=True)), Vector(0)
            )
            self.loads.append(torque(f"damping_{name}", couple, on=joint.child, by=joint.parent))

    def _mimic(self, own: Connection) -> None:
        """Equation (2), and the couples or forces of one size that maintain it."""
        mimic = own.mimic
        assert mimic is not None
        if mimic.joint not in self.drives or own.name not in self.drives:
            raise InputError(
                f"joint {own.name}: it mimics {mimic.joint!r}: both have to turn or to slide"
            )
        drive, other = self.drives[own.name], self.drives[mimic.joint]
        name = f"{self.names[own.name]}_mimic"
        tie = _action(name, drive, Integer(1))
        if mimic.multiplier:
            tie = Reaction(tie.name, tie.on, tie.by, tie.along, tie.at,
                           (_action(name, other, -mimic.multiplier),))  # fmt: skip
        gap = drive.q - mimic.multiplier * other.q - mimic.offset
        self.reactions.append(tie)
        self.constraints.append(holonomic(f"{name}s", gap, name))

    def _rotor(self, own: Connection, name: str, drive: _Drive) -> None:
        raise InputError(f"joint {own.name}: it has an armature, {own.armature}")

    # ------------------------------------------------------------------ links

    def _body(self, link: str, spot: _Spot, inertial: Inertial | None) -> None:
        name = spot.body
        assert name is not None
        inertial = inertial or Inertial(Integer(0), NOWHERE, STRAIGHT, (Integer(0),) * 6)
        frame = _turned(spot.frame, inertial.turn, f"{name}_inertia")
        mass = self._value("mass", f"m_{name}", "kg", inertial.mass, positive=True)
        centre = [
            self._value("com", f"c{axis}_{name}", "m", entry)
            for axis, entry in zip("xyz", inertial.centre, strict=True)
        ]
        moments = [
            self._value("inertia", f"I{ends}_{name}", "kg*m^2", entry, positive=i < 3)
            for i, (ends, entry) in enumerate(zip(MOMENTS, inertial.moments, strict=True))
        ]
        at = spot.point
        if any(centre):
            x, y, z = spot.frame.x, spot.frame.y, spot.frame.z
            at = at.locatenew(f"{name}_centre", centre[0] * x + centre[1] * y + centre[2] * z)
        self.bodies.append(RigidBody(name, at, frame, mass, inertia(frame, *moments)))

    def _outputs(self) -> dict[str, Output]:
        """Position and orientation of the links that carry nothing more."""
        found: dict[str, Output] = {}
        parents = {joint.parent for joint in self.robot.joints}
        for link, spot in self.spots.items():
            if link not in parents and spot.body is not None:
                name = _numbered(self._link(link), self._known)
                found |= {f"{name}_position": position(spot.point),
                          f"{name}_orientation": orientation(spot.frame)}  # fmt: skip
        return found

    # ------------------------------------------------------------------ names and numbers

    def _name(self, name: str) -> str:
        """An identifier for a joint, such that its coordinates and reactions have names, too."""
        tried = _numbered(
            _identifier(name), lambda one: any(f"{one}{end}" in self.taken for end in _ENDS)
        )
        self.taken |= {f"{tried}{end}" for end in _ENDS}
        self.names[name] = tried
        return tried

    def _link(self, name: str) -> str:
        """An identifier for a link."""
        used = set(self.links.values())
        return self.links.setdefault(name, _numbered(_identifier(name), used.__contains__))

    def _known(self, name: str) -> bool:
        return f"{name}_position" in self.taken or f"{name}_orientation" in self.taken

    def _value(self, kind: str, name: str, unit: str, number: Expr, positive: bool = False) -> Expr:
        """A number, or the parameter that stands for it."""
        if kind not in self.symbolic or not isinstance(number, Rational) or number == 0:
            return number
        (symbol,) = parameters(name, unit, str(number), positive=positive)
        return symbol

    def _step(self, spot: _Spot, column: tuple[Expr, ...], name: str, of: str) -> Point:
        """A point of a link."""
        if not any(column):
            return spot.point
        x, y, z = (
            self._value("lengths", f"{axis}_{of}", "m", entry)
            for axis, entry in zip("xyz", column, strict=True)
        )
        frame = spot.frame
        return spot.point.locatenew(name, x * frame.x + y * frame.y + z * frame.z)


def _action(name: str, drive: _Drive, factor: Expr) -> Reaction:
    at = None if drive.turning else drive.joint.point
    return Reaction(name, drive.joint.child, drive.joint.parent, factor * drive.along, at)


def _turned(parent: ReferenceFrame, matrix: ImmutableMatrix, name: str) -> ReferenceFrame:
    """A frame that is fixed in another: v_parent = R v_frame."""
    if matrix == STRAIGHT:
        return parent
    frame = ReferenceFrame(name)
    frame.orient_explicit(parent, matrix)
    return frame


def _numbered(name: str, known: Callable[[str], bool]) -> str:
    """The name, or with the first number with which it is not known yet."""
    return next(
        one for one in (name, *(f"{name}_n{k}" for k in range(2, 10_000))) if not known(one)
    )


def _identifier(name: str) -> str:
    plain = re.sub(r"\W", "_", name, flags=re.ASCII).strip("_") or "part"
    return f"n{plain}" if not plain[0].isalpha() or iskeyword(plain) else plain
