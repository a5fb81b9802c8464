"""Kane's equations.

    sum over bodies of (m a - F) . dv/du_r + (I alpha + omega x I omega - T) . domega/du_r = 0

F and T are the loads on a body reduced to its mass centre. Constraints stay, maintained by their
reactions as unknown loads. Friction enters with the reaction that presses as an unknown, which one
more row gives: an auxiliary speed lets everything outboard of that reaction move along it.
"""

from dataclasses import replace

from mechanics.equations import Rows
from mechanics.kinematics import chain
from mechanics.kinematics.motion import BodyMotion, Motions, body_motions
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import Matrix, add, cross, dot, scale, subtract, times, zeros
from mechanics.routes.elimination import without_pressing
from mechanics.routes.loads import Wrench, acting_reactions, applied, by_body
from mechanics.routes.rows import acceleration_forms, coefficients, remainder


def derive(mechanism: Mechanism) -> Rows:
    """Rows power-conjugate to u; where there is friction, without the reactions that press."""
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
    names = [reaction.name for reaction in mechanism.reactions]
    rows, reactions = without_pressing(
        mechanism.filters,
        gradient(velocities, forces, mechanism.u),
        opened(mechanism, motions, groups, bodies),
        {index: node for index, node in unknown.items() if index not in mechanism.multipliers},
        names,
    )
    return Rows(
        "kane",
        rows,
        tuple(unknown[index] for index in mechanism.multipliers),
        conjugate=not mechanism.frictions,
        reactions={names[index]: value for index, value in reactions.items()},
    )


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
    return {
        index: mechanism.builder.input(mechanism.reactions[index].name)
        for index in (*mechanism.multipliers, *pressing_reactions(mechanism))
    }


def pressing_reactions(mechanism: Mechanism) -> list[int]:
    """The reactions that friction depends on, but those that maintain a constraint."""
    known = mechanism.multipliers
    return [
        r for r in dict.fromkeys(load.reaction for load in mechanism.frictions) if r not in known
    ]


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
    for index in pressing_reactions(mechanism):
        reaction = mechanism.reactions[index]
        along = motions.poses.vector(reaction.along)
        inside = mechanism.subtree(reaction.on)
        row = mechanism.builder.zero
        for body in inside:
            force, _ = inertial(mechanism, body, bodies[body], groups[body])
            row = row + dot(along, force)
        rows.append(row)
    return rows


def with_dependent_speeds(mechanism: Mechanism, rows: Rows) -> Rows:
    """The rows of the independent speeds, free of the reactions that maintain constraints.

        A_d W = -A_i        row_i + W^T row_d        u = (u_i, u_d),  A_d regular

    These have no power on u_i + W u_i, so that they may be left out.

    Parameters
    ----------
    rows : Rows
        As `derive` gives them.
    """
    if not mechanism.constraints:
        return rows
    build = mechanism.builder
    matrix = coefficients(acceleration_forms(mechanism), mechanism.ud)
    dependent = _last_independent(mechanism, matrix)
    free = [i for i in range(len(mechanism.u)) if i not in dependent]
    plain = remainder(build, rows.values, rows.multipliers)
    kept = []
    square = [[row[d] for d in dependent] for row in matrix]
    for i in free:
        weights = build.solve(square, [-row[i] for row in matrix])
        total = plain[i]
        for weight, d in zip(weights, dependent, strict=True):
            total = total + weight * plain[d]
        kept.append(total)
    names = [build.inputs[build.operands[0][mechanism.u[d].number]] for d in dependent]
    return replace(
        rows,
        values=tuple(kept),
        multipliers=(),
        conjugate=False,
        chosen=tuple(f"dependent speed {name}" for name in names),
    )


def _last_independent(mechanism: Mechanism, matrix: Matrix) -> list[int]:
    """The last speeds that the constraints can be solved for."""
    backwards = range(len(mechanism.u) - 1, -1, -1)
    _, closed = mechanism.filters
    columns = [closed.values([row[i] for row in matrix]) for i in backwards]
    return sorted(backwards[k] for k, _ in closed.eliminate(columns, len(matrix)))
