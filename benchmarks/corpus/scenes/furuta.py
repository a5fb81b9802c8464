"""Rotary pendulums: an arm that turns about the vertical, a rod that turns about the arm."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, rotary_pendulum


def rods():
    """Two uniform rods, theta from upright."""
    theta, phi, tau = dynamicsymbols("theta phi torque")
    lp, mp, lr, mr, g = P("l_p:m m_p:kg l_r:m m_r:kg gravity:m/s^2")
    J = mp * lp**2 / 12
    return rotary_pendulum(
        phi, theta, lr, mr * lr**2 / 3, mp, lp / 2, (J, J, 0), -1, 1, g, tau, 0, (tau,)
    )


def hinge_only():
    """The rod's inertia I2 about its hinge alone, alpha from upright."""
    theta, alpha, u = dynamicsymbols("theta alpha u")
    I1, I2, m2, L1, c2, g = P("I1:kg*m^2 I2:kg*m^2 m2:kg L1:m Lc2:m g:m/s^2")
    return rotary_pendulum(theta, alpha, L1, I1, m2, c2, (I2, 0, 0), 1, 1, g, u, 0, (u,))


def adelaide():
    """Slender rod, theta_2 from hanging, frictions in both joints, torques tau_1, tau_2."""
    a, b, u, v = dynamicsymbols("theta_1 theta_2 tau_1 tau_2")
    m1, m2, l1, l2, L1, J1, J2, b1, b2, g = P(
        "m_1:kg m_2:kg l_1:m l_2:m L_1:m J_1:kg*m^2 J_2:kg*m^2 b_1:N*m*s b_2:N*m*s g:m/s^2"
    )
    return rotary_pendulum(
        a,
        b,
        L1,
        J1 + m1 * l1**2,
        m2,
        l2,
        (J2, J2, 0),
        1,
        -1,
        g,
        u - b1 * a.diff(),
        v - b2 * b.diff(),
        (u, v),
    )
