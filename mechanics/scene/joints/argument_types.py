"""Whether the arguments of a joint, as `Joint.given` keeps them, are those of its kind.

Checks read what a joint has to be from these alone; a scene in JSON may hold any.
"""

from collections.abc import Callable, Mapping
from typing import Any

from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import kind_of
from mechanics.scene.euler import Euler
from mechanics.scene.joints.arguments import ARGUMENTS
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope
from mechanics.scene.rotations import Rotation

OPTIONAL = {("roll", "axis"), ("roll", "inside"), ("roll", "outside"), ("rope", "along"),
            ("free", "rotation")}  # fmt: skip
MOVED = {"angle", "distance", "angles", "coordinates", "rotation"}
"""What a joint that closes a loop has not."""


def _direction(value: Any) -> bool:
    return isinstance(value, Vector) and len(value.args) == 1


def _scalar(value: Any) -> bool:
    return isinstance(value, Expr | int | float)


def _each(test: Callable[[Any], bool]) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, tuple | list) and all(map(test, value))


def _onto(value: Any) -> bool:
    if not isinstance(value, tuple | list):
        return isinstance(value, Point)
    return (
        len(value) == 2
        and isinstance(value[0], Point)
        and (isinstance(value[1], ReferenceFrame) or _direction(value[1]))
    )


def _end(value: Any) -> bool:
    return (
        isinstance(value, tuple | list)
        and len(value) == 2
        and (value[0] is None or isinstance(value[0], str))
        and isinstance(value[1], Point)
    )


def _two_axes(value: Any) -> bool:
    return isinstance(value, str) and len(value) == 2 and len({*value.lower()} & {*"xyz"}) == 2


EXPECTED: Mapping[str, Callable[[Any], bool]] = {
    "axis": _direction,
    "normal": _direction,
    "frame": lambda value: isinstance(value, ReferenceFrame),
    "axes": _two_axes,
    "angle": _scalar,
    "distance": _scalar,
    "angles": _each(_scalar),
    "coordinates": _each(_scalar),
    "speeds": _each(_scalar),
    "rotation": lambda value: isinstance(value, Euler | Rotation),
    "radius": lambda value: _scalar(value) or _each(_scalar)(value),
    "inside": _scalar,
    "outside": _scalar,
    "length": _scalar,
    "ends": _each(_end),
    "along": _each(lambda value: value is None or _direction(value)),
    "onto": _onto,
}


def check_given(joint: Joint | Rope) -> None:
    """Refuse arguments that no joint of the kind has.

    Raises
    ------
    SceneError
        Names the joint and the argument.
    """
    given = joint.given
    if not given:
        return
    what = f"joint {joint.name}: given"
    kind = given.get("kind", "")
    if kind not in ARGUMENTS or (kind == "rope") != isinstance(joint, Rope):
        raise SceneError(f"{what} has the kind {kind_of(kind)}: leave given out")
    if {*given} != {"kind", *ARGUMENTS[kind]}:
        raise SceneError(
            f"{what} has {', '.join(sorted(given))}: a {kind} has kind,"
            f" {', '.join(ARGUMENTS[kind])}"
        )
    closes = given.get("onto") is not None
    if isinstance(joint, Joint) and joint.carries is closes:
        raise SceneError(f"{what} has onto={given.get('onto')}: this joint closes no such loop")
    for name in ARGUMENTS[kind]:
        spared = name == "onto" or (kind, name) in OPTIONAL or (closes and name in MOVED)
        if not (EXPECTED[name](given[name]) or (spared and given[name] is None)):
            raise SceneError(f"{what} has {name} = {kind_of(given[name])}: no {kind} has that")
