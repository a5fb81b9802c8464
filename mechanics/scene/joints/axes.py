"""The axis of a joint: any constant vector of one frame.

    R = (e1, e2, n)        n along the axis, v_F = R v_A

Where the axis is one of F's own, A is F. Else a joint turns by R, about A.z, and back by R^T: each
step is fixed or a turn about a coordinate axis, as the recursions want it.
"""

from dataclasses import dataclass
from typing import Any

from sympy import Expr, Matrix, eye, sqrt
from sympy.core.function import AppliedUndef
from sympy.physics.vector import ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene.declared import decimals, kind_of
from mechanics.symbolic import canonical

Named = tuple[tuple[str, Vector], ...]
"""Directions with what the names of their reactions end in."""


@dataclass(frozen=True)
class Axis:
    """A direction that is fixed in a frame.

    Attributes
    ----------
    frame : ReferenceFrame
        F, in which it was given.
    unit : Vector
    across : two pairs (name, Vector)
        Unit vectors that complete it: with the letters of F's other axes, or ``"1"`` and ``"2"``.
    matrix : Matrix or None
        R; None where A is F.
    """

    frame: ReferenceFrame
    unit: Vector
    across: tuple[tuple[str, Vector], tuple[str, Vector]]
    matrix: Matrix | None

    def turned(self, name: str, angle: Expr) -> ReferenceFrame:
        """A frame that has turned about the axis."""
        if self.matrix is None:
            return self.frame.orientnew(name, "Axis", (angle, self.unit))
        ((_, inner),) = self.unit.args
        middle = inner.orientnew(f"{name}_turned", "Axis", (angle, inner.z))
        frame = ReferenceFrame(name)
        frame.orient_explicit(middle, self.matrix.T)
        return frame


def read_axis(what: str, vector: Any) -> Axis:
    """An axis, checked.

    Parameters
    ----------
    what : str
        For messages: ``"joint elbow: the axis"``.
    vector : Vector
        Of any length but zero.

    Raises
    ------
    SceneError
        When it is no vector, has no length, stands in several frames, or is not constant.
    """
    if not isinstance(vector, Vector):
        raise SceneError(f"{what} is {kind_of(vector)}: give a vector, such as frame.z")
    column, frame = constant_column(what, vector)
    square = canonical(column.dot(column))
    if square == 0:
        raise SceneError(f"{what} has no length: give a vector, such as {frame.name}.z")
    n = column if square == 1 else column / sqrt(square)
    axes = along_axes(frame)
    for k in range(3):
        if n[(k + 1) % 3] == n[(k + 2) % 3] == 0:
            if not n[k].is_positive and not n[k].is_negative:
                raise SceneError(
                    f"{what} = {vector} has a sign that is not known: leave the length out, as in"
                    f" axis={axes[k][1]}"
                )
            unit = axes[k][1] if n[k].is_positive else -axes[k][1]
            first, second = (axis for i, axis in enumerate(axes) if i != k)
            return Axis(frame, unit, (first, second), None)
    e1 = _perpendicular(n)
    matrix = Matrix.hstack(e1, n.cross(e1), n)
    inner = ReferenceFrame(f"{frame.name}_axis")
    inner.orient_explicit(frame, matrix)
    return Axis(frame, inner.z, (("1", inner.x), ("2", inner.y)), matrix)


def along_axes(frame: ReferenceFrame) -> Named:
    """The axes of a frame with their letters."""
    return tuple(zip("xyz", (frame.x, frame.y, frame.z), strict=True))


def constant_column(what: str, vector: Vector) -> tuple[Matrix, ReferenceFrame]:
    """3 x 1 components of a vector that is fixed in one frame, and that frame."""
    if not vector.args:
        raise SceneError(f"{what} has no length: give a vector, such as frame.z")
    if len(vector.args) > 1:
        frames = ", ".join(frame.name for _, frame in vector.args)
        raise SceneError(
            f"{what} stands in several frames ({frames}): write it in the frame of the parent"
        )
    ((column, frame),) = vector.args
    if column.atoms(AppliedUndef) or column.has(dynamicsymbols._t):
        raise SceneError(
            f"{what} = {vector} moves in {frame.name}: give a vector of a frame in which it is"
            " fixed"
        )
    return Matrix(column).applyfunc(decimals), frame


def _perpendicular(n: Matrix) -> Matrix:
    # An axis that it does not have is normal to it; where it has all three, none is parallel.
    for k in range(3):
        if n[k] == 0:
            return eye(3)[:, k]
    across = n.cross(eye(3)[:, 2])
    return across / sqrt(canonical(across.dot(across)))
