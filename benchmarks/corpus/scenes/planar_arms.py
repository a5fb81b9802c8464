"""Arms of two links, a rotary pendulum, a ball on a beam."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, rotary_pendulum, two_link_arm
from mechanics.scene import Particle, RigidBody, Scene, gravity, reaction, torque


def double_link():
    """The weight's acceleration is GRAVITY; torques tau1, tau2."""
    q1, q2, u, v = dynamicsymbols("q1 q2 tau1 tau2")
    m1, m2, l1, c1, c2, I1, I2, g = P(
        "m1:kg m2:kg l1:m lc1:m lc2:m I1:kg*m^2 I2:kg*m^2 GRAVITY:m/s^2"
    )
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), g, (u, v), (u, v))


def swinging():
    """Without torques, mass centres at r1, r2."""
    q1, q2 = dynamicsymbols("theta_a theta_b")
    m1, m2, l1, c1, c2, I1, I2, g = P("m1:kg m2:kg l1:m r1:m r2:m I1:kg*m^2 I2:kg*m^2 g:m/s^2")
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), g, (0, 0), ())


def horizontal():
    """In a horizontal plane, with torques."""
    q1, q2, u, v = dynamicsymbols("q1 q2 tau1 tau2")
    m1, m2, l1, c1, c2, I1, I2 = P("m1:kg m2:kg l1:m lc1:m lc2:m I1:kg*m^2 I2:kg*m^2")
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), 0, (u, v), (u, v))


def ends():
    """In a horizontal plane, the masses at the ends."""
    q1, q2, u, v = dynamicsymbols("q1 q2 tau1 tau2")
    m1, m2, l1, l2 = P("M1:kg M2:kg L1:m L2:m")
    return two_link_arm((q1, q2), l1, (m1, l1, 0), (m2, l2, 0), 0, (u, v), (u, v))


def pendubot():
    """A motor tau_1 at the shoulder only."""
    q1, q2, u = dynamicsymbols("q_1 q_2 tau_1")
    m1, m2, l1, c1, c2, I1, I2, g = P(
        "m_1:kg m_2:kg l_1:m l_c1:m l_c2:m I_1:kg*m^2 I_2:kg*m^2 g:m/s^2"
    )
    return two_link_arm((q1, q2), l1, (m1, c1, I1), (m2, c2, I2), g, (u, 0), (u,))


def furuta():
    """Arm J_arm about its shaft, slender rod J_pend about its mass centre at l_pend, theta_pend
    from below; torque tau."""
    theta, alpha, tau = dynamicsymbols("theta_arm theta_pend tau")
    J1, Jp, mp, Lr, lp, g = P("J_arm:kg*m^2 J_pend:kg*m^2 m_pend:kg L_arm:m l_pend:m g:m/s^2")
    return rotary_pendulum(theta, alpha, Lr, J1, mp, lp, (Jp, Jp, 0), 1, -1, g, tau, 0, (tau,))


def ball_beam():
    """A ball, a point mass m, at r from the pivot of a beam with the inertia J about it; torque
    tau."""
    r, theta, tau = dynamicsymbols("r theta tau")
    m, J, g = P("m:kg J:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    ball = O.locatenew("B", r * A.x)
    return Scene(
        "ball on beam",
        N,
        O,
        coordinates=(r, theta),
        inputs=(tau,),
        example={"r": 0.2, "theta": 0.1},
        bodies=(Particle("ball", ball, m), RigidBody("beam", O, A, 0, J)),
        loads=(gravity(-g * N.y), torque("motor", tau * N.z, on="beam")),
        reactions=(
            *held(O, "beam", X=N.x, Y=N.y),
            reaction("P", at=ball, on="ball", by="beam", along=A.y),
        ),
    )
