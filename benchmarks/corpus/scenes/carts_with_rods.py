"""Carts with rods or loads, a wheel with a pendulum."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole, cart_with_rods


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
