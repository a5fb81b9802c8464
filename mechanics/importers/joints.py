"""Joints of a robot, and the links that they carry.

    tau = motor - damping q' - friction sign(q') - stiffness (q - rest)       at each joint   (1)

A link that does not move is the ground; one without mass that is fixed to another is a frame and a
point of that one.
"""

from sympy import Abs, Expr, ImmutableMatrix, Integer, sign
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from sympy.physics.vector import Vector

from mechanics.errors import InputError
from mechanics.importers.parts import Drive, Parts, Spot, action, turned
from mechanics.importers.robot import NOWHERE, STRAIGHT, Connection, Inertial
from mechanics.importers.rotations import about, towards
from mechanics.scene import (
    Joint,
    RigidBody,
    ball,
    free,
    pin,
    planar,
    quaternion,
    reaction,
    reaction_couple,
    slide,
    torque,
    torsion_spring,
    weld,
)
from mechanics.scene.reactions import Reaction
from mechanics.scene.rotations import Rotation

MOMENTS = ("xx", "yy", "zz", "xy", "yz", "xz")
_T = dynamicsymbols._t


def join(parts: Parts, own: Connection, spot: Spot) -> None:
    """A joint on what carries it, and the link that it carries, beside the others.

    Raises
    ------
    InputError
        When it floats on what moves.
    """
    name = parts.names[own.name]
    at = parts.step(spot, own.place, f"{name}_at", name)
    frame = turned(spot.frame, own.turn, f"{name}_base")
    inertial = parts.robot.link(own.child).inertial
    massive = inertial is not None and not inertial.nothing
    if own.kind == "fixed":
        carried = Spot(spot.body, at, frame)
        if massive and spot.body is not None:
            body = parts.link(own.child)
            joint = weld(name, spot.body, body, at=at, frame=frame)
            parts.joints.append(joint)
            carried = Spot(body, at, joint.frame)
    else:
        body = parts.link(own.child)
        joint, frame = _moving(parts, own, name, body, at, frame, spot)
        carried = Spot(body, joint.point, frame)
        parts.joints.append(joint)
    point = parts.step(carried, own.offset, f"{name}_link", f"back_{name}")
    parts.spots[own.child] = carried = Spot(carried.body, point, carried.frame)
    if carried.body is not None and carried.body != spot.body:
        _body(parts, own.child, carried, inertial)


def _moving(
    parts: Parts,
    own: Connection,
    name: str,
    body: str,
    at: Point,
    frame: ReferenceFrame,
    spot: Spot,
) -> tuple[Joint, ReferenceFrame]:
    """A joint with freedoms, and the frame of the link on it."""
    parent = spot.body
    turn, k, way = towards(own.axis)
    held, back = turned(frame, turn, f"{name}_axis"), turn.T
    if own.kind in ("turn", "slide"):
        (q,) = dynamicsymbols(f"{name},")
        if own.zero and own.kind == "turn":
            held = turned(held, ImmutableMatrix(about(k, -way * own.zero)), f"{name}_zero")
        along = way * (held.x, held.y, held.z)[k]
        if own.zero and own.kind == "slide":
            at = at.locatenew(f"{name}_zero", -own.zero * along)
        joint = (
            pin(name, parent, body, at=at, axis=along, angle=q)
            if own.kind == "turn"
            else slide(name, parent, body, at=at, axis=along, distance=q)
        )
        drive = Drive(q, joint, along, own.kind == "turn")
        parts.drives[own.name] = drive
        _act(parts, own, name, drive)
        return joint, turned(joint.frame, back, f"{name}_link")
    if own.kind == "ball":
        rotation = _quaternion(name)
        joint = ball(name, parent, body, at=at, frame=frame, rotation=rotation)
        _damp_ball(parts, own, name, joint, rotation.speeds)
        return joint, joint.frame
    if own.kind == "floating":
        if parent is not None:
            raise InputError(
                f"joint {own.name}: it floats, but {own.parent!r} below it moves: a floating"
                " joint stands on what does not move"
            )
        places = dynamicsymbols(f"{name}_x {name}_y {name}_z")
        rotation = _quaternion(name)
        joint = free(name, body, at=at, frame=frame, coordinates=places, rotation=rotation)
        return joint, joint.frame
    # The plane is that of x and y of a frame whose z is the normal.
    upright = ImmutableMatrix(3, 3, lambda i, j: Integer(int((i - j - k - 1) % 3 == 0)))
    if way < 0:
        upright = upright * ImmutableMatrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]])
    flat = turned(held, upright, f"{name}_plane")
    x, y, angle = dynamicsymbols(f"{name}_x {name}_y {name}_angle")
    joint = planar(name, parent, body, at=at, frame=flat, coordinates=(x, y), angle=angle)
    return joint, turned(joint.frame, ImmutableMatrix((turn * upright).T), f"{name}_link")


def _quaternion(name: str) -> Rotation:
    coordinates = " ".join(f"{name}_e{k}" for k in range(4))
    return quaternion(coordinates, " ".join(f"{name}_w{k}" for k in "xyz"))


