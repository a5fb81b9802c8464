"""More scenes of the corpus, in the symbols of the authors."""

from sympy import cos, cot, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P, bead_on_parabola, two_bobs
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    rope,
    spring,
    torque,
)

t = dynamicsymbols._t


def _ground():
    return ReferenceFrame("N"), Point("O")


def _cart_and_bob(names, mass_names, push, side, down, *, friction=None, inertia_of=None):
    """A cart that is pushed, and a bob on a rod: side * l * sin, down * l * cos from the cart."""
    x, angle = dynamicsymbols(names)
    F = dynamicsymbols(push)
    cart, bob, l, g = parameters(mass_names, units="kg kg m m/s^2")
    b = parameters(friction, units="N*s/m")[0] if friction else 0
    about = parameters(inertia_of, units="kg*m^2")[0] if inertia_of else 0
    N, O = _ground()
    A = O.locatenew("A", x * N.x)
    B = N.orientnew("B", "Axis", (side * angle * (1 if down < 0 else -1), N.z))
    P = A.locatenew("P", down * l * B.y)
    return Scene(
        "cart and rod", N, O, coordinates=(x, angle), inputs=(F,),
        bodies=(Particle("cart", A, cart), RigidBody("rod", P, B, bob, about)),
        loads=(gravity(-g * N.y), force("push", A, (F - b * x.diff()) * N.x, on="cart")),
        reactions=(reaction("R", at=A, on="cart", by=None, along=N.y),
                   reaction("X", at=A, on="rod", by="cart", along=N.x),
                   reaction("Y", at=A, on="rod", by="cart", along=N.y)),
    )  # fmt: skip


def cart_left():
    """The same with theta and a force f."""
    return _cart_and_bob("x theta", "M m l g", "f", -1, 1)


def puffer():
    """PufferLib's cart-pole: a uniform pole of half the length pole_length, from upright."""
    x, theta, force_ = dynamicsymbols("x theta force")
    mc, mp, l, g = parameters("cart_mass pole_mass pole_length gravity", units="kg kg m m/s^2")
    return _cart_pole(x, theta, force_, mc, mp, l, g)


def gym():
    """Gymnasium's cart-pole: a uniform pole of half the length `length`, from upright."""
    x, theta, force_ = dynamicsymbols("x theta force")
    mc, mp, l, g = parameters("masscart masspole length gravity", units="kg kg m m/s^2")
    return _cart_pole(x, theta, force_, mc, mp, l, g)


def _cart_pole(x, theta, push, mc, mp, l, g):
    N, O = _ground()
    A = O.locatenew("A", x * N.x)
    B = N.orientnew("B", "Axis", (-theta, N.z))
    P = A.locatenew("P", l * B.y)
    return Scene(
        "cart-pole", N, O, coordinates=(x, theta), inputs=(push,),
        bodies=(Particle("cart", A, mc), RigidBody("pole", P, B, mp, mp * l**2 / 3)),
        loads=(gravity(-g * N.y), force("push", A, push * N.x, on="cart")),
        reactions=(reaction("R", at=A, on="cart", by=None, along=N.y),
                   reaction("X", at=A, on="pole", by="cart", along=N.x),
                   reaction("Y", at=A, on="pole", by="cart", along=N.y)),
    )  # fmt: skip


def two_wheels():
    """A body on a wheel that rolls, phi of the wheel, theta of the body, both absolute."""
    phi, theta, tau = dynamicsymbols("phi theta tau")
    Mp, Mr, Ip, Ir, l, r, g = parameters("Mp Mr Ip Ir l r g", units="kg kg kg*m^2 kg*m^2 m m m/s^2")
    N, O = _ground()
    A = O.locatenew("A", r * phi * N.x)
    W = N.orientnew("W", "Axis", (-phi, N.z))
    B = N.orientnew("B", "Axis", (-theta, N.z))
    K = A.locatenew("K", -r * N.y)
    P = A.locatenew("P", l * B.y)
    return Scene(
        "body on a wheel", N, O, coordinates=(phi, theta), inputs=(tau,),
        bodies=(RigidBody("wheel", A, W, Mr, Ir), RigidBody("body", P, B, Mp, Ip)),
        loads=(gravity(-g * N.y), torque("motor", -tau * N.z, on="wheel", by="body")),
        reactions=(reaction("F", at=K, on="wheel", by=None, along=N.x),
                   reaction("R", at=K, on="wheel", by=None, along=N.y),
                   reaction("X", at=A, on="body", by="wheel", along=N.x),
                   reaction("Y", at=A, on="body", by="wheel", along=N.y)),
    )  # fmt: skip


