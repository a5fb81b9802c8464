"""Carts with bobs, rods or poles, some on a spring."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole


def benchmark():
    """A pole m with its mass centre at l, I about it, theta clockwise from upright.

    Frictions b_c, b_p; a force u.
    """
    x, theta, u = dynamicsymbols("x theta u")
    M, m, l, I, bc, bp, g = P(
        "M:kg m:kg l:m I:kg*m^2 b_c:N*s/m b_p:N*m*s g:m/s^2",
        typical="1 0.2 0.5 0.0167 0.1 0.005 9.81",
    )
    return cart_pole(
        x,
        theta,
        M,
        m,
        l,
        g,
        u - bc * x.diff(),
        up=1,
        sense=1,
        I=I,
        inputs=(u,),
        moment=-bp * theta.diff(),
    )


def lesson():
    """A uniform pole m_p of length 2 ell, theta clockwise from upright, a cart m_c, a force u."""
    x, theta, u = dynamicsymbols("x theta u")
    mc, mp, ell, g = P("m_c:kg m_p:kg ell:m g:m/s^2")
    return cart_pole(x, theta, mc, mp, ell, g, u, up=1, sense=1, I=mp * ell**2 / 3, inputs=(u,))


def spring():
    """A bob m on l below a cart M on a spring k, theta counterclockwise from below.

    X from equilibrium.
    """
    x, theta = dynamicsymbols("x theta")
    M, m, l, k, g = P("M:kg m:kg l:m k:N/m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, -k * x, up=-1, sense=1)


def spring_phi():
    """A bob M on L below a cart m on a spring k, phi counterclockwise from below."""
    x, phi = dynamicsymbols("x phi")
    m, M, L, k, g = P("m:kg M:kg L:m k:N/m g:m/s^2")
    return cart_pole(x, phi, m, M, L, g, -k * x, up=-1, sense=1)


def spring_rod():
    """A uniform rod m2, l below a body m1 on a spring k.

    X1 of the body, y1 the angle counterclockwise from below.
    """
    x, y = dynamicsymbols("x1 y1")
    m1, m2, l, k, g = P("m1:kg m2:kg l:m k:N/m g:m/s^2")
    return cart_pole(x, y, m1, m2, l / 2, g, -k * x, up=-1, sense=1, I=m2 * l**2 / 12)


def spring_back():
    """A bob m_2 on l below a body m_1 on a spring k stretched by x, theta against x."""
    x, theta = dynamicsymbols("x theta")
    m1, m2, l, k, g = P("m_1:kg m_2:kg l:m k:N/m g:m/s^2")
    return cart_pole(x, theta, m1, m2, l, g, -k * x, up=-1, sense=-1)


def free_left():
    """A bob m on l, th counterclockwise from upright, a cart M without a force."""
    x, th = dynamicsymbols("x th")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, th, M, m, l, g, 0, up=1, sense=-1)


def free_cart():
    """A bob m on L, th clockwise from upright, a cart M without a force."""
    x, th = dynamicsymbols("x th")
    m, M, L, g = P("m:kg M:kg L:m g:m/s^2")
    return cart_pole(x, th, M, m, L, g, 0, up=1, sense=1)


def controlled():
    """A bob mp on l, theta counterclockwise from upright, a cart mc, a force f."""
    x, theta, f = dynamicsymbols("x theta f")
    mc, mp, l, g = P("mc:kg mp:kg l:m g:m/s^2")
    return cart_pole(x, theta, mc, mp, l, g, f, up=1, sense=-1, inputs=(f,))


def friction():
    """A bob m on L, theta clockwise from upright, a cart M with a friction b, a force u."""
    x, theta, u = dynamicsymbols("x theta u")
    m, M, L, g, b = P("m:kg M:kg L:m g:m/s^2 b:N*s/m")
    return cart_pole(x, theta, M, m, L, g, u - b * x.diff(), up=1, sense=1, inputs=(u,))


def book():
    """A rod m with its mass centre at L, J about it, theta clockwise from upright.

    A platform M at p; frictions F, C; no force.
    """
    p, theta = dynamicsymbols("p theta")
    M, m, L, J, F, C, g = P("M:kg m:kg L:m J:kg*m^2 F:N*s/m C:N*m*s g:m/s^2")
    return cart_pole(
        p, theta, M, m, L, g, -F * p.diff(), up=1, sense=1, I=J, moment=-C * theta.diff()
    )


def notes():
    """A rod m with its mass centre at L, I about it, phi clockwise from upright, a cart M.

    A force u.
    """
    x, phi, u = dynamicsymbols("x phi u")
    M, m, L, I, g = P("M:kg m:kg L:m I:kg*m^2 g:m/s^2")
    return cart_pole(x, phi, M, m, L, g, u, up=1, sense=1, I=I, inputs=(u,))


def playground():
    """A bob m on ell below a cart M, theta counterclockwise from below, no force."""
    x, theta = dynamicsymbols("x theta")
    M, m, ell, g = P("M:kg m:kg ell:m g:m/s^2")
    return cart_pole(x, theta, M, m, ell, g, 0, up=-1, sense=1)


def tutorial():
    """A pole m1 with its mass centre at a1, J1 about it, q1 counterclockwise from upright.

    A cart m0 at q0; frictions d0, d1; a force F; l1 is its length.
    """
    q0, q1, F = dynamicsymbols("q0 q1 F")
    m0, m1, J1, _, a1, g, d0, d1 = P("m0:kg m1:kg J1:kg*m^2 l1:m a1:m g:m/s^2 d0:N*s/m d1:N*m*s")
    return cart_pole(
        q0,
        q1,
        m0,
        m1,
        a1,
        g,
        F - d0 * q0.diff(),
        up=1,
        sense=-1,
        I=J1,
        inputs=(F,),
        moment=-d1 * q1.diff(),
    )


def support():
    """A bob M_2 on l below a support M_1, theta counterclockwise from below, no force."""
    x, theta = dynamicsymbols("x theta")
    M, m, l, g = P("M_1:kg M_2:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, 0, up=-1, sense=1)
