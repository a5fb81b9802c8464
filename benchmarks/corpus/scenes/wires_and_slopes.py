"""Points on wires and surfaces, on plates and rods that turn, pulleys, wedges, rolling."""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held, of_one_particle, roller, shared
from mechanics.scene import Particle, Scene, gravity, reaction

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


def hoop_weightless():
    """A bead m on a hoop R turned at omega about a diameter, theta from that axis, no gravity."""
    return _hoop(*P("m:kg R:m omega:1/s"), 0)


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


def ball_in_bowl():
    """A uniform ball M, r rolls in a spherical bowl R.

    The angle theta of its centre from the lowest point.
    """
    M, r, R, g = P("M:kg r:m R:m g:m/s^2", typical="1 0.1 1 9.81")
    return roller(M, R, r, g, 2 * M * r**2 / 5)


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
