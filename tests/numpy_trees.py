"""The small arm in plain NumPy, which knows nothing of `mechanics`, and mistakes made in it."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from benchmarks.space.textbook import Array, Link, inverse_dynamics, turn

GRAVITY = np.array([0.0, 0.0, -9.81])
CENTRE = np.array([0.1, -0.05, 0.2])
INERTIA = np.array([[0.02, 0.002, 0.004], [0.002, 0.03, -0.003], [0.004, -0.003, 0.025]])


def arm_joints(count: int = 3) -> list[Link]:
    """The joints of `small_trees.arm`."""
    quarter = turn(0, np.pi / 2)
    return [
        Link(i - 1, 2, True, quarter if i else np.eye(3),
             np.array([0.3 + i / 10 if i else 0.0, 0, 0]), 2 + (i + 1) / 2, CENTRE, INERTIA)
        for i in range(count)
    ]  # fmt: skip


def answers(
    joints: list[Link],
    *,
    gravity: Array = GRAVITY,
    added: Callable[[Array, Array, Array], Array] = lambda q, v, a: 0 * a,
) -> dict[str, Callable[..., Array]]:
    """Quantities of the arm; `added` are forces beside those of the bodies."""
    n = len(joints)

    def inverse(q: Array, v: Array, a: Array) -> Array:
        return inverse_dynamics(joints, q, v, a, -gravity) + added(q, v, a)

    def mass_matrix(q: Array, v: Array) -> Array:
        rest = inverse(q, np.zeros(n), np.zeros(n))
        return np.array([inverse(q, np.zeros(n), unit) - rest for unit in np.eye(n)]).T

    def bias(q: Array, v: Array) -> Array:
        return inverse(q, v, np.zeros(n))

    return {
        "mass_matrix": mass_matrix,
        "bias": bias,
        "inverse_dynamics": inverse,
        "forward_dynamics": lambda q, v, f: np.linalg.solve(mass_matrix(q, v), f - bias(q, v)),
    }


def with_inertia(joints: list[Link], change: Callable[[Link], Array]) -> list[Link]:
    """The joints with another inertia of each body."""
    return [replace(joint, inertia=change(joint)) for joint in joints]


def point_mass(joint: Link) -> Array:
    """m (c.c 1 - c c^T)."""
    c = joint.centre
    return joint.mass * (c @ c * np.eye(3) - np.outer(c, c))


def with_tool(joints: list[Link]) -> list[Link]:
    """The last body with 1 kg and 1 kg m^2 where a next joint would be."""
    *others, last = joints
    tool = np.array([0.3 + len(joints) / 10, 0, 0])
    mass = last.mass + 1
    centre = (last.mass * last.centre + tool) / mass
    inertia = last.inertia + np.eye(3)
    for part, own in ((last.mass, last.centre - centre), (1.0, tool - centre)):
        inertia = inertia + part * (own @ own * np.eye(3) - np.outer(own, own))
    return [*others, replace(last, mass=mass, centre=centre, inertia=inertia)]


def turned(quaternion: Array) -> Array:
    """R of a quaternion (w, x, y, z)."""
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * (w * cross + cross @ cross) / (quaternion @ quaternion)


def floating_answers(
    R_of: Callable[[Array], Array] = turned, local: bool = False
) -> dict[str, Callable[..., Array]]:
    """A free body by Newton and Euler; q = (x, quaternion), v = (velocity, omega in the body).

    `local`: the velocity has the components of the body's own frame.
    """
    mass, c, inertia = 2.5, CENTRE, INERTIA

    def inverse(q: Array, v: Array, a: Array) -> Array:
        R, w, growth = R_of(q[3:]), v[3:], a[3:]
        linear = R @ (a[:3] + np.cross(w, v[:3])) if local else a[:3]
        of_centre = linear + R @ (np.cross(growth, c) + np.cross(w, np.cross(w, c)))
        force = mass * (of_centre - GRAVITY)
        couple = inertia @ growth + np.cross(w, inertia @ w) + np.cross(c, R.T @ force)
        return np.concatenate([R.T @ force if local else force, couple])

    def mass_matrix(q: Array, v: Array) -> Array:
        rest = inverse(q, 0 * v, np.zeros(6))
        return np.array([inverse(q, 0 * v, unit) - rest for unit in np.eye(6)]).T

    return {"mass_matrix": mass_matrix, "inverse_dynamics": inverse}


def link_poses(joints: list[Link], q: Array) -> list[tuple[Array, Array]]:
    """Where the joints of a row are, and how their bodies are turned."""
    R, p, found = np.eye(3), np.zeros(3), []
    for joint, angle in zip(joints, q, strict=True):
        p = p + R @ joint.offset
        R = R @ joint.rotation @ turn(joint.axis, angle)
        found.append((p, R))
    return found


def jacobian(joints: list[Link], q: Array) -> Array:
    """6 x n of the last body: velocity of its joint over its angular velocity."""
    poses = link_poses(joints, q)
    axes = [R[:, joint.axis] for joint, (_, R) in zip(joints, poses, strict=True)]
    end = poses[-1][0]
    return np.array([[*np.cross(e, end - p), *e] for e, (p, _) in zip(axes, poses, strict=True)]).T


def momentum_matrix(joints: list[Link], q: Array, about: Array | None = None) -> Array:
    """6 x n: momentum over angular momentum about a point, by default the mass centre."""
    poses, n = link_poses(joints, q), len(joints)
    centres = [p + R @ joint.centre for joint, (p, R) in zip(joints, poses, strict=True)]
    if about is None:
        about = mass_centre(joints, q)
    found = np.zeros((6, n), dtype=q.dtype)
    for i, (joint, (_, R)) in enumerate(zip(joints, poses, strict=True)):
        for k in range(i + 1):
            axis = poses[k][1][:, joints[k].axis]
            momentum = joint.mass * np.cross(axis, centres[i] - poses[k][0])
            found[:3, k] += momentum
            found[3:, k] += R @ joint.inertia @ R.T @ axis
            found[3:, k] += np.cross(centres[i] - about, momentum)
    return found


def mass_centre(joints: list[Link], q: Array) -> Array:
    """Of all bodies."""
    poses = zip(joints, link_poses(joints, q), strict=True)
    whole = sum(joint.mass * (p + R @ joint.centre) for joint, (p, R) in poses)
    return whole / sum(joint.mass for joint in joints)


def momentum_matrix_rate(joints: list[Link], q: Array, v: Array, moving: bool = True) -> Array:
    """Its rate by a complex step; without the velocity of the mass centre where that is at rest."""
    step = q + 1e-30j * v
    about = None if moving else mass_centre(joints, q)
    return momentum_matrix(joints, step, about).imag / 1e-30
