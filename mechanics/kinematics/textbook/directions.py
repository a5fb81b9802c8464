"""Which directions a scene uses: planar is what falls out when nothing leaves the plane.

A translation along an inertial axis is in use when a velocity, a load or a reaction has a component
there. A rotation about an axis is in use when a body turns or a couple acts about it; when forces
use a plane, its normal; when they use space, all three.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from mechanics.kinematics.textbook.motion import BodyMotion
from mechanics.scene.actions import Action
from mechanics.symbolic import is_zero

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Directions:
    """Inertial axes (0, 1, 2 for x, y, z) along and about which momentum principles are written."""

    translation: tuple[int, ...]
    rotation: tuple[int, ...]

    @property
    def normal(self) -> int | None:
        """The axis normal to the plane that the scene keeps; None when it keeps none."""
        if len(self.rotation) == 1 and self.rotation[0] not in self.translation:
            return self.rotation[0]
        return None


def used_directions(motions: Sequence[BodyMotion], actions: Iterable[Action]) -> Directions:
    """Directions in use, given the motions, the applied actions and the unit reactions."""
    actions = list(actions)
    linear = [motion.centre.velocity for motion in motions] + [a.force for a in actions]
    angular = [motion.angular_velocity for motion in motions] + [a.couple for a in actions]
    translation = tuple(i for i in range(3) if any(not is_zero(v[i]) for v in linear))
    rotation = {i for i in range(3) if any(not is_zero(v[i]) for v in angular)}
    if any(motion.turns for motion in motions):
        if len(translation) == 2:
            rotation |= {0, 1, 2} - set(translation)
        if len(translation) == 3:
            rotation = {0, 1, 2}
    return Directions(translation, tuple(sorted(rotation)))
