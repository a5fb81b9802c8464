"""Scenes over which faults are planted."""

from collections.abc import Callable, Mapping
from functools import partial

from sympy import Rational, cos, pi, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    ball,
    cylindrical,
    euler,
    force,
    free,
    gravity,
    parameters,
    pin,
    planar,
    quaternion,
    reaction,
    reaction_couple,
    roll,
    rope,
    slide,
    spring,
    torque,
    universal,
    weld,
)
from mechanics.scene.composite import composite, part
from mechanics.scene.euler import Euler
from mechanics.scene.loads import damper, torsion_spring
from mechanics.scene.rotations import Rotation
from mechanics.scene.shapes import Disc, Rectangle, Ring, Rod, Semidisc
from systems import EVERY


def plate() -> Scene:
    """A pendulum cut from every shape, on a support moved by hand; a bead slides along it."""
    R, rho, g = parameters("R rho g")
    theta, s, y = dynamicsymbols("theta s y")
    cut = composite(
        (
            part(Rectangle(2 * R, R), density=rho, at=(R, 0), angle=pi / 6),
            part(Disc(R), density=rho, at=(0, R)),
            part(Semidisc(R), density=2 * rho, at=(R, R), angle=pi / 3),
            part(Ring(R / 2), density=rho * R),
            part(Rod(R), mass=rho * R**2, at=(0, -R)),
        )
    )
    N, O = ReferenceFrame("N"), Point("O")
    frame = N.orientnew("A", "Axis", (theta, N.z))
    pivot = O.locatenew("P", y * N.x)
    x_c, y_c = cut.centroid
    centre = O.locatenew("C", y * N.x + x_c * frame.x + y_c * frame.y)
    bead = pivot.locatenew("D", s * frame.x + R * frame.y)
    return Scene(
        "plate", N, O, coordinates=(theta, s), inputs=(y,),
        bodies=(
            RigidBody("plate", centre, frame, cut.mass, cut.inertia),
            Particle("bead", bead, rho * R**2),
        ),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("X", at=pivot, on="plate", by=None, along=N.x),
            reaction("Y", at=pivot, on="plate", by=None, along=N.y),
            reaction("B", at=bead, on="bead", by="plate", along=frame.y),
        ),
    )  # fmt: skip


def arm(count: int = 3) -> Scene:
    """Turning joints in space with a quarter turn between two of them; every kind of load."""
    m, L, k, c, g, A, B, C = parameters("m L k c g A B C")
    angles = dynamicsymbols(f"q1:{count + 1}")
    tau, f = dynamicsymbols("tau f")
    N, O = ReferenceFrame("N"), Point("O")
    frame, pivot, inner = N, O, None
    bodies, reactions = [], []
    for i, angle in enumerate(angles, 1):
        if i == 2:
            frame = frame.orientnew(f"F{i}", "Axis", (pi / 2, frame.x))
        frame = frame.orientnew(f"B{i}", "Axis", (angle, frame.z))
        name, axes = f"link{i}", (("x", frame.x), ("y", frame.y), ("z", frame.z))
        centre = pivot.locatenew(f"C{i}", L / 2 * frame.x)
        bodies.append(RigidBody(name, centre, frame, m, inertia(frame, A, B, C)))
        reactions += [
            *(reaction(f"R{x}{i}", at=pivot, on=name, by=inner, along=e) for x, e in axes),
            *(reaction_couple(f"Q{x}{i}", on=name, by=inner, along=e) for x, e in axes[:2]),
        ]
        pivot, inner = pivot.locatenew(f"P{i}", L * frame.x), name
    one, two, three = bodies[0], bodies[-2], bodies[-1]
    return Scene(
        "arm in space", N, O, coordinates=angles, inputs=(tau, f), bodies=tuple(bodies),
        loads=(
            gravity(-g * N.y),
            torque("tau", tau * two.frame.z, on=two.name, by=f"link{count - 2}"),
            force("f", pivot, f * two.frame.x, on=three.name),
            spring("k", O, three.centre, k, length=L / 3),
            damper("c", one.centre, three.centre, c),
            torsion_spring("t", angles[-1], three.frame.z, k * L**2, on=three.name, by=two.name),
        ),
        reactions=tuple(reactions),
    )  # fmt: skip


