"""From the coordinates and speeds of a scene to those of an engine, and back.

v_engine = B(q) v          v_engine' = B v' + B' v          forces = B^T forces_engine
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from mechanics.compare.ours import Array
from mechanics.compare.tree import Link


@dataclass(frozen=True, eq=False)
class Order:
    """From the coordinates and speeds of a scene to those of an engine, and back.

    Attributes
    ----------
    tree : tuple of Link
    q, v : mapping of str to int
        By name of the joint: where its first coordinate and its first speed stand in the engine.
    sizes : (int, int)
        How many coordinates and speeds the engine has.
    scalar_first : bool
        Of quaternions: (w, x, y, z); otherwise (x, y, z, w).
    local : bool
        Whether the velocity of a free link has the components of its own frame.
    circles : frozenset of str
        Joints whose angle is given by its cosine and sine.
    """

    tree: tuple[Link, ...]
    q: Mapping[str, int]
    v: Mapping[str, int]
    sizes: tuple[int, int]
    scalar_first: bool = True
    local: bool = False
    circles: frozenset[str] = frozenset()

    @property
    def _moving(self) -> list[Link]:
        return [link for link in self.tree if link.v]

    def position(self, q: Array) -> Array:
        """The engine's coordinates."""
        found = np.zeros(self.sizes[0])
        for link in self._moving:
            own = q[list(link.q)]
            if link.kind in ("free", "ball") and not self.scalar_first:
                own = np.concatenate([own[:-4], own[-3:], own[-4:-3]])
            if link.joint in self.circles:
                own = np.array([np.cos(own[0]), np.sin(own[0])])
            found[self.q[link.joint] : self.q[link.joint] + len(own)] = own
        return found

    def matrix(self, q: Array) -> Array:
        """B with v_engine = B v."""
        found = np.zeros((self.sizes[1], sum(len(link.v) for link in self._moving)))
        for link in self._moving:
            place = self.v[link.joint]
            for k, speed in enumerate(link.v):
                found[place + k, speed] = 1.0
            if link.kind == "free" and self.local:
                found[place : place + 3, list(link.v[:3])] = rotation(q[list(link.q[3:])]).T
        return found

    def drift(self, q: Array, v: Array) -> Array:
        """B' v: that of R^T v is -omega x R^T v."""
        found = np.zeros(self.sizes[1])
        for link in self._moving:
            if link.kind == "free" and self.local:
                place = self.v[link.joint]
                seen = rotation(q[list(link.q[3:])]).T @ v[list(link.v[:3])]
                found[place : place + 3] = -np.cross(v[list(link.v[3:])], seen)
        return found


def rotation(quaternion: Array) -> Array:
    """The matrix of a quaternion, its scalar part first."""
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * (w * cross + cross @ cross) / (quaternion @ quaternion)
