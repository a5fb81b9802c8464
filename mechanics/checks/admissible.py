"""Whether a scene can be right, before any route runs.

    ideal       the power of a unit of each reaction vanishes on the velocities that are admitted
    complete    rank of the reactions = freedoms of the isolated bodies - independent speeds
    regular     the metric of the kinetic energy has full rank

Ranks are those at one point of a field, on the constraints if there are any: a scene is refused for
what is not zero there, and so not zero at all, or for a rank that is too small but for a chance of
degree / 2^60.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.checks.energy import kinetic
from mechanics.checks.equilibria import check_equilibria
from mechanics.checks.example import check_example
from mechanics.errors import SceneError
from mechanics.kinematics import chain
from mechanics.kinematics.motion import BodyMotion, Motions, body_motions
from mechanics.mechanism import GROUND, Mechanism, lower
from mechanics.program.builder import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.vectors import Vector, add, cross, dot, scale, subtract
from mechanics.routes.directions import AXES, Directions, used_directions
from mechanics.routes.lagrange import virtual_power
from mechanics.routes.loads import Wrench, applied, unit_reactions
from mechanics.routes.redundant import independent_beside
from mechanics.routes.rows import coefficients, velocity_forms
from mechanics.scene import Scene


@dataclass(frozen=True)
class _Freedom:
    """One freedom of one isolated body: its velocity, and what each reaction does to it."""

    body: str
    words: str
    velocity: Node
    reactions: tuple[Node, ...]


def check_scene(scene: Scene) -> Mechanism:
    """The mechanism of a scene that was found admissible; see `check_admissible`.

    Raises
    ------
    SceneError
        For what `check_admissible` refuses, for a declared equilibrium that is none, and for an
        example that contradicts a constraint.
    """
    mechanism = lower(scene, Builder())
    check_example(scene, mechanism)
    check_admissible(mechanism)
    check_equilibria(scene, mechanism)
    return mechanism


def check_admissible(mechanism: Mechanism) -> None:
    """Refuse a mechanism that cannot be right.

    Raises
    ------
    SceneError
        For constraints that are not linear in the speeds or redundant, a reaction that does work,
        reactions that are incomplete or redundant, a scalar inertia in a scene that leaves its
        plane, a torsion spring or friction whose angle or velocity is another, a singular mass
        matrix.
    """
    anywhere, filter_ = mechanism.filters
    motions = chain.motions(mechanism)
    bodies = body_motions(mechanism, motions)
    units = unit_reactions(mechanism, motions.poses)
    every = [*applied(mechanism, motions), *(unit for pair in units for unit in pair)]
    directions = used_directions(anywhere, bodies, every)
    table = _constraint_rows(mechanism, anywhere, filter_)
    _lines(mechanism, motions, anywhere)
    _torsions(mechanism, motions, filter_)
    _frictions(mechanism, motions, filter_)
    _scalar_inertias(mechanism, bodies, directions)
    powers = [filter_.values(virtual_power(mechanism, motions, pair)) for pair in units]
    if mechanism.closure.values or not mechanism.closure:
        # Where no point on the constraints is known, the laws say that it is undecided.
        _ideal(mechanism, table, powers, filter_)
    _complete(mechanism, _freedoms(mechanism, bodies, directions, units), table, filter_)
    _maintained(mechanism, powers, filter_)
    _regular(mechanism, table, filter_)


def _rank(filter_: Residues, rows: Sequence[Sequence[int]], width: int) -> list[int]:
    """Rows that are independent of those before them."""
    return [i for i, _ in filter_.eliminate([list(row) for row in rows], width)]


def _constraint_rows(
    mechanism: Mechanism, anywhere: Residues, filter_: Residues
) -> list[list[int]]:
    """A of A u + a = 0 at the point, after each constraint was found linear and independent."""
    forms, vacuous = velocity_forms(mechanism), list[str]()
    for form, constraint in zip(forms, mechanism.constraints, strict=True):
        where = f"constraint {constraint.name}"
        (slopes,) = coefficients([form], mechanism.u)
        curved = gradient(slopes, [1] * len(slopes), mechanism.u)
        if any(not filter_.is_zero(entry) for entry in curved):
            raise SceneError(f"{where}: it is not linear in the speeds: state it so that it is")
        held = gradient([form], [1], mechanism.ud)
        if any(not entry.is_zero for entry in held):
            raise SceneError(
                f"{where}: it holds accelerations: state it for coordinates or for their rates"
            )
        if all(map(anywhere.is_zero, slopes)):
            vacuous.append(constraint.name)
        elif all(map(filter_.is_zero, slopes)):
            raise SceneError(
                f"{where}: it restricts no speed where the constraints hold: give an example of a"
                " state at which it does"
            )
    if vacuous:
        raise SceneError(
            f"constraint {', '.join(vacuous)}: it restricts no speed: is it an identity?"
            ' redundant="drop" in the scene leaves it out, with a reaction that is not determined'
        )
    table = [filter_.values(row) for row in coefficients(forms, mechanism.u)]
    kept = _rank(filter_, table, len(mechanism.u))
    names = [constraint.name for constraint in mechanism.constraints]
    words = _dependences(filter_, table, kept, names)
    near = independent_beside(mechanism, coefficients(forms, mechanism.u))
    if near is not None and len(near) < len(kept):
        # It moves for special lengths and angles, of which no exact point is known.
        words = ", ".join(name for i, name in enumerate(names) if i not in near)
        kept, words = near, f"{words} follow from those before at the example"
    if len(kept) < len(table):
        raise SceneError(
            f"{mechanism.name}: redundant constraints: {words}:"
            ' their reactions are not determined: remove both, or give the scene redundant="drop"'
        )
    if len(kept) >= len(mechanism.u):
        raise SceneError(
            f"{mechanism.name}: {len(kept)} constraints on {len(mechanism.u)} speeds leave nothing"
            " to move"
        )
    return table


def _dependences(
    filter_: Residues, table: Sequence[Sequence[int]], kept: Sequence[int], names: Sequence[str]
) -> str:
    """Which rows follow from which: sum_k x_k row_k = row_i, and where x_k is not zero."""
    groups: dict[str, list[str]] = {}
    for i in sorted(set(range(len(table))) - set(kept)):
        rows = [[*(table[k][c] for k in kept), entry] for c, entry in enumerate(table[i])]
        pivots = filter_.eliminate(rows, len(kept))
        others = ", ".join(
            names[kept[c]] for r, c in sorted(pivots, key=lambda p: p[1]) if rows[r][-1]
        )
        groups.setdefault(others, []).append(names[i])
    return "; ".join(f"{', '.join(group)} follow from {others}" for others, group in groups.items())


def _ideal(
    mechanism: Mechanism,
    table: Sequence[Sequence[int]],
    powers: Sequence[Sequence[int]],
    filter_: Residues,
) -> None:
    """The power of a unit is a combination of the constraints' rows: zero where they hold."""
    independent = _rank(filter_, [*table, *powers], len(mechanism.u))
    if len(independent) > len(table):
        reaction = mechanism.reactions[independent[len(table)] - len(table)]
        raise SceneError(
            f"reaction {reaction.name}: it does work on velocities that the scene admits:"
            " correct its point, its direction or its bodies, or declare it as a load"
        )


