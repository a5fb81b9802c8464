"""Carts with a rod or a load, with two of them, on a spring."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole
from mechanics.scene import parameters


def swingup():
    """A uniform pole of the length l, theta from upright, its top at x - l sin(theta); friction b
    of the cart."""
    x, theta, F = dynamicsymbols("x theta action")
    mp, mc, l, b, g = P("m_p:kg m_c:kg l:m b:N*s/m g:m/s^2")
    return cart_pole(
        x, theta, mc, mp, l / 2, g, F - b * x.diff(), up=1, sense=-1, I=mp * l**2 / 12, inputs=(F,)
    )


def crocoddyl():
    """A bob m2 on l, th from upright, its top at y - l sin(th)."""
    y, th, f = dynamicsymbols("y th f")
    m1, m2, l, g = P("m1:kg m2:kg l:m g:m/s^2")
    return cart_pole(y, th, m1, m2, l, g, f, up=1, sense=-1, inputs=(f,))


def _uniform(names, F, sense):
    x, theta, force_ = dynamicsymbols(f"x theta {F}")
    M, m, l, g = parameters(names, units="kg kg m m/s^2")
    return cart_pole(
        x, theta, M, m, l, g, force_, up=1, sense=sense, I=m * l**2 / 3, inputs=(force_,)
    )


def gym():
    """A uniform pole of half the length `length`, from upright."""
    return _uniform("masscart masspole length gravity", "force", 1)


def capitals():
    """The same in capitals."""
    return _uniform("MASSCART MASSPOLE LENGTH GRAVITY", "force", 1)


def florian():
    """The same as in the literature."""
    return _uniform("m_c m_p l g", "F", 1)


def mppi():
    """The same, theta counterclockwise."""
    return _uniform("M m l g", "force", -1)


def balance():
    """Åström's balance system: top at q - l sin(theta), inertia J, frictions c and gamma."""
    q, theta, u = dynamicsymbols("q theta u")
    M, m, J, l, c, gamma, g = P("M:kg m:kg J:kg*m^2 l:m c:N*s/m gamma:N*m*s g:m/s^2")
    push = u - c * q.diff()
    return cart_pole(
        q, theta, M, m, l, g, push, up=1, sense=-1, I=J, inputs=(u,), moment=-gamma * theta.diff()
    )


def mathworks():
    """A bob, theta counterclockwise from upright, cart at z with a damping Kd."""
    z, theta, F = dynamicsymbols("z theta F")
    M, m, g, l, Kd = P("M:kg m:kg g:m/s^2 l:m Kd:N*s/m")
    return cart_pole(z, theta, M, m, l, g, F - Kd * z.diff(), up=1, sense=-1, inputs=(F,))


def bob():
    """A bob m on l, clockwise from upright, pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, u, up=1, sense=1, inputs=(u,))


def inertia():
    """A rod with the inertia J about its mass centre, clockwise from upright."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, L, J, g = P("M:kg m:kg L:m J:kg*m^2 g:m/s^2")
    return cart_pole(x, theta, M, m, L, g, u, up=1, sense=1, I=J, inputs=(u,))


def gantry():
    """A container m that hangs on r at x + r sin(theta), dampings dc of the trolley and dp of the
    swing."""
    x, theta, u = dynamicsymbols("x theta u")
    m, M, r, dp, dc, g = P("m:kg M:kg r:m dp:N*m*s dc:N*s/m g:m/s^2")
    push = u - dc * x.diff()
    return cart_pole(
        x, theta, M, m, r, g, push, up=-1, sense=1, inputs=(u,), moment=-dp * theta.diff()
    )


def web():
    """A bob, theta counterclockwise from upright, pushed by F."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, F, up=1, sense=-1, inputs=(F,))


def hanging():
    """A bob that hangs at x + l sin(theta) on a free cart."""
    x, theta = dynamicsymbols("x theta")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, 0, up=-1, sense=1)


def ctms():
    """A rod that hangs, with the inertia I about its mass centre, friction b of the cart."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, l, I, b, g = P("M:kg m:kg l:m I:kg*m^2 b:N*s/m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, F - b * x.diff(), up=-1, sense=1, I=I, inputs=(F,))


def on_spring():
    """A cart on a spring k with a bob that hangs on R; dampings d of the cart and b of the pin."""
    x, theta = dynamicsymbols("x theta")
    M, m, R, k, d, b, g = P("M:kg m:kg R:m k:N/m d:N*s/m b:N*m*s g:m/s^2")
    push = -k * x - d * x.diff()
    return cart_pole(x, theta, M, m, R, g, push, up=-1, sense=1, moment=-b * theta.diff())


def hanging_u():
    """A bob mp that hangs at x + l sin(theta) on a cart mc, pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    mc, mp, l, g = P("mc:kg mp:kg l:m g:m/s^2")
    return cart_pole(x, theta, mc, mp, l, g, u, up=-1, sense=1, inputs=(u,))