def string_and_spring():
    """A block on a string of length L that hangs on a spring of length l, theta from below."""
    l, theta = dynamicsymbols("l theta")
    m, L, k, g = parameters("m L k g", units="kg m N/m m/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", -(l + L) * B.y)
    return Scene(
        "elastic pendulum", N, O, coordinates=(l, theta), bodies=(Particle("block", P, m),),
        loads=(gravity(-g * N.y), spring("k", O, P, k)),
    )  # fmt: skip


def parabola():
    """A bead on a wire y = a x^2."""
    return bead_on_parabola(*P("m:kg a:1/m g:m/s^2"))


def tilted_wire():
    """A bead on a straight wire at an angle a to the vertical, turned at w about it."""
    r = dynamicsymbols("r")
    m, w, a, g = parameters("m w a g", units="kg 1/s 1 m/s^2")
    N, O = _ground()
    H = N.orientnew("H", "Axis", (w * t, N.z))
    P = O.locatenew("P", r * sin(a) * H.x + r * cos(a) * H.z)
    return Scene(
        "bead on a tilted wire", N, O, coordinates=(r,), bodies=(Particle("bead", P, m),),
        loads=(gravity(-g * N.z),),
        reactions=(reaction("R_1", at=P, on="bead", by=None, along=H.y),
                   reaction("R_2", at=P, on="bead", by=None, along=cos(a) * H.x - sin(a) * H.z)),
    )  # fmt: skip


def two_rods():
    """Two bobs on rods of lengths L_1 and L_2, angles from below."""
    return two_bobs("theta_1 theta_2", *P("m_1:kg m_2:kg L_1:m L_2:m g:m/s^2"))


def two_equal():
    """Two equal bobs."""
    m, l1, l2, g = P("m:kg L1:m L2:m g:m/s^2")
    return two_bobs("theta1 theta2", m, m, l1, l2, g)


def driven():
    """A pendulum, th from below, torque u."""
    return _driven("th", "u", None)


def damped():
    """A pendulum, theta from below, with friction b at the pivot."""
    return _driven("theta", None, "b")


def _driven(angle, drive, friction):
    th = dynamicsymbols(angle)
    m, l, g = parameters("m l g", units="kg m m/s^2")
    u = dynamicsymbols(drive) if drive else 0
    b = parameters(friction, units="N*m*s")[0] if friction else 0
    N, O = _ground()
    B = N.orientnew("B", "Axis", (th, N.z))
    P = O.locatenew("P", -l * B.y)
    return Scene(
        "pendulum", N, O, coordinates=(th,), inputs=(u,) if drive else (),
        bodies=(RigidBody("bob", P, B, m, 0),),
        loads=(gravity(-g * N.y), torque("pivot", (u - b * th.diff()) * N.z, on="bob")),
        reactions=(reaction("X", at=O, on="bob", by=None, along=N.x),
                   reaction("Y", at=O, on="bob", by=None, along=N.y)),
    )  # fmt: skip


def oily_hoop():
    """A bead on a hoop that turns at omega, with a friction b times its angular speed."""
    phi = dynamicsymbols("phi")
    m, r, b, w, g = parameters("m r b omega g", units="kg m N*s 1/s m/s^2")
    N, O = _ground()
    H = N.orientnew("H", "Axis", (w * t, N.z))
    B = H.orientnew("B", "Axis", (-phi, H.y))
    P = O.locatenew("P", -r * B.z)
    return Scene(
        "bead on a hoop", N, O, coordinates=(phi,), bodies=(Particle("bead", P, m),),
        loads=(gravity(-g * N.z), force("oil", P, -b * phi.diff() * B.x, on="bead")),
        reactions=(reaction("across", at=P, on="bead", by=None, along=H.y),
                   reaction("inwards", at=P, on="bead", by=None, along=B.z)),
    )  # fmt: skip


