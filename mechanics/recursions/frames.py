"""Vectors in the frames of a mechanism, taken from one to another along the tree of frames.

v_parent = R v_frame        one frame at a time, so that zeros of R and v spare work        (1)
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from mechanics.mechanism import GROUND, Frame, Mechanism, Mixed, inputs_of
from mechanics.program.builder import Node
from mechanics.program.vectors import Matrix, Vector, add, times, transpose, zeros


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


def rigid_steps(mechanism: Mechanism) -> Mechanism:
    """The same mechanism, fixed steps in one frame where they can be.

    People give a step in the frames at hand: along a link, and along the axis of the next joint.
    What is fixed in a frame that is fixed in another is fixed there as well (1); so is what lies on
    the axis about which the one turns in the other (2), which is used to join two parts of a step.
    """
    moving = set(mechanism.rates)

    def fixed(nodes: Sequence[Node]) -> bool:
        return not inputs_of(nodes) & moving

    def inwards(frame: int, column: Vector) -> tuple[int, Vector]:
        while frame != 0 and fixed(column):
            own = mechanism.frames[frame]
            if not fixed([entry for row in own.rotation for entry in row]):
                break
            column, frame = times(own.rotation, column), own.parent
        return frame, column

    def place(step: Mixed) -> Mixed:
        parts: dict[int, Vector] = {}
        for frame, column in (inwards(*part) for part in step):
            parts[frame] = add(parts[frame], column) if frame in parts else column
        for inner in sorted(parts, reverse=True):
            if inner == 0 or inner not in parts:
                continue
            own = mechanism.frames[inner]
            outer, column = inwards(own.parent, parts[inner])
            if outer not in parts or not fixed(parts[inner]):
                continue
            back = express(mechanism, parts[outer], outer, own.parent)
            if _on_axis(own, parts[inner]):
                parts[outer] = add(parts[outer], column)
                del parts[inner]
            elif fixed(back) and _on_axis(own, back):
                parts[inner] = add(parts[inner], back)
                del parts[outer]
        return tuple(sorted(parts.items()))

    points = tuple(replace(point, step=place(point.step)) for point in mechanism.points)
    return replace(mechanism, points=points)


def _on_axis(frame: Frame, column: Vector) -> bool:
    if frame.turn is None:
        return False
    pairs = zip(frame.turn.axis, column, strict=True)
    return all(entry.is_zero for along, entry in pairs if along.is_zero)
