"""Points on wires and surfaces, on plates and rods that turn, pulleys, wedges, rolling."""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, of_one_particle, roller, shared
from mechanics.scene import Particle, RigidBody, Scene, force, gravity, reaction, torque

t = dynamicsymbols._t


def _bowl(r, angle, m, g, height, slope, order):
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (angle, N.z))
    C = O.locatenew("C", r * A.x + height * A.z)
    return of_one_particle(
        "bowl", N, O, order, ("bead", C, m), (gravity(-g * N.z),),
        example={str(r.func): 0.7, str(angle.func) + "_dot": 1.0},
        R=(-slope * A.x + A.z) / sqrt(1 + slope**2),
    )  # fmt: skip


def bowl():
    """A bead m in the bowl z = c rho^2/2, phi about the axis."""
    rho, phi = dynamicsymbols("rho phi")
    m, c, g = P("m:kg c:1/m g:m/s^2")
    return _bowl(rho, phi, m, g, c * rho**2 / 2, c * rho, (rho, phi))


def paraboloid():
    """A point m in the paraboloid z = r^2/a, theta about the axis."""
    r, theta = dynamicsymbols("r theta")
    m, a, g = P("m:kg a:m g:m/s^2")
    return _bowl(r, theta, m, g, r**2 / a, 2 * r / a, (r, theta))


def _hoop(m, R, omega, g):
    theta = dynamicsymbols("theta")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (omega * t, N.z))
    out = sin(theta) * A.x - cos(theta) * A.z
    C = O.locatenew("C", R * out)
    return of_one_particle(
        "hoop", N, O, (theta,), ("bead", C, m), (gravity(-g * N.z),) if g != 0 else (),
        example={"theta": 0.5}, N_phi=A.y, N_r=-out,
    )  # fmt: skip


def hoop():
    """A bead m on a hoop R turned at omega about its vertical diameter.

    The angle theta from the lowest point; N_phi across the hoop, forwards.
    """
    return _hoop(*P("m:kg R:m omega:1/s g:m/s^2"))


def hoop_weightless():
    """A bead m on a hoop R turned at omega about a diameter, theta from that axis, no gravity."""
    return _hoop(*P("m:kg R:m omega:1/s"), 0)


