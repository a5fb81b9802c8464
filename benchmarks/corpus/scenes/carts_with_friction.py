"""Carts with bobs, rods or poles."""

from sympy.physics.mechanics import dynamicsymbols

from benchmarks.corpus.builders import P, cart_pole


def hanging_friction():
    """A bob m on L below a cart M, counterclockwise; frictions b of the cart, d of the pivot."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, L, g, b, d = P("M:kg m:kg L:m g:m/s^2 b:N*s/m d:N*m*s")
    push, brake = u - b * x.diff(), -d * theta.diff()
    return cart_pole(x, theta, M, m, L, g, push, up=-1, sense=1, inputs=(u,), moment=brake)


def upright_f():
    """A bob m on l, clockwise from upright; a friction f m l theta' in the pivot."""
    return _per_mass("f")


def _per_mass(friction):
    x, theta, u = dynamicsymbols("x theta u")
    M, m, l, g, f = P(f"M:kg m:kg l:m g:m/s^2 {friction}:m/s")
    brake = -f * m * l * theta.diff()
    return cart_pole(x, theta, M, m, l, g, u, up=1, sense=1, inputs=(u,), moment=brake)


def quanser():
    """A rod mp with the mass centre at lp and ip about it, alfa counterclockwise from upright."""
    names = "mc:kg mp:kg lp:m ip:kg*m^2 g:m/s^2 beq:N*s/m bp:N*m*s"
    return _rod_with_friction("x alfa", names)


def quanser_capital():
    """The same in other letters."""
    names = "Mc:kg Mp:kg lp:m Ip:kg*m^2 g:m/s^2 Beq:N*s/m Bp:N*m*s"
    return _rod_with_friction("x alpha", names)


def _rod_with_friction(coordinates, names):
    x, angle = dynamicsymbols(coordinates)
    M, m, l, I, g, b, d = P(names)
    push, brake = -b * x.diff(), -d * angle.diff()
    return cart_pole(x, angle, M, m, l, g, push, up=1, sense=-1, I=I, moment=brake)


def left():
    """A bob m on l, th counterclockwise from upright."""
    x, th, u = dynamicsymbols("x th u")
    return cart_pole(
        x, th, *P("M:kg m:kg l:m g:m/s^2"), u, up=1, sense=-1, inputs=(u,)
    )  # fmt: skip


def hanging_m_c():
    """A bob m_p on l below a cart m_c, counterclockwise from below."""
    x, theta, u = dynamicsymbols("x theta u")
    return cart_pole(
        x, theta, *P("m_c:kg m_p:kg l:m g:m/s^2"), u, up=-1, sense=1, inputs=(u,)
    )  # fmt: skip


def pole():
    """A uniform pole m of half-length l, clockwise from upright."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, l, g = P("M:kg m:kg l:m g:m/s^2")
    return cart_pole(x, theta, M, m, l, g, u, up=1, sense=1, I=m * l**2 / 3, inputs=(u,))


def trajectory():
    """A mass m_p on l, varphi counterclockwise from upright, on a cart M_w at x_w; a force F."""
    x, phi, F = dynamicsymbols("x_w varphi F")
    return cart_pole(
        x, phi, *P("M_w:kg m_p:kg l:m g:m/s^2"), F, up=1, sense=-1, inputs=(F,)
    )  # fmt: skip