def cone():
    """A particle inside a cone of half angle alpha, r from its axis."""
    r, theta = dynamicsymbols("r theta")
    m, alpha, g = parameters("m alpha g", units="kg 1 m/s^2")
    N, O = _ground()
    H = N.orientnew("H", "Axis", (theta, N.z))
    P = O.locatenew("P", r * H.x + r * cot(alpha) * N.z)
    normal = sin(alpha) * N.z - cos(alpha) * H.x
    return Scene(
        "particle in a cone", N, O, coordinates=(r, theta), bodies=(Particle("particle", P, m),),
        loads=(gravity(-g * N.z),),
        reactions=(reaction("R", at=P, on="particle", by=None, along=normal),),
    )  # fmt: skip


def atwood():
    """Atwood's machine with a pulley of inertia I; m_1 goes down by x."""
    x = dynamicsymbols("x")
    m1, m2, I, R, g = parameters("m_1 m_2 I R g", units="kg kg kg*m^2 m m/s^2")
    N, O = _ground()
    W = N.orientnew("W", "Axis", (x / R, N.z))
    P = O.locatenew("P", -R * N.x - x * N.y)
    Q = O.locatenew("Q", R * N.x + x * N.y)
    return Scene(
        "Atwood's machine", N, O, coordinates=(x,),
        bodies=(Particle("1", P, m1), Particle("2", Q, m2), RigidBody("pulley", O, W, 0, I)),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("T_1", at=P, on="1", by="pulley", along=N.y),
                   reaction("T_2", at=Q, on="2", by="pulley", along=N.y),
                   reaction("Y", at=O, on="pulley", by=None, along=N.y)),
    )  # fmt: skip


def swinging_atwood():
    """A counterweight M that rises by r, a bob m that swings, theta from below."""
    r, theta = dynamicsymbols("r theta")
    M, m, g, length = parameters("M m g l_0", units="kg kg m/s^2 m")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", -r * B.y)
    W = O.locatenew("W", -length * N.x)
    Q = W.locatenew("Q", (r - length) * N.y)
    line = rope(
        "S",
        ("bob", P),
        (None, O),
        (None, W),
        ("counterweight", Q),
        length=length,
        along=(B.y, -N.y),
    )
    return Scene(
        "swinging Atwood's machine", N, O, coordinates=(r, theta),
        bodies=(Particle("bob", P, m), Particle("counterweight", Q, M)),
        loads=(gravity(-g * N.y),),
        reactions=(*line.reactions, reaction("G", at=Q, on="counterweight", by=None, along=N.x)),
    )  # fmt: skip


def furuta():
    """An arm of inertia J and length r turned by tau, a bob on a rod l, theta from upright."""
    phi, theta, tau = dynamicsymbols("phi theta tau")
    J, m, r, l, g = parameters("J m r l g", units="kg*m^2 kg m m m/s^2")
    N, O = _ground()
    A = N.orientnew("A", "Axis", (phi, N.z))
    E = O.locatenew("E", r * A.x)
    rod = sin(theta) * A.y + cos(theta) * N.z
    P = E.locatenew("P", l * rod)
    return Scene(
        "Furuta's pendulum", N, O, coordinates=(phi, theta), inputs=(tau,),
        bodies=(RigidBody("arm", O, A, 0, inertia(A, 0, 0, J)), Particle("bob", P, m)),
        loads=(gravity(-g * N.z), torque("motor", tau * N.z, on="arm")),
        reactions=(reaction("X", at=O, on="arm", by=None, along=A.x),
                   reaction("Y", at=O, on="arm", by=None, along=A.y),
                   reaction("Z", at=O, on="arm", by=None, along=A.z),
                   reaction_couple("K_x", on="arm", by=None, along=A.x),
                   reaction_couple("K_y", on="arm", by=None, along=A.y),
                   reaction("S_x", at=P, on="bob", by="arm", along=A.x),
                   reaction("S", at=P, on="bob", by="arm", along=rod)),
    )  # fmt: skip


