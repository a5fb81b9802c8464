"""Rotary pendulums: an arm that turns about the vertical, a rod that turns about the arm."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, rotary_pendulum


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
