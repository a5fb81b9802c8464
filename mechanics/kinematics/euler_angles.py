"""Euler angles where they do not tell the rotation: a failure of the angles, not of the motion.

    R_i(a) R_j(b) R_k(c)            sin b = 0 (k = i), cos b = 0 (k, j, i all different)

Only where nothing but the last frame has a body: with a body on each, the turns are joints.
"""

from collections.abc import Mapping
from itertools import pairwise

from sympy import Expr, cos, sin, sympify

from mechanics.mechanism import axis_angle
from mechanics.scene import RigidBody, Scene
from mechanics.scene.geometry import frame_path, relative_rotation

NEAR = 0.01
"""Sine or cosine at which the angles are blamed for a matrix that is singular."""


def singular_angles(scene: Scene, coordinates: Mapping[str, float | Expr]) -> str:
    """Which Euler angles are singular at a configuration, in words; empty if none are.

    Parameters
    ----------
    coordinates : mapping of str to float or Expr
        By plain name; an angle that is missing, or no number, is not blamed.
    """
    carried = [body.frame for body in scene.bodies if isinstance(body, RigidBody)]
    values = {q: sympify(coordinates[q.name]) for q in scene.q if q.name in coordinates}
    for frame in carried:
        path = frame_path(scene.frame, frame)
        turns = [axis_angle(relative_rotation(*step)) for step in pairwise(path)]
        for k, (first, second, third) in enumerate(zip(turns, turns[1:], turns[2:], strict=False)):
            if first is None or second is None or third is None:
                continue
            if path[k + 1] in carried or path[k + 2] in carried:
                continue
            axes = [axis for axis, _ in (first, second, third)]
            if axes[0] == axes[1] or axes[1] == axes[2]:
                continue
            a, b, c = (scene.plain(angle) for _, angle in (first, second, third))
            value = b.xreplace(values)
            measure = (sin if axes[0] == axes[2] else cos)(value)
            if value.is_number and abs(measure) < NEAR:
                return (
                    f"the Euler angles {a}, {b}, {c} are singular at {b} = {float(value):.3g},"
                    f" where {a} and {c} turn about one line: the motion goes on, take a quaternion"
                    " or another order of axes"
                )
    return ""
