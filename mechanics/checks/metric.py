"""The metric of the kinetic energy, written out: M = sum of m J_v^T J_v + J_w^T I J_w."""

from collections.abc import Sequence

from sympy import Matrix

from mechanics.kinematics.textbook.motion import BodyMotion, inertia_matrix
from mechanics.scene import Scene
from mechanics.symbolic import collect_linear


def metric(scene: Scene, motions: Sequence[BodyMotion]) -> Matrix:
    """M = sum over bodies of m J_v^T J_v + J_w^T I J_w, n x n, entries not expanded."""
    total = Matrix.zeros(len(scene.u), len(scene.u))
    for motion in motions:
        linear = Matrix([collect_linear(v, scene.u)[0] for v in motion.centre.velocity])
        total += motion.body.mass * linear.T * linear
        if motion.turns:
            angular = Matrix([collect_linear(w, scene.u)[0] for w in motion.angular_velocity])
            inertia = inertia_matrix(scene, motion.body, motion.rotation)
            total += angular.T * inertia * angular
    return total