def _maintained(mechanism: Mechanism, powers: Sequence[Sequence[int]], filter_: Residues) -> None:
    """The reactions that constraints name act against their violation, each in its own way."""
    kept = mechanism.multipliers
    independent = _rank(filter_, [powers[index] for index in kept], len(mechanism.u))
    for i, constraint in enumerate(mechanism.constraints):
        if i not in independent:
            name = mechanism.reactions[kept[i]].name
            raise SceneError(
                f"constraint {constraint.name}: the reaction {name} does not maintain it: name"
                " the one that does work when it is violated"
            )


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


def _lines(mechanism: Mechanism, motions: Motions, filter_: Residues) -> None:
    """Ends that move on one line have a length with a sign, which the distance has not."""
    for line in mechanism.lines:
        span = subtract(motions.poses.positions[line.second], motions.poses.positions[line.first])
        rate = subtract(motions.points[line.second].velocity, motions.points[line.first].velocity)
        moves = any(not filter_.is_zero(entry) for entry in rate)
        if line.along is None and moves and all(map(filter_.is_zero, cross(span, rate))):
            raise SceneError(
                f"load {line.name}: its ends move on one line, so that its length is |d| of a"
                " distance d with a sign: give the direction with along="
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
                f"load {load.name}: the angle {load.typed[0]} is not how far {on!r} turns about"
                f" {load.typed[1]} relative to {by!r}: correct the angle, its sign, or the axis"
            )


