"""Robots by Pinocchio, an engine of others: in our order of coordinates and our kinds of speeds."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

Array = np.ndarray


@dataclass(frozen=True)
class Peer:
    """A model of Pinocchio beside a model of ours.

    A base that floats has position, quaternion (scalar first) and angular velocity in its own
    frame; its velocity is that in the inertial frame, where Pinocchio has the base's own.
    """

    pin: Any
    model: Any
    data: Any
    names: tuple[str, ...]
    free: bool

    def state(self, q: Array, u: Array, ud: Array) -> tuple[Array, Array, Array]:
        """In Pinocchio's coordinates and speeds; v' of the base is that of its components."""
        own, v, a = self.pin.neutral(self.model), np.zeros(self.model.nv), np.zeros(self.model.nv)
        joints = len(self.names)
        angles, rates, accelerations = q[:joints], u[:joints], ud[:joints]
        if self.free:
            # Ours: x y z, joints, quaternion | rates of x y z, of joints, angular velocity.
            e = q[-4:]
            place, angles = q[:3], q[3:-4]
            own[:7] = [*place, *e[1:], e[0]]
            R, w = rotation(e), u[-3:]
            v[:6] = [*(R.T @ u[:3]), *w]
            a[:6] = [*(R.T @ ud[:3] - np.cross(w, R.T @ u[:3])), *ud[-3:]]
            rates, accelerations = u[3:-3], ud[3:-3]
        for k, name in enumerate(self.names):
            joint = self.model.joints[self.model.getJointId(name)]
            if joint.nq == 2:
                own[joint.idx_q : joint.idx_q + 2] = np.cos(angles[k]), np.sin(angles[k])
            else:
                own[joint.idx_q] = angles[k]
            v[joint.idx_v], a[joint.idx_v] = rates[k], accelerations[k]
        return own, v, a

    def ours(self, rows: Array, q: Array) -> Array:
        """Rows along Pinocchio's speeds, along ours."""
        own = [rows[self.model.joints[self.model.getJointId(name)].idx_v] for name in self.names]
        if not self.free:
            return np.array(own)
        R = rotation(q[-4:])
        return np.concatenate([R @ rows[:3], own, rows[3:6]])

    def inverse_dynamics(self, q: Array, u: Array, ud: Array) -> Array:
        """Generalized forces, without damping."""
        return self.ours(self.pin.rnea(self.model, self.data, *self.state(q, u, ud)), q)

    def jacobian(self, link: str, q: Array) -> Array:
        """6 x n of the origin of a link: velocities, then angular velocities, inertial."""
        own, _, _ = self.state(q, *np.zeros((2, q.size)))
        frame = self.model.getFrameId(link)
        found = self.pin.computeFrameJacobian(
            self.model, self.data, own, frame, self.pin.LOCAL_WORLD_ALIGNED
        )
        return np.array([self.ours(row, q) for row in found])


def rotation(e: Array) -> Array:
    """Of a unit quaternion, scalar first."""
    w, v = e[0], np.array(e[1:])
    skew = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + 2 * (w * skew + skew @ skew)


def peer(path: Path, names: tuple[str, ...], free: bool = False) -> Peer:
    """The same file, read by Pinocchio; the test is skipped where there is none."""
    pin = pytest.importorskip("pinocchio")
    root = [pin.JointModelFreeFlyer()] if free else []
    model = pin.buildModelFromUrdf(str(path), *root)
    return Peer(pin, model, model.createData(), names, free)
