"""Scenes of the corpus, in the symbols of the authors."""

from sympy import cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, bead_on_parabola, held, of_one_particle, two_bobs
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    parameters,
    reaction,
    spring,
    torque,
)

t = dynamicsymbols._t


def _ground():
    return ReferenceFrame("N"), Point("O")


def pendulum():
    """A bob on a light rod, theta from the bottom; S pulls it to the pivot."""
    theta = dynamicsymbols("theta")
    m, l, g = parameters("m l g", units="kg m m/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", -l * B.y)
    return of_one_particle("pendulum", N, O, (theta,), ("bob", P, m), (gravity(-g * N.y),), S_0=B.y)


def damped_pendulum():
    """Tedrake's pendulum: m l^2 theta'' + m g l sin(theta) = u - b theta'."""
    theta, u = dynamicsymbols("theta u")
    m, l, g, b = parameters("m l g b", units="kg m m/s^2 N*m*s")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", -l * B.y)
    return Scene(
        "damped pendulum", N, O, coordinates=(theta,), inputs=(u,),
        bodies=(RigidBody("bob", P, B, m, 0),),
        loads=(gravity(-g * N.y), torque("drive", (u - b * theta.diff()) * N.z, on="bob")),
        reactions=held(O, "bob", X=N.x, Y=N.y),
    )  # fmt: skip


def cart_pole_bottom():
    """Cart and point mass, theta from the bottom (Tedrake, Underactuated Robotics, 3.2)."""
    x, theta, f = dynamicsymbols("x theta f_x")
    m_c, m_p, l, g = parameters("m_c m_p l g", units="kg kg m m/s^2")
    N, O = _ground()
    A = O.locatenew("A", x * N.x)
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = A.locatenew("P", -l * B.y)
    return Scene(
        "cart-pole", N, O, coordinates=(x, theta), inputs=(f,),
        bodies=(Particle("cart", A, m_c), Particle("bob", P, m_p)),
        loads=(gravity(-g * N.y), force("f", A, f * N.x, on="cart")),
        reactions=(reaction("R", at=A, on="cart", by=None, along=N.y),
                   reaction("S", at=P, on="bob", by="cart", along=B.y)),
    )  # fmt: skip


def double_pendulum():
    """Two bobs on light rods, both angles from the vertical."""
    return two_bobs("theta_1 theta_2", *P("m_1:kg m_2:kg l_1:m l_2:m g:m/s^2"))


def spring_pendulum():
    """A bob on a spring of length r, natural length l, theta from the bottom."""
    r, theta = dynamicsymbols("r theta")
    m, k, l, g = parameters("m k l g", units="kg N/m m m/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", -r * B.y)
    return of_one_particle(
        "spring pendulum", N, O, (r, theta), ("bob", P, m),
        (gravity(-g * N.y), force("k", P, k * (r - l) * B.y, on="bob")),
    )  # fmt: skip


def rotating_hoop():
    """A bead on a hoop that turns about its vertical diameter, theta from the bottom."""
    theta = dynamicsymbols("theta")
    m, R, w, g = parameters("m R Omega g", units="kg m 1/s m/s^2")
    N, O = _ground()
    H = N.orientnew("H", "Axis", (w * t, N.z))
    B = H.orientnew("B", "Axis", (-theta, H.y))
    P = O.locatenew("P", -R * B.z)
    return of_one_particle(
        "bead on a hoop", N, O, (theta,), ("bead", P, m), (gravity(-g * N.z),), across=H.y,
        inwards=B.z,
    )  # fmt: skip


def arm():
    """Two links with point masses at their ends, the second angle from the first link."""
    a, b, u, v = dynamicsymbols("theta_1 theta_2 tau_1 tau_2")
    m1, m2, l1, l2, g = parameters("m_1 m_2 l_1 l_2 g", units="kg kg m m m/s^2")
    N, O = _ground()
    A = N.orientnew("A", "Axis", (a, N.z))
    B = A.orientnew("B", "Axis", (b, A.z))
    P = O.locatenew("P", l1 * A.x)
    Q = P.locatenew("Q", l2 * B.x)
    return Scene(
        "two-link arm", N, O, coordinates=(a, b), inputs=(u, v),
        bodies=(RigidBody("link 1", P, A, m1, 0), RigidBody("link 2", Q, B, m2, 0)),
        loads=(gravity(-g * N.y), torque("shoulder", u * N.z, on="link 1"),
               torque("elbow", v * N.z, on="link 2", by="link 1")),
        reactions=(*held(O, "link 1", X_1=N.x, Y_1=N.y),
                   *held(P, "link 2", "link 1", X_2=N.x, Y_2=N.y)),
    )  # fmt: skip


def oscillator():
    """A mass on a spring and a damper, pushed by F_0 cos(omega t)."""
    x = dynamicsymbols("x")
    m, c, k, F, w = parameters("m c k F_0 omega", units="kg N*s/m N/m N 1/s")
    N, O = _ground()
    P = O.locatenew("P", x * N.x)
    return Scene(
        "forced oscillator", N, O, coordinates=(x,), bodies=(Particle("body", P, m),),
        loads=(spring("k", O, P, k, along=N.x), damper("c", O, P, c, along=N.x),
               force("F", P, F * cos(w * t) * N.x, on="body")),
    )  # fmt: skip


def two_masses():
    """Two masses in a row of three springs, both counted from rest."""
    a, b = dynamicsymbols("x_1 x_2")
    m1, m2, k1, k2, k3 = parameters("m_1 m_2 k_1 k_2 k_3", units="kg kg N/m N/m N/m")
    N, O = _ground()
    d = parameters("d", units="m")[0]
    P, Q, W = O.locatenew("P", (d + a) * N.x), O.locatenew("Q", (2 * d + b) * N.x), None
    W = O.locatenew("W", 3 * d * N.x)
    return Scene(
        "two masses", N, O, coordinates=(a, b),
        bodies=(Particle("first", P, m1), Particle("second", Q, m2)),
        loads=(spring("1", O, P, k1, along=N.x, length=d),
               spring("2", P, Q, k2, along=N.x, length=d),
               spring("3", Q, W, k3, along=N.x, length=d)),
    )  # fmt: skip


