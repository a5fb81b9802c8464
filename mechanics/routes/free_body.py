"""Procedure (i): isolate every body, write its momentum principles, eliminate the reactions.

    sum F = m a_C,    sum tau_C = dH_C/dt = I alpha + omega x I omega          of each body
    row:    value = rate - applied - sum_j c_j R_j = 0

Reactions are unknowns of these rows. From the leaves of the tree of bodies to its root each one is
solved for from a row of the outboard body, and put into every other row that holds it. Rows are
written along the axes in which the reactions of the inboard joint are given, so that each holds one
of them and pivots are numbers where they can be. Velocities come from `differentiate`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.equations import Rows
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import BodyMotion, Motions, body_motions
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.vectors import Vector, add, dot, times, transpose, zeros
from mechanics.routes.directions import AXES, Directions, used_directions
from mechanics.routes.elimination import Elimination, Row, nonzero
from mechanics.routes.loads import Wrench, acting_reactions, applied, by_body, friction


@dataclass(frozen=True)
class FreeBodyRow:
    """One momentum equation of one isolated body, before any elimination.

    Attributes
    ----------
    kind : str
        ``"linear"``, or ``"angular"`` about the mass centre.
    along : Vector
        Unit vector, inertial components.
    axis : str
        Its name, for people.
    velocity, momentum, rate, applied : Node
        Component of the velocity of the mass centre or of the angular velocity, of the momentum,
        its time derivative, and that of the loads, in SI units.
    loads : tuple of (str, Node)
        That of each load, by its name.
    coefficients : mapping of int to Node
        What a unit of each reaction contributes, with the friction that it brings.
    frictions : tuple of (str, int, Node)
        What of that is friction: its name, the reaction, and its part.
    """

    body: int
    kind: str
    along: Vector
    axis: str
    velocity: Node
    momentum: Node
    rate: Node
    applied: Node
    loads: tuple[tuple[str, Node], ...]
    coefficients: dict[int, Node]
    frictions: tuple[tuple[str, int, Node], ...]


def derive(mechanism: Mechanism) -> Rows:
    """Rows free of every reaction but those that maintain constraints.

    Raises
    ------
    SingularError
        When no row determines a reaction.
    """
    build = mechanism.builder
    rows, elimination = eliminated(mechanism)
    kept = mechanism.multipliers
    names = [reaction.name for reaction in mechanism.reactions]
    multipliers = {index: build.input(names[index]) for index in kept}
    values = elimination.reactions(multipliers)
    residuals = []
    for row in elimination.work:
        value = row.value
        for reaction, coefficient in row.coefficients.items():
            value = value - coefficient * multipliers[reaction]
        residuals.append(value)
    return Rows(
        "free_body",
        tuple(residuals),
        tuple(multipliers.values()),
        conjugate=False,
        reactions={names[s.reaction]: values[s.reaction] for s in elimination.solved},
        chosen=tuple(
            f"{mechanism.bodies[row.body].name}: {row.kind} momentum along {row.axis}"
            for row in rows
        ),
    )


def eliminated(mechanism: Mechanism) -> tuple[tuple[FreeBodyRow, ...], Elimination]:
    """The momentum equations, and what is left of them without reactions.

    Raises
    ------
    SingularError
        When no row determines a reaction.
    """
    filter_, closed = mechanism.filters
    rows = free_body_rows(mechanism, filter_, differentiate.motions(mechanism))
    work = [
        Row(row.body, row.rate - row.applied, dict(row.coefficients), place)
        for place, row in enumerate(rows)
    ]
    elimination = Elimination(filter_, closed, work)
    kept = mechanism.multipliers
    names = [reaction.name for reaction in mechanism.reactions]
    for body in reversed(mechanism.order):
        own = [reaction for reaction in mechanism.joints[body] if reaction not in kept]
        elimination.solve_for(own, body, names)
    left = dict.fromkeys(r for row in elimination.work for r in row.coefficients if r not in kept)
    elimination.solve_for(list(left), None, names)
    return rows, elimination


def free_body_rows(
    mechanism: Mechanism, filter_: Residues, motions: Motions
) -> tuple[FreeBodyRow, ...]:
    """Momentum equations of every isolated body, in tree order."""
    bodies = body_motions(mechanism, motions)
    loads = applied(mechanism, motions)
    units = acting_reactions(mechanism, motions.poses)
    every = [*loads, *(unit for pair in units for unit in pair)]
    directions = used_directions(filter_, bodies, every)
    groups = by_body(mechanism, loads)
    rubbing = [
        (load.reaction, wrench)
        for load in mechanism.frictions
        for wrench in friction(motions.poses, load, units[load.reaction])
    ]
    rows: list[FreeBodyRow] = []
    for index in mechanism.order:
        acting = {
            reaction: unit
            for reaction, pair in enumerate(units)
            for unit in pair
            if unit.body == index
        }
        linear, angular = _axes(mechanism, motions, index, directions)
        rubs = [(reaction, wrench) for reaction, wrench in rubbing if wrench.body == index]
        own = bodies[index], groups[index], acting, rubs, filter_
        rows += _linear(mechanism, index, linear, *own)
        if bodies[index].turning is not None:
            rows += _angular(mechanism, index, angular, *own)
    return tuple(rows)


Axis = tuple[str, Vector]


def _axes(
    mechanism: Mechanism, motions: Motions, index: int, directions: Directions
) -> tuple[list[Axis], list[Axis]]:
    """Axes for linear and angular momentum: those of the reactions at the inboard joint."""
    frames: tuple[set[int], set[int]] = (set(), set())
    for reaction in mechanism.joints[index]:
        kind = mechanism.reactions[reaction].at is None
        frames[kind].update(frame for frame, _ in mechanism.reactions[reaction].along)
    found = []
    for chosen, used in zip(frames, (directions.translation, directions.rotation), strict=True):
        frame = chosen.pop() if len(chosen) == 1 else 0
        columns = transpose(motions.frames[frame].rotation)
        names = (f"{mechanism.frames[frame].name}.{axis}" for axis in AXES)
        found.append(
            [
                (name, column)
                for name, column in zip(names, columns, strict=True)
                if any(not column[i].is_zero for i in used)
            ]
        )
    return found[0], found[1]


def _linear(
    mechanism: Mechanism,
    index: int,
    axes: Sequence[Axis],
    motion: BodyMotion,
    loads: Sequence[Wrench],
    acting: dict[int, Wrench],
    rubs: Sequence[tuple[int, Wrench]],
    filter_: Residues,
) -> list[FreeBodyRow]:
    mass, centre = mechanism.bodies[index].mass, motion.centre
    force = add(zeros(mechanism.builder), *(load.force for load in loads))
    return [
        FreeBodyRow(
            index,
            "linear",
            along,
            axis,
            dot(centre.velocity, along),
            mass * dot(centre.velocity, along),
            mass * dot(centre.acceleration, along),
            dot(force, along),
            tuple((load.name, dot(load.force, along)) for load in loads),
            nonzero(filter_, {r: dot(unit.force, along) for r, unit in acting.items()}),
            tuple((rub.name, r, dot(rub.force, along)) for r, rub in rubs),
        )
        for axis, along in axes
    ]


def _angular(
    mechanism: Mechanism,
    index: int,
    axes: Sequence[Axis],
    motion: BodyMotion,
    loads: Sequence[Wrench],
    acting: dict[int, Wrench],
    rubs: Sequence[tuple[int, Wrench]],
    filter_: Residues,
) -> list[FreeBodyRow]:
    assert motion.turning is not None and motion.inertia is not None  # a body that turns has both
    centre = motion.centre.position
    momentum = times(motion.inertia, motion.turning.omega)
    rate = tuple(tangent(momentum, mechanism.rates))
    torque = add(zeros(mechanism.builder), *(load.moment(centre) for load in loads))
    arms = {reaction: unit.moment(centre) for reaction, unit in acting.items()}
    return [
        FreeBodyRow(
            index,
            "angular",
            along,
            axis,
            dot(motion.turning.omega, along),
            dot(momentum, along),
            dot(rate, along),
            dot(torque, along),
            tuple((load.name, dot(load.moment(centre), along)) for load in loads),
            nonzero(filter_, {reaction: dot(arm, along) for reaction, arm in arms.items()}),
            tuple((rub.name, r, dot(rub.moment(centre), along)) for r, rub in rubs),
        )
        for axis, along in axes
    ]