def _act(parts: Parts, own: Connection, name: str, drive: Drive) -> None:
    """Loads and limits of a joint of one freedom, equation (1)."""
    q, rate = drive.q, drive.q.diff(_T)
    if own.driven:
        (motor,) = dynamicsymbols(f"tau_{name},")
        parts.inputs.append(motor)
        parts.load(f"motor_{name}", motor, drive)
        if own.limits.effort is not None and own.limits.effort > 0:
            parts.limit(
                f"{name}_effort", Abs(motor) <= own.limits.effort, "exceeds its effort limit"
            )
    if own.damping:
        parts.load(f"damping_{name}", -own.damping * rate, drive)
    if own.friction:
        parts.load(f"friction_{name}", -own.friction * sign(rate), drive)
    if own.stiffness and drive.turning:
        parts.loads.append(
            torsion_spring(f"spring_{name}", q - own.rest, drive.along, own.stiffness, *drive.ends)
        )
    elif own.stiffness:
        parts.load(f"spring_{name}", -own.stiffness * (q - own.rest), drive)
    if own.armature:
        _rotor(parts, own, name, drive)
    lower, upper = own.limits.lower, own.limits.upper
    if lower is not None:
        parts.limit(f"{name}_lower", q >= lower, "reaches its lower limit")
    if upper is not None:
        parts.limit(f"{name}_upper", q <= upper, "reaches its upper limit")
    if own.limits.rate is not None and own.limits.rate > 0:
        parts.limit(f"{name}_rate", Abs(rate) <= own.limits.rate, "exceeds its speed limit")
    if lower is not None and upper is not None and not lower <= 0 <= upper:
        parts.example[name] = float((lower + upper) / 2)


def _damp_ball(
    parts: Parts, own: Connection, name: str, joint: Joint, speeds: tuple[Expr, ...]
) -> None:
    if own.damping:
        axes = (joint.frame.x, joint.frame.y, joint.frame.z)
        couple = sum((-own.damping * u * e for u, e in zip(speeds, axes, strict=True)), Vector(0))
        parts.loads.append(torque(f"damping_{name}", couple, on=joint.child, by=joint.parent))


def _rotor(parts: Parts, own: Connection, name: str, drive: Drive) -> None:
    """What turns or slides on the ground as the joint does, and is driven by it.

    Its kinetic energy is armature q'^2 / 2, whatever the links do.
    """
    origin, ground = parts.ground.point, parts.ground.frame
    rotor, gear, child = f"{name}_rotor", f"{name}_gear", drive.joint.child
    inertial = parts.value("inertia", f"a_{name}", "kg*m^2" if drive.turning else "kg",
                           own.armature, positive=True)  # fmt: skip
    axes = dict(zip("xyz", (ground.x, ground.y, ground.z), strict=True))
    if drive.turning:
        axis, at = ground.z, origin
        frame = ground.orientnew(rotor, "Axis", (drive.q, axis))
        body = RigidBody(rotor, origin, frame, 0, inertia(frame, 0, 0, inertial))
        held = [reaction(f"{rotor}_{k}", origin, rotor, None, e) for k, e in axes.items()]
        held += [reaction_couple(f"{rotor}_m{k}", rotor, None, axes[k]) for k in "xy"]
    else:
        level = [k for k, pull in zip("xyz", parts.pull, strict=True) if pull == 0]
        if not level:
            raise InputError(
                f"joint {own.name}: an armature of a slide where gravity has three components"
                " is not read: let gravity be along an axis"
            )
        axis = axes.pop(level[0])
        at = origin.locatenew(rotor, drive.q * axis)
        frame = ground
        body = RigidBody(rotor, at, frame, inertial, inertia(frame, 0, 0, 0))
        held = [reaction(f"{rotor}_{k}", at, rotor, None, e) for k, e in axes.items()]
        held += [reaction_couple(f"{rotor}_m{k}", rotor, None, e)
                 for k, e in zip("xyz", (ground.x, ground.y, ground.z), strict=True)]  # fmt: skip
    where = None if drive.turning else at
    over = Reaction(gear, child, None, axis, where)
    tie = Reaction(gear, rotor, child, axis, where, (over, action(gear, drive, Integer(-1))))
    parts.bodies.append(body)
    parts.reactions += [*held, tie]


def _body(parts: Parts, link: str, spot: Spot, inertial: Inertial | None) -> None:
    name = spot.body
    assert name is not None
    inertial = inertial or Inertial(Integer(0), NOWHERE, STRAIGHT, (Integer(0),) * 6)
    frame = turned(spot.frame, inertial.turn, f"{name}_inertia")
    mass = parts.value("mass", f"m_{name}", "kg", inertial.mass, positive=True)
    centre = [
        parts.value("com", f"c{axis}_{name}", "m", entry)
        for axis, entry in zip("xyz", inertial.centre, strict=True)
    ]
    moments = [
        parts.value("inertia", f"I{ends}_{name}", "kg*m^2", entry, positive=i < 3)
        for i, (ends, entry) in enumerate(zip(MOMENTS, inertial.moments, strict=True))
    ]
    at = spot.point
    if any(centre):
        x, y, z = spot.frame.x, spot.frame.y, spot.frame.z
        at = at.locatenew(f"{name}_centre", centre[0] * x + centre[1] * y + centre[2] * z)
    parts.bodies.append(RigidBody(name, at, frame, mass, inertia(frame, *moments)))