def _frictions(mechanism: Mechanism, motions: Motions, filter_: Residues) -> None:
    """Bodies slide as friction says: v_on - v_by = v t at the point of contact.

    So friction cannot push, act on a body that does not slide, or leave out a sideways slip.
    """
    for load in mechanism.frictions:
        reaction = mechanism.reactions[load.reaction]
        stated = scale(load.sliding, motions.poses.vector(load.along))
        slip = _velocity(mechanism, motions, reaction.on, reaction.at)
        if reaction.by != GROUND:
            slip = subtract(slip, _velocity(mechanism, motions, reaction.by, reaction.at))
        if any(not filter_.is_zero(entry) for entry in subtract(slip, stated)):
            on = mechanism.bodies[reaction.on].name
            by = "the ground" if reaction.by == GROUND else mechanism.bodies[reaction.by].name
            raise SceneError(
                f"load {load.name}: {load.typed[0]} along {load.typed[1]} is not how {on!r} slides"
                f" on {by!r} where {reaction.name} acts: correct sliding= or along="
            )


def _velocity(mechanism: Mechanism, motions: Motions, body: int, at: int | None) -> Vector:
    """Velocity of a body's material at a point."""
    centre = motions.points[mechanism.bodies[body].centre]
    frame = mechanism.bodies[body].frame
    if frame is None or at is None:
        return centre.velocity
    arm = subtract(motions.points[at].position, centre.position)
    return add(centre.velocity, cross(motions.frames[frame].omega, arm))


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


def _complete(
    mechanism: Mechanism,
    freedoms: Sequence[_Freedom],
    table: Sequence[Sequence[int]],
    filter_: Residues,
) -> None:
    """Reactions and velocities that the constraints admit span the freedoms of isolated bodies."""
    names = [reaction.name for reaction in mechanism.reactions]
    size = len(freedoms)
    flat = filter_.values([entry for freedom in freedoms for entry in freedom.reactions])
    columns = [flat[j :: len(names)] for j in range(len(names))]
    independent = _rank(filter_, columns, size)
    if len(independent) < len(columns):
        extra = ", ".join(names[j] for j in range(len(columns)) if j not in independent)
        raise SceneError(
            f"{mechanism.name}: the reactions {extra} follow from the others, so no equation of"
            " motion determines them: remove them, or let a body or joint give way"
        )
    free = len(mechanism.u) - len(mechanism.constraints)
    wanted = size - free
    if len(independent) == wanted:
        return
    moved = coefficients([freedom.velocity for freedom in freedoms], mechanism.u)
    speeds = filter_.values([entry for row in moved for entry in row])
    width = len(mechanism.u)
    # A combination of these is admitted where what it does to the constraints, behind, is zero.
    behind = [0] * len(table)
    spanned = [[*column, *behind] for column in columns]
    spanned += [[*speeds[k::width], *(row[k] for row in table)] for k in range(width)]
    have = len(_rank(filter_, spanned, size + len(table)))
    for k, freedom in enumerate(freedoms):
        alone = [*(int(i == k) for i in range(size)), *behind]
        if len(_rank(filter_, [*spanned, alone], size + len(table))) > have:
            raise SceneError(
                f"{mechanism.name}: the reactions are incomplete ({len(independent)} of {wanted}):"
                f" nothing holds body {freedom.body} in {freedom.words}: declare the reaction"
            )
    raise SceneError(
        f"{mechanism.name}: {len(independent)} independent reactions for {size} freedoms of the"
        f" isolated bodies and {free} independent speeds: {wanted} wanted"
    )


def _regular(mechanism: Mechanism, table: Sequence[Sequence[int]], filter_: Residues) -> None:
    """[[M, A^T], [A, 0]] has full rank, M the metric of the kinetic energy."""
    momenta = gradient([kinetic(mechanism)], [1], mechanism.u)
    metric = [filter_.values(row) for row in coefficients(momenta, mechanism.u)]
    n, c = len(metric), len(table)
    rows = [[*metric[i], *(table[k][i] for k in range(c))] for i in range(n)]
    rows += [[*row, *([0] * c)] for row in table]
    kept = _rank(filter_, rows, n + c)
    if len(kept) < n + c:
        free = next(i for i in range(n + c) if i not in kept)
        speed = "the constraints"
        if free < n:
            build = mechanism.builder
            speed = build.inputs[build.operands[0][mechanism.u[free].number]]
        raise SceneError(
            f"{mechanism.name}: the mass matrix is singular: nothing resists a change of {speed}:"
            " is a mass or an inertia zero that must not be?"
        )
