"""Rockets and a wing in a plane, a satellite, a mass on a table with another below it."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held
from benchmarks.corpus.free_bodies import craft, turning_body
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    holonomic,
    reaction,
    rope,
    torque,
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


def upright_rocket():
    """Near upright: theta, z downwards; thrust u1 along the vertical, a side force u2 at the
    lower end that lowers theta."""
    theta, z, u1, u2 = dynamicsymbols("theta z u1 u2")
    m, l, g = P("m:kg l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", -z * N.y)
    return Scene(
        "rocket",
        N,
        O,
        coordinates=(theta, z),
        inputs=(u1, u2),
        plane=N.z,
        bodies=(RigidBody("rocket", C, A, m, m * l**2 / 16),),
        loads=(
            gravity(-g * N.y),
            force("thrust", C, u1 * N.y, on="rocket"),
            torque("side", -l / 2 * u2 * N.z, on="rocket"),
        ),
        reactions=(reaction("guide", at=C, on="rocket", by=None, along=N.x),),
    )


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


def hole():
    """A mass m at r, theta on a smooth table, a string of length l through a hole, a mass M that
    hangs below it at the height z."""
    r, theta, z = dynamicsymbols("r theta z")
    m, M, l, g = P("m:kg M:kg l:m g:m/s^2", typical="1 1 1 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", r * A.x)
    H = O.locatenew("H", z * N.z)
    line = rope("T", ("ball", C), (None, O), ("weight", H), length=l, along=(-A.x, -N.z))
    return Scene(
        "mass on a table",
        N,
        O,
        coordinates=(r, theta, z),
        bodies=(Particle("ball", C, m), Particle("weight", H, M)),
        loads=(gravity(-g * N.z),),
        example={"r": 0.5, "z": -0.5},
        constraints=(holonomic("string", r - z - l, "T"),),
        reactions=(
            *line.reactions,
            reaction("table", at=C, on="ball", by=None, along=N.z),
            *held(H, "weight", x=N.x, y=N.y),
        ),
    )


def satellite():
    """A rigid body that turns freely, rates wx, wy, wz about its principal axes, torques Mx, My,
    Mz."""
    return turning_body(
        "wx wy wz", "Ix:kg*m^2 Iy:kg*m^2 Iz:kg*m^2", dynamicsymbols("Mx My Mz"), name="satellite"
    )
