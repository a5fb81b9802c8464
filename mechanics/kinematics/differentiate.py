"""Velocities by differentiating components.

    v = dr/dt,  a = dv/dt,  [omega]x = (dR/dt) R^T

Nothing is composed along frames but the poses; the other way is `chain`.
"""

from collections.abc import Mapping

from mechanics.kinematics.motion import FrameMotion, Motions, PointMotion, poses
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.vectors import Matrix, Vector, dot


def motions(mechanism: Mechanism, rates: Mapping[Node, Node] | None = None) -> Motions:
    """Motion of all frames and points.

    Parameters
    ----------
    rates : mapping of Node to Node, optional
        Rate of each node that changes; by default those of q, u and what is given.
    """
    table = mechanism.rates if rates is None else rates
    where = poses(mechanism)
    points = [entry for position in where.positions for entry in position]
    velocities = tangent(points, table)
    accelerations = tangent(velocities, table)
    omegas = _angular_velocities(where.rotations, table)
    alphas = tangent([entry for omega in omegas for entry in omega], table)
    return Motions(
        where,
        tuple(
            FrameMotion(rotation, omega, tuple(alphas[3 * i : 3 * i + 3]))
            for i, (rotation, omega) in enumerate(zip(where.rotations, omegas, strict=True))
        ),
        tuple(
            PointMotion(
                position,
                tuple(velocities[3 * i : 3 * i + 3]),
                tuple(accelerations[3 * i : 3 * i + 3]),
            )
            for i, position in enumerate(where.positions)
        ),
    )


def _angular_velocities(rotations: tuple[Matrix, ...], table: Mapping[Node, Node]) -> list[Vector]:
    """omega read off the skew matrix (dR/dt) R^T."""
    entries = [entry for rotation in rotations for row in rotation for entry in row]
    rates = tangent(entries, table)
    found: list[Vector] = []
    for i, rotation in enumerate(rotations):
        turning = [rates[9 * i + 3 * k : 9 * i + 3 * k + 3] for k in range(3)]
        found.append(
            (
                dot(turning[2], rotation[1]),
                dot(turning[0], rotation[2]),
                dot(turning[1], rotation[0]),
            )
        )
    return found
