"""Bodies that turn freely, by a unit quaternion: in the air, on a joint, sliding and rolling."""

from sympy import Matrix
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    free,
    gravity,
    holonomic,
    nonholonomic,
    parameters,
    pin,
    quaternion,
    reaction,
)

UNITS = {"m": "kg", "g": "m/s^2", "l": "m", "A": "kg*m^2", "B": "kg*m^2", "C": "kg*m^2"}
VALUES = {"m": 2, "g": 9.81, "l": 0.3, "A": 0.4, "B": 0.5, "C": 0.2}


def _declared(names: str) -> tuple:
    units, values = (" ".join(str(d[name]) for name in names.split()) for d in (UNITS, VALUES))
    return parameters(names, units, values)


def thrown_body() -> Scene:
    """A rigid body in the air, three moments of inertia."""
    x, y, z = dynamicsymbols("x y z")
    m, g, A, B, C = _declared("m g A B C")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    frame = turning.orient("F", ground)
    centre = origin.locatenew("P", x * ground.x + y * ground.y + z * ground.z)
    return Scene(
        "thrown_body",
        ground,
        origin,
        coordinates=(x, y, z),
        rotations=(turning,),
        bodies=(RigidBody("body", centre, frame, m, inertia(frame, A, B, C)),),
        loads=(gravity(-g * ground.z),),
        example={"wx": 0.1, "wy": 2, "wz": 0.1, "x_dot": 1},
    )


def ball_top() -> Scene:
    """A heavy top on a ball joint, A its moment of inertia about the mass centre."""
    m, g, l, A, C = _declared("m g l A C")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    frame = turning.orient("F", ground)
    axes = zip("xyz", (ground.x, ground.y, ground.z), strict=True)
    return Scene(
        "ball_top",
        ground,
        origin,
        coordinates=(),
        rotations=(turning,),
        bodies=(
            RigidBody("top", origin.locatenew("P", l * frame.z), frame, m, inertia(frame, A, A, C)),
        ),
        loads=(gravity(-g * ground.z),),
        reactions=tuple(
            reaction(f"R{name}", at=origin, on="top", by=None, along=axis) for name, axis in axes
        ),
        example={"e0": 0.95, "e1": 0.3, "wz": 20},
    )


def sliding_top() -> Scene:
    """A top whose tip slides on the ground: a quaternion in a holonomic constraint."""
    x, y, z = dynamicsymbols("x y z")
    m, g, l, A, C = _declared("m g l A C")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    frame = turning.orient("F", ground)
    centre = origin.locatenew("P", x * ground.x + y * ground.y + z * ground.z)
    tip = centre.locatenew("T", -l * frame.z)
    return Scene(
        "sliding_top",
        ground,
        origin,
        coordinates=(x, y, z),
        rotations=(turning,),
        bodies=(RigidBody("top", centre, frame, m, inertia(frame, A, A, C)),),
        loads=(gravity(-g * ground.z),),
        reactions=(reaction("N_z", at=tip, on="top", by=None, along=ground.z),),
        constraints=(holonomic("ground", z - l * turning.matrix[2, 2], "N_z"),),
        example={"e0": 0.95, "e1": 0.3, "wz": 20},
    )


def rolling_ball() -> Scene:
    """A ball whose mass is not spread evenly rolls on the ground; A and C about its centre."""
    x, y = dynamicsymbols("x y")
    m, g, l, A, C = _declared("m g l A C")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    frame = turning.orient("F", ground)
    centre = origin.locatenew("P", x * ground.x + y * ground.y + l * ground.z)
    contact = centre.locatenew("T", -l * ground.z)
    omega = turning.matrix * Matrix(turning.speeds)
    axes = zip("xyz", (ground.x, ground.y, ground.z), strict=True)
    return Scene(
        "rolling_ball",
        ground,
        origin,
        coordinates=(x, y),
        rotations=(turning,),
        bodies=(RigidBody("ball", centre, frame, m, inertia(frame, A, A, C)),),
        loads=(gravity(-g * ground.z),),
        reactions=tuple(
            reaction(f"R{name}", at=contact, on="ball", by=None, along=axis) for name, axis in axes
        ),
        constraints=(
            nonholonomic("roll x", x.diff() - l * omega[1], "Rx"),
            nonholonomic("roll y", y.diff() + l * omega[0], "Ry"),
        ),
        example={"wx": 1, "wy": 2, "wz": 3},
    )


def flyer() -> Scene:
    """A body in the air with an arm on a pin, made of joints."""
    x, y, z, angle = dynamicsymbols("x y z q")
    m, g, l, A, C = _declared("m g l A C")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    hull = free("base", "hull", at=origin, frame=ground, coordinates=(x, y, z), rotation=turning)
    edge = hull.point.locatenew("S", l * hull.frame.x)
    arm = pin("shoulder", "hull", "arm", at=edge, axis=hull.frame.z, angle=angle)
    centre = arm.point.locatenew("G", l * arm.frame.x)
    return Scene(
        "flyer",
        ground,
        origin,
        coordinates=(),
        joints=(hull, arm),
        bodies=(
            RigidBody("hull", hull.point, hull.frame, m, inertia(hull.frame, A, A, C)),
            RigidBody("arm", centre, arm.frame, m, inertia(arm.frame, C, A, A)),
        ),
        loads=(gravity(-g * ground.z),),
        example={"wx": 1, "q": 0.3},
    )
