"""Recursive Newton-Euler in plain NumPy: the referee of what is derived for trees of joints.

J. Y. S. Luh, M. W. Walker, R. P. C. Paul, "On-Line Computational Scheme for Mechanical
Manipulators", 1980; J. J. Craig, Introduction to Robotics, equations 6.45 to 6.53. Outward, for
every joint with R from its frame to that of the body before it and axis z,

    w = R^T w_b + u z          w' = R^T w_b' + (R^T w_b) x u z + u' z
    a = R^T (a_b + w_b' x p + w_b x (w_b x p))          a_C = a + w' x c + w x (w x c)

and inward, with what is carried further out added in, F = m a_C, N = I w' + w x I w,

    f = F + sum R_k f_k        n = N + c x F + sum (R_k n_k + p_k x R_k f_k)        tau = n . z

Gravity is an acceleration of the ground. It knows nothing of `mechanics`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Joint:
    """A turning joint and the body behind it, in SI units.

    Attributes
    ----------
    before : int
        Index of the joint that carries it; -1 for the ground.
    turn : array, 3 x 3
        Fixed rotation from the frame of the body before it: v_before = turn v.
    offset : array, 3
        From the joint before it to this one, components in the frame of the body before it.
    axis : array, 3
        Unit vector, in the frame after the fixed rotation, and so in the frame of the body.
    mass : float
    centre : array, 3
        From the joint to the mass centre, components in the frame of the body.
    inertia : array, 3 x 3
        About the mass centre, components in the frame of the body.
    """

    before: int
    turn: Array
    offset: Array
    axis: Array
    mass: float
    centre: Array
    inertia: Array


def rotation(axis: Array, angle: float) -> Array:
    """Rodrigues' formula, 3 x 3."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def inverse_dynamics(
    joints: Sequence[Joint], q: Array, u: Array, ud: Array, gravity: Array
) -> Array:
    """Torques about the axes, N m, for angles q, speeds u and accelerations ud."""
    turns = [j.turn @ rotation(j.axis, angle) for j, angle in zip(joints, q, strict=True)]
    ground = np.zeros(3), np.zeros(3), -gravity
    motions: list[tuple[Array, Array, Array]] = []
    for joint, R, speed, rate in zip(joints, turns, u, ud, strict=True):
        w_b, g_b, a_b = motions[joint.before] if joint.before >= 0 else ground
        p, z = joint.offset, joint.axis
        w = R.T @ w_b + speed * z
        growth = R.T @ g_b + np.cross(R.T @ w_b, speed * z) + rate * z
        a = R.T @ (a_b + np.cross(g_b, p) + np.cross(w_b, np.cross(w_b, p)))
        motions.append((w, growth, a))
    forces, moments = np.zeros((len(joints), 3)), np.zeros((len(joints), 3))
    torques = np.zeros(len(joints))
    for i in reversed(range(len(joints))):
        joint, (w, growth, a) = joints[i], motions[i]
        c, inertia = joint.centre, joint.inertia
        force = joint.mass * (a + np.cross(growth, c) + np.cross(w, np.cross(w, c)))
        forces[i] += force
        moments[i] += inertia @ growth + np.cross(w, inertia @ w) + np.cross(c, force)
        torques[i] = moments[i] @ joint.axis
        if joint.before >= 0:
            carried = turns[i] @ forces[i]
            forces[joint.before] += carried
            moments[joint.before] += turns[i] @ moments[i] + np.cross(joint.offset, carried)
    return torques


def forward_dynamics(
    joints: Sequence[Joint], q: Array, u: Array, torques: Array, gravity: Array
) -> Array:
    """Accelerations: the torques are linear in them, so unit accelerations give the mass matrix."""
    n = len(joints)
    rest = inverse_dynamics(joints, q, u, np.zeros(n), gravity)
    columns = [inverse_dynamics(joints, q, u, unit, gravity) - rest for unit in np.eye(n)]
    return np.linalg.solve(np.array(columns).T, torques - rest)
