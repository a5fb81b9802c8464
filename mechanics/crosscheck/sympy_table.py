"""Which scenes SymPy's own methods finish in seconds: a table of counts, looked up before them.

SymPy works on one expression for each component, multiplied out where it likes to: what it takes
grows with the bodies that turn in space, with the speeds that constraints make dependent (for which
Cramer's rule writes minors), and with the size of the velocities.
"""

from mechanics.kinematics import chain
from mechanics.kinematics.motion import body_motions
from mechanics.mechanism import Mechanism

LARGEST: dict[str, int] = {
    "speeds": 12,
    "dependent speeds": 5,
    "bodies turning in space": 3,
    "operations of the velocities": 120,
}
"""The most of each that SymPy is given."""


def counts(mechanism: Mechanism) -> dict[str, int]:
    """Of a scene, by the names of `LARGEST`."""
    motions = body_motions(mechanism, chain.motions(mechanism))
    velocities = [
        entry
        for motion in motions
        for vector in (motion.centre.velocity, motion.turning.omega if motion.turning else ())
        for entry in vector
    ]
    in_space = sum(body.inertia is not None and not body.scalar for body in mechanism.bodies)
    return {
        "speeds": len(mechanism.u),
        "dependent speeds": len(mechanism.constraints),
        "bodies turning in space": in_space,
        "operations of the velocities": mechanism.builder.program({"v": velocities}).count,
    }


def too_large(mechanism: Mechanism, method: str = "") -> str:
    """Why a scene is not given to one of SymPy's methods, in a few words; empty where it is."""
    bodies = len(mechanism.bodies)
    if method == "lagrange_sympy" and bodies > 1 and any(f.spin for f in mechanism.frames):
        # It differentiates the quotients of R twice: a minute for a body with an arm.
        return f"{bodies} bodies and a quaternion; SymPy's Lagrange is given one body"
    for name, count in counts(mechanism).items():
        if count > LARGEST[name]:
            return f"{count} {name}; SymPy is given up to {LARGEST[name]}"
    return ""
