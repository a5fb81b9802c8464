"""Pendulums: one, two, on a spring, driven; rods on springs; beads on rods that turn."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import (
    P,
    double_pendulum,
    of_one_particle,
    pendulum,
    spring_pendulum,
)
from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    pin,
    torque,
)

t = dynamicsymbols._t


def capitals():
    """theta_1, M_1, L_1, G."""
    return double_pendulum("theta_1 theta_2", *P("M_1:kg M_2:kg L_1:m L_2:m G:m/s^2"))


def phis():
    """phi1, m1, L1."""
    return double_pendulum("phi1 phi2", *P("m1:kg m2:kg L1:m L2:m g:m/s^2"))


def th():
    """th1, M1, L1, G."""
    return double_pendulum("th1 th2", *P("M1:kg M2:kg L1:m L2:m G:m/s^2"))


def damped_torque():
    """A torque tau and a damping B."""
    theta, tau = dynamicsymbols("theta tau")
    m, l, g, B = P("m:kg l:m g:m/s^2 B:N*m*s")
    return pendulum(theta, m, 0, l, g, tau - B * theta.diff(), (tau,))


def rod_upright():
    """A uniform rod of the length l, clockwise from upright, with a torque u."""
    theta, u = dynamicsymbols("theta u")
    m, l, g = P("m:kg l:m g:m/s^2")
    return pendulum(theta, m, m * l**2 / 12, l / 2, g, u, (u,), up=True)


def air():
    """A drag mu times the velocity of the bob."""
    theta = dynamicsymbols("theta")
    m, l, g, mu = P("m:kg l:m g:m/s^2 mu:N*s/m")
    return pendulum(theta, m, 0, l, g, -mu * l**2 * theta.diff())


def driven():
    """A damping b and a drive A cos(k t)."""
    theta = dynamicsymbols("theta")
    m, R, g, b, A, k = P("m:kg R:m g:m/s^2 b:N*m*s A:N*m k:1/s")
    return pendulum(theta, m, 0, R, g, -b * theta.diff() + A * cos(k * t))


def estop():
    """A torque `action`, a friction per moment of inertia."""
    theta, u = dynamicsymbols("theta action")
    m, l, g, f = P("mass:kg length:m gravity:m/s^2 friction:1/s")
    return pendulum(theta, m, 0, l, g, u - f * m * l**2 * theta.diff(), (u,))


def with_inertia():
    """An inertia I about the pivot, the mass centre at lc, a torque u, a friction b."""
    theta, u = dynamicsymbols("theta u")
    m, b, lc, I, g = P("m:kg b:N*m*s lc:m I:kg*m^2 g:m/s^2")
    return pendulum(theta, m, I - m * lc**2, lc, g, u - b * theta.diff(), (u,))


def inverted_spring():
    """A bob at l, clockwise from upright; a horizontal spring k and damper c at the height d; a
    torque M."""
    theta, M = dynamicsymbols("theta M")
    m, l, d, k, c, g = P("m:kg l:m d:m k:N/m c:N*s/m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hold", None, "rod", at=O, axis=-N.z, angle=theta)
    C, D = (hold.point.locatenew(n, s * hold.frame.y) for n, s in (("C", l), ("D", d)))
    side = d * sin(theta)
    return Scene(
        "inverted pendulum on a spring",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        inputs=(M,),
        bodies=(RigidBody("rod", C, hold.frame, m, 0),),
        loads=(
            gravity(-g * N.y),
            torque("motor", -M * N.z, on="rod"),
            force("spring", D, -(k * side + c * side.diff(t)) * N.x, on="rod"),
        ),
    )


def elastic_soton():
    """r, theta, k, l."""
    r, theta = dynamicsymbols("r theta")
    m, k, l, g = P("m:kg k:N/m l:m g:m/s^2")
    return spring_pendulum(theta, r, m, g, k * (r - l))


def springy():
    """theta, l; l0 is the length at rest with the bob on it, da a drag across, ds a damping of the
    spring."""
    theta, l = dynamicsymbols("theta l")
    l0, k, m, g, da, ds = P("l0:m k:N/m m:kg g:m/s^2 da:N*s/m ds:N*s/m")
    pull = k * (l - l0) + m * g + ds * l.diff()
    return spring_pendulum(theta, l, m, g, pull, -da * l * theta.diff(), order=(theta, l))


def cone():
    """A particle on a cone that opens downwards, on a spring from its top: s along it, phi about
    it."""
    s, phi = dynamicsymbols("s phi")
    m, g, k, L0, a = P("m:kg g:m/s^2 k:N/m L_0:m alpha:1", typical="1 9.81 20 0.5 0.5")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    along, across = sin(a) * A.x - cos(a) * A.z, cos(a) * A.x + sin(a) * A.z
    C = O.locatenew("C", s * along)
    return of_one_particle(
        "spring pendulum on a cone", N, O, (s, phi), ("particle", C, m),
        (gravity(-g * N.z), force("spring", C, -k * (s - L0) * along, on="particle")),
        example={"s": 1.0}, R=across,
    )  # fmt: skip


def moving_pivot():
    """The pivot goes up and down as a cos(omega t)."""
    theta = dynamicsymbols("theta")
    m, l, a, omega, g = P("m:kg l:m a:m omega:1/s g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = O.locatenew("A", a * cos(omega * t) * N.y)
    hold = pin("hold", None, "rod", at=A, axis=N.z, angle=theta)
    C = hold.point.locatenew("C", -l * hold.frame.y)
    return Scene(
        "driven pendulum",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        loads=(gravity(-g * N.y),),
        bodies=(RigidBody("rod", C, hold.frame, m, 0),),
    )


def _rod_on_spring(L, reach, k):
    """A uniform rod M, L on a hinge, without gravity; a spring across it at the reach."""
    theta = dynamicsymbols("theta")
    (M,) = parameters("M", units="kg")
    N, O = ReferenceFrame("N"), Point("O")
    hold = pin("hinge", None, "rod", at=O, axis=N.z, angle=theta)
    C, D = (hold.point.locatenew(n, s * hold.frame.x) for n, s in (("C", L / 2), ("D", reach)))
    return Scene(
        "rod on a spring",
        N,
        O,
        plane=N.z,
        joints=(hold,),
        bodies=(RigidBody("rod", C, hold.frame, M, M * L**2 / 12),),
        loads=(force("spring", D, -k * reach * sin(theta) * N.y, on="rod"),),
    )


def rod_end():
    """The spring at its end."""
    L, K = P("L:m K:N/m")
    return _rod_on_spring(L, L, K)


def rod_at():
    """The spring at the distance a."""
    L, a, k = P("L:m a:m k:N/m")
    return _rod_on_spring(L, a, k)


def _bead(r, m, turn, g=0):
    """A bead at r on a smooth rod that turns."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (turn, N.z))
    C = O.locatenew("C", r * A.x)
    loads = (gravity(-g * N.y),) if g != 0 else ()
    return of_one_particle("bead on a rod", N, O, (r,), ("bead", C, m), loads, across=A.y, side=N.z)