def trammel() -> Scene:
    """A rod whose end and mass centre slide along oblique lines; a speed that is no rate."""
    a, b, k, m, A, g, f = parameters("a b k m A g f")
    theta, u = dynamicsymbols("theta u")
    N, O = ReferenceFrame("N"), Point("O")
    rod = N.orientnew("B", "Axis", (theta, N.z))
    one, two = (N.x - N.y) / sqrt(2), (N.x + N.y) / sqrt(2)
    start = O.locatenew("S", (b + Rational(1, 2)) * N.y)
    end = start.locatenew("E", a * cos(theta) * one + b * two)
    centre = start.locatenew("C", (b - a * sin(theta)) * two)
    return Scene(
        "trammel", N, O, coordinates=(theta,), speeds=((u, 2 * theta.diff()),),
        bodies=(RigidBody("rod", centre, rod, m, A),),
        loads=(
            gravity(-g * N.y),
            spring("k", O, centre, k, length=a),
            force("f", end, f * one, on="rod"),
        ),
        reactions=(
            reaction("R1", at=end, on="rod", by=None, along=two),
            reaction("R2", at=centre, on="rod", by=None, along=one),
        ),
    )  # fmt: skip


def chain_of_joints() -> Scene:
    """Joints in space in a row, two about oblique axes, and a box welded to the first body."""
    m, L, k, g, A, B, C = parameters("m L k g A B C")
    s, a, x, b, c, d = dynamicsymbols("s a x b c d")
    N, O = ReferenceFrame("N"), Point("O")
    one = slide("rail", None, "cart", at=O, axis=3 * N.x + 4 * N.z, distance=s)
    two = cylindrical("sleeve", "cart", "drum", at=one.point.locatenew("S", L * N.y),
                      axis=one.frame.y - one.frame.x, angle=a, distance=x)  # fmt: skip
    three = universal("cross", "drum", "stick", at=two.point.locatenew("U", L * two.frame.x),
                      frame=two.frame, axes="xz", angles=(b, c))  # fmt: skip
    four = pin("hinge", "stick", "tip", at=three.point.locatenew("H", L * three.frame.y),
               axis=-2 * three.frame.z, angle=d)  # fmt: skip
    five = weld("glue", "cart", "box", at=one.point.locatenew("W", L * one.frame.z),
                frame=one.frame)  # fmt: skip
    joints = one, two, three, four, five
    bodies = tuple(
        RigidBody(joint.child, joint.point.locatenew(f"C{i}", i * L * joint.frame.x / 2),
                  joint.frame, m, inertia(joint.frame, A, B, C))
        for i, joint in enumerate(joints)
    )  # fmt: skip
    tip = four.point.locatenew("T", L * four.frame.z)
    return Scene(
        "chain of joints", N, O, joints=joints, bodies=bodies,
        loads=(
            gravity(-g * N.y),
            spring("k", one.point.locatenew("Q", L * N.x), tip, k, length=L / 3,
                   first_on="cart", second_on="tip"),
        ),
    )  # fmt: skip


def hung_plate() -> Scene:
    """A rod on a pin and a plate in the plane; a pin closes the loop, a spring joins both."""
    m, L, k, g, A = parameters("m L k g A", typical="2 1/2 30 9.81 1/10")
    x, y, a, b = dynamicsymbols("x y a b")
    N, O = ReferenceFrame("N"), Point("O")
    rod = pin("pivot", None, "rod", at=O, axis=-N.z, angle=b)
    plate = planar("plane", None, "plate", at=O, frame=N, coordinates=(x, y), angle=a)
    nail = pin("nail", "rod", "plate", at=O.locatenew("Q", -L * rod.frame.y), axis=rod.frame.z,
               onto=plate.point.locatenew("P", L * plate.frame.y))  # fmt: skip
    return Scene(
        "hung plate", N, O, plane=N.z, joints=(rod, plate, nail),
        bodies=(
            RigidBody("rod", O.locatenew("C", -L / 2 * rod.frame.y), rod.frame, m, A),
            RigidBody("plate", plate.point, plate.frame, m, A),
        ),
        loads=(
            gravity(-g * N.y),
            spring("k", plate.point.locatenew("S", L / 3 * plate.frame.y),
                   O.locatenew("T", -L / 2 * rod.frame.y), k, length=L,
                   first_on="plate", second_on="rod"),
        ),
        example={"x": 0, "y": -1, "a": 0, "b": 0},
    )  # fmt: skip


