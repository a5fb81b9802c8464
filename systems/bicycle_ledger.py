"""The linear equations of the bicycle as their source's appendix A prints them.

    M x'' + v C_1 x' + (g K_0 + v^2 K_2) x = 0,    x = (lean, steer)

Of the whole bicycle (T), of the front assembly (A), about the steering axis (l), whose tilt lambda
is pi/10; z is down. J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Proceedings of
the Royal Society A 463 (2007), with zB, zH and IHxz as in `systems.bicycle`.
"""

from sympy import ImmutableMatrix, Symbol, cos, pi, sin

from mechanics.scene.linear_quantities import SpeedMatrix, operating_point
from mechanics.scene.published import published
from systems.bicycle import bicycle_parameters

p = bicycle_parameters()
v = Symbol("v", positive=True)
STEADY = operating_point({"lean": 0, "pitch": 0, "steer": 0}, speeds={"tR_dot": -v / p["rR"]})
"""Upright and straight ahead."""


def _matrices() -> dict[str, ImmutableMatrix]:
    """The four matrices by name."""
    w, c, rR, rF = (p[name] for name in ("w", "c", "rR", "rF"))
    mR, mB, mH, mF = (p[name] for name in ("mR", "mB", "mH", "mF"))
    xB, zB, xH, zH = p["xB"], -p["zB"], p["xH"], -p["zH"]
    bxx, bzz, bxz = p["IBx"], p["IBz"], p["IBxz"]
    hxx, hzz, hxz = p["IHx"], p["IHz"], -p["IHxz"]
    rxx, ryy, fxx, fyy = p["IRx"], p["IRy"], p["IFx"], p["IFy"]
    s, k = sin(pi / 10), cos(pi / 10)
    mT = mR + mB + mH + mF
    xT = (xB * mB + xH * mH + w * mF) / mT
    zT = (-rR * mR + zB * mB + zH * mH - rF * mF) / mT
    txx = rxx + bxx + hxx + fxx + mR * rR**2 + mB * zB**2 + mH * zH**2 + mF * rF**2
    txz = bxz + hxz - mB * xB * zB - mH * xH * zH + mF * w * rF
    tzz = rxx + bzz + hzz + fxx + mB * xB**2 + mH * xH**2 + mF * w**2
    mA = mH + mF
    xA, zA = (xH * mH + w * mF) / mA, (zH * mH - rF * mF) / mA
    axx = hxx + fxx + mH * (zH - zA) ** 2 + mF * (rF + zA) ** 2
    axz = hxz - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA)
    azz = hzz + fxx + mH * (xH - xA) ** 2 + mF * (w - xA) ** 2
    uA = (xA - w - c) * k - zA * s
    all_ = mA * uA**2 + axx * s**2 + 2 * axz * s * k + azz * k**2
    alx = -mA * uA * zA + axx * s + axz * k
    alz = mA * uA * xA + axz * s + azz * k
    mu = c / w * k
    SR, SF = ryy / rR, fyy / rF
    ST, SA = SR + SF, mA * uA + mu * mT * xT
    beside = alx + mu * txz
    return {
        "M": ImmutableMatrix([[txx, beside], [beside, all_ + 2 * mu * alz + mu**2 * tzz]]),
        "K0": ImmutableMatrix([[mT * zT, -SA], [-SA, -SA * s]]),
        "K2": ImmutableMatrix([[0, (ST - mT * zT) / w * k], [0, (SA + SF * s) / w * k]]),
        "C1": ImmutableMatrix(
            [[0, mu * ST + SF * k + txz / w * k - mu * mT * zT],
             [-(mu * ST + SF * k), alz / w * k + mu * (SA + tzz / w * k)]]),
    }  # fmt: skip


PUBLISHED = tuple(
    published(name, SpeedMatrix(STEADY, name, "v"), matrix, label="matrix of lean and steer")
    for name, matrix in _matrices().items()
)
