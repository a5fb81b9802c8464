"""Joints: each places a body and declares its coordinates, reactions and constraints."""

from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.kinds import (
    ball,
    cylindrical,
    free,
    pin,
    planar,
    slide,
    universal,
    weld,
)

__all__ = [
    "Joint",
    "ball",
    "cylindrical",
    "free",
    "pin",
    "planar",
    "slide",
    "universal",
    "weld",
]
