"""From the coordinates and speeds of a scene to those of an engine, and back.

v_engine = B(q) v          v_engine' = B v' + B' v          forces = B^T forces_engine
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from mechanics.compare.change import Array
from mechanics.compare.tree import Link

LINEAR = {"free": 3, "planar": 2}
"""How many of the speeds of a joint are those of a point, before those of the turn."""


@dataclass(frozen=True, eq=False)
class Order:
    """From the coordinates and speeds of a scene to those of an engine, and back.

    Attributes
    ----------
    q, v : mapping of str to int
        By name of the joint: where its first coordinate and its first speed stand in the engine.
    sizes : (int, int)
        How many coordinates and speeds the engine has.
    scalar_first : bool
        Of quaternions: (w, x, y, z); otherwise (x, y, z, w).
    local : bool
        Whether the velocity of a free or planar link has the components of its own frame.
    circles : frozenset of str
        Joints with a coordinate more than the scene has: an angle, which is the last one, is given
        by its cosine and sine.
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
            if link.kind in ("free", "ball"):
                if not self.scalar_first:
                    own = np.concatenate([own[:-4], own[-3:], own[-4:-3]])
            elif link.kind in ("pin", "planar") and link.joint in self.circles:
                own = np.array([*own[:-1], np.cos(own[-1]), np.sin(own[-1])])
            found[self.q[link.joint] : self.q[link.joint] + len(own)] = own
        return found

    def matrix(self, q: Array) -> Array:
        """B with v_engine = B v."""
        found = np.zeros((self.sizes[1], sum(len(link.v) for link in self._moving)))
        for link in self._moving:
            place = self.v[link.joint]
            for k, speed in enumerate(link.v):
                found[place + k, speed] = 1.0
            if link.kind in LINEAR and self.local:
                linear, turn = link.v[: LINEAR[link.kind]], _turn(link, q)
                found[place : place + len(linear), list(linear)] = turn.T
        return found

    def drift(self, q: Array, v: Array) -> Array:
        """B' v: that of R^T v is -omega x R^T v."""
        found = np.zeros(self.sizes[1])
        for link in self._moving:
            if link.kind in LINEAR and self.local:
                place, count = self.v[link.joint], LINEAR[link.kind]
                seen, omega = np.zeros(3), np.zeros(3)
                seen[:count] = _turn(link, q).T @ v[list(link.v[:count])]
                omega[count - 3 :] = v[list(link.v[count:])]
                found[place : place + count] = -np.cross(omega, seen)[:count]
        return found


def _turn(link: Link, q: Array) -> Array:
    """From the components of velocity in the link's frame to those in which the scene has it."""
    if link.kind == "free":
        return rotation(q[list(link.q[3:])])
    cos, sin = np.cos(q[link.q[2]]), np.sin(q[link.q[2]])
    return np.array([[cos, -sin], [sin, cos]])


def rotation(quaternion: Array) -> Array:
    """The matrix of a quaternion, its scalar part first."""
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * (w * cross + cross @ cross) / (quaternion @ quaternion)