def quarter_car():
    """Body and wheel, heights from rest; the road's height is z_r."""
    s, u, r, f = dynamicsymbols("z_s z_u z_r F_a")
    ms, mu, ks, cs, kt = parameters("m_s m_u k_s c_s k_t", units="kg kg N/m N*s/m N/m")
    h = parameters("h", units="m")[0]
    N, O = _ground()
    R = O.locatenew("R", r * N.y)
    U = O.locatenew("U", (h + u) * N.y)
    S = O.locatenew("S", (2 * h + s) * N.y)
    return Scene(
        "quarter car", N, O, coordinates=(s, u), inputs=(r, f),
        bodies=(Particle("body", S, ms), Particle("wheel", U, mu)),
        loads=(spring("suspension", U, S, ks, along=N.y, length=h),
               damper("shock", U, S, cs, along=N.y), spring("tyre", R, U, kt, along=N.y, length=h),
               force("actuator", S, f * N.y, on="body"),
               force("actuator down", U, -f * N.y, on="wheel")),
    )  # fmt: skip


def kapitza():
    """A pendulum whose support moves as a cos(gamma t) vertically (Landau, section 5, 3c)."""
    phi = dynamicsymbols("phi")
    m, l, g, a, w = parameters("m l g a gamma", units="kg m m/s^2 m 1/s")
    N, O = _ground()
    A = O.locatenew("A", -a * cos(w * t) * N.y)
    B = N.orientnew("B", "Axis", (phi, N.z))
    P = A.locatenew("P", -l * B.y)
    return of_one_particle(
        "vertically driven pendulum", N, O, (phi,), ("bob", P, m), (gravity(-g * N.y),), S_0=B.y
    )


def sliding_support():
    """A pendulum whose support, of mass m_1, slides horizontally (Landau, section 5, 2)."""
    x, phi = dynamicsymbols("x phi")
    m1, m2, l, g = parameters("m_1 m_2 l g", units="kg kg m m/s^2")
    N, O = _ground()
    A = O.locatenew("A", x * N.x)
    B = N.orientnew("B", "Axis", (phi, N.z))
    P = A.locatenew("P", -l * B.y)
    return Scene(
        "pendulum on a sliding support", N, O, coordinates=(x, phi),
        bodies=(Particle("support", A, m1), Particle("bob", P, m2)), loads=(gravity(-g * N.y),),
        reactions=(reaction("R", at=A, on="support", by=None, along=N.y),
                   reaction("S", at=P, on="bob", by="support", along=B.y)),
    )  # fmt: skip


def quadrotor():
    """A planar quadrotor (Tedrake): r from the centre to each rotor."""
    x, y, theta, u1, u2 = dynamicsymbols("x y theta u_1 u_2")
    m, I, r, g = parameters("m I r g", units="kg kg*m^2 m m/s^2")
    N, O = _ground()
    C = O.locatenew("C", x * N.x + y * N.y)
    B = N.orientnew("B", "Axis", (theta, N.z))
    R, L = C.locatenew("R", r * B.x), C.locatenew("L", -r * B.x)
    return Scene(
        "planar quadrotor", N, O, coordinates=(x, y, theta), inputs=(u1, u2),
        bodies=(RigidBody("frame", C, B, m, I),),
        loads=(gravity(-g * N.y), force("right", R, u1 * B.y, on="frame"),
               force("left", L, u2 * B.y, on="frame")),
    )  # fmt: skip


def parabola():
    """A bead on a wire y = c x^2."""
    return bead_on_parabola(*P("m:kg c:1/m g:m/s^2"))


def reaction_wheel():
    """A pendulum with a driven wheel at its end (Spong), theta from the top, phi absolute."""
    a, b, u = dynamicsymbols("theta phi tau")
    m1, m2, l, lc, I1, I2, g = parameters(
        "m_1 m_2 l_1 l_c I_1 I_2 g", units="kg kg m m kg*m^2 kg*m^2 m/s^2"
    )
    N, O = _ground()
    A = N.orientnew("A", "Axis", (-a, N.z))
    W = N.orientnew("W", "Axis", (-b, N.z))
    C, P = O.locatenew("C", lc * A.y), O.locatenew("P", l * A.y)
    return Scene(
        "reaction wheel pendulum", N, O, coordinates=(a, b), inputs=(u,),
        bodies=(RigidBody("rod", C, A, m1, I1), RigidBody("wheel", P, W, m2, I2)),
        loads=(gravity(-g * N.y), torque("motor", -u * N.z, on="wheel", by="rod")),
        reactions=(*held(O, "rod", X=N.x, Y=N.y), *held(P, "wheel", "rod", X_2=N.x, Y_2=N.y)),
    )  # fmt: skip


def ball_in_bowl():
    """A point on a smooth sphere of radius l: theta from the bottom, phi about the vertical."""
    theta, phi = dynamicsymbols("theta phi")
    m, l, g = parameters("m l g", units="kg m m/s^2")
    N, O = _ground()
    H = N.orientnew("H", "Axis", (phi, N.z))
    B = H.orientnew("B", "Axis", (-theta, H.y))
    P = O.locatenew("P", -l * B.z)
    return of_one_particle(
        "spherical pendulum", N, O, (theta, phi), ("bob", P, m), (gravity(-g * N.z),), S_0=B.z
    )
