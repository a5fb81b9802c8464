"""Humanoid by rule: a trunk that floats in space, and limbs of one, two or three segments.

    leg     hip, knee, ankle        carry thigh, shank, foot
    arm     shoulder, elbow, wrist  carry upper arm, forearm, hand

Each joint turns about the lateral axis of what carries it, positive from hanging straight down to
the front; the trunk turns by a unit quaternion. Segments are slender: their inertia about their own
axis is a tenth of that across. Sizes are those of D. A. Winter, "Biomechanics and Motor Control of
Human Movement": lengths as parts of height, masses, mass centres from the joint above and radii of
gyration as parts of the whole and of the segment; head and neck belong to the trunk.
"""

from dataclasses import dataclass

from sympy import Expr, Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.errors import SceneError
from mechanics.scene import (
    RigidBody,
    Scene,
    free,
    gravity,
    parameters,
    pin,
    quaternion,
    torque,
)

HEIGHT, MASS = Rational("1.75"), Rational("70")
(g,) = parameters("g", units="m/s^2", typical="9.81", meanings=("acceleration of gravity",))


@dataclass(frozen=True)
class Segment:
    """A segment of a limb: parts of height and mass, of its length to its centre and gyration."""

    joint: str
    name: str
    length: str
    mass: str
    centre: str
    gyration: str


LEG = (
    Segment("hip", "thigh", "0.245", "0.100", "0.433", "0.323"),
    Segment("knee", "shank", "0.246", "0.0465", "0.433", "0.302"),
    Segment("ankle", "foot", "0.039", "0.0145", "0.500", "0.475"),
)
ARM = (
    Segment("shoulder", "upper_arm", "0.186", "0.028", "0.436", "0.322"),
    Segment("elbow", "forearm", "0.146", "0.016", "0.430", "0.303"),
    Segment("wrist", "hand", "0.108", "0.006", "0.506", "0.297"),
)
TRUNK = Segment("", "trunk", "0.288", "0.578", "0.660", "0.503")
"""With head and neck, from the hips up to the shoulders."""
WIDTHS = {"hips": "0.191", "shoulders": "0.259"}


def _typical(part: str, whole: Expr) -> str:
    return str(float(Rational(part) * whole))


def _sizes(segment: Segment) -> tuple[Expr, ...]:
    """Length, mass, distance of the centre from the joint, inertia across."""
    length = Rational(segment.length) * HEIGHT
    mass = Rational(segment.mass) * MASS
    across = mass * (Rational(segment.gyration) * length) ** 2
    word = segment.name.replace("_", " ")
    return parameters(
        " ".join(f"{letter}_{segment.name}" for letter in "lmcI"),
        units="m kg m kg*m^2",
        typical=" ".join(
            str(float(x)) for x in (length, mass, Rational(segment.centre) * length, across)
        ),
        meanings=(
            f"length of the {word}",
            f"mass of the {word}",
            f"distance of its mass centre from the joint, {word}",
            f"inertia across the {word}",
        ),
    )


def _body(name: str, joint: Point, frame: ReferenceFrame, sizes: tuple, sense: int) -> RigidBody:
    _, mass, centre, across = sizes
    place = joint.locatenew(f"centre of {name}", sense * centre * frame.z)
    return RigidBody(name, place, frame, mass, inertia(frame, across, across, across / 10))


def scene(segments: int = 2) -> Scene:
    """A trunk with two legs and two arms.

    Parameters
    ----------
    segments : int
        Of each limb, one to three: 4, 8 or 12 joints.

    Raises
    ------
    SceneError
        For any other number.
    """
    if not 1 <= segments <= len(LEG):
        raise SceneError(f"humanoid: {segments} segments a limb: it has one, two or three")
    ground, origin = ReferenceFrame("N"), Point("O")
    base = free(
        "base", "trunk", at=origin, frame=ground, coordinates=dynamicsymbols("x y z"),
        rotation=quaternion("e0 e1 e2 e3", "wx wy wz"),
    )  # fmt: skip
    hips, shoulders = parameters(
        "w_hips w_shoulders",
        units="m m",
        typical=" ".join(_typical(part, HEIGHT) for part in WIDTHS.values()),
        meanings=("distance of the hips", "distance of the shoulders"),
    )
    trunk = _sizes(TRUNK)
    bodies, joints = [_body("trunk", base.point, base.frame, trunk, 1)], [base]
    drives, inputs = [], []
    starts = (
        (LEG, "left", hips / 2, 0), (LEG, "right", -hips / 2, 0),
        (ARM, "left", shoulders / 2, trunk[0]), (ARM, "right", -shoulders / 2, trunk[0]),
    )  # fmt: skip
    sizes = {segment: _sizes(segment) for segment in (*LEG, *ARM)}
    for limb, side, across, up in starts:
        at = base.point.locatenew(
            f"{limb[0].joint} {side}", across * base.frame.y + up * base.frame.z
        )
        parent, frame = "trunk", base.frame
        for segment in limb[:segments]:
            name, joint = f"{side}_{segment.name}", f"{side}_{segment.joint}"
            angle, drive = dynamicsymbols(f"q_{joint} tau_{joint}")
            pinned = pin(joint, parent, name, at=at, axis=-frame.y, angle=angle)
            drives.append(torque(f"tau_{joint}", -drive * frame.y, on=name, by=parent))
            inputs.append(drive)
            joints.append(pinned)
            bodies.append(_body(name, pinned.point, pinned.frame, sizes[segment], -1))
            parent, frame = name, pinned.frame
            length = sizes[segment][0]
            at = pinned.point.locatenew(f"end of {name}", -length * frame.z)
    return Scene(
        f"humanoid of {4 * segments} joints",
        ground,
        origin,
        bodies=tuple(bodies),
        joints=tuple(joints),
        loads=(gravity(-g * ground.z), *drives),
        inputs=tuple(inputs),
        example={"z": 1.0},
    )
