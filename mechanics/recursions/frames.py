"""Vectors in the frames of a mechanism, taken from one to another along the tree of frames.

v_parent = R v_frame        one frame at a time, so that zeros of R and v spare work        (1)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from mechanics.mechanism import GROUND, Frame, Mechanism, Mixed
from mechanics.program.builder import Node
from mechanics.program.derivatives import tangent
from mechanics.program.vectors import Matrix, Vector, add, dot, scale, times, transpose, zeros


def lineage(mechanism: Mechanism, frame: int) -> tuple[int, ...]:
    """A frame and those it stands on, up to the inertial frame."""
    found = []
    while frame != GROUND:
        found.append(frame)
        frame = mechanism.frames[frame].parent
    return tuple(found)


def common(mechanism: Mechanism, frames: Iterable[int]) -> int:
    """The last frame that all of them stand on."""
    first, *others = [lineage(mechanism, frame) for frame in frames]
    return next(frame for frame in first if all(frame in other for other in others))


def express(mechanism: Mechanism, vector: Vector, source: int, target: int) -> Vector:
    """Components in another frame, equation (1)."""
    if source == target or all(entry.is_zero for entry in vector):
        return vector
    meet = common(mechanism, (source, target))
    while source != meet:
        frame = mechanism.frames[source]
        vector, source = times(frame.rotation, vector), frame.parent
    down = lineage(mechanism, target)
    for index in reversed(down[: down.index(meet)]):
        vector = times(transpose(mechanism.frames[index].rotation), vector)
    return vector


def collect(mechanism: Mechanism, mixed: Mixed, target: int) -> Vector:
    """A vector that is given in several frames, in one."""
    parts = [express(mechanism, column, frame, target) for frame, column in mixed]
    return add(zeros(mechanism.builder), *parts)


def relative_velocity(frame: Frame, rates: Mapping[Node, Node]) -> tuple[Vector, Vector]:
    """Angular velocity relative to the parent and its rate, in the frame itself, 1/s and 1/s^2."""
    if frame.turn is not None:
        (rate,) = tangent([frame.turn.angle], rates)
        (gain,) = tangent([rate], rates)
        return scale(rate, frame.turn.axis), scale(gain, frame.turn.axis)
    flat = tangent([entry for row in frame.rotation for entry in row], rates)
    # [omega]x = R^T dR/dt.
    columns = transpose(frame.rotation)
    turning = transpose([flat[3 * k : 3 * k + 3] for k in range(3)])
    omega = (
        dot(columns[2], turning[1]),
        dot(columns[0], turning[2]),
        dot(columns[1], turning[0]),
    )
    return omega, tuple(tangent(omega, rates))


def acceleration_matrix(omega: Vector, alpha: Vector) -> Matrix:
    """U with U c = alpha x c + omega x (omega x c), as a matrix.

    Its products of components of omega serve every vector that is fixed in the frame.
    """
    x, y, z = omega
    xx, yy, zz, xy, xz, yz = x * x, y * y, z * z, x * y, x * z, y * z
    return (
        (-(yy + zz), xy - alpha[2], xz + alpha[1]),
        (xy + alpha[2], -(xx + zz), yz - alpha[0]),
        (xz - alpha[1], yz + alpha[0], -(xx + yy)),
    )


def negated(vector: Sequence[Node]) -> Vector:
    """-vector."""
    return tuple(-entry for entry in vector)
