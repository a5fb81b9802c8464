"""How the frames of a scene turn, as graphs, each step worked out once along the scene's tree.

    R(F <- G) = Rz(a_G - a_F)                    steps about one axis
    R(F <- G) = R(F <- parent) R(parent <- G)    any other
    omega_F = R^T omega_parent + o               components in F; o is what the step adds

Frames that the user oriented relative to the same frame stay independent of each other, so that a
chain in absolute angles has no product of many rotations.
"""

from dataclasses import dataclass, field
from itertools import pairwise

import casadi as ca
from sympy import Expr, Matrix, cos, sin
from sympy.physics.vector import ReferenceFrame

from mechanics.compiled.forms.bodies.affine import (
    PLANES,
    STILL,
    Graphs,
    Rotation,
    product,
    rotated,
    summed,
    transposed,
)
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.kinematics.textbook.chain import Chain, axis_angle
from mechanics.scene.geometry import frame_path, relative_rotation
from mechanics.scene.rates import rate, rates
from mechanics.symbolic import canonical

IDENTITY: Rotation = tuple(tuple(ca.SX(int(i == j)) for j in range(3)) for i in range(3))


@dataclass(frozen=True)
class Step:
    """One orientation as the user gave it.

    Attributes
    ----------
    rotation : Matrix
        v_parent = R v_child, in plain symbols.
    axis : int or None
        The coordinate axis that it turns about; None for any other rotation.
    angle : Expr or None
    own : Matrix
        What it adds to the angular velocity, in the child's components.
    """

    parent: ReferenceFrame
    rotation: Matrix
    axis: int | None
    angle: Expr | None
    own: Matrix


