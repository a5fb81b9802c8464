"""Whether friction slides as the bodies do, which has to be known before any route runs.

    v_on - v_by = v t         at the point of contact, v and t as declared

So friction cannot push, act on a body that does not slide, or leave out a sideways slip.
"""

from collections.abc import Mapping

from sympy import Matrix, zeros

from mechanics.errors import SceneError
from mechanics.exact import is_zero
from mechanics.kinematics.motion import BodyMotion
from mechanics.scene import Scene
from mechanics.scene.actions import frictions


def check_sliding(scene: Scene, motions: Mapping[str, BodyMotion]) -> None:
    """Refuse friction whose sliding velocity is another one.

    Raises
    ------
    SceneError
        Names the load.
    """
    for load in frictions(scene):
        normal = scene.reaction(load.normal)
        at = scene.position(normal.at)
        found = _carried(motions, normal.on, at) - _carried(motions, normal.by, at)
        stated = scene.plain(load.sliding, load.name) * scene.vector(load.along, load.name)
        for entry, given in zip(found, stated, strict=True):
            if is_zero(entry - given) is False:
                raise SceneError(
                    f"load {load.name}: {load.sliding} along {load.along} is not how"
                    f" {normal.on!r} slides on {normal.by or 'the ground'!r} where {load.normal}"
                    " acts: correct sliding= or along="
                )


def _carried(motions: Mapping[str, BodyMotion], name: str | None, at: Matrix) -> Matrix:
    """Velocity of the material point of a body, or of the ground, at a place."""
    if name is None:
        return zeros(3, 1)
    motion = motions[name]
    arm = at - motion.centre.position
    return motion.centre.velocity + motion.angular_velocity.cross(arm)
