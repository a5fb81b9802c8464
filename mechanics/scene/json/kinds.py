"""What the parts of a scene are called in JSON. Their entries are the fields of the dataclasses.

{"kind": "spring", "name": "k", "first": "A", "second": "B", "stiffness": "k"}
"""

from dataclasses import MISSING, Field, fields
from functools import cache
from typing import Any, get_args, get_type_hints

from mechanics.scene.bodies import Outline, Particle, RigidBody
from mechanics.scene.conditions import Condition
from mechanics.scene.euler import Euler
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope
from mechanics.scene.loads import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    Spring,
    Torque,
    TorsionSpring,
)
from mechanics.scene.outputs import Orientation, Output, Position, Velocity
from mechanics.scene.reactions import Constraint, Reaction
from mechanics.scene.rotations import Rotation

FORMAT = "mechanics scene 1"

KINDS: dict[str, type] = {
    "particle": Particle,
    "rigid body": RigidBody,
    "outline": Outline,
    "gravity": Gravity,
    "spring": Spring,
    "damper": Damper,
    "force": Force,
    "torque": Torque,
    "torsion spring": TorsionSpring,
    "coulomb": Coulomb,
    "joint": Joint,
    "rope": Rope,
    "position": Position,
    "orientation": Orientation,
    "velocity": Velocity,
    "quaternion": Rotation,
    "euler": Euler,
    "reaction": Reaction,
    "constraint": Constraint,
    "condition": Condition,
}
NAME_OF = {own: name for name, own in KINDS.items()}

PARTS: dict[str, tuple[type, ...]] = {
    "rotations": (Rotation,),
    "bodies": (Particle, RigidBody),
    "loads": get_args(Load),
    "reactions": (Reaction,),
    "constraints": (Constraint,),
    "joints": (Joint, Rope),
    "conditions": (Condition,),
    "outputs": get_args(Output),
}
"""Entries of a scene that hold parts, in the order in which they are written."""


@cache
def entries(kind: Any) -> tuple[tuple[str, Field[Any], Any], ...]:
    """(name in JSON, field, its type) of a part."""
    hints = get_type_hints(kind)
    return tuple((f.name.rstrip("_"), f, hints[f.name]) for f in fields(kind))


def required(field: Field[Any]) -> bool:
    """Whether a field has no default."""
    return field.default is MISSING and field.default_factory is MISSING
