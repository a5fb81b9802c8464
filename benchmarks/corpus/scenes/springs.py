"""Masses on springs, a car's half, an absorber."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, two_discs, two_masses
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    slide,
    torque,
)

t = dynamicsymbols._t


def hanging():
    """Two equal masses below each other; x, y down from where the springs (l long) are
    unextended."""
    x, y = dynamicsymbols("x y")
    m, k, l, g = P("m:kg k:N/m l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    a = slide("a", None, "one", at=O.locatenew("A0", -l * N.y), axis=-N.y, distance=x)
    b = slide("b", None, "two", at=O.locatenew("B0", -2 * l * N.y), axis=-N.y, distance=y)
    return Scene(
        "two masses below each other",
        N,
        O,
        plane=N.z,
        joints=(a, b),
        bodies=(RigidBody("one", a.point, N, m, 0), RigidBody("two", b.point, N, m, 0)),
        loads=(
            gravity(-g * N.y),
            force("top", a.point, k * x * N.y, on="one"),
            force("middle", b.point, k * (y - x) * N.y, on="two", by="one"),
        ),
    )


def table():
    """Wall, spring, mass, spring, mass; x and y from rest."""
    x, y = dynamicsymbols("x y")
    m, k = P("m:kg k:N/m")
    return two_masses(
        (x, y),
        (m, m),
        lambda N, A, B: (
            force("wall", A, -k * x * N.x, on="one"),
            force("between", B, -k * (y - x) * N.x, on="two", by="one"),
        ),
    )


def half_car():
    """Heave and pitch (small: axles at z_s - a theta, z_s + b theta), two wheels, two roads."""
    z, th, zf, zr, rf, rr = dynamicsymbols("z_s theta z_uf z_ur z_rf z_rr")
    m, I, mf, mr, kf, kr, cf, cr, tf, tr, a, b = P(
        "m_s:kg I_y:kg*m^2 m_uf:kg m_ur:kg "
        "k_sf:N/m k_sr:N/m c_f:N*s/m c_r:N*s/m k_tf:N/m k_tr:N/m a:m b:m"
    )
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (th, N.z))
    S, U, V = (O.locatenew(n, q * N.y) for n, q in (("S", z), ("U", zf), ("V", zr)))
    f, r = zf - (z - a * th), zr - (z + b * th)
    F, R = kf * f + cf * f.diff(t), kr * r + cr * r.diff(t)
    return Scene(
        "half car",
        N,
        O,
        coordinates=(z, th, zf, zr),
        inputs=(rf, rr),
        bodies=(RigidBody("body", S, A, m, I), Particle("front", U, mf), Particle("rear", V, mr)),
        loads=(
            force("springs", S, (F + R) * N.y, on="body"),
            torque("pitch", (b * R - a * F) * N.z, on="body"),
            force("front wheel", U, (-F - tf * (zf - rf)) * N.y, on="front"),
            force("rear wheel", V, (-R - tr * (zr - rr)) * N.y, on="rear"),
        ),
    )


def plotutils():
    """Two pendulums with small swings, a spring between them; displacements xone, xtwo."""
    x, y = dynamicsymbols("xone xtwo")
    m1, m2, l1, l2, k, g = P("mone:kg mtwo:kg lone:m ltwo:m k:N/m g:m/s^2")
    return two_masses(
        (x, y),
        (m1, m2),
        lambda N, A, B: (
            force("gravity one", A, -m1 * g * x / l1 * N.x, on="one"),
            force("gravity two", B, -m2 * g * y / l2 * N.x, on="two"),
            force("spring", B, -k * (y - x) * N.x, on="two", by="one"),
        ),
    )


def shafts():
    """Two discs on a shaft, the second on the ground."""
    a, b = dynamicsymbols("phi1 phi2")
    J1, J2, c1, c2, d1, d2 = P("J1:kg*m^2 J2:kg*m^2 c1:N*m c2:N*m d1:N*m*s d2:N*m*s")
    between = c1 * (b - a) + d1 * (b - a).diff(t)
    return two_discs((a, b), (J1, J2), between, (0, -(c2 * b + d2 * b.diff(t))))