def held_block() -> Scene:
    """A body by Euler angles that a sleeve holds: a loop in space."""
    m, L, g, A, B, C = parameters("m L g A B C")
    x, y, z, a, b, c = dynamicsymbols("x y z a b c")
    N, O = ReferenceFrame("N"), Point("O")
    air = free("air", "block", at=O, frame=N, coordinates=(x, y, z),
               rotation=euler("xyz", a, b, c))  # fmt: skip
    hung = air.point.locatenew("P", L * air.frame.y)
    sleeve = cylindrical("sleeve", None, "block", at=O, axis=N.z,
                         onto=(hung, air.frame.z))  # fmt: skip
    return Scene(
        "held block", N, O, joints=(air, sleeve),
        bodies=(RigidBody("block", air.point, air.frame, m, inertia(air.frame, A, B, C)),),
        loads=(gravity(-g * N.y),), example={"y": -0.5},
    )  # fmt: skip


def top(name: str, rotation: Euler | Rotation, example: Mapping[str, float]) -> Scene:
    """A heavy top on a ball joint."""
    m, L, g, A, C = parameters("m L g A C", typical="2 0.3 9.81 0.4 0.2")
    N, O = ReferenceFrame("N"), Point("O")
    foot = ball("foot", None, "top", at=O, frame=N, rotation=rotation)
    centre = foot.point.locatenew("C", L * foot.frame.z)
    return Scene(
        name, N, O, joints=(foot,),
        bodies=(RigidBody("top", centre, foot.frame, m, inertia(foot.frame, A, A, C)),),
        loads=(gravity(-g * N.z),), example=example,
    )  # fmt: skip


def quaternion_top() -> Scene:
    """A top without a chart."""
    rotation = quaternion("e0 e1 e2 e3", "wx wy wz")
    return top("quaternion top", rotation, {"e0": 0.95, "e1": 0.3, "wz": 20})


def euler_top() -> Scene:
    """A top by angles that are regular where it is upright."""
    return top("top by Euler angles", euler("xyz", *dynamicsymbols("a b c")), {})


def leaning_wheel() -> Scene:
    """A wheel that leans below its plane, by its total spin rate and the velocities of contact."""
    m, R, g, A, C = parameters("m R g A C")
    x, y, yaw, lean, spin, w, v, s = dynamicsymbols("x y yaw lean spin w v s")
    N, O = ReferenceFrame("N"), Point("O")
    wheel = roll("wheel", None, "wheel", at=O, normal=-N.z, radius=R, coordinates=(x, y),
                 angles=(yaw, lean, spin), speeds=(w, v, s))  # fmt: skip
    body = RigidBody("wheel", wheel.point, wheel.frame, m, inertia(wheel.frame, A, C, A))
    return Scene("leaning wheel", N, O, joints=(wheel,), bodies=(body,),
                 loads=(gravity(g * N.z + g / 3 * N.x),), example={"lean": 0.2})  # fmt: skip


def unicycle() -> Scene:
    """A wheel that leans and a frame on its hub; the plane is a plate that moves along a rail."""
    m, R, g, A, C = parameters("m R g A C")
    z, x, y, yaw, lean, spin, tilt = dynamicsymbols("z x y yaw lean spin tilt")
    N, O = ReferenceFrame("N"), Point("O")
    rail = slide("rail", None, "plate", at=O, axis=N.x, distance=z)
    wheel = roll("wheel", "plate", "wheel", at=rail.point, normal=N.z, radius=R,
                 coordinates=(x, y), angles=(yaw, lean, spin))  # fmt: skip
    seat = pin("seat", "wheel", "frame", at=wheel.point, axis=wheel.hub.y, angle=tilt)
    top = seat.point.locatenew("T", R * seat.frame.z)
    bodies = (
        RigidBody("plate", rail.point, rail.frame, m, inertia(rail.frame, A, A, A)),
        RigidBody("wheel", wheel.point, wheel.frame, m, inertia(wheel.frame, A, C, A)),
        RigidBody("frame", top, seat.frame, m, inertia(seat.frame, A, A, C)),
    )
    return Scene("unicycle", N, O, joints=(rail, wheel, seat), bodies=bodies,
                 loads=(gravity(-g * N.z),), example={"lean": 0.2})  # fmt: skip


