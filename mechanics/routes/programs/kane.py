"""Kane's equations.

    sum over bodies of (m a - F) . dv/du_r + (I alpha + omega x I omega - T) . domega/du_r = 0

F and T are the loads on a body reduced to its mass centre. Constraints stay, maintained by their
reactions as unknown loads. Friction enters with the reaction that presses as an unknown, which one
more row gives: an auxiliary speed lets everything outboard of that reaction move along it.
"""

from __future__ import annotations

from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import add, cross, dot, scale, subtract, times, zeros
from mechanics.routes.programs import chain
from mechanics.routes.programs.loads import Wrench, acting_reactions, applied, by_body
from mechanics.routes.programs.motion import BodyMotion, Motions, body_motions
from mechanics.routes.programs.rows import Rows


def derive(mechanism: Mechanism) -> Rows:
    """Rows power-conjugate to u; where there is friction, rows for the reactions that press."""
    motions = chain.motions(mechanism)
    unknown = unknown_reactions(mechanism)
    loads = [*applied(mechanism, motions), *_unknown_loads(mechanism, motions, unknown)]
    velocities: list[Node] = []
    forces: list[Node] = []
    groups = by_body(mechanism, loads)
    bodies = body_motions(mechanism, motions)
    for index, (motion, wrenches) in enumerate(zip(bodies, groups, strict=True)):
        force, torque = inertial(mechanism, index, motion, wrenches)
        velocities += motion.centre.velocity
        forces += force
        if motion.turning is not None:
            velocities += motion.turning.omega
            forces += torque
    rows = gradient(velocities, forces, mechanism.u)
    rows += opened(mechanism, motions, groups, bodies)
    return Rows("kane", tuple(rows), tuple(unknown.values()), conjugate=not mechanism.frictions)


def inertial(
    mechanism: Mechanism, index: int, motion: BodyMotion, wrenches: list[Wrench]
) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
    """m a - F and I alpha + omega x I omega - T of one body."""
    body, none = mechanism.bodies[index], zeros(mechanism.builder)
    centre = motion.centre
    force = subtract(scale(body.mass, centre.acceleration), add(none, *(w.force for w in wrenches)))
    if motion.turning is None or motion.inertia is None:
        return force, none
    omega, alpha = motion.turning.omega, motion.turning.alpha
    spin = add(times(motion.inertia, alpha), cross(omega, times(motion.inertia, omega)))
    torque = add(none, *(wrench.moment(centre.position) for wrench in wrenches))
    return force, subtract(spin, torque)


def unknown_reactions(mechanism: Mechanism) -> dict[int, Node]:
    """Reactions that stay as unknowns: those of constraints, and those that friction depends on."""
    pressing = [load.reaction for load in mechanism.frictions]
    return {
        index: mechanism.builder.input(mechanism.reactions[index].name)
        for index in dict.fromkeys((*mechanism.multipliers, *pressing))
    }


def _unknown_loads(
    mechanism: Mechanism, motions: Motions, unknown: dict[int, Node]
) -> list[Wrench]:
    """Unknown reactions as loads: a pressing one does no work itself, but its friction does."""
    units = acting_reactions(mechanism, motions.poses)
    return [
        Wrench(unit.name, unit.body, unit.at, scale(size, unit.force), scale(size, unit.couple))
        for index, size in unknown.items()
        for unit in units[index]
    ]


def opened(
    mechanism: Mechanism,
    motions: Motions,
    groups: list[list[Wrench]],
    bodies: tuple[BodyMotion, ...],
) -> list[Node]:
    """For each pressing reaction: the momentum of all that is outboard, along the reaction."""
    rows = []
    for load in mechanism.frictions:
        reaction = mechanism.reactions[load.reaction]
        along = motions.poses.vector(reaction.along)
        inside = mechanism.subtree(reaction.on)
        row = mechanism.builder.zero
        for index in inside:
            force, _ = inertial(mechanism, index, bodies[index], groups[index])
            row = row + dot(along, force)
        rows.append(row)
    return rows
