"""A joint: what places a body, moves it, and transmits forces to it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.scene.reactions import Constraint, Reaction
from mechanics.scene.rotations import Rotation


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between a parent and a child: made by `pin`, `slide` and the others.

    Attributes
    ----------
    name : str
    parent : str or None
        Body that carries the joint; None for the ground.
    child : str
        Body that it carries.
    at : Point
        Of the parent.
    frame : ReferenceFrame
        Turns with the child.
    point : Point
        Moves with the child.
    coordinates : tuple of dynamic symbols
    reactions : tuple of Reaction
        Of the parent on the child.
    directions : tuple of Vector
        Of the reactions, where the joint is assembled.
    constraints : tuple of Constraint
        Of a joint that closes a loop, one a reaction; of one that rolls.
    rotations : tuple of Rotation
        Quaternions, with their coordinates and speeds.
    carries : bool
        Whether it places its child; otherwise it ties bodies that other joints carry.
    own : tuple of (coordinate, speed, definition)
        Speeds in place of the rates of coordinates.
    hub : ReferenceFrame or None
        Of a joint that rolls: what does not spin with the child.
    contact : Point or None
        Of a joint that rolls.
    given : mapping of str to Any
        ``"kind"``, and what the user gave, by the names of the arguments: a check reads what the
        joint has to be from this alone.
    """

    name: str
    parent: str | None
    child: str
    at: Point
    frame: ReferenceFrame
    point: Point
    coordinates: tuple[Expr, ...]
    reactions: tuple[Reaction, ...]
    directions: tuple[Vector, ...]
    constraints: tuple[Constraint, ...] = ()
    rotations: tuple[Rotation, ...] = ()
    carries: bool = True
    own: tuple[tuple[Expr, Expr, Expr], ...] = ()
    hub: ReferenceFrame | None = None
    contact: Point | None = None
    given: Mapping[str, Any] = field(default_factory=dict)

    @property
    def speeds(self) -> tuple[tuple[Expr, Expr], ...]:
        """Generalized speeds with their definitions; empty where they are rates."""
        turning = tuple(pair for rotation in self.rotations for pair in rotation.definitions)
        return (*((u, definition) for _, u, definition in self.own), *turning)
