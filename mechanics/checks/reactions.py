"""Reactions of procedure (i), put back into the momentum equations of every isolated body.

rate - applied - sum_j c_j R_j(q, u, u') = 0        at the accelerations of another route
"""

from mechanics.checks.agreement import Derived
from mechanics.checks.statements import equal
from mechanics.equations import Rows
from mechanics.kernel import Finding
from mechanics.kinematics import chain
from mechanics.kinematics.motion import body_motions
from mechanics.program.residues import Residues
from mechanics.program.vectors import scale, subtract
from mechanics.routes.directions import used_directions
from mechanics.routes.kane import inertial
from mechanics.routes.loads import acting_reactions, applied, by_body
from mechanics.routes.rows import substitute


def check_reactions(free_body: Rows, other: Derived) -> Finding:
    """Newton's and Euler's equations of every body hold with all loads and reactions on it.

    Written in inertial axes from composed velocities, which procedure (i) does not use, at the
    accelerations of another route.

    Parameters
    ----------
    free_body : Rows
        With its reactions.
    other : Derived
        Of a route whose multipliers are the declared reactions: kane.
    """
    mechanism = other.mechanism
    build = mechanism.builder
    motions = chain.motions(mechanism)
    groups = by_body(mechanism, applied(mechanism, motions))
    units = acting_reactions(mechanism, motions.poses)
    bodies = body_motions(mechanism, motions)
    every = [wrench for group in (*groups, *units) for wrench in group]
    directions = used_directions(Residues(build), bodies, every)
    left = []
    for index, motion in enumerate(bodies):
        force, torque = inertial(mechanism, index, motion, groups[index])
        for reaction, pair in zip(mechanism.reactions, units, strict=True):
            for unit in pair:
                if unit.body == index:
                    # One that maintains a constraint is an unknown of the same name in both.
                    size = free_body.reactions.get(reaction.name, build.input(reaction.name))
                    force = subtract(force, scale(size, unit.force))
                    torque = subtract(torque, scale(size, unit.moment(motion.centre.position)))
        left += [force[i] for i in directions.translation]
        if motion.turning is not None:
            left += [torque[i] for i in directions.rotation]
    solved = dict(zip(other.unknowns, other.solution, strict=True))
    values = substitute(build, left, solved)
    return equal("reactions: every body's momentum", mechanism, values, [0] * len(values))
