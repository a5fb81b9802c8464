"""Arms of one and two joints in a plane."""

from sympy import cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P
from mechanics.scene import RigidBody, Scene, gravity, pin, torque


def _arm(angles, length, first, second, g, moments, inputs, *, turn=0):
    """Two links, the second angle from the first link; each (mass, x and y of its centre,
    inertia)."""
    a, b = angles
    N, O = ReferenceFrame("N"), Point("O")
    shoulder = pin("shoulder", None, "one", at=O, axis=N.z, angle=a)
    A = shoulder.frame
    ux, uy = cos(turn) * A.x + sin(turn) * A.y, -sin(turn) * A.x + cos(turn) * A.y
    elbow = pin(
        "elbow", "one", "two", at=shoulder.point.locatenew("E", length * ux), axis=A.z, angle=b
    )
    B = elbow.frame
    vx, vy = cos(turn) * B.x + sin(turn) * B.y, -sin(turn) * B.x + cos(turn) * B.y
    (m1, x1, y1, I1), (m2, x2, y2, I2) = first, second
    C1 = shoulder.point.locatenew("C1", x1 * ux + y1 * uy)
    C2 = elbow.point.locatenew("C2", x2 * vx + y2 * vy)
    loads = [gravity(-g * N.y)] if g != 0 else []
    if moments[0] != 0:
        loads.append(torque("shoulder moment", moments[0] * N.z, on="one"))
    if moments[1] != 0:
        loads.append(torque("elbow moment", moments[1] * N.z, on="two", by="one"))
    return Scene(
        "arm",
        N,
        O,
        plane=N.z,
        joints=(shoulder, elbow),
        loads=loads,
        inputs=inputs,
        bodies=(RigidBody("one", C1, A, m1, I1), RigidBody("two", C2, B, m2, I2)),
    )


def robotzoo():
    """Masses at the ends of the links, inertias about them, friction c in both joints."""
    a, b, u = dynamicsymbols("theta1 theta2 u")
    m1, m2, l1, l2, J1, J2, g, c = P("m1:kg m2:kg l1:m l2:m J1:kg*m^2 J2:kg*m^2 g:m/s^2 c:N*m*s")
    return _arm(
        (a, b), l1, (m1, l1, 0, J1), (m2, l2, 0, J2), g, (-c * a.diff(), u - c * b.diff()), (u,)
    )


def acrobot():
    """theta1 from the downward vertical; reinforcement learning's acrobot."""
    a, b, u = dynamicsymbols("theta1 theta2 a")
    m1, m2, l1, c1, c2, I1, I2, g = P("m1:kg m2:kg l1:m lc1:m lc2:m I1:kg*m^2 I2:kg*m^2 g:m/s^2")
    return _arm((a, b), l1, (m1, c1, 0, I1), (m2, c2, 0, I2), g, (0, u), (u,), turn=-pi / 2)


def murray():
    """In a horizontal plane, r_i to the centres of mass."""
    a, b, u, v = dynamicsymbols("theta_1 theta_2 tau_1 tau_2")
    m1, m2, l1, r1, r2, I1, I2 = P("m_1:kg m_2:kg l_1:m r_1:m r_2:m I_z1:kg*m^2 I_z2:kg*m^2")
    return _arm((a, b), l1, (m1, r1, 0, I1), (m2, r2, 0, I2), 0, (u, v), (u, v))


def lynch():
    """Point masses at the ends, from the horizontal."""
    a, b, u, v = dynamicsymbols("theta_1 theta_2 tau_1 tau_2")
    m1, m2, L1, L2, g = P("m_1:kg m_2:kg L_1:m L_2:m g:m/s^2")
    return _arm((a, b), L1, (m1, L1, 0, 0), (m2, L2, 0, 0), g, (u, v), (u, v))


def slotine():
    """In a horizontal plane; the load's centre is turned back by delta_e against the second
    link."""
    a, b, u, v = dynamicsymbols("q_1 q_2 tau_1 tau_2")
    m1, me, l1, c1, ce, I1, Ie, d = P(
        "m_1:kg m_e:kg l_1:m l_c1:m l_ce:m I_1:kg*m^2 I_e:kg*m^2 delta_e:1"
    )
    return _arm((a, b), l1, (m1, c1, 0, I1), (me, ce * cos(d), -ce * sin(d), Ie), 0, (u, v), (u, v))


def single():
    """A uniform rod on a shaft, theta from the horizontal."""
    theta = dynamicsymbols("theta")
    m, r, g = P("m:kg r:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    joint = pin("shaft", None, "arm", at=O, axis=N.z, angle=theta)
    C = joint.point.locatenew("C", r / 2 * joint.frame.x)
    return Scene(
        "arm",
        N,
        O,
        plane=N.z,
        joints=(joint,),
        loads=(gravity(-g * N.y),),
        bodies=(RigidBody("arm", C, joint.frame, m, m * r**2 / 12),),
    )