def wire():
    """A bead m on the wire y = a (1 - cos(x/a)) in a vertical plane."""
    x = dynamicsymbols("x")
    m, a, g = P("m:kg a:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + a * (1 - cos(x / a)) * N.y)
    slope = sin(x / a)
    return of_one_particle(
        "wire", N, O, (x,), ("bead", C, m), (gravity(-g * N.y),), example={"x": 0.4},
        N_n=(-slope * N.x + N.y) / sqrt(1 + slope**2), N_z=N.z,
    )  # fmt: skip


def ring_spring():
    """A bead m on a vertical ring a, theta from the horizontal x axis.

    A spring k without natural length to the point (0, beta a).
    """
    theta = dynamicsymbols("theta")
    m, a, k, beta, g = P("m:kg a:m k:N/m beta:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    out = cos(theta) * N.x + sin(theta) * N.y
    C = O.locatenew("C", a * out)
    return of_one_particle(
        "ring", N, O, (theta,), ("bead", C, m),
        (gravity(-g * N.y), force("spring", C, -k * (a * out - beta * a * N.y), on="bead")),
        example={"theta": 0.3}, N_r=out, N_z=N.z,
    )  # fmt: skip


def on_top():
    """A point m on a fixed circle R, theta from its top; lambda pushes outwards."""
    theta = dynamicsymbols("theta")
    m, R, g = P("m:kg R:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    out = sin(theta) * N.x + cos(theta) * N.y
    C = O.locatenew("C", R * out)
    return of_one_particle(
        "circle", N, O, (theta,), ("point", C, m), (gravity(-g * N.y),), example={"theta": 0.3},
        **{"lambda": out}, side=N.z,
    )  # fmt: skip


def incline():
    """A body m slides down by s on a plane inclined by theta.

    The plane moves by a t^2/2 towards the low side; height h of the top.
    """
    s = dynamicsymbols("s")
    m, g, theta, a, h = P("m:kg g:m/s^2 theta:1 a:m/s^2 h:m")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", (s * cos(theta) + a * t**2 / 2) * N.x + (h - s * sin(theta)) * N.y)
    return of_one_particle(
        "incline", N, O, (s,), ("body", C, m), (gravity(-g * N.y),), example={"s": 0.4},
        R=sin(theta) * N.x + cos(theta) * N.y, side=N.z,
    )  # fmt: skip


def _hole(angle, m, M, g, l):
    """A body m on a table at r from a hole, a thread l to a body M that hangs below it."""
    r, a = dynamicsymbols("r"), dynamicsymbols(angle)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (a, N.z))
    C, D = O.locatenew("C", r * A.x), O.locatenew("D", -(l - r) * N.z)
    return Scene(
        "hole",
        N,
        O,
        coordinates=(r, a),
        bodies=(Particle("on", C, m), Particle("below", D, M)),
        loads=(gravity(-g * N.z),),
        reactions=(
            *held(C, "on", table=N.z),
            *held(D, "below", Dx=N.x, Dy=N.y),
            shared(
                reaction("T", at=C, on="on", by=None, along=-A.x),
                reaction("T", at=D, on="below", by=None, along=N.z),
            ),
        ),
        example={"r": 0.7, angle + "_dot": 1.0},
    )


def hole_equal():
    """Two equal bodies m, a thread l; r, phi of the one on the table."""
    m, g, l = P("m:kg g:m/s^2 l:m")
    return _hole("phi", m, m, g, l)


def hole():
    """m on the table at r, theta; M hangs; a thread l."""
    m, M, g, l = P("m:kg M:kg g:m/s^2 l:m")
    return _hole("theta", m, M, g, l)


def plate():
    """A point m on a plate that turns at Omega, x, y on the plate.

    Springs k_x, k_y to the axis.
    """
    x, y = dynamicsymbols("x y")
    m, kx, ky, Omega = P("m:kg k_x:N/m k_y:N/m Omega:1/s")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (Omega * t, N.z))
    C = O.locatenew("C", x * A.x + y * A.y)
    return of_one_particle(
        "plate", N, O, (x, y), ("point", C, m),
        (force("springs", C, -kx * x * A.x - ky * y * A.y, on="point"),),
        example={"x": 0.4, "y": 0.3}, up=A.z,
    )  # fmt: skip


def ball_in_bowl():
    """A uniform ball M, r rolls in a spherical bowl R.

    The angle theta of its centre from the lowest point.
    """
    M, r, R, g = P("M:kg r:m R:m g:m/s^2", typical="1 0.1 1 9.81")
    return roller(M, R, r, g, 2 * M * r**2 / 5)


def disc_on_incline():
    """A disc m, R, I rolls down a slope alpha by x.

    The friction f points up the slope, N is the normal force.
    """
    x = dynamicsymbols("x")
    m, R, I, alpha, g = P("m:kg R:m I:kg*m^2 alpha:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-alpha, N.z))
    B = A.orientnew("B", "Axis", (-x / R, A.z))
    C, E = O.locatenew("C", x * A.x + R * A.y), O.locatenew("E", x * A.x)
    return Scene(
        "disc",
        N,
        O,
        plane=N.z,
        coordinates=(x,),
        bodies=(RigidBody("disc", C, B, m, I),),
        loads=(gravity(-g * N.y),),
        reactions=held(E, "disc", f=-A.x, N=A.y),
    )


def atwood():
    """m_1 goes down by x, m_2 up, a pulley R, I with a moment kappa times its rate.

    T_1, T_2 pull up.
    """
    x = dynamicsymbols("x")
    m1, m2, R, I, kappa, g = P(
        "m_1:kg m_2:kg R:m I:kg*m^2 kappa:N*m*s g:m/s^2", typical="2 1 0.3 0.1 0.2 9.81"
    )
    N, O = ReferenceFrame("N"), Point("O")
    W = N.orientnew("W", "Axis", (x / R, N.z))
    C, D = O.locatenew("C", -R * N.x - x * N.y), O.locatenew("D", R * N.x + x * N.y)
    return Scene(
        "Atwood's machine",
        N,
        O,
        coordinates=(x,),
        bodies=(Particle("1", C, m1), Particle("2", D, m2), RigidBody("pulley", O, W, 0, I)),
        loads=(gravity(-g * N.y), torque("friction", -kappa * x.diff() / R * N.z, on="pulley")),
        reactions=(
            reaction("T_1", at=C, on="1", by="pulley", along=N.y),
            reaction("T_2", at=D, on="2", by="pulley", along=N.y),
            reaction("Y", at=O, on="pulley", by=None, along=N.y),
        ),
        plane=N.z,
    )


def two_slopes():
    """A prism M at x on a smooth table.

    M_1 on its left slope alpha at the distance l of thread from the ridge, m_2 on the right one
    beta; a thread l_0.
    """
    x, l = dynamicsymbols("x l")
    M, m1, m2, alpha, beta, l0, g = P(
        "M:kg m_1:kg m_2:kg alpha:1 beta:1 l_0:m g:m/s^2", typical="3 1 2 0.5 0.7 3 9.81"
    )
    N, O = ReferenceFrame("N"), Point("O")
    T = O.locatenew("T", x * N.x)
    C = T.locatenew("C", -l * cos(alpha) * N.x - l * sin(alpha) * N.y)
    D = T.locatenew("D", (l0 - l) * cos(beta) * N.x - (l0 - l) * sin(beta) * N.y)
    u = -cos(alpha) * N.x - sin(alpha) * N.y
    w = cos(beta) * N.x - sin(beta) * N.y
    thread = shared(
        reaction("S", at=C, on="1", by="prism", along=-u),
        reaction("S", at=D, on="2", by="prism", along=-w),
    )
    return Scene(
        "prism",
        N,
        O,
        plane=N.z,
        coordinates=(x, l),
        loads=(gravity(-g * N.y),),
        bodies=(Particle("prism", T, M), Particle("1", C, m1), Particle("2", D, m2)),
        reactions=(
            reaction("R", at=T, on="prism", by=None, along=N.y),
            reaction("N_1", at=C, on="1", by="prism", along=-sin(alpha) * N.x + cos(alpha) * N.y),
            reaction("N_2", at=D, on="2", by="prism", along=sin(beta) * N.x + cos(beta) * N.y),
            thread,
        ),
    )
