"""Recursive Newton-Euler in plain NumPy, as textbooks print it, and the magnitudes of its terms.

Luh, Walker and Paul 1980, in the frames of the links, for a tree of turning and sliding joints.
The magnitudes are the same recursion with |x| for x and + for -: sums of the sizes of all terms.
"""

from dataclasses import dataclass

import numpy as np

Array = np.ndarray


@dataclass(frozen=True)
class Link:
    """One body and its joint; matrices and vectors in its own frame, the offset in its parent's."""

    parent: int
    axis: int
    turning: bool
    rotation: Array
    offset: Array
    mass: float
    centre: Array
    inertia: Array


def turn(axis: int, angle: complex) -> Array:
    """Rotation matrix about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = np.eye(3, dtype=np.result_type(angle, float))
    result[i, i] = result[j, j] = np.cos(angle)
    result[j, i] = np.sin(angle)
    result[i, j] = -result[j, i]
    return result


def cross(a: Array, b: Array) -> Array:
    return np.cross(a, b)


def crossed(a: Array, b: Array) -> Array:
    """The cross product with + for -."""
    (x, y, z), (u, v, w) = a, b
    return np.array([y * w + z * v, z * u + x * w, x * v + y * u])


def inverse_dynamics(
    links: list[Link], q: Array, qd: Array, qdd: Array, g: complex | Array, sizes: bool = False
) -> Array:
    """Generalized forces, or the sums of the magnitudes of their terms.

    Gravity is an acceleration of the ground: g along z, or a vector.
    """
    found = loads(links, q, qd, qdd, g, sizes)
    return np.array(
        [
            (couple if link.turning else force)[link.axis]
            for link, (force, couple) in zip(links, found, strict=True)
        ]
    )


def loads(
    links: list[Link], q: Array, qd: Array, qdd: Array, g: complex | Array, sizes: bool = False
) -> list[tuple[Array, Array]]:
    """Force and couple of each joint on its link, about the joint, in the link's frame."""
    x = crossed if sizes else cross
    size = np.abs if sizes else np.asarray
    none, ground = np.zeros(3), g * np.eye(3)[2] if np.ndim(g) == 0 else g
    qd, qdd = size(qd), size(qdd)
    rotations, arms, omegas, alphas, accelerations, forces, couples = [], [], [], [], [], [], []
    for i, link in enumerate(links):
        e = np.eye(3)[link.axis]
        R = link.rotation @ (turn(link.axis, q[i]) if link.turning else np.eye(3))
        r = link.offset + (0 if link.turning else link.rotation @ e * q[i])
        R, r = size(R), size(r)
        w, al, a = none, none, ground
        if link.parent >= 0:
            w, al, a = (v[link.parent] for v in (omegas, alphas, accelerations))
        a = R.T @ (a + x(al, r) + x(w, x(w, r)))
        w, al = R.T @ w, R.T @ al
        if link.turning:
            al = al + e * qdd[i] + x(w, e * qd[i])
            w = w + e * qd[i]
        else:
            a = a + 2 * x(w, e * qd[i]) + e * qdd[i]
        c, I = size(link.centre), size(link.inertia)
        force = link.mass * (a + x(al, c) + x(w, x(w, c)))
        couple = I @ al + x(w, I @ w) + x(c, force)
        for table, value in zip(
            (rotations, arms, omegas, alphas, accelerations, forces, couples),
            (R, r, w, al, a, force, couple),
            strict=True,
        ):
            table.append(value)
    for i in reversed(range(len(links))):
        link = links[i]
        if link.parent >= 0:
            inner = rotations[i] @ forces[i]
            forces[link.parent] = forces[link.parent] + inner
            couples[link.parent] = (
                couples[link.parent] + rotations[i] @ couples[i] + x(arms[i], inner)
            )
    return list(zip(forces, couples, strict=True))


def heights(links: list[Link], q: Array) -> Array:
    """Of the mass centres above the origin, against gravity."""
    frames, points, found = [], [], []
    for i, link in enumerate(links):
        R, r = (np.eye(3), np.zeros(3))
        if link.parent >= 0:
            R, r = frames[link.parent], points[link.parent]
        e = np.eye(3)[link.axis]
        r = r + R @ (link.offset + (0 if link.turning else link.rotation @ e * q[i]))
        R = R @ link.rotation @ (turn(link.axis, q[i]) if link.turning else np.eye(3))
        frames.append(R)
        points.append(r)
        found.append((r + R @ link.centre)[2])
    return np.array(found)
