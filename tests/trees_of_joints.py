"""Trees of joints of every kind: how they are drawn, and joints and bodies by their kind."""

from dataclasses import dataclass

from hypothesis import strategies as st
from sympy import Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import (
    Joint,
    ball,
    cylindrical,
    euler,
    free,
    pin,
    planar,
    slide,
    universal,
    weld,
)

STEPS: dict[str, str] = {
    "pin": "Z", "backward": "Y", "oblique": "oblique", "slide": "x", "cylindrical": "Yy",
    "universal": "XZ", "planar": "xyZ", "ball": "ZXZ", "free": "xyzXYZ", "weld": "",
}  # fmt: skip
"""Turns (capital) and slides of a joint, in the order in which they are made."""


@dataclass(frozen=True)
class Drawn:
    """A joint and its body: what carries it (0 is the ground), its kind, a fixed turn before it."""

    parent: int
    kind: str
    axis: int
    angle: int


@st.composite
def trees(draw: st.DrawFn) -> tuple[Drawn, ...]:
    kinds = [kind for kind in STEPS if kind != "free"]
    found = []
    for i in range(draw(st.integers(1, 3))):
        parent = draw(st.integers(0, i))
        # Only the ground frees a body, and what is welded to the ground does not move.
        own = [kind for kind in kinds if kind != "weld"] + ["free"] if parent == 0 else kinds
        kind = draw(st.sampled_from(own))
        found.append(Drawn(parent, kind, draw(st.integers(0, 2)), draw(st.integers(0, 5))))
    return tuple(found)


def joined(drawn: Drawn, name: str, by: str | None, at: Point, F: ReferenceFrame) -> Joint:
    q = dynamicsymbols(f"{name}_q1:7")
    body = f"body_{name}"
    match drawn.kind:
        case "pin":
            return pin(name, by, body, at=at, axis=F.z, angle=q[0])
        case "backward":
            return pin(name, by, body, at=at, axis=-2 * F.y, angle=q[0])
        case "oblique":
            return pin(name, by, body, at=at, axis=4 * F.x + 3 * F.z, angle=q[0])
        case "slide":
            return slide(name, by, body, at=at, axis=F.x, distance=q[0])
        case "cylindrical":
            return cylindrical(name, by, body, at=at, axis=F.y, angle=q[0], distance=q[1])
        case "universal":
            return universal(name, by, body, at=at, frame=F, axes="xz", angles=q[:2])
        case "planar":
            return planar(name, by, body, at=at, frame=F, coordinates=q[:2], angle=q[2])
        case "ball":
            return ball(name, by, body, at=at, frame=F, rotation=euler("ZXZ", *q[:3]))
        case "free":
            rotation = euler("XYZ", *q[3:])
            return free(name, body, at=at, frame=F, coordinates=q[:3], rotation=rotation)
        case _:
            return weld(name, by, body, at=at, frame=F)


def mass_of(i: int) -> tuple[Rational, list[Rational], list[Rational]]:
    """Mass, its centre and the entries xx, yy, zz, xy, yz, zx about it."""
    moments = [Rational(n, 10) for n in (4 + i, 5, 6, 1, -1)] + [Rational(1, 20)]
    return Rational(2 + i), [Rational(1, 10), Rational(1, 5), Rational(-3, 10)], moments