def wheels_in_space() -> Scene:
    """An upright wheel on a slope, and one in a ring that turns, each held in space."""
    m, R, r, g, A, B = parameters("m R r g A B", typical="1 1 0.3 9.81 0.1 0.2")
    x, a, b, phi, c = dynamicsymbols("x a b phi c")
    N, O = ReferenceFrame("N"), Point("O")
    upright = roll("upright", None, "wheel", at=O, normal=N.y, axis=N.z, radius=r,
                   coordinates=(x,), angles=(a,))  # fmt: skip
    hinge = pin("hinge", None, "ring", at=O.locatenew("H", 3 * R * N.y), axis=N.z, angle=b)
    ring = hinge.frame
    inner = roll("inner", "ring", "roller", at=hinge.point, normal=-ring.y, axis=ring.z,
                 inside=R, radius=r, angles=(phi, c))  # fmt: skip
    joints = upright, hinge, inner
    bodies = tuple(
        RigidBody(joint.child, joint.point, joint.frame, m, inertia(joint.frame, A, A, B))
        for joint in joints
    )
    return Scene("wheels in space", N, O, joints=joints, bodies=bodies,
                 loads=(gravity(g / 3 * N.x - g * N.y),))  # fmt: skip


def rolling_body(axle: bool) -> Scene:
    """A free ellipsoid on a plane, or a wheel by its axle; it carries a rod."""
    m, g, A, B, C = parameters("m g A B C")
    sizes = parameters("a1 a2 a3")
    x, y, z, a, b, c = dynamicsymbols("x y z a b c")
    N, O = ReferenceFrame("N"), Point("O")
    air = free("air", "body", at=O, frame=N, coordinates=(x, y, z),
               rotation=euler("zxy", a, b, c))  # fmt: skip
    own = {"radius": sizes[0], "axis": air.frame.y} if axle else {"radius": sizes}
    touch = roll("touch", None, "body", at=O, normal=N.z, onto=(air.point, air.frame), **own)
    body = RigidBody("body", air.point, air.frame, m, inertia(air.frame, A, B, C))
    return Scene("rolling wheel" if axle else "rolling ellipsoid", N, O, joints=(air, touch),
                 bodies=(body,), loads=(gravity(-g * N.z + g / 3 * N.x),),
                 example={"z": 1})  # fmt: skip


def crane() -> Scene:
    """A rope from the ground over the tip of a beam to a load, another from the load to a mass."""
    m, L, l, h, g, A = parameters("m L l h g A", typical="1 4 3 1 9.81 0.5")
    a, x, y, z, s = dynamicsymbols("a x y z s")
    N, O = ReferenceFrame("N"), Point("O")
    hinge = pin("hinge", None, "beam", at=O, axis=N.z, angle=a)
    air = free("air", "load", at=O, frame=N, coordinates=(x, y, z))
    tip = O.locatenew("T", 2 * h * hinge.frame.x)
    lift = rope("lift", (None, O.locatenew("W", 3 * h * N.y - h * N.x)), ("beam", tip),
                ("load", air.point), length=L)  # fmt: skip
    counter = O.locatenew("K", -h * N.x - s * N.y)
    tow = rope("tow", ("counter", counter), (None, O.locatenew("P", -h * N.x)),
               ("load", air.point), length=l, along=(N.y, None))  # fmt: skip
    guides = [
        reaction(f"guide_{k}", counter, "counter", None, e) for k, e in (("x", N.x), ("z", N.z))
    ]
    return Scene(
        "crane", N, O, joints=(hinge, air, lift, tow), coordinates=(s,), reactions=tuple(guides),
        bodies=(
            RigidBody("beam", O.locatenew("C", h * hinge.frame.x), hinge.frame, m,
                      inertia(hinge.frame, A, A, A)),
            Particle("load", air.point, m), Particle("counter", counter, m),
        ),
        loads=(gravity(-g * N.y),), example={"x": 1.5, "y": -0.5, "s": 1},
    )  # fmt: skip


OWN: dict[str, Callable[[], Scene]] = {
    "plate": plate,
    "trammel": trammel,
    "arm": arm,
    "arm of programs": partial(arm, 4),
    "chain of joints": chain_of_joints,
    "hung plate": hung_plate,
    "held block": held_block,
    "quaternion top": quaternion_top,
    "top by Euler angles": euler_top,
    "leaning wheel": leaning_wheel,
    "unicycle": unicycle,
    "wheels in space": wheels_in_space,
    "rolling ellipsoid": partial(rolling_body, False),
    "rolling wheel": partial(rolling_body, True),
    "crane": crane,
}
"""Made for faults, of what no shipped system has."""
SHIPPED: dict[str, Callable[[], Scene]] = {system.name: system.scene for system in EVERY}
SCENES = {**SHIPPED, **OWN}
GROUPS = {"shipped": tuple(SHIPPED), "own": tuple(OWN)}
