"""Rotary pendulums: an arm that turns about the vertical, a rod that turns about the arm."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P
from mechanics.scene import RigidBody, Scene, gravity, pin, torque


def _rotary(
    arm, rod, reach, arm_inertia, mass, centre, moments, sense, up, g, drive, brake, inputs
):
    """The rod's end goes forward with sense +1; moments of the rod about its hinge, across,
    along."""
    N, O = ReferenceFrame("N"), Point("O")
    shaft = pin("shaft", None, "arm", at=O, axis=N.z, angle=arm)
    A = shaft.frame
    axis = -A.x if sense * up > 0 else A.x
    hinge = pin(
        "hinge", "arm", "rod", at=shaft.point.locatenew("E", reach * A.x), axis=axis, angle=rod
    )
    B = hinge.frame
    C = hinge.point.locatenew("C", up * centre * B.z)
    loads = [gravity(-g * N.z), torque("motor", drive * N.z, on="arm")]
    if brake != 0:
        loads.append(torque("hinge moment", brake * axis, on="rod", by="arm"))
    return Scene(
        "rotary pendulum",
        N,
        O,
        joints=(shaft, hinge),
        loads=loads,
        inputs=inputs,
        bodies=(
            RigidBody("arm", O, A, 0, inertia(A, 0, 0, arm_inertia)),
            RigidBody("rod", C, B, mass, inertia(B, *moments)),
        ),
    )


def rods():
    """Two uniform rods, theta from upright."""
    theta, phi, tau = dynamicsymbols("theta phi torque")
    lp, mp, lr, mr, g = P("l_p:m m_p:kg l_r:m m_r:kg gravity:m/s^2")
    J = mp * lp**2 / 12
    return _rotary(phi, theta, lr, mr * lr**2 / 3, mp, lp / 2, (J, J, 0), -1, 1, g, tau, 0, (tau,))


def hinge_only():
    """The rod's inertia I2 about its hinge alone, alpha from upright."""
    theta, alpha, u = dynamicsymbols("theta alpha u")
    I1, I2, m2, L1, c2, g = P("I1:kg*m^2 I2:kg*m^2 m2:kg L1:m Lc2:m g:m/s^2")
    return _rotary(theta, alpha, L1, I1, m2, c2, (I2, 0, 0), 1, 1, g, u, 0, (u,))


def adelaide():
    """Slender rod, theta_2 from hanging, frictions in both joints, torques tau_1, tau_2."""
    a, b, u, v = dynamicsymbols("theta_1 theta_2 tau_1 tau_2")
    m1, m2, l1, l2, L1, J1, J2, b1, b2, g = P(
        "m_1:kg m_2:kg l_1:m l_2:m L_1:m J_1:kg*m^2 J_2:kg*m^2 b_1:N*m*s b_2:N*m*s g:m/s^2"
    )
    return _rotary(
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
