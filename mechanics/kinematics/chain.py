"""Velocities composed along frames and points by the transport theorem.

    omega_child = omega_parent + R e angle'
    alpha_child = alpha_parent + omega_parent x R e angle' + R e angle''
    v = v_parent + R c' + omega x R c
    a = a_parent + R c'' + 2 omega x R c' + alpha x R c + omega x (omega x R c)

where c are the components of one step in the frame in which it is given, and e the axis of a turn;
for a quaternion e angle' is the speeds, for any other rotation what [omega]x = R^T dR/dt says.
The other way is `differentiate`.
"""

import operator
from collections.abc import Mapping, Sequence

from mechanics.kinematics.motion import FrameMotion, Motions, PointMotion, poses
from mechanics.mechanism import GROUND, Frame, Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.vectors import Vector, add, cross, dot, scale, times, transpose, zeros


def motions(mechanism: Mechanism, rates: Mapping[Node, Node] | None = None) -> Motions:
    """Motion of all frames and points.

    Parameters
    ----------
    rates : mapping of Node to Node, optional
        Rate of each node that changes; by default those of q, u and what is given.
    """
    build, table = mechanism.builder, mechanism.rates if rates is None else rates
    where = poses(mechanism)
    frames: list[FrameMotion] = []
    for frame, rotation in zip(mechanism.frames, where.rotations, strict=True):
        if frame.parent == GROUND:
            frames.append(FrameMotion(rotation, zeros(build), zeros(build)))
            continue
        outer = frames[frame.parent]
        own, gain = (times(rotation, v) for v in relative_velocity(frame, table))
        if all(entry.is_zero for entry in (*own, *gain)):
            frames.append(FrameMotion(rotation, outer.omega, outer.alpha))
            continue
        frames.append(
            FrameMotion(
                rotation,
                add(outer.omega, own),
                add(outer.alpha, cross(outer.omega, own), gain),
            )
        )
    points: list[PointMotion] = []
    for place, position in zip(mechanism.points, where.positions, strict=True):
        if place.parent == GROUND:
            points.append(PointMotion(position, zeros(build), zeros(build)))
            continue
        outer_point = points[place.parent]
        velocity, acceleration = outer_point.velocity, outer_point.acceleration
        for index, column in place.step:
            v, a = _step(frames[index], column, table)
            velocity, acceleration = add(velocity, v), add(acceleration, a)
        points.append(PointMotion(position, velocity, acceleration))
    return Motions(where, tuple(frames), tuple(points))


def own_rates(mechanism: Mechanism, rates: Mapping[Node, Node]) -> list[Vector]:
    """Angular velocity of each frame in its own components: R^T omega_parent + what it turns by."""
    found: list[Vector] = []
    for frame in mechanism.frames:
        turning, _ = relative_velocity(frame, rates)
        if frame.parent != GROUND:
            outer = found[frame.parent]
            turning = add(times(transpose(frame.rotation), outer), turning)
        found.append(turning)
    return found


def relative_velocity(frame: Frame, rates: Mapping[Node, Node]) -> tuple[Vector, Vector]:
    """Angular velocity relative to the parent and its rate, in the frame itself, 1/s and 1/s^2."""
    if frame.turn is not None:
        (rate,) = tangent([frame.turn.angle], rates)
        (gain,) = tangent([rate], rates)
        return scale(rate, frame.turn.axis), scale(gain, frame.turn.axis)
    spin = frame.spin
    if spin is not None and all(map(operator.eq, spin.rates, map(rates.get, spin.coordinates))):
        return spin.omega, tuple(tangent(spin.omega, rates))
    flat = tangent([entry for row in frame.rotation for entry in row], rates)
    # [omega]x = R^T dR/dt in the frame itself.
    columns = transpose(frame.rotation)
    turning = transpose([flat[3 * k : 3 * k + 3] for k in range(3)])
    omega = (
        dot(columns[2], turning[1]),
        dot(columns[0], turning[2]),
        dot(columns[1], turning[0]),
    )
    return omega, tuple(tangent(omega, rates))


def _step(
    frame: FrameMotion, column: Sequence[Node], table: Mapping[Node, Node]
) -> tuple[Vector, Vector]:
    """What a step adds to velocity and acceleration."""
    first = tangent(column, table)
    second = tangent(first, table)
    arm = times(frame.rotation, column)
    across = cross(frame.omega, arm)
    velocity = across
    acceleration = add(cross(frame.alpha, arm), cross(frame.omega, across))
    if any(not entry.is_zero for entry in (*first, *second)):
        relative = times(frame.rotation, first)
        velocity = add(velocity, relative)
        acceleration = add(
            acceleration,
            times(frame.rotation, second),
            scale(2, cross(frame.omega, relative)),
        )
    return velocity, acceleration
