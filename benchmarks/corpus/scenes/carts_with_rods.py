"""Carts with rods or loads, a wheel with a pendulum."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole, cart_with_rods, held
from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    torque,
)


def espinn():
    """A uniform pole of half-length POLE_L, clockwise from upright, pushed by force."""
    x, theta, F = dynamicsymbols("x theta force")
    M, m, l, g = P("CART_MASS:kg POLE_MASS:kg POLE_L:m G:m/s^2")
    return cart_pole(x, theta, M, m, l, g, F, up=1, sense=1, I=m * l**2 / 3, inputs=(F,))


def mpechac():
    """A uniform pole of half-length l, clockwise from upright, pushed by F; the cart at s."""
    s, theta, F = dynamicsymbols("s theta F")
    mc, mp, l, g = P("mc:kg mp:kg l:m g:m/s^2")
    return cart_pole(s, theta, mc, mp, l, g, F, up=1, sense=1, I=mp * l**2 / 3, inputs=(F,))


def mpc():
    """A uniform pole of half-length l, counterclockwise from upright, pushed by F."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, F, up=1, sense=-1, I=m * l**2 / 3, inputs=(F,))


def dip_rods():
    """Two uniform rods that hang from a cart, L1 and L2 long, both angles from below.

    Counterclockwise; pushed by u.
    """
    x, a, b, u = dynamicsymbols("x theta1 theta2 u")
    M, m1, m2, L1, L2, g = P("M:kg m1:kg m2:kg L1:m L2:m g:m/s^2")
    return cart_with_rods(
        x,
        M,
        [
            ("one", "cart", a, -1, 1, m1, L1 / 2, m1 * L1**2 / 12, L1),
            ("two", "one", b, -1, 1, m2, L2 / 2, m2 * L2**2 / 12, L2),
        ],
        g,
        u,
        (u,),
    )


def sopot():
    """Two bobs on light links, upright on a cart, both angles clockwise from the vertical.

    Pushed by F.
    """
    x, a, b, F = dynamicsymbols("x theta1 theta2 F")
    mc, m1, m2, L1, L2, g = P("mc:kg m1:kg m2:kg L1:m L2:m g:m/s^2")
    return cart_with_rods(
        x,
        mc,
        [("one", "cart", a, 1, 1, m1, L1, 0, L1), ("two", "one", b, 1, 1, m2, L2, 0, L2)],
        g,
        F,
        (F,),
    )


def crane():
    """A load m on l below a trolley M, counterclockwise from below, pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, u, up=-1, sense=1, inputs=(u,))


def crane_swapped():
    """A load M on l below a trolley m, counterclockwise from below, pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    m, M, l, g = P("m:kg M:kg l:m g:m/s^2")
    return cart_pole(x, theta, m, M, l, g, u, up=-1, sense=1, inputs=(u,))


def two_hanging():
    """Two bobs m1, m2 that hang on l from the same cart M at q.

    Frictions c_cart of the cart and c_piv of each pivot.
    """
    q, a, b = dynamicsymbols("q phi1 phi2")
    M, m1, m2, l, g, cc, cp = P("M:kg m1:kg m2:kg l:m g:m/s^2 c_cart:N*s/m c_piv:N*m*s")
    return cart_with_rods(
        q,
        M,
        [("one", "cart", a, -1, 1, m1, l, 0, l), ("two", "cart", b, -1, 1, m2, l, 0, l)],
        g,
        -cc * q.diff(),
        (),
        (("one", -cp * a.diff()), ("two", -cp * b.diff())),
    )


def ocs2():
    """A uniform rod of length l, counterclockwise from upright, pushed by F."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l / 2, g, F, up=1, sense=-1, I=m * l**2 / 12, inputs=(F,))


def ejercicio():
    """A bob m on a rod ell, clockwise from upright, its pivot at the height H on a free cart M."""
    x, theta = dynamicsymbols("x theta")
    M, m, l, g, H = P("M:kg m:kg ell:m g:m/s^2 H:m")
    return cart_pole(x, theta, M, m, l, g, 0, up=1, sense=1, height=H)


def lezione():
    """A bob M that hangs on L from a cart m, driven by a couple C on a light wheel of radius R."""
    x, theta, C = dynamicsymbols("x theta C")
    m, M, L, R, g = P("m:kg M:kg L:m R:m g:m/s^2")
    return cart_pole(x, theta, m, M, L, g, C / R, up=-1, sense=1, inputs=(C,))


def wip():
    """A wheel mw, r, Jw that rolls by phi, a pendulum mp at l from its axle, Jp about it.

    The angle theta is clockwise from upright; a torque u between them.
    """
    theta, phi, u = dynamicsymbols("theta phi u")
    Jp, mp, l, r, mw, Jw, g = P("Jp:kg*m^2 mp:kg l:m r:m mw:kg Jw:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A, B = N.orientnew("A", "Axis", (-phi, N.z)), N.orientnew("B", "Axis", (-theta, N.z))
    C = O.locatenew("C", r * phi * N.x)
    K = C.locatenew("K", -r * N.y)
    D = C.locatenew("D", l * (sin(theta) * N.x + cos(theta) * N.y))
    return Scene(
        "wheeled pendulum",
        N,
        O,
        coordinates=(theta, phi),
        inputs=(u,),
        bodies=(RigidBody("wheel", C, A, mw, Jw), RigidBody("pendulum", D, B, mp, Jp - mp * l**2)),
        loads=(gravity(-g * N.y), torque("motor", -u * N.z, on="wheel", by="pendulum")),
        reactions=(*held(K, "wheel", f=N.x, n=N.y), *held(C, "pendulum", "wheel", X=N.x, Y=N.y)),
    )
