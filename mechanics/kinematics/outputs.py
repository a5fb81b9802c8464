"""What a scene wants computed, with Jacobians by the speeds.

position     R_B^T r        v = R_B^T dr/dt
rotation     R_B^T R        v = R_B^T omega
velocity     v              v = R_B^T (v_C + omega x (r - r_C)),  R_B^T dr/dt,  or e . dr/dt
Jacobian     dv/du
"""

from mechanics.kinematics.motion import Motions
from mechanics.mechanism import Mechanism, Output
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import (
    Matrix,
    Vector,
    add,
    cross,
    dot,
    product,
    subtract,
    times,
    transpose,
)
from mechanics.scene.outputs import JACOBIAN

SLOPE = "jacobian"
"""Name of a Jacobian; values have the name of their kind."""


def output_functions(mechanism: Mechanism) -> dict[str, tuple[Output, bool]]:
    """By name of a function the output that it gives, and whether it gives the Jacobian."""
    return {
        f"{output.name}{JACOBIAN if slope else ''}": (output, slope)
        for output in mechanism.outputs
        for slope in (False, True)
    }


def output_matrix(
    mechanism: Mechanism, motions: Motions, output: Output, slope: bool
) -> tuple[str, Matrix]:
    """What a function gives: its name, and its rows.

    Parameters
    ----------
    motions : Motions
        In q and u.
    slope : bool
        Whether the Jacobian is wanted.
    """
    basis = transpose(motions.poses.rotations[output.basis])
    if not slope and output.kind == "rotation":
        return output.kind, product(basis, motions.poses.rotations[output.frame])
    if not slope and output.kind == "position":
        rows = times(basis, motions.poses.positions[output.point])
        return output.kind, transpose([rows])
    moving = _rate(mechanism, motions, output)
    rows = times(basis, moving)
    if output.along is not None:
        rows = (dot(moving, motions.poses.vector(output.along)),)
    if slope:
        return SLOPE, tuple(tuple(gradient([row], [1], mechanism.u)) for row in rows)
    return output.kind, transpose([rows])


def _rate(mechanism: Mechanism, motions: Motions, output: Output) -> Vector:
    """Inertial components of the velocity or angular velocity."""
    if output.kind == "rotation":
        return motions.frames[output.frame].omega
    if output.on is None:
        return motions.points[output.point].velocity
    body = mechanism.bodies[output.on]
    centre = motions.points[body.centre]
    if body.frame is None:
        return centre.velocity
    arm = subtract(motions.poses.positions[output.point], centre.position)
    return add(centre.velocity, cross(motions.frames[body.frame].omega, arm))
