"""Velocities composed along frames and points by the transport theorem.

    omega_child = R^T omega_parent + omega_step                            (in the child's frame)
    v = v_parent + R_F (c' + omega_F x c)
    a = a_parent + R_F (c'' + 2 omega_F x c' + alpha_F x c + omega_F x (omega_F x c))

where c are the components of one step between points, in the frame F in which the user gave it.
Nothing is expressed in the inertial frame before it has to be, so that a step along a link keeps
one term. The other way is `mechanics.kinematics.textbook.differentiate`.
"""

from dataclasses import dataclass, field
from itertools import pairwise

from sympy import Expr, Matrix, cos, eye, sin, zeros
from sympy.physics.vector import Point, ReferenceFrame

from mechanics.scene import Scene
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.rates import rate, rate_table, rates
from mechanics.symbolic import canonical

# A vector kept in the frames in which it is short: components by frame, to be added.
Mixed = dict[ReferenceFrame, Matrix]


@dataclass(frozen=True)
class FrameMotion:
    """Rotation to the inertial frame, and the angular velocity and acceleration in the frame."""

    rotation: Matrix
    omega: Matrix
    alpha: Matrix


@dataclass(frozen=True)
class MixedMotion:
    """Position, velocity and acceleration of a point as mixed vectors."""

    position: Mixed
    velocity: Mixed
    acceleration: Mixed


@dataclass(frozen=True)
class Chain:
    """Motions composed along the scene's frames and points, each step once.

    The two tables only remember what was composed already.
    """

    scene: Scene
    _frames: dict[ReferenceFrame, FrameMotion] = field(default_factory=dict)
    _points: dict[Point, MixedMotion] = field(default_factory=dict)

    def frame(self, frame: ReferenceFrame) -> FrameMotion:
        """Motion of a frame."""
        root = self.scene.frame
        path = frame_path(root, frame)
        known = self._frames
        known.setdefault(root, FrameMotion(eye(3), zeros(3, 1), zeros(3, 1)))
        for parent, child in pairwise(path):
            if child not in known:
                known[child] = self._turned(parent, child)
        return known[frame]

    def _turned(self, parent: ReferenceFrame, child: ReferenceFrame) -> FrameMotion:
        table = rate_table(self.scene)
        outer = self._frames[parent]
        step = relative_rotation(parent, child).applyfunc(
            lambda entry: self.scene.plain(entry, f"frame {child.name}")
        )
        simple = axis_angle(step)
        if simple is not None:
            axis, angle = simple
            own = axis * rate(angle, table)
        else:
            # In the child's frame the step turns with R^T R'.
            skew = step.T * Matrix(3, 3, list(rates(step, table)))
            own = Matrix([skew[2, 1], skew[0, 2], skew[1, 0]]).applyfunc(canonical)
        carried = outer.omega if _unturned(step, outer.omega) else step.T * outer.omega
        omega = carried + own
        # The derivative of omega in a frame that turns with omega is the angular acceleration.
        return FrameMotion(outer.rotation * step, omega, rates(omega, table))

    def point(self, point: Point) -> MixedMotion:
        """Motion of a geometric point, in mixed components."""
        path = point_path(self.scene.origin, point)
        known = self._points
        known.setdefault(self.scene.origin, MixedMotion({}, {}, {}))
        for parent, child in pairwise(path):
            if child not in known:
                known[child] = self._stepped(parent, child)
        return known[point]

    def _stepped(self, parent: Point, child: Point) -> MixedMotion:
        table = rate_table(self.scene)
        before = self._points[parent]
        position, velocity, acceleration = (
            dict(before.position),
            dict(before.velocity),
            dict(before.acceleration),
        )
        for frame, column in components(step_vector(parent, child)):
            turn = self.frame(frame)
            c = column.applyfunc(lambda entry: self.scene.plain(entry, f"point {child.name}"))
            c1 = rates(c, table)
            across = turn.omega.cross(c)
            v = c1 + across
            a = (
                rates(c1, table)
                + 2 * turn.omega.cross(c1)
                + turn.alpha.cross(c)
                + turn.omega.cross(across)
            )
            position[frame] = position.get(frame, zeros(3, 1)) + c
            velocity[frame] = velocity.get(frame, zeros(3, 1)) + v
            acceleration[frame] = acceleration.get(frame, zeros(3, 1)) + a
        return MixedMotion(position, velocity, acceleration)

    def inertial(self, mixed: Mixed) -> Matrix:
        """3 x 1 inertial components of a mixed vector."""
        total = zeros(3, 1)
        for frame, column in mixed.items():
            total += self.frame(frame).rotation * column
        return total


def axis_angle(step: Matrix) -> tuple[Matrix, Expr] | None:
    """(axis, angle) of a rotation about a constant coordinate axis; None for any other.

    The angular velocity of such a rotation is the rate of the angle along the axis.
    """
    for k in range(3):
        axis = Matrix([int(i == k) for i in range(3)])
        i, j = (k + 1) % 3, (k + 2) % 3
        if step[k, k] != 1 or (step[j, i].func not in (sin, cos) and not step[j, i].is_Mul):
            continue
        for angle in sorted({f.args[0] for f in step.atoms(sin, cos)}, key=str):
            for signed in (angle, -angle):
                c, s = cos(signed), sin(signed)
                turn = eye(3)
                turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, -s, s
                if turn == step:
                    return axis, signed
    return None


def _unturned(step: Matrix, vector: Matrix) -> bool:
    """Whether a vector along one axis keeps its components, because the step turns about it."""
    axes = [i for i in range(3) if vector[i] != 0]
    return all(step[i, j] == int(i == j) for j in axes for i in range(3))