def bead_vertical():
    """The rod turns in a vertical plane, omega t from the horizontal."""
    m, omega, g = P("m:kg omega:1/s g:m/s^2")
    return _bead(dynamicsymbols("s"), m, omega * t, g)


def bead_horizontal():
    """The rod turns in a horizontal plane."""
    m, omega = P("m:kg omega:1/s")
    return _bead(dynamicsymbols("r"), m, omega * t)


def walker():
    """The simplest walker on a slope gamma: stance leg theta from the slope's normal, swing leg
    phi from the stance leg."""
    theta, phi = dynamicsymbols("theta phi")
    M, m, l, gamma, g = P("M:kg m:kg l:m gamma:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    # N.y is the slope's normal; the walker goes to x, downhill.
    foot = pin("foot", None, "stance", at=O, axis=N.z, angle=theta)
    hip = foot.point.locatenew("H", l * foot.frame.y)
    swing = pin("hip", "stance", "swing", at=hip, axis=-foot.frame.z, angle=phi)
    down = -cos(gamma) * N.y + sin(gamma) * N.x
    return Scene(
        "walker",
        N,
        O,
        plane=N.z,
        joints=(foot, swing),
        loads=(gravity(g * down),),
        bodies=(
            RigidBody("stance", hip, foot.frame, M, 0),
            RigidBody("swing", hip.locatenew("S", -l * swing.frame.y), swing.frame, m, 0),
        ),
    )
