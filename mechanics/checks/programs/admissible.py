"""Whether a tree of bodies can be right, before any route runs.

    ideal       the power of a unit of each reaction vanishes on the velocities that are admitted
    complete    rank of the reactions = freedoms of the isolated bodies - independent speeds
    regular     the metric of the kinetic energy has full rank

Ranks are those at one point of a field: a scene is refused for what is not zero there, and so not
zero at all, or for a rank that is too small but for a chance of degree / 2^61.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.checks.programs.energy import kinetic
from mechanics.errors import SceneError
from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient, tangent
from mechanics.program.residues import Residues, eliminate
from mechanics.program.vectors import dot, subtract
from mechanics.routes.programs import chain
from mechanics.routes.programs.directions import AXES, Directions, used_directions
from mechanics.routes.programs.lagrange import virtual_power
from mechanics.routes.programs.loads import Wrench, applied, unit_reactions
from mechanics.routes.programs.motion import BodyMotion, Motions, body_motions
from mechanics.routes.programs.rows import coefficients


@dataclass(frozen=True)
class _Freedom:
    """One freedom of one isolated body: its velocity, and what each reaction does to it."""

    body: str
    words: str
    velocity: Node
    reactions: tuple[Node, ...]


def check_admissible(mechanism: Mechanism) -> None:
    """Refuse a mechanism without constraints that cannot be right.

    Raises
    ------
    SceneError
        For a reaction that does work, reactions that are incomplete or redundant, a scalar inertia
        in a scene that leaves its plane, a torsion spring whose angle is another, a singular mass
        matrix.
    """
    filter_ = Residues(mechanism.builder)
    motions = chain.motions(mechanism)
    bodies = body_motions(mechanism, motions)
    units = unit_reactions(mechanism, motions.poses)
    every = [*applied(mechanism, motions), *(unit for pair in units for unit in pair)]
    directions = used_directions(filter_, bodies, every)
    _scalar_inertias(mechanism, bodies, directions)
    _torsions(mechanism, motions, filter_)
    for reaction, pair in zip(mechanism.reactions, units, strict=True):
        power = virtual_power(mechanism, motions, pair)
        if any(not filter_.is_zero(entry) for entry in power):
            raise SceneError(
                f"reaction {reaction.name}: it does work on velocities that the scene admits:"
                " correct its point, its direction or its bodies, or declare it as a load"
            )
    _complete(mechanism, _freedoms(mechanism, bodies, directions, units), filter_)
    _regular(mechanism, filter_)


def _scalar_inertias(
    mechanism: Mechanism, bodies: Sequence[BodyMotion], directions: Directions
) -> None:
    if len(directions.rotation) == 1 and directions.rotation[0] not in directions.translation:
        return
    for body, motion in zip(mechanism.bodies, bodies, strict=True):
        turns = motion.turning is not None and any(
            not entry.is_zero for entry in motion.turning.omega
        )
        if body.scalar and turns:
            raise SceneError(
                f"body {body.name}: its inertia is a scalar, but the scene leaves its plane: give a"
                " Dyadic about the mass centre"
            )


def _torsions(mechanism: Mechanism, motions: Motions, filter_: Residues) -> None:
    """The angle of a torsion spring grows with the turning of `on` relative to `by`."""
    for load in mechanism.torsions:
        frame = mechanism.bodies[load.on].frame
        if frame is None:
            continue
        turning = motions.frames[frame].omega
        inner = None if load.by == GROUND else mechanism.bodies[load.by].frame
        if inner is not None:
            turning = subtract(turning, motions.frames[inner].omega)
        (counted,) = tangent([load.angle], mechanism.rates)
        if not filter_.is_zero(dot(turning, motions.poses.vector(load.axis)) - counted):
            on = mechanism.bodies[load.on].name
            by = "the ground" if load.by == GROUND else mechanism.bodies[load.by].name
            raise SceneError(
                f"load {load.name}: its angle is not how far {on!r} turns about its axis relative"
                f" to {by!r}: correct the angle, its sign, or the axis"
            )


def _freedoms(
    mechanism: Mechanism,
    bodies: Sequence[BodyMotion],
    directions: Directions,
    units: Sequence[Sequence[Wrench]],
) -> list[_Freedom]:
    zero, found = mechanism.builder.zero, []
    for index, (body, motion) in enumerate(zip(mechanism.bodies, bodies, strict=True)):
        own = [next((u for u in pair if u.body == index), None) for pair in units]
        for i in directions.translation:
            forces = tuple(zero if unit is None else unit.force[i] for unit in own)
            velocity = motion.centre.velocity[i]
            found.append(_Freedom(body.name, f"translation along {AXES[i]}", velocity, forces))
        if motion.turning is None:
            continue
        centre = motion.centre.position
        moments = [None if unit is None else unit.moment(centre) for unit in own]
        for i in directions.rotation:
            couples = tuple(zero if moment is None else moment[i] for moment in moments)
            omega = motion.turning.omega[i]
            found.append(_Freedom(body.name, f"rotation about {AXES[i]}", omega, couples))
    return found


def _complete(mechanism: Mechanism, freedoms: Sequence[_Freedom], filter_: Residues) -> None:
    names = [reaction.name for reaction in mechanism.reactions]
    size = len(freedoms)
    flat = filter_.values([entry for freedom in freedoms for entry in freedom.reactions])
    columns = [flat[j :: len(names)] for j in range(len(names))]
    independent = [i for i, _ in eliminate([list(column) for column in columns], size)]
    if len(independent) < len(columns):
        extra = ", ".join(names[j] for j in range(len(columns)) if j not in independent)
        raise SceneError(
            f"{mechanism.name}: the reactions {extra} follow from the others, so no equation of"
            " motion determines them: remove them, or let a body or joint give way"
        )
    wanted = size - len(mechanism.u)
    if len(independent) == wanted:
        return
    moved = coefficients([freedom.velocity for freedom in freedoms], mechanism.u)
    speeds = filter_.values([entry for row in moved for entry in row])
    width = len(mechanism.u)
    spanned = [list(column) for column in columns] + [speeds[k::width] for k in range(width)]
    have = len(eliminate([list(row) for row in spanned], size))
    for k, freedom in enumerate(freedoms):
        alone = [int(i == k) for i in range(size)]
        if len(eliminate([*(list(row) for row in spanned), alone], size)) > have:
            raise SceneError(
                f"{mechanism.name}: the reactions are incomplete ({len(independent)} of {wanted}):"
                f" nothing holds body {freedom.body} in {freedom.words}: declare the reaction"
            )
    raise SceneError(
        f"{mechanism.name}: {len(independent)} independent reactions for {size} freedoms of the"
        f" isolated bodies and {len(mechanism.u)} independent speeds: {wanted} wanted"
    )


def _regular(mechanism: Mechanism, filter_: Residues) -> None:
    momenta = gradient([kinetic(mechanism)], [1], mechanism.u)
    width = len(mechanism.u)
    flat = filter_.values([entry for row in coefficients(momenta, mechanism.u) for entry in row])
    kept = [
        i for i, _ in eliminate([flat[width * i : width * (i + 1)] for i in range(width)], width)
    ]
    if len(kept) < width:
        free = next(i for i in range(width) if i not in kept)
        speed = mechanism.builder.inputs[mechanism.builder.operands[0][mechanism.u[free].number]]
        raise SceneError(
            f"{mechanism.name}: the mass matrix is singular: nothing resists a change of {speed}:"
            " is a mass or an inertia zero that must not be?"
        )
