"""Rockets and a wing in a plane, a satellite, a mass on a table with another below it."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P
from benchmarks.corpus.free_bodies import craft
from mechanics.scene import (
    Particle,
    Scene,
    force,
    gravity,
    reaction,
)


def _rocket(names, m, l, thrust, gimbal, g, inputs):
    """A uniform rod, its angle clockwise from upright; the thrust at its lower end, turned by the
    gimbal angle, clockwise, too."""
    return craft(
        names, m, m * l**2 / 12,
        lambda N, A, C: (
            force("engine", C.locatenew("E", -l / 2 * A.y),
                  thrust * (sin(gimbal) * A.x + cos(gimbal) * A.y), on="rocket"),
        ),
        inputs, g=g, sense=-1, name="rocket",
    )  # fmt: skip


def myriad():
    """The thrust in parts of the greatest one."""
    u, a = dynamicsymbols("thrust thrust_angle")
    m, l, F, g = P("m:kg length:m max_thrust:N g:m/s^2")
    return _rocket("x y theta", m, l, F * u, a, g, (u, a))


def myriad_docs():
    """The same in the symbols of its documentation."""
    u, a = dynamicsymbols("u_0 u_1")
    m, l, F, g = P("m:kg l:m F_v:N g:m/s^2")
    return _rocket("x_0 x_1 phi", m, l, F * u, a, g, (u, a))


def planar_rocket():
    """Thrust T at the gimbal angle phi."""
    T, phi = dynamicsymbols("T phi")
    m, l, g = P("m:kg ell:m g:m/s^2")
    return _rocket("x y theta", m, l, T, phi, g, (T, phi))


def wing():
    """A flying platform: thrust F_T along the angle theta, lift F_L across it, drag against x by
    the speed u of the air."""
    x, y, L, T, theta, u = dynamicsymbols("x y F_L F_T theta u")
    m, g, CD, rho, S = P("m:kg g:m/s^2 C_D:1 rho:kg/m^3 A:m^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + y * N.y)
    c, s = cos(theta), sin(theta)
    return Scene(
        "platform",
        N,
        O,
        coordinates=(x, y),
        inputs=(L, T, theta, u),
        bodies=(Particle("platform", C, m),),
        loads=(
            gravity(-g * N.y),
            force("thrust", C, T * (c * N.x + s * N.y), on="platform"),
            force("lift", C, L * (-s * N.x + c * N.y), on="platform"),
            force("drag", C, -CD * rho * u**2 * S / 2 * N.x, on="platform"),
        ),
        reactions=(reaction("side", at=C, on="platform", by=None, along=N.z),),
    )
