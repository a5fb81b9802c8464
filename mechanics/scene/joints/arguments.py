"""The arguments of each kind of joint that say what it is, in the order of its function."""

from collections.abc import Mapping
from typing import Any

ARGUMENTS: Mapping[str, tuple[str, ...]] = {
    "pin": ("axis", "angle", "onto"),
    "slide": ("axis", "distance", "onto"),
    "cylindrical": ("axis", "angle", "distance", "onto"),
    "universal": ("frame", "axes", "angles", "onto"),
    "planar": ("frame", "coordinates", "angle", "onto"),
    "ball": ("frame", "rotation", "onto"),
    "weld": ("frame", "onto"),
    "free": ("frame", "coordinates", "rotation"),
    "roll": (
        "radius", "normal", "axis", "inside", "outside", "coordinates", "angles", "speeds", "onto",
    ),
    "rope": ("ends", "length", "along"),
}  # fmt: skip


def arguments(kind: str, *values: Any) -> dict[str, Any]:
    """What `Joint.given` keeps: the kind, and each argument by its name."""
    return dict(zip(("kind", *ARGUMENTS[kind]), (kind, *values), strict=True))
