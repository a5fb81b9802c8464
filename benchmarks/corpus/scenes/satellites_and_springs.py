"""Arms, satellites, rockets, masses on springs, a rotary pendulum."""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    of_one_particle,
    on_walls,
    one_mass,
    two_masses,
)
from benchmarks.corpus.free_bodies import chaser, craft, turning_body
from mechanics.scene import RigidBody, Scene, force, gravity, pin, torque

t = dynamicsymbols._t


def satellite_torque():
    """The same with w1, w2, w3, I1, I2, I3 and torques M1, M2, M3."""
    M = dynamicsymbols("M1 M2 M3")
    return turning_body("w1 w2 w3", "I1:kg*m^2 I2:kg*m^2 I3:kg*m^2", M, name="body")


def attitude():
    """The same with yaw alpha, pitch beta, roll gamma, rates W1, W2, W3, no torque."""
    return turning_body(
        "W1 W2 W3", "I1:kg*m^2 I2:kg*m^2 I3:kg*m^2", name="body", angles="alpha beta gamma"
    )


def hill():
    """A chaser near a target in a circular orbit with the rate W: x outwards, y forwards."""
    m, W = P("m:kg W:1/s")
    return chaser(m, W, lambda N: N.orientnew("A", "Axis", (W * t, N.z)), (2, -1, -1), (), "y")


def rocket():
    """A rocket mr, Jr, theta counterclockwise from upright.

    The engine FE at the base, l1 below the mass centre, gimballed by phi clockwise; a thruster FT
    at l2 above it pushes to the left.
    """
    FE, FT, phi = dynamicsymbols("FE FT phi")
    m, J, g, l1, l2 = P("mr:kg Jr:kg*m^2 g:m/s^2 l1:m l2:m")
    return craft(
        "x y theta",
        m,
        J,
        lambda N, A, C: (
            force(
                "engine",
                C.locatenew("B", -l1 * A.y),
                FE * (cos(phi) * A.y + sin(phi) * A.x),
                on="rocket",
            ),
            force("thruster", C.locatenew("T", l2 * A.y), -FT * A.x, on="rocket"),
        ),
        (FE, FT, phi),
        g=g,
        name="rocket",
    )


def driven():
    """position, mass, damping, stiffness, input_force."""
    x, f = dynamicsymbols("position input_force")
    m, c, k = P("mass:kg damping:N*s/m stiffness:N/m")
    return one_mass(x, m, f - k * x - c * x.diff(), (f,))


def haptic():
    """A virtual mass m at x on a spring k to the handle at dx, a damper d to the ground."""
    x, dx = dynamicsymbols("x dx")
    m, k, d = P("m:kg k:N/m d:N*s/m")
    return one_mass(x, m, k * (dx - x) - d * x.diff(), (dx,))


def crane():
    """A load m at x_m on a rope l below a trolley at x_c, small swings, a drag c."""
    x, u = dynamicsymbols("x_m x_c")
    m, c, g, l = P("m:kg c:N*s/m g:m/s^2 l:m")
    return one_mass(x, m, -c * x.diff() - m * g / l * (x - u), (u,))


def one_spring():
    """x_1, x_2, m_1, m_2 and a spring k, l_0 between them."""
    m1, m2, k, l0 = P("m_1:kg m_2:kg k:N/m l_0:m")
    return _between("x_1 x_2", m1, m2, k, l0)


def _between(names, m1, m2, k, length):
    a, b = dynamicsymbols(names)
    return two_masses(
        (a, b),
        (m1, m2),
        lambda N, A, B: (force("spring", A, k * (b - a - length) * N.x, on="one", by="two"),),
    )


def three_springs():
    """x1, x2, two masses m, three springs k between walls."""
    m, k = P("m:kg k:N/m")
    return on_walls("x1 x2", m, m, k, k, k)


def chain():
    """r1, r2, two masses m, three springs k between walls."""
    m, k = P("m:kg k:N/m")
    return on_walls("r1 r2", m, m, k, k, k)


def quarter():
    """z_s, z_u, m_s, m_u, springs k_s, k_u, the road z_r."""
    a, b, u = dynamicsymbols("z_s z_u z_r")
    ms, mu, ks, ku = P("m_s:kg m_u:kg k_s:N/m k_u:N/m")
    return two_masses(
        (a, b),
        (ms, mu),
        lambda N, A, B: (
            force("strut", A, -ks * (a - b) * N.x, on="one", by="two"),
            force("tyre", B, -ku * (b - u) * N.x, on="two"),
        ),
        (u,),
    )


def suspension():
    """x1 of the body m1, x2 of the wheel m2; k1, b1 between them, k2 to a road A sin(Omega t)."""
    a, b = dynamicsymbols("x1 x2")
    m1, m2, k1, b1, k2, A0, W = P("m1:kg m2:kg k1:N/m b1:N*s/m k2:N/m A:m Omega:1/s")
    strut = -k1 * (a - b) - b1 * (a.diff() - b.diff())
    return two_masses(
        (a, b),
        (m1, m2),
        lambda N, A, B: (
            force("strut", A, strut * N.x, on="one", by="two"),
            force("tyre", B, -k2 * (b - A0 * sin(W * t)) * N.x, on="two"),
        ),
    )


def standing():
    """A leg and a trunk, theta_a counterclockwise from upright.

    Theta_h of the trunk relative to the leg; torques T_a, T_h in ankle and hip; the platform
    under the ankle is accelerated by a to the right, so that each body feels its mass times a to
    the left.
    """
    a, h, A, B, acc = dynamicsymbols("theta_a theta_h T_a T_h a")
    w = dynamicsymbols("omega_a omega_h")
    mL, mT, lL, dL, dT, IL, IT, g = P(
        "m_L:kg m_T:kg l_L:m d_L:m d_T:m I_L:kg*m^2 I_T:kg*m^2 g:m/s^2"
    )
    N, O = ReferenceFrame("N"), Point("O")
    ankle = pin("ankle", None, "leg", at=O, axis=N.z, angle=a)
    E = ankle.point.locatenew("E", lL * ankle.frame.y)
    hip = pin("hip", "leg", "trunk", at=E, axis=ankle.frame.z, angle=h)
    C, D = (
        ankle.point.locatenew("C", dL * ankle.frame.y),
        hip.point.locatenew("D", dT * hip.frame.y),
    )
    return Scene(
        "standing",
        N,
        O,
        plane=N.z,
        joints=(ankle, hip),
        inputs=(A, B, acc),
        speeds=((w[0], a.diff()), (w[1], h.diff())),
        loads=(
            gravity(-g * N.y),
            torque("ankle torque", A * N.z, on="leg"),
            torque("hip torque", B * N.z, on="trunk", by="leg"),
            force("leg behind", C, -mL * acc * N.x, on="leg"),
            force("trunk behind", D, -mT * acc * N.x, on="trunk"),
        ),
        bodies=(RigidBody("leg", C, ankle.frame, mL, IL), RigidBody("trunk", D, hip.frame, mT, IT)),
    )


def satellite_orbit():
    """A satellite m in the field mu of a fixed planet, x, y, z."""
    x, y, z = dynamicsymbols("x y z")
    m, mu = P("m:kg mu:m^3/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    r = x * N.x + y * N.y + z * N.z
    C = O.locatenew("C", r)
    d = sqrt(x**2 + y**2 + z**2)
    return of_one_particle(
        "satellite", N, O, (x, y, z), ("satellite", C, m),
        (force("gravity", C, -m * mu / d**3 * r, on="satellite"),),
        example={"x": 1.0, "y": 0.5, "z": 0.3},
    )  # fmt: skip
