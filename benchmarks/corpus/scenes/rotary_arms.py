"""Arms, a rotary pendulum, a pendulum with a wheel."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, rotary_pendulum, two_link_arm
from mechanics.scene import RigidBody, Scene, gravity, pin, torque


def spong():
    """Mass centres at l_c1, l_c2, gravity."""
    q1, q2, u, v = dynamicsymbols("q_1 q_2 tau_1 tau_2")
    m1, m2, l1, c1, c2, I1, I2, g = P(
        "m_1:kg m_2:kg l_1:m l_c1:m l_c2:m I_1:kg*m^2 I_2:kg*m^2 g:m/s^2"
    )
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), g, (u, v), (u, v))


def construct():
    """In a horizontal plane."""
    q1, q2, u, v = dynamicsymbols("t1 t2 tau1 tau2")
    m1, m2, l1, c1, c2, I1, I2 = P("m1:kg m2:kg l1:m lc1:m lc2:m Izz1:kg*m^2 Izz2:kg*m^2")
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), 0, (u, v), (u, v))


def ends():
    """Point masses at the ends of a1, a2."""
    q1, q2, u, v = dynamicsymbols("q1 q2 tau1 tau2")
    m1, m2, a1, a2, g = P("m1:kg m2:kg a1:m a2:m g:m/s^2")
    return two_link_arm((q1, q2), a1, (m1, a1, 0), (m2, a2, 0), g, (u, v), (u, v))


def furuta():
    """Arm J_1 about its shaft, slender rod with J_p about its mass centre, alpha from upright;
    torque tau."""
    theta, alpha, tau = dynamicsymbols("theta alpha tau")
    J1, Jp, mp, Lr, lp, g = P("J_1:kg*m^2 J_p:kg*m^2 m_p:kg L_r:m l_p:m g:m/s^2")
    return rotary_pendulum(theta, alpha, Lr, J1, mp, lp, (Jp, Jp, 0), 1, 1, g, tau, 0, (tau,))


def wheel():
    """A pendulum from upright with a wheel at its end; q_2 of the wheel against the pendulum,
    torque tau between them."""
    q1, q2, tau = dynamicsymbols("q_1 q_2 tau")
    m1, m2, l1, c1, I1, I2, g = P("m_1:kg m_2:kg l_1:m l_c1:m I_1:kg*m^2 I_2:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "pendulum", at=O, axis=N.z, angle=q1)
    B = hold.frame
    shaft = pin(
        "shaft", "pendulum", "wheel", at=hold.point.locatenew("E", l1 * B.y), axis=B.z, angle=q2
    )
    return Scene(
        "inertia wheel pendulum",
        N,
        O,
        plane=N.z,
        joints=(hold, shaft),
        inputs=(tau,),
        bodies=(
            RigidBody("pendulum", hold.point.locatenew("C", c1 * B.y), B, m1, I1),
            RigidBody("wheel", shaft.point, shaft.frame, m2, I2),
        ),
        loads=(gravity(-g * N.y), torque("motor", tau * N.z, on="wheel", by="pendulum")),
    )
