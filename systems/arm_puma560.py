"""PUMA 560: six joints in space, with the parameters of P. I. Corke and B. Armstrong-Helouvry.

Frames by Denavit and Hartenberg's standard convention: joint i turns by q_i about z of the frame
before; its link's frame then lies d along that axis, a along the new x, and is turned about it.
Source: "A meta-study of PUMA 560 dynamics: a critical appraisal of literature data", Robotica 13
(1995) 253-258, as in Corke's Robotics Toolbox (`mdl_puma560`): lengths, masses, mass centres and
inertias in the frames of the links, of which the third is none that a body can have. Motors are
left out.

The source prints parameters, so there are no published rows; torques of gravity and inertias that
the toolbox prints at two poses are reproduced (`tests/systems/test_systems_published.py`). Of the
constants of gravity of B. Armstrong, O. Khatib and J. Burdick, "The explicit dynamic model and
inertial parameters of the PUMA 560 arm" (1986), typed from memory, three are those of this arm:
37.2, 1.02 and 0.249 N m. The fourth, 8.44 N m, is 8.74 here: Corke's table has the mass centre of
link 4 beyond the wrist by 0.019 m (y of its frame), Armstrong's before it: with ry4 = -0.019 it is
8.44, too.
"""

from sympy import pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import RigidBody, Scene, gravity, parameters, pin, torque

q = dynamicsymbols("q1:7")
tau = dynamicsymbols("tau1:7")
(g,) = parameters("g", units="m/s^2", typical="9.81", meanings=("acceleration of gravity",))
a2, a3, d3, d4 = parameters(
    "a2 a3 d3 d4",
    units="m m m m",
    typical="0.4318 0.0203 0.15005 0.4318",
    meanings=(
        "length of the upper arm",
        "offset of the elbow along the forearm's normal",
        "offset of the elbow along its axis",
        "length of the forearm",
    ),
)
TWISTS = (pi / 2, 0, -pi / 2, pi / 2, -pi / 2, 0)
"""Of each link's axis about the normal before it."""
LENGTHS = (0, a2, a3, 0, 0, 0)
OFFSETS = (0, 0, d3, d4, 0, 0)
MASSES = ("", "17.4", "4.8", "0.82", "0.34", "0.09")
CENTRES: tuple[dict[str, str], ...] = (
    {},
    {"x": "-0.3638", "y": "0.006", "z": "0.2275"},
    {"x": "-0.0203", "y": "-0.0141", "z": "0.070"},
    {"y": "0.019"},
    {},
    {"z": "0.032"},
)
INERTIAS = (
    {"yy": "0.35"},
    {"xx": "0.13", "yy": "0.524", "zz": "0.539"},
    {"xx": "0.066", "yy": "0.086", "zz": "0.0125"},
    {"xx": "0.0018", "yy": "0.0013", "zz": "0.0018"},
    {"xx": "0.0003", "yy": "0.0004", "zz": "0.0003"},
    {"xx": "0.00015", "yy": "0.00015", "zz": "0.00004"},
)
"""What is not listed is zero; of the first link the source gives what its joint moves."""


def _named(prefix: str, i: int, values: dict[str, str], unit: str, positive: bool) -> dict:
    return {
        axis: parameters(f"{prefix}{axis}{i}", units=unit, typical=value, positive=positive)[0]
        for axis, value in values.items()
    }


def scene() -> Scene:
    """Six links on a base, each driven by a torque in its joint."""
    ground, base = ReferenceFrame("N"), Point("O")
    frame, point, parent = ground, base, None
    bodies, joints, drives = [], [], []
    for i, (angle, drive, twist) in enumerate(zip(q, tau, TWISTS, strict=True), 1):
        link = f"link{i}"
        joint = pin(f"joint{i}", parent, link, at=point, axis=frame.z, angle=angle)
        drives.append(torque(f"tau{i}", drive * frame.z, on=link, by=parent))
        joints.append(joint)
        turned = joint.frame
        frame = turned.orientnew(f"L{i}", "Axis", (twist, turned.x)) if twist else turned
        offset = OFFSETS[i - 1] * turned.z + LENGTHS[i - 1] * turned.x
        point = joint.point.locatenew(f"O{i}", offset)
        centre = _named("r", i, CENTRES[i - 1], "m", positive=False)
        moments = _named("I", i, INERTIAS[i - 1], "kg*m^2", positive=True)
        bodies.append(
            RigidBody(
                link,
                point.locatenew(f"C{i}", sum((centre[k] * getattr(frame, k) for k in centre), 0)),
                frame,
                _named("m", i, {"": MASSES[i - 1]} if MASSES[i - 1] else {}, "kg", True).get("", 0),
                inertia(frame, *(moments.get(axis, 0) for axis in ("xx", "yy", "zz"))),
            )
        )
        parent = link
    return Scene(
        "PUMA 560",
        ground,
        base,
        bodies=tuple(bodies),
        joints=tuple(joints),
        loads=(gravity(-g * ground.z), *drives),
        inputs=tuple(tau),
        example={"q2": 0.5, "q3": -1.0},
        notes=("body link3: the source's 0.086 kg m^2 exceeds the sum of 0.066 and 0.0125",),
    )
