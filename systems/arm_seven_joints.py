"""Franka Emika's Panda: seven joints in space, with identified parameters.

Frames by Denavit and Hartenberg's modified convention, as Craig's: from one link's frame to the
next a along x, a turn about x, d along z, the joint's angle about z. Lengths are those of the
maker's documentation; masses, mass centres and inertias about them are those of C. Gaz,
M. Cognetti, A. Oliva, P. Robuffo Giordano and A. De Luca, "Dynamic identification of the Franka
Emika Panda robot", IEEE Robotics and Automation Letters 4 (2019) 4147-4154, as `franka_ros` has
them. The output is the flange.
"""

from sympy import pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import RigidBody, Scene, gravity, parameters, pin, position, torque

q = dynamicsymbols("q1:8")
tau = dynamicsymbols("tau1:8")
(g,) = parameters("g", units="m/s^2", typical="9.81", meanings=("acceleration of gravity",))
LENGTHS = d1, d3, d5, df, a4, a7 = parameters(
    "d1 d3 d5 df a4 a7",
    units="m m m m m m",
    typical="0.333 0.316 0.384 0.107 0.0825 0.088",
    meanings=(
        "height of the shoulder",
        "length of the upper arm",
        "length of the forearm",
        "from the last joint to the flange",
        "offset of the elbow",
        "offset of the wrist",
    ),
)
ROWS = (
    (0, 0, d1), (0, -pi / 2, 0), (0, pi / 2, d3), (a4, pi / 2, 0),
    (-a4, -pi / 2, d5), (0, pi / 2, 0), (a7, pi / 2, 0),
)  # fmt: skip
"""Of each joint: a along x, the turn about x, d along z."""
LINKS = (
    ("4.970684", "0.003875 0.002081 -0.04762",
     "0.70337 0.70661 0.009117 -0.000139 0.019169 0.006772"),
    ("0.646926", "-0.003141 -0.02872 0.003495",
     "0.007962 0.02811 0.025995 -0.003925 0.000704 0.010254"),
    ("3.228604", "0.027518 0.039252 -0.066502",
     "0.037242 0.036155 0.01083 -0.004761 -0.012805 -0.011396"),
    ("3.587895", "-0.05317 0.104419 0.027454",
     "0.025853 0.019552 0.028323 0.007796 0.008641 -0.001332"),
    ("1.225946", "-0.011953 0.041065 -0.038437",
     "0.035549 0.029474 0.008627 -0.002117 0.000229 -0.004037"),
    ("1.666555", "0.060149 -0.014117 -0.010517",
     "0.001964 0.004354 0.005433 0.000109 0.000341 -0.001158"),
    ("0.735522", "0.010517 -0.004252 0.061597",
     "0.012516 0.010027 0.004815 -0.000428 -0.000741 -0.001196"),
)  # fmt: skip
"""Mass, mass centre, and moments and products of inertia, xx yy zz xy yz zx."""
MOMENTS = ("xx", "yy", "zz", "xy", "yz", "zx")


def _link(i: int, name: str, frame: ReferenceFrame, origin: Point) -> RigidBody:
    mass, centre, moments = LINKS[i - 1]
    (m,) = parameters(f"m{i}", units="kg", typical=mass)
    xyz = parameters(f"x{i} y{i} z{i}", units="m m m", typical=centre, positive=False)
    about = [
        parameters(f"I{axis}{i}", units="kg*m^2", typical=value, positive=axis in MOMENTS[:3])[0]
        for axis, value in zip(MOMENTS, moments.split(), strict=True)
    ]
    place = sum((r * e for r, e in zip(xyz, (frame.x, frame.y, frame.z), strict=True)), 0)
    return RigidBody(name, origin.locatenew(f"C{i}", place), frame, m, inertia(frame, *about))


def scene() -> Scene:
    """Seven links on a base, each driven by a torque in its joint."""
    ground, base = ReferenceFrame("N"), Point("O")
    frame, point, parent = ground, base, None
    bodies, joints, drives = [], [], []
    for i, (angle, drive, (a, twist, d)) in enumerate(zip(q, tau, ROWS, strict=True), 1):
        link = f"link{i}"
        turned = frame.orientnew(f"B{i}", "Axis", (twist, frame.x)) if twist else frame
        at = point.locatenew(f"J{i}", a * frame.x + d * turned.z)
        joint = pin(f"joint{i}", parent, link, at=at, axis=turned.z, angle=angle)
        joints.append(joint)
        drives.append(torque(f"tau{i}", drive * turned.z, on=link, by=parent))
        frame, point, parent = joint.frame, joint.point, link
        bodies.append(_link(i, link, frame, point))
    return Scene(
        "arm with seven joints",
        ground,
        base,
        bodies=tuple(bodies),
        joints=tuple(joints),
        loads=(gravity(-g * ground.z), *drives),
        inputs=tuple(tau),
        outputs={"flange": position(point.locatenew("F", df * frame.z))},
        example={"q2": -0.785, "q4": -2.356, "q6": 1.571, "q7": 0.785},
    )