def spong_arm():
    """Spong's acrobot: q_1 from the horizontal, q_2 from the first link."""
    a, b, u = dynamicsymbols("q_1 q_2 tau")
    m1, m2, l1, c1, c2, I1, I2, g = parameters(
        "m_1 m_2 l_1 l_c1 l_c2 I_1 I_2 g", units="kg kg m m m kg*m^2 kg*m^2 m/s^2"
    )
    N, O = _ground()
    A = N.orientnew("A", "Axis", (a, N.z))
    B = A.orientnew("B", "Axis", (b, A.z))
    C, P = O.locatenew("C", c1 * A.x), O.locatenew("P", l1 * A.x)
    D = P.locatenew("D", c2 * B.x)
    return Scene(
        "acrobot", N, O, coordinates=(a, b), inputs=(u,),
        bodies=(RigidBody("link 1", C, A, m1, I1), RigidBody("link 2", D, B, m2, I2)),
        loads=(gravity(-g * N.y), torque("elbow", u * N.z, on="link 2", by="link 1")),
        reactions=(reaction("X_1", at=O, on="link 1", by=None, along=N.x),
                   reaction("Y_1", at=O, on="link 1", by=None, along=N.y),
                   reaction("X_2", at=P, on="link 2", by="link 1", along=N.x),
                   reaction("Y_2", at=P, on="link 2", by="link 1", along=N.y)),
    )  # fmt: skip


def rolling():
    """A cylinder of radius r that rolls inside one of radius R, theta of the line of centres."""
    theta = dynamicsymbols("theta")
    m, R, r, g = parameters("m R r g", units="kg m m m/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    W = N.orientnew("W", "Axis", (-(R - r) / r * theta, N.z))
    P = O.locatenew("P", -(R - r) * B.y)
    K = P.locatenew("K", -r * B.y)
    return Scene(
        "cylinder in a cylinder", N, O, coordinates=(theta,),
        bodies=(RigidBody("cylinder", P, W, m, m * r**2 / 2),), loads=(gravity(-g * N.y),),
        reactions=(reaction("F", at=K, on="cylinder", by=None, along=B.x),
                   reaction("K", at=K, on="cylinder", by=None, along=B.y)),
    )  # fmt: skip


def quadratic():
    """A mass on a spring with a resistance b times the square of its speed."""
    x = dynamicsymbols("x")
    m, k, b = parameters("m k b", units="kg N/m kg/m")
    N, O = _ground()
    P = O.locatenew("P", x * N.x)
    return Scene(
        "quadratic damping", N, O, coordinates=(x,), bodies=(Particle("body", P, m),),
        loads=(spring("k", O, P, k, along=N.x),
               force("b", P, -b * abs(x.diff()) * x.diff() * N.x, on="body")),
    )  # fmt: skip


def top():
    """A symmetric top by Euler's angles, I_1 across its axis at its tip."""
    phi, theta, psi = dynamicsymbols("phi theta psi")
    I1, I3, M, l, g = parameters("I_1 I_3 M l g", units="kg*m^2 kg*m^2 kg m m/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Body", (phi, theta, psi), "ZXZ")
    C = O.locatenew("C", l * B.z)
    across = I1 - M * l**2
    return Scene(
        "heavy top", N, O, coordinates=(phi, theta, psi),
        bodies=(RigidBody("top", C, B, M, inertia(B, across, across, I3)),),
        loads=(gravity(-g * N.z),), example={"theta": 0.7},
        reactions=(reaction("X", at=O, on="top", by=None, along=N.x),
                   reaction("Y", at=O, on="top", by=None, along=N.y),
                   reaction("Z", at=O, on="top", by=None, along=N.z)),
    )  # fmt: skip


def orbit():
    """A body about a fixed centre that pulls by mu/r^2 a unit of mass."""
    r, theta = dynamicsymbols("r theta")
    m, mu = parameters("m mu", units="kg m^3/s^2")
    N, O = _ground()
    B = N.orientnew("B", "Axis", (theta, N.z))
    P = O.locatenew("P", r * B.x)
    return Scene(
        "orbit", N, O, coordinates=(r, theta), bodies=(Particle("body", P, m),),
        loads=(force("pull", P, -m * mu / r**2 * B.x, on="body"),), example={"r": 1.3},
    )  # fmt: skip