@dataclass(frozen=True)
class Turning:
    """Rotations and angular velocities of the frames of a scene; the tables only remember."""

    reading: Reading
    chain: Chain
    _steps: dict[ReferenceFrame, Step] = field(default_factory=dict)
    _rotations: dict[tuple[ReferenceFrame, ReferenceFrame], Rotation] = field(default_factory=dict)
    _angles: dict[tuple[ReferenceFrame, ReferenceFrame], ca.SX] = field(default_factory=dict)
    _omegas: dict[ReferenceFrame, Graphs] = field(default_factory=dict)
    _declared: dict[ReferenceFrame, Matrix | None] = field(default_factory=dict)

    def step(self, frame: ReferenceFrame) -> Step | None:
        """The step that leads to a frame; None for the inertial one."""
        scene = self.reading.scene
        if frame == scene.frame:
            return None
        if frame not in self._steps:
            for parent, child in pairwise(frame_path(scene.frame, frame)):
                if child not in self._steps:
                    self._steps[child] = self._made(parent, child)
        return self._steps[frame]

    def _made(self, parent: ReferenceFrame, child: ReferenceFrame) -> Step:
        scene, table = self.reading.scene, self.reading.rates
        rotation = relative_rotation(parent, child).applyfunc(
            lambda entry: scene.plain(entry, f"frame {child.name}")
        )
        simple = axis_angle(rotation)
        if simple is None:
            skew = rotation.T * Matrix(3, 3, list(rates(rotation, table)))
            own = Matrix([skew[2, 1], skew[0, 2], skew[1, 0]]).applyfunc(canonical)
            return Step(parent, rotation, None, None, own)
        axis, angle = simple
        return Step(parent, rotation, list(axis).index(1), angle, axis * rate(angle, table))

    def path(self, frame: ReferenceFrame) -> tuple[ReferenceFrame, ...]:
        """Frames from the inertial one to this one."""
        step = self.step(frame)
        return (frame,) if step is None else (*self.path(step.parent), frame)

    def rotation(self, to: ReferenceFrame, of: ReferenceFrame) -> Rotation:
        """R with v_to = R v_of."""
        if to == of:
            return IDENTITY
        if (to, of) not in self._rotations:
            self._rotations[to, of] = self._rotation(to, of)
        return self._rotations[to, of]

    def _rotation(self, to: ReferenceFrame, of: ReferenceFrame) -> Rotation:
        if (of, to) in self._rotations:
            return transposed(self._rotations[of, to])
        common, down, up = self._ways(to, of)
        axes = {self._steps[frame].axis for frame in (*down, *up)}
        axis = axes.pop()
        if not axes and axis is not None:
            return _about(axis, *self._circle(common, to, of))
        if not down and len(up) == 1:
            return self._single(up[0])
        if not down:
            inner = self._steps[of].parent
            return product(self.rotation(to, inner), self.rotation(inner, of))
        if not up:
            return transposed(self.rotation(of, to))
        return product(self.rotation(to, common), self.rotation(common, of))

    def _single(self, frame: ReferenceFrame) -> Rotation:
        rotation = self._steps[frame].rotation
        return tuple(self.reading.column(rotation[i, :]) for i in range(3))

    def _ways(
        self, to: ReferenceFrame, of: ReferenceFrame
    ) -> tuple[ReferenceFrame, list[ReferenceFrame], list[ReferenceFrame]]:
        """The last common frame, and the frames from it to either."""
        one, two = self.path(to), self.path(of)
        shared = sum(a == b for a, b in zip(one, two, strict=False))
        return one[shared - 1], list(one[shared:]), list(two[shared:])

    def _circle(
        self, common: ReferenceFrame, to: ReferenceFrame, of: ReferenceFrame
    ) -> tuple[ca.SX, ca.SX]:
        """Cosine and sine of a_of - a_to, the angles from the common frame.

        Of angles that are large the difference would be rounded, and with it its sine.
        """
        c, s = self._from(common, of)
        d, e = self._from(common, to)
        return c * d + s * e, s * d - c * e

    def _from(self, base: ReferenceFrame, frame: ReferenceFrame) -> tuple[ca.SX, ca.SX]:
        """Cosine and sine of the angle from one frame out to another."""
        if frame == base:
            return ca.SX(1), ca.SX(0)
        step = self._steps[frame]
        if step.parent == base:
            # By the translator, which knows sines of the angle already.
            return self.reading(cos(step.angle)), self.reading(sin(step.angle))
        angle = self._angle(base, frame)
        return ca.cos(angle), ca.sin(angle)

    def _angle(self, base: ReferenceFrame, frame: ReferenceFrame) -> ca.SX:
        """Sum of the angles of the steps from one frame out to another."""
        if (base, frame) not in self._angles:
            step = self._steps[frame]
            own = self.reading(step.angle)
            before = None if step.parent == base else self._angle(base, step.parent)
            self._angles[base, frame] = own if before is None else before + own
        return self._angles[base, frame]

    def omega(self, frame: ReferenceFrame) -> Graphs:
        """Angular velocity of a frame, in its own components."""
        if frame not in self._omegas:
            spin = self.declared(frame)
            if frame == self.reading.scene.frame:
                self._omegas[frame] = STILL
            elif spin is not None:
                self._omegas[frame] = self.reading.column(spin)
            else:
                self._omegas[frame] = summed(self.carried(frame), self.own(frame))
        return self._omegas[frame]

    def declared(self, frame: ReferenceFrame) -> Matrix | None:
        """Angular velocity in the frame where the speeds were declared to be its components.

        Euler's equations are regular where the rates of Euler's angles are not.
        """
        scene = self.reading.scene
        if not scene.speeds or self.step(frame) is None:
            return None
        if frame not in self._declared:
            omega = self.chain.frame(frame).omega.applyfunc(canonical)
            slopes = omega.jacobian(list(scene.u))
            constant = all(entry.is_number for entry in slopes) and not omega.has(*scene.q)
            self._declared[frame] = omega if constant else None
        return self._declared[frame]

    def carried(self, frame: ReferenceFrame) -> Graphs:
        """Angular velocity of the frame that it is oriented by, in its own components."""
        parent = self._steps[frame].parent
        return rotated(self.rotation(frame, parent), self.omega(parent))

    def own(self, frame: ReferenceFrame) -> Graphs:
        """What its step adds."""
        return self.reading.column(self._steps[frame].own)


def _about(axis: int, c: ca.SX, s: ca.SX) -> Rotation:
    """The rotation about a coordinate axis."""
    i, j = PLANES[axis]
    rows = [list(row) for row in IDENTITY]
    rows[i][i], rows[j][j], rows[i][j], rows[j][i] = c, c, -s, s
    return tuple(map(tuple, rows))
