"""Poses of frames and points in the inertial frame, and the common form of both kinematics.

R_child = R_parent R_step            r_child = r_parent + sum R_F c_F
"""

from dataclasses import dataclass

from mechanics.mechanism import GROUND, Mechanism, Mixed
from mechanics.program.vectors import Matrix, Vector, add, product, times, transpose, zeros


@dataclass(frozen=True)
class Poses:
    """Orientation of each frame and position of each point, inertial components, in m."""

    rotations: tuple[Matrix, ...]
    positions: tuple[Vector, ...]

    def vector(self, mixed: Mixed) -> Vector:
        """Inertial components of a vector that is given in several frames."""
        zero = zeros(self.rotations[0][0][0].builder)
        return add(zero, *(times(self.rotations[frame], column) for frame, column in mixed))


def poses(mechanism: Mechanism) -> Poses:
    """Poses of all frames and points, each step composed once."""
    build = mechanism.builder
    rotations: list[Matrix] = []
    for frame in mechanism.frames:
        if frame.parent == GROUND:
            rotations.append(frame.rotation)
        else:
            rotations.append(product(rotations[frame.parent], frame.rotation))
    positions: list[Vector] = []
    for place in mechanism.points:
        origin = zeros(build) if place.parent == GROUND else positions[place.parent]
        steps = [times(rotations[frame], column) for frame, column in place.step]
        positions.append(add(origin, *steps))
    return Poses(tuple(rotations), tuple(positions))


@dataclass(frozen=True)
class PointMotion:
    """Position, velocity and acceleration of a point; inertial components, SI units."""

    position: Vector
    velocity: Vector
    acceleration: Vector


@dataclass(frozen=True)
class FrameMotion:
    """Orientation, angular velocity and acceleration of a frame; inertial components."""

    rotation: Matrix
    omega: Vector
    alpha: Vector


@dataclass(frozen=True)
class Motions:
    """Motion of every frame and point of a mechanism."""

    poses: Poses
    frames: tuple[FrameMotion, ...]
    points: tuple[PointMotion, ...]


@dataclass(frozen=True)
class BodyMotion:
    """Motion of a body: that of its mass centre and frame, and its inertia in inertial components.

    `turning` and `inertia` are None for a particle, and for a body that does not turn and
    that no couple holds.
    """

    centre: PointMotion
    turning: FrameMotion | None
    inertia: Matrix | None


def body_motions(mechanism: Mechanism, motions: Motions) -> tuple[BodyMotion, ...]:
    """Motion of every body, in the order of the mechanism."""
    found, (filter_, _) = [], mechanism.filters
    for index, body in enumerate(mechanism.bodies):
        centre = motions.points[body.centre]
        if body.frame is None or body.inertia is None:
            found.append(BodyMotion(centre, None, None))
            continue
        turning = motions.frames[body.frame]
        # One that is held by couples has moment equations, which determine these.
        held = any(mechanism.reactions[r].at is None for r in mechanism.joints[index])
        if not held and all(map(filter_.is_zero, turning.omega)):
            found.append(BodyMotion(centre, None, None))
            continue
        found.append(BodyMotion(centre, turning, turned(turning.rotation, body.inertia)))
    return tuple(found)


def turned(rotation: Matrix, inertia: Matrix) -> Matrix:
    """R I R^T; a multiple of the unit matrix stays what it is."""
    scalar = inertia[0][0]
    if all(
        entry == scalar if i == j else entry.is_zero
        for i, row in enumerate(inertia)
        for j, entry in enumerate(row)
    ):
        return inertia
    return product(product(rotation, inertia), transpose(rotation))
