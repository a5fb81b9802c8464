"""Planar arms: PR, RR with friction, RR of rods, RP."""

from sympy import sign
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, force, gravity, parameters, pin, slide, torque

q1, q2, theta, d_2 = dynamicsymbols("q1 q2 theta d_2")
tau1, tau2, tau_1, tau_2, u1, u2 = dynamicsymbols("tau1 tau2 tau_1 tau_2 u1 u2")
d, m1, m2, I, g = parameters(
    "d m1 m2 I g", units="m kg kg kg*m^2 m/s^2", typical="0.3 2 1 0.02 9.81"
)
L1, L2, I1, I2, b1, b2, fC1, fC2 = parameters(
    "L1 L2 I1 I2 b1 b2 fC1 fC2",
    units="m m kg*m^2 kg*m^2 N*m*s N*m*s N*m N*m",
    typical="0.2 0.15 0.02 0.01 0.1 0.1 0.2 0.2",
)
a1, a2 = parameters("a1 a2", units="m m", typical="0.4 0.3")
l1, l2 = parameters("l1 l2", units="m m", typical="0.4 0.3")
m_1, m_2, l_1, I_1, I_2 = parameters(
    "m_1 m_2 l_1 I_1 I_2", units="kg kg m kg*m^2 kg*m^2", typical="2 1 0.3 0.02 0.01"
)


def pr():
    """Slider along x, then a hinge; horizontal; d to the second mass centre."""
    N, O = ReferenceFrame("N"), Point("O")
    first = slide("first", None, "carriage", at=O, axis=N.x, distance=q1)
    second = pin("second", "carriage", "arm", at=first.point, axis=N.z, angle=q2)
    C = second.point.locatenew("C", d * second.frame.x)
    return Scene(
        "PR robot",
        N,
        O,
        bodies=(
            RigidBody("carriage", first.point, first.frame, m1, 0),
            RigidBody("arm", C, second.frame, m2, I),
        ),
        joints=(first, second),
        plane=N.z,
        loads=(
            force("u1", first.point, u1 * N.x, on="carriage"),
            torque("u2", u2 * N.z, on="arm", by="carriage"),
        ),
        inputs=(u1, u2),
        example={"q2": 0.5},
    )


def _rr(
    name, length1, centre1, centre2, inertia1, inertia2, angles, torques, mass1, mass2, friction=()
):
    N, O = ReferenceFrame("N"), Point("O")
    shoulder = pin("shoulder", None, "link1", at=O, axis=N.z, angle=angles[0])
    elbow_at = O.locatenew("E", length1 * shoulder.frame.x)
    elbow = pin("elbow", "link1", "link2", at=elbow_at, axis=shoulder.frame.z, angle=angles[1])
    C1 = O.locatenew("C1", centre1 * shoulder.frame.x)
    C2 = elbow.point.locatenew("C2", centre2 * elbow.frame.x)
    loads = [
        gravity(-g * N.y),
        torque("t1", torques[0] * N.z, on="link1"),
        torque("t2", torques[1] * N.z, on="link2", by="link1"),
    ]
    if friction:
        loads += [
            torque("f1", -friction[0] * N.z, on="link1"),
            torque("f2", -friction[1] * N.z, on="link2", by="link1"),
        ]
    return Scene(
        name,
        N,
        O,
        bodies=(
            RigidBody("link1", C1, shoulder.frame, mass1, inertia1),
            RigidBody("link2", C2, elbow.frame, mass2, inertia2),
        ),
        joints=(shoulder, elbow),
        plane=N.z,
        loads=tuple(loads),
        inputs=tuple(torques),
        example={angles[1].func.__name__: 0.5},
    )


def pm2r():
    """Links of lengths 2 L1 and 2 L2, friction, viscous and dry; from the horizontal."""
    friction = (fC1 * sign(q1.diff()) + b1 * q1.diff(), fC2 * sign(q2.diff()) + b2 * q2.diff())
    return _rr("PM2R", 2 * L1, L1, L2, I1, I2, (q1, q2), (tau1, tau2), m1, m2, friction)


def rods():
    """Uniform rods of lengths a1 and a2, from the horizontal."""
    return _rr(
        "planar arm of rods",
        a1,
        a1 / 2,
        a2 / 2,
        m1 * a1**2 / 12,
        m2 * a2**2 / 12,
        (q1, q2),
        (tau1, tau2),
        m1,
        m2,
    )


def rods_in_l():
    """Uniform rods of lengths l1 and l2, from the horizontal."""
    return _rr(
        "RR manipulator",
        l1,
        l1 / 2,
        l2 / 2,
        m1 * l1**2 / 12,
        m2 * l2**2 / 12,
        (q1, q2),
        (tau1, tau2),
        m1,
        m2,
    )


def rp():
    """A hinge, then a slider along the arm; centres of mass at l_1 and d_2; in a vertical plane."""
    N, O = ReferenceFrame("N"), Point("O")
    hinge = pin("hinge", None, "link1", at=O, axis=N.z, angle=theta)
    A = hinge.frame
    slider = slide("slider", "link1", "link2", at=O, axis=A.x, distance=d_2)
    C1 = O.locatenew("C1", l_1 * A.x)
    return Scene(
        "RP manipulator",
        N,
        O,
        bodies=(
            RigidBody("link1", C1, A, m_1, I_1),
            RigidBody("link2", slider.point, slider.frame, m_2, I_2),
        ),
        joints=(hinge, slider),
        plane=N.z,
        loads=(
            gravity(-g * N.y),
            torque("tau_1", tau_1 * N.z, on="link1"),
            force("tau_2", slider.point, tau_2 * A.x, on="link2", by="link1"),
        ),
        inputs=(tau_1, tau_2),
        example={"theta": 0.4, "d_2": 0.5},
    )
