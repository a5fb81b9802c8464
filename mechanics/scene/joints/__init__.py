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
from mechanics.scene.joints.roll import roll
from mechanics.scene.joints.rope import Rope, rope

__all__ = [
    "Joint",
    "Rope",
    "ball",
    "cylindrical",
    "free",
    "pin",
    "planar",
    "roll",
    "rope",
    "slide",
    "universal",
    "weld",
]
