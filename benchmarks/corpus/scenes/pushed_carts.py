"""Carts with a rod or a load."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole


def lapy():
    """A cart q1 with a bob m2 that hangs on l, q2 from below, pushed by f."""
    q1, q2, f = dynamicsymbols("q1 q2 f")
    m1, m2, l, g = P("m1:kg m2:kg l:m g:m/s^2")
    return cart_pole(q1, q2, m1, m2, l, g, f, up=-1, sense=1, inputs=(f,))


def bob():
    """A bob m on l, clockwise from upright, pushed by F."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, F, up=1, sense=1, inputs=(F,))


def pymoskito():
    """A cart s with friction D, a rod with the inertia J about its pin and friction d, varphi
    from upright, its top at s - l sin(varphi)."""
    s, phi, F = dynamicsymbols("s varphi F")
    M, m, J, l, D, d, g = P("M:kg m:kg J:kg*m^2 l:m D:N*s/m d:N*m*s g:m/s^2")
    return cart_pole(
        s,
        phi,
        M,
        m,
        l,
        g,
        F - D * s.diff(),
        up=1,
        sense=-1,
        I=J - m * l**2,
        inputs=(F,),
        moment=-d * phi.diff(),
    )


def hussein():
    """A rod of the length l with I_p about its mass centre, counterclockwise from upright;
    disturbances D_c and D_p."""
    x, theta, U, Dc, Dp = dynamicsymbols("x theta U_f D_c D_p")
    mc, mp, l, I, bc, bp, g = P("m_c:kg m_p:kg l:m I_p:kg*m^2 b_c:N*s/m b_p:N*m*s g:m/s^2")
    push = U - bc * x.diff() + Dc
    return cart_pole(
        x,
        theta,
        mc,
        mp,
        l / 2,
        g,
        push,
        up=1,
        sense=-1,
        I=I,
        inputs=(U, Dc, Dp),
        moment=-bp * theta.diff() + Dp,
    )


def hussein_u():
    """The same, pushed by u alone."""
    x, theta, u = dynamicsymbols("x theta u")
    mc, mp, l, I, bc, bp, g = P("m_c:kg m_p:kg l:m I_p:kg*m^2 b_c:N*s/m b_p:N*m*s g:m/s^2")
    return cart_pole(
        x,
        theta,
        mc,
        mp,
        l / 2,
        g,
        u - bc * x.diff(),
        up=1,
        sense=-1,
        I=I,
        inputs=(u,),
        moment=-bp * theta.diff(),
    )


def damped():
    """A bob mp that hangs on l, frictions b of the cart and d of the pin, pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    mc, mp, l, b, d, g = P("mc:kg mp:kg l:m b:N*s/m d:N*m*s g:m/s^2")
    return cart_pole(
        x,
        theta,
        mc,
        mp,
        l,
        g,
        u - b * x.diff(),
        up=-1,
        sense=1,
        inputs=(u,),
        moment=-d * theta.diff(),
    )
