"""Procedure (ii): free bodies and moment centres chosen so that the reactions drop out.

    sum tau_B = dH_B/dt + v_B x P                  (1)     about a moving point B
    sum F . e = dP/dt . e                          (2)     along a direction e

v_B is the velocity of the geometric point B, not of a material one. Candidates are the outboard
subtrees of the tree of bodies. The reactions that cross the boundary of one are wrenches
(F_j, tau_j) about a reference point; a twist (v, w) with

    v . F_j + w . tau_j = 0        for every crossing reaction j                        (3)

does no work on them, and the principle projected on it holds none of them:

    w = 0          (2) along v
    w . v = 0      (1) about the point w x v / w^2 off the reference point, along w
    otherwise      that, plus the pitch v . w / w^2 times (2) along w (a screw)

Momenta of a subtree are those of its body and of the subtrees on it:

    P = m v_C + sum P_k        H_B = I omega + (r_C - r_B) x m v_C + sum (H_k + (r_k - r_B) x P_k)

The first set of full rank in tree order is kept. Velocities come from `chain`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mechanics.equations import Rows
from mechanics.errors import SingularError
from mechanics.kinematics import chain
from mechanics.kinematics.motion import BodyMotion, Motions, body_motions
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.sympy_printer import expressions, written_size
from mechanics.program.vectors import (
    Vector,
    add,
    cross,
    dot,
    scale,
    subtract,
    times,
    transpose,
    zeros,
)
from mechanics.routes.directions import AXES, Directions, used_directions
from mechanics.routes.elimination import Elimination, Row
from mechanics.routes.loads import (
    Wrench,
    acting_reactions,
    applied,
    balanced,
    by_body,
    together,
)
from mechanics.routes.rows import acceleration_forms, coefficients

LARGEST_DIRECTION = 60
"""Operations up to which a direction is written for people."""


@dataclass(frozen=True)
class Principle:
    """A momentum principle of an outboard subtree.

    Attributes
    ----------
    root : int
        The innermost body of the subtree.
    offset : Vector
        From the reference point of the subtree to the moment centre, inertial components, in m.
    axis : Vector
        Axis of the moment; zero for linear momentum.
    along : Vector
        Direction of linear momentum (the pitch times the axis for a screw).
    direction : str
        Of the axis, or of linear momentum, for people.
    """

    root: int
    offset: Vector
    axis: Vector
    along: Vector
    direction: str

    @property
    def linear(self) -> bool:
        """Whether it is one of linear momentum alone."""
        return all(entry.is_zero for entry in self.axis)


@dataclass(frozen=True)
class Subtree:
    """An outboard subtree: its reference point, and momenta and loads about it."""

    point: int
    momentum: Vector
    spin: Vector
    force: Vector
    torque: Vector


@dataclass(frozen=True)
class Balance:
    """A principle with what it is made of, inertial components.

    Attributes
    ----------
    words : str
        What was chosen, for people.
    spin, spin_rate : Vector
        H_B about the moment centre, and its rate.
    velocity : Vector
        Of the moment centre as a geometric point.
    torque, force : Vector
        Of the loads.
    coefficients : mapping of int to Node
        What a unit of each reaction that is let in contributes.
    """

    principle: Principle
    words: str
    spin: Vector
    spin_rate: Vector
    momentum: Vector
    momentum_rate: Vector
    velocity: Vector
    torque: Vector
    force: Vector
    coefficients: Mapping[int, Node]

    @property
    def value(self) -> Node:
        """Rates minus loads; equal to the part of the reactions that are let in."""
        principle = self.principle
        value = dot(principle.along, subtract(self.momentum_rate, self.force))
        if principle.linear:
            return value
        moving = add(self.spin_rate, cross(self.velocity, self.momentum))
        return value + dot(principle.axis, subtract(moving, self.torque))


@dataclass(frozen=True)
class Choice:
    """Principles that determine the motion.

    Attributes
    ----------
    balances : tuple of Balance
        Read from the ground outward.
    let_in : mapping of int to Node
        Reactions of constraints and of loops, as inputs.
    elimination : Elimination
        Of the reactions that close a loop of bodies.
    """

    balances: tuple[Balance, ...]
    let_in: Mapping[int, Node]
    elimination: Elimination


def derive(mechanism: Mechanism) -> Rows:
    """Rows from principles in which the reactions do not enter.

    Raises
    ------
    SingularError
        When the principles do not determine the motion.
    """
    choice = choose(mechanism)
    return Rows(
        "moving_point",
        tuple(_without(row, choice.let_in) for row in choice.elimination.work),
        tuple(choice.let_in[index] for index in mechanism.multipliers),
        conjugate=False,
        chosen=tuple(balance.words for balance in choice.balances),
    )


@dataclass(frozen=True)
class Candidates:
    """Every principle of every outboard subtree in which no reaction of a joint enters.

    Attributes
    ----------
    motions : Motions
    bodies : tuple of BodyMotion
    loads : list of lists of Wrench
        By body.
    subtrees : mapping of int to Subtree
        By the innermost body.
    balances : tuple of Balance
        From the leaves inward.
    let_in : mapping of int to Node
        Reactions of constraints and of loops, as inputs.
    """

    motions: Motions
    bodies: tuple[BodyMotion, ...]
    loads: list[list[Wrench]]
    subtrees: Mapping[int, Subtree]
    balances: tuple[Balance, ...]
    let_in: Mapping[int, Node]


def candidates(mechanism: Mechanism, filters: tuple[Residues, Residues]) -> Candidates:
    """Principles to choose from."""
    build, (filter_, _) = mechanism.builder, filters
    motions = chain.motions(mechanism)
    units = acting_reactions(mechanism, motions.poses)
    let_in = {
        index: build.input(mechanism.reactions[index].name)
        for index in (*mechanism.multipliers, *_loop_reactions(mechanism))
    }
    loads = applied(mechanism, motions)
    bodies = body_motions(mechanism, motions)
    every = [*loads, *(unit for pair in units for unit in pair)]
    directions = used_directions(filter_, bodies, every)
    groups = by_body(mechanism, loads)
    subtrees = _subtrees(mechanism, motions, bodies, groups)
    principles: list[Principle] = []
    held: list[dict[int, Node]] = []
    for root in reversed(mechanism.order):
        crossing = _crossing(units, mechanism.subtree(root))
        stopped = {j: unit for j, unit in crossing.items() if j not in let_in}
        about = motions.points[subtrees[root].point].position
        for principle in _principles(mechanism, motions, filters, root, about, stopped, directions):
            principles.append(principle)
            centre = add(about, principle.offset)
            held.append(
                {
                    j: coefficient
                    for j, unit in crossing.items()
                    if j in let_in
                    and not filter_.is_zero(coefficient := _power(principle, unit, centre))
                }
            )
    balances = _balances(mechanism, motions, subtrees, principles, held)
    return Candidates(motions, bodies, groups, subtrees, tuple(balances), let_in)


def choose(mechanism: Mechanism) -> Choice:
    """Free bodies and moment centres of full rank.

    Raises
    ------
    SingularError
        When the principles do not determine the motion.
    """
    filter_, closed = filters = mechanism.filters
    found = candidates(mechanism, filters)
    balances, let_in = found.balances, found.let_in
    values = [balance.value for balance in balances]
    held = [balance.coefficients for balance in balances]
    kept = _independent(mechanism, closed, values, held, let_in)
    rows = [Row(balances[i].principle.root, values[i], dict(held[i])) for i in kept]
    elimination = Elimination(filter_, closed, rows)
    names = [reaction.name for reaction in mechanism.reactions]
    elimination.solve_for(list(_loop_reactions(mechanism)), None, names)
    return Choice(tuple(balances[i] for i in kept), let_in, elimination)


def _without(row: Row, let_in: Mapping[int, Node]) -> Node:
    """value - sum of coefficients times reactions."""
    value = row.value
    for reaction, coefficient in row.coefficients.items():
        value = value - coefficient * let_in[reaction]
    return value


def _loop_reactions(mechanism: Mechanism) -> tuple[int, ...]:
    """Reactions in no joint of the tree and named by no constraint: they close a loop of bodies."""
    known = {r for joint in mechanism.joints for r in joint} | set(mechanism.multipliers)
    return tuple(r for r in range(len(mechanism.reactions)) if r not in known)


def _crossing(units: Sequence[Sequence[Wrench]], inside: Sequence[int]) -> dict[int, Wrench]:
    """What each reaction that crosses the boundary of a free body does to it, per unit."""
    members, found = set(inside), {}
    for index, pair in enumerate(units):
        own = [unit for unit in pair if unit.body in members]
        if own and not balanced(pair, own):
            found[index] = together(own)
    return found


def _power(principle: Principle, unit: Wrench, centre: Vector) -> Node:
    return dot(principle.axis, unit.moment(centre)) + dot(principle.along, unit.force)


# ---------------------------------------------------------------------- momenta


def _subtrees(
    mechanism: Mechanism,
    motions: Motions,
    bodies: Sequence[BodyMotion],
    loads: Sequence[Sequence[Wrench]],
) -> dict[int, Subtree]:
    """Momenta and loads of every outboard subtree about its reference point, leaves first."""
    none = zeros(mechanism.builder)
    found: dict[int, Subtree] = {}
    for root in reversed(mechanism.order):
        point = _reference(mechanism, root)
        about = motions.points[point].position
        body, motion = mechanism.bodies[root], bodies[root]
        momentum = scale(body.mass, motion.centre.velocity)
        spin = cross(subtract(motion.centre.position, about), momentum)
        if motion.turning is not None and motion.inertia is not None:
            spin = add(spin, times(motion.inertia, motion.turning.omega))
        force = add(none, *(load.force for load in loads[root]))
        torque = add(none, *(load.moment(about) for load in loads[root]))
        for outer, subtree in found.items():
            if mechanism.parents[outer] == root:
                arm = subtract(motions.points[subtree.point].position, about)
                momentum = add(momentum, subtree.momentum)
                spin = add(spin, subtree.spin, cross(arm, subtree.momentum))
                force = add(force, subtree.force)
                torque = add(torque, subtree.torque, cross(arm, subtree.force))
        found[root] = Subtree(point, momentum, spin, force, torque)
    return found


def _reference(mechanism: Mechanism, root: int) -> int:
    """Where the first force of the inboard joint acts, or the mass centre."""
    for index in mechanism.joints[root]:
        at = mechanism.reactions[index].at
        if at is not None:
            return at
    return mechanism.bodies[root].centre


def _balances(
    mechanism: Mechanism,
    motions: Motions,
    subtrees: Mapping[int, Subtree],
    principles: Sequence[Principle],
    held: Sequence[Mapping[int, Node]],
) -> list[Balance]:
    """What each principle is made of, all momenta differentiated in one walk."""
    rates = mechanism.rates
    flat: list[Node] = []
    spins = []
    for principle in principles:
        subtree = subtrees[principle.root]
        # H_B about the centre: the reference point and the offset.
        spins.append(subtract(subtree.spin, cross(principle.offset, subtree.momentum)))
        flat += [*spins[-1], *subtree.momentum, *principle.offset]
    derived = tangent(flat, rates) if flat else []
    balances = []
    for i, principle in enumerate(principles):
        subtree = subtrees[principle.root]
        spin_rate, momentum_rate, moving = (
            tuple(derived[9 * i + 3 * k : 9 * i + 3 * k + 3]) for k in range(3)
        )
        balances.append(
            Balance(
                principle,
                _words(mechanism, subtrees, principle),
                spins[i],
                spin_rate,
                subtree.momentum,
                momentum_rate,
                add(motions.points[subtree.point].velocity, moving),
                subtract(subtree.torque, cross(principle.offset, subtree.force)),
                subtree.force,
                held[i],
            )
        )
    return balances


# ---------------------------------------------------------------------- principles


def _principles(
    mechanism: Mechanism,
    motions: Motions,
    filters: tuple[Residues, Residues],
    root: int,
    about: Vector,
    crossing: Mapping[int, Wrench],
    directions: Directions,
) -> list[Principle]:
    """Every principle of a subtree in which no crossing reaction enters, translations first."""
    none, (filter_, _) = zeros(mechanism.builder), filters
    frame = _frame(mechanism, crossing, directions)
    rotation = motions.frames[frame].rotation
    back = transpose(rotation)
    rows = []
    for index, unit in crossing.items():
        reaction = mechanism.reactions[index]
        given = [column for at, column in reaction.along if at == frame]
        plain = len(given) == len(reaction.along) == 1 and not mechanism.frictions
        along = given[0] if plain else _tidied(filter_, times(back, unit.force))
        if reaction.at is None:
            couple = given[0] if plain else _tidied(filter_, times(back, unit.couple))
            along = none
        else:
            arm = subtract(unit.at, about)
            couple = _tidied(filter_, times(back, cross(arm, unit.force)))
        rows.append(
            [along[i] for i in directions.translation] + [couple[i] for i in directions.rotation]
        )
    size = len(directions.translation) + len(directions.rotation)
    found = []
    for vector in null_space(rows, size, filters, mechanism.builder.one):
        v, w = _twist(vector, directions, mechanism.builder.zero)
        turning = any(not entry.is_zero for entry in w)
        direction = _direction(mechanism.frames[frame].name, w if turning else v)
        found.append(_principle(root, rotation, v, w, direction))
    return sorted(found, key=lambda principle: not principle.linear)


def _frame(mechanism: Mechanism, crossing: Mapping[int, Wrench], directions: Directions) -> int:
    """A frame in which the crossing reactions are simple: that of the couples, else the inertial.

    Planar scenes are written in the inertial frame, whose axes they keep.
    """
    if len(directions.translation) < 3 or len(directions.rotation) < 3:
        return 0
    couples = [mechanism.reactions[i] for i in crossing if mechanism.reactions[i].at is None]
    forces = [mechanism.reactions[i] for i in crossing if mechanism.reactions[i].at is not None]
    for group in (couples, forces):
        frames = {frame for reaction in group for frame, _ in reaction.along}
        if len(frames) == 1:
            return frames.pop()
    return 0


def _tidied(filter_: Residues, vector: Sequence[Node]) -> Vector:
    return tuple(filter_.tidy(entry) for entry in vector)


def _twist(vector: Sequence[Node], directions: Directions, zero: Node) -> tuple[Vector, Vector]:
    count = len(directions.translation)
    v = dict(zip(directions.translation, vector[:count], strict=True))
    w = dict(zip(directions.rotation, vector[count:], strict=True))
    return tuple(v.get(i, zero) for i in range(3)), tuple(w.get(i, zero) for i in range(3))


def _direction(frame: str, vector: Vector) -> str:
    """A direction for people: an axis of its frame where it is one."""
    used = [i for i, entry in enumerate(vector) if not entry.is_zero]
    if len(used) == 1:
        sign = "-" if vector[used[0]].constant == -1 else ""
        return f"{sign}{frame}.{AXES[used[0]]}"
    program = vector[0].builder.program({"direction": vector})
    if written_size(program) > LARGEST_DIRECTION:
        return f"oblique in {frame}"
    return f"({', '.join(map(str, expressions(program)['direction']))})"


def _principle(
    root: int, rotation: Sequence[Vector], v: Vector, w: Vector, direction: str
) -> Principle:
    """A twist of a frame as a principle in inertial components."""
    if all(entry.is_zero for entry in w):
        zero = v[0].builder.zero
        none = (zero, zero, zero)
        return Principle(root, none, none, times(rotation, v), direction)
    square = dot(w, w)
    offset = tuple(entry / square for entry in cross(w, v))
    pitch = dot(v, w) / square
    axis = times(rotation, w)
    return Principle(root, times(rotation, offset), axis, scale(pitch, axis), direction)


def null_space(
    rows: Sequence[Sequence[Node]], size: int, filters: tuple[Residues, Residues], one: Node
) -> list[list[Node]]:
    """Basis of the vectors that every row annihilates, by fraction-free elimination.

    Where the constraints hold, if they do not at all states: no pivot is zero there.
    """
    anywhere, closed = filters
    work = [list(row) for row in rows]
    pivots: dict[int, int] = {}
    waiting = list(range(len(work)))
    while True:
        candidates = [
            (work[r][c].constant is None, c, r)
            for r in waiting
            for c in range(size)
            if c not in pivots and not closed.is_zero(work[r][c])
        ]
        if not candidates:
            break
        _, column, row = min(candidates)
        waiting.remove(row)
        pivots[column] = row
        for i, other in enumerate(work):
            head = other[column]
            if i == row or head.is_zero:
                continue
            number = work[row][column].constant
            keep, factor = (one, head / number) if number is not None else (work[row][column], head)
            work[i] = [anywhere.tidy(keep * other[k] - factor * work[row][k]) for k in range(size)]
    basis = []
    for free in (c for c in range(size) if c not in pivots):
        # Without the divisors of its entries, which vanish at some states.
        used = {c: r for c, r in pivots.items() if not work[r][free].is_zero}
        divisors = {c: work[r][c] for c, r in used.items() if work[r][c].constant is None}
        vector = [one.builder.zero] * size
        vector[free] = _product(one, divisors.values())
        for c, r in used.items():
            others = _product(one, (d for k, d in divisors.items() if k != c))
            scaled = -(work[r][free] * others)
            vector[c] = scaled if c in divisors else scaled / work[r][c]
        basis.append(vector)
    return basis


def _product(one: Node, factors: object) -> Node:
    total = one
    for factor in factors:  # type: ignore[attr-defined]
        total = total * factor
    return total


# ---------------------------------------------------------------------- choice


def _independent(
    mechanism: Mechanism,
    filter_: Residues,
    values: Sequence[Node],
    held: Sequence[Mapping[int, Node]],
    let_in: Mapping[int, Node],
) -> list[int]:
    """The first candidates of full rank, with the constraints; read from the ground outward.

    Raises
    ------
    SingularError
        When the candidates do not determine the motion.
    """
    size = len(mechanism.u)
    wanted = size + len(let_in) - len(mechanism.constraints)
    kept = list(range(len(values)))
    if len(values) > wanted:
        zero = mechanism.builder.zero
        forms = acceleration_forms(mechanism)
        rows = [[*row, *(zero for _ in let_in)] for row in coefficients(forms, mechanism.ud)]
        for row, reactions in zip(coefficients(values, mechanism.ud), held, strict=True):
            rows.append([*row, *(-reactions.get(j, zero) for j in let_in)])
        flat = filter_.values([entry for row in rows for entry in row])
        width = size + len(let_in)
        table = [flat[width * i : width * (i + 1)] for i in range(len(rows))]
        pivots = filter_.eliminate(table, width)
        kept = [i - len(forms) for i, _ in pivots if i >= len(forms)][:wanted]
    if len(kept) < wanted:
        raise SingularError(
            f"{mechanism.name}: the moving-point principles give {len(kept)} independent"
            f" equations where {wanted} are needed: are the reactions complete and the mass"
            " matrix regular? A loop may need more coordinates, and holonomic(...) constraints"
            " that name its reactions"
        )
    return list(reversed(kept))


def _words(mechanism: Mechanism, subtrees: Mapping[int, Subtree], principle: Principle) -> str:
    inside = mechanism.subtree(principle.root)
    free = "whole system"
    if len(inside) < len(mechanism.bodies):
        free = " + ".join(mechanism.bodies[i].name for i in inside)
    if principle.linear:
        return f"{free}: linear momentum along {principle.direction}"
    where = mechanism.points[subtrees[principle.root].point].name
    if any(not entry.is_zero for entry in principle.offset):
        where = f"a point of the axis beside {where}"
    pitch = any(not entry.is_zero for entry in principle.along)
    words = f"{free}: moment about {where}, axis {principle.direction}"
    return words + (", plus pitch times momentum" if pitch else "")
