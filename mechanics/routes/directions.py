"""Which directions a mechanism uses: planar is what falls out when nothing leaves the plane.

A translation along an inertial axis is in use when a velocity, a load or a reaction has a component
there. A rotation about an axis is in use when a body turns or a couple acts about it; when forces
use a plane, its normal; when they use space, all three.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.kinematics.motion import BodyMotion
from mechanics.program.residues import Residues
from mechanics.program.vectors import Vector
from mechanics.routes.loads import Wrench

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Directions:
    """Inertial axes (0, 1, 2 for x, y, z) along and about which momentum principles are written."""

    translation: tuple[int, ...]
    rotation: tuple[int, ...]


def used_directions(
    filter_: Residues, bodies: Sequence[BodyMotion], wrenches: Sequence[Wrench]
) -> Directions:
    """Directions in use, given the motions, the loads and the unit reactions."""
    turnings = [motion.turning for motion in bodies if motion.turning is not None]
    linear = [motion.centre.velocity for motion in bodies] + [w.force for w in wrenches]
    angular = [turning.omega for turning in turnings] + [w.couple for w in wrenches]

    def used(vectors: Sequence[Vector]) -> set[int]:
        return {i for i in range(3) if any(not filter_.is_zero(v[i]) for v in vectors)}

    translation = used(linear)
    rotation = used(angular)
    if any(not filter_.is_zero(entry) for turning in turnings for entry in turning.omega):
        if len(translation) == 2:
            rotation |= {0, 1, 2} - translation
        if len(translation) == 3:
            rotation = {0, 1, 2}
    return Directions(tuple(sorted(translation)), tuple(sorted(rotation)))
