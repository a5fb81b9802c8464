"""Joints by their kind alone: what the functions of `mechanics.scene.joints` take.

{"kind": "pin", "name": "shoulder", "parent": null, "child": "arm", "at": "O",
 "axis": {"N": [0, 0, 1]}, "angle": "q"}

The joint's frame and point have its name, and carry other frames and points. A joint that closes a
loop, one that rolls, and a rope are written in full, as kind "joint" or "rope".
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.scene.euler import Euler
from mechanics.scene.joints import ball, cylindrical, free, pin, planar, slide, universal, weld
from mechanics.scene.joints.arguments import ARGUMENTS
from mechanics.scene.joints.joint import Joint
from mechanics.scene.rotations import Rotation

FUNCTIONS: Mapping[str, Callable[..., Joint]] = {
    "pin": pin, "slide": slide, "cylindrical": cylindrical, "universal": universal,
    "planar": planar, "ball": ball, "weld": weld, "free": free,
}  # fmt: skip
HINTS: Mapping[str, Any] = {
    "name": str, "parent": str | None, "child": str, "at": Point, "axis": Vector,
    "frame": ReferenceFrame, "axes": str, "angle": Expr, "distance": Expr,
    "angles": tuple[Expr, ...], "coordinates": tuple[Expr, ...], "rotation": Rotation | Euler,
}  # fmt: skip
OPTIONAL = ("axes", "rotation")


def arguments_of(kind: str) -> tuple[str, ...]:
    """What an entry of the kind has."""
    parent = () if kind == "free" else ("parent",)
    return ("name", *parent, "child", "at", *(x for x in ARGUMENTS[kind] if x != "onto"))


def required_of(kind: str) -> tuple[str, ...]:
    """What it cannot be without."""
    return tuple(entry for entry in arguments_of(kind) if entry not in OPTIONAL)


def carriers(tree: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """What has to be placed before: ``("frames", name)`` and ``("points", name)``."""
    yield "points", tree.get("at")
    if "frame" in tree:
        yield "frames", tree["frame"]
    if isinstance(axis := tree.get("axis"), Mapping):
        yield from (("frames", name) for name in axis)
