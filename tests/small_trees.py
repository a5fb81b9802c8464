"""Small models to compare on: an arm in space, a slider, a body that floats, a gripper."""

from dataclasses import replace

from sympy import pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    Torque,
    TorsionSpring,
    free,
    gravity,
    holonomic,
    orientation,
    parameters,
    pin,
    planar,
    position,
    quaternion,
    reaction_couple,
    slide,
    torque,
    torsion_spring,
)

MOMENTS = ("0.02", "0.03", "0.025", "0.002", "-0.003", "0.004")


def link(i: int, joint, frame, shift: str = "0.1 -0.05 0.2") -> RigidBody:
    """A body with a full inertia, off its joint."""
    (m,) = parameters(f"m{i}", "kg", f"{2 + i / 2}")
    x, y, z = parameters(f"x{i} y{i} z{i}", "m m m", shift, positive=False)
    moments = parameters(
        " ".join(f"I{e}{i}" for e in ("xx", "yy", "zz", "xy", "yz", "zx")),
        " ".join(["kg*m^2"] * 6), " ".join(MOMENTS), positive=False,
    )  # fmt: skip
    centre = joint.point.locatenew(f"C{i}", x * frame.x + y * frame.y + z * frame.z)
    return RigidBody(joint.child, centre, frame, m, inertia(frame, *moments))


def arm(count: int = 3, damped: str = "", tool: bool = False) -> Scene:
    """Turning joints in space with fixed quarter turns between them; with a tool of no mass.

    The tool is where a next joint would be, turned as that would be.
    """
    (g,) = parameters("g", "m/s^2", "9.81")
    N, O = ReferenceFrame("N"), Point("O")
    outer, at, before = N, O, None
    bodies, joints, loads = [], [], [gravity(-g * N.z)]
    for i, angle in enumerate(dynamicsymbols(f"q1:{count + 1}"), start=1):
        name = f"link{i}"
        joint = pin(f"joint{i}", before, name, at=at, axis=outer.z, angle=angle)
        bodies.append(link(i, joint, joint.frame))
        joints.append(joint)
        if damped:
            (b,) = parameters(f"b{i}", "N*m*s/rad", damped)
            loads.append(torque(f"damping{i}", -b * angle.diff() * outer.z, on=name, by=before))
        outer = joint.frame.orientnew(f"F{i}", "Axis", (pi / 2, joint.frame.x))
        at, before = joint.point.locatenew(f"P{i}", (0.3 + i / 10) * joint.frame.x), name
    outputs = {"tool_position": position(at), "tool_orientation": orientation(outer)}
    return Scene(
        "arm", N, O, bodies=tuple(bodies), joints=tuple(joints), loads=tuple(loads),
        outputs=outputs if tool else {},
    )  # fmt: skip


def sprung(power: int = 0) -> Scene:
    """The arm of two joints with dampers, and a spring in the second one that rests elsewhere.

    With a power the spring is a couple, proportional to that power of its angle.
    """
    base = arm(2, "0.4")
    k, r = parameters("k r", "N*m/rad rad", "3 1/5", positive=False)
    angle, axis = base.coordinates[1], base.joints[1].frame.z
    pull: TorsionSpring | Torque = torsion_spring("spring", angle - r, axis, k, "link2", "link1")
    if power:
        pull = torque("couple", -k * (angle - r) ** power * axis, on="link2", by="link1")
    return replace(base, loads=(*base.loads, pull))


def lift() -> Scene:
    """A carriage on a vertical rail, and an arm on it."""
    (g,) = parameters("g", "m/s^2", "9.81")
    N, O = ReferenceFrame("N"), Point("O")
    s, q = dynamicsymbols("s q")
    rail = slide("rail", None, "carriage", at=O, axis=N.z, distance=s)
    elbow = pin("elbow", "carriage", "arm", at=rail.point, axis=N.y, angle=q)
    bodies = (link(1, rail, rail.frame), link(2, elbow, elbow.frame))
    return Scene("lift", N, O, bodies=bodies, joints=(rail, elbow), loads=(gravity(-g * N.z),))


def floating() -> Scene:
    """A body that nothing holds, its mass centre off the point that its coordinates place."""
    (g,) = parameters("g", "m/s^2", "9.81")
    N, O = ReferenceFrame("N"), Point("O")
    base = free("base", "trunk", at=O, frame=N, coordinates=dynamicsymbols("x y z"),
                rotation=quaternion("e0 e1 e2 e3", "wx wy wz"))  # fmt: skip
    bodies = (link(1, base, base.frame),)
    return Scene("floating", N, O, bodies=bodies, joints=(base,), loads=(gravity(-g * N.z),))


def puck() -> Scene:
    """A body that slides and turns in a plane that is inclined, and an arm on it."""
    (g,) = parameters("g", "m/s^2", "9.81")
    N, O = ReferenceFrame("N"), Point("O")
    slope = N.orientnew("slope", "Axis", (pi / 6, N.x))
    table = planar("table", None, "puck", at=O, frame=slope, coordinates=dynamicsymbols("x y"),
                   angle=dynamicsymbols("angle"))  # fmt: skip
    elbow = pin("elbow", "puck", "arm", at=table.point, axis=table.frame.y,
                angle=dynamicsymbols("q"))  # fmt: skip
    bodies = (link(1, table, table.frame), link(2, elbow, elbow.frame))
    return Scene("puck", N, O, bodies=bodies, joints=(table, elbow), loads=(gravity(-g * N.z),))


def gripper() -> Scene:
    """Two fingers on a hand; the second one follows the first."""
    (g,) = parameters("g", "m/s^2", "9.81")
    N, O = ReferenceFrame("N"), Point("O")
    joints, bodies = [], []
    for i, angle in enumerate(dynamicsymbols("q1:3"), start=1):
        at = O.locatenew(f"P{i}", (i - 1) * N.x)
        joints.append(pin(f"joint{i}", None, f"finger{i}", at=at, axis=N.y, angle=angle))
        bodies.append(link(i, joints[-1], joints[-1].frame))
    first, second = (joint.coordinates[0] for joint in joints)
    gear = reaction_couple("gear", "finger1", None, N.y)
    gear = replace(gear, parts=(reaction_couple("gear", "finger2", None, N.y),))
    return Scene(
        "gripper", N, O, bodies=tuple(bodies), joints=tuple(joints), loads=(gravity(-g * N.z),),
        reactions=(gear,),
        constraints=(holonomic("mimic", second + first, "gear"),),
    )  # fmt: skip
