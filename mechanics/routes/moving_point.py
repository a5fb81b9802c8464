"""Procedure (ii): free bodies and moment centres chosen so that the reactions drop out.

    sum tau_B = dH_B/dt + v_B x P                  (1)     about a moving point B
    sum F . e = dP/dt . e                          (2)     along a direction e

v_B is the velocity of the geometric point B, not of a material one. Candidates are the outboard
subtrees of the tree of bodies; `mechanics.routes.twists` finds, for each, the principles in which
the reactions that cross its boundary do not enter. Velocities come from
`mechanics.kinematics.chain`.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Matrix, Symbol, zeros

from mechanics.equations import Equations
from mechanics.errors import SingularError
from mechanics.exact import canonical, independent_rows
from mechanics.kinematics import chain
from mechanics.kinematics.constraints import constraint_rows
from mechanics.kinematics.directions import used_directions
from mechanics.kinematics.motion import BodyMotion, PointMotion, inertia_matrix
from mechanics.routes.common import System, assemble
from mechanics.routes.moving_point_steps import derivation_steps
from mechanics.routes.twists import Principle, principles
from mechanics.scene import Scene
from mechanics.scene.actions import Action, applied_actions, by_body, moment, unit_reactions
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.topology import multipliers, tree


@dataclass(frozen=True)
class Balance:
    """One principle written out for one free body, every term projected on its direction.

    Attributes
    ----------
    principle : Principle
    momentum : Expr
        H_B or P.
    momentum_rate : Expr
        dH_B/dt or dP/dt.
    moving_term : Expr
        v_B x P; zero for a linear principle.
    applied : Expr
        Moment about B, or force, of the loads.
    coefficients : dict of Symbol to Expr
        What a unit of each kept reaction contributes.
    """

    principle: Principle
    momentum: Expr
    momentum_rate: Expr
    moving_term: Expr
    applied: Expr
    coefficients: dict[Symbol, Expr]

    @property
    def value(self) -> Expr:
        """Rates minus loads; equal to the kept reactions' part."""
        return self.momentum_rate + self.moving_term - self.applied


def derive(scene: Scene) -> Equations:
    """Equations of motion from principles in which the reactions do not enter."""
    balances = tuple(chosen_balances(scene))
    kept = multipliers(scene)
    matrix, bias = constraint_rows(scene)
    system, balances = _full_rank(scene, balances, assemble(scene, balances, kept))
    return Equations(
        scene,
        "moving_point",
        system.mass,
        system.forcing,
        kept,
        system.reaction_matrix,
        matrix,
        bias,
        conjugate=False,
        chosen=tuple(balance.principle.words for balance in balances),
        steps=derivation_steps(scene, balances, system),
    )


def chosen_balances(scene: Scene) -> Iterator[Balance]:
    """Every candidate principle of every outboard subtree, from the leaves inward."""
    bodies = tree(scene)
    kept = multipliers(scene)
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    loads = by_body(applied_actions(scene))
    reactions = unit_reactions(scene)
    every = [action for group in loads.values() for action in group]
    every += [action for pair in reactions.values() for action in pair]
    directions = used_directions(tuple(motions.values()), every)
    spins = {name: _spin(scene, motion) for name, motion in motions.items()}
    for name in reversed(bodies.order):
        inside = bodies.subtree(name)
        crossing = _crossing(reactions, inside)
        stopped = {symbol: unit for symbol, unit in crossing.items() if symbol not in kept}
        let_in = {symbol: unit for symbol, unit in crossing.items() if symbol in kept}
        for principle in principles(scene, inside, stopped, directions):
            yield _balance(
                scene,
                principle,
                [(motions[body], spins[body]) for body in inside],
                [load for body in inside for load in loads.get(body, [])],
                let_in,
            )


def _crossing(
    reactions: Mapping[Symbol, Sequence[Action]], inside: Sequence[str]
) -> dict[Symbol, Action]:
    """What each reaction that crosses the boundary of a free body does to it, per unit."""
    found = {}
    for symbol, pair in reactions.items():
        own = [action for action in pair if action.body in inside]
        # Both ends inside: equal and opposite. A single action is the ground's.
        if len(own) == 1:
            found[symbol] = own[0]
    return found


def _spin(scene: Scene, motion: BodyMotion) -> tuple[Matrix, Matrix]:
    """(H_C, dH_C/dt) of one body, inertial components."""
    if not motion.turns:
        return zeros(3, 1), zeros(3, 1)
    momentum = inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    return momentum, rates(momentum, rate_table(scene))


def _balance(
    scene: Scene,
    principle: Principle,
    parts: Sequence[tuple[BodyMotion, tuple[Matrix, Matrix]]],
    loads: Sequence[Action],
    let_in: Mapping[Symbol, Action],
) -> Balance:
    """Equation (1) along the axis plus pitch times (2), or (2) alone."""
    centre = _centre(scene, principle)
    sums = _sums(centre, parts, loads)
    axis, along = principle.axis, principle.along

    def projected(pick: str) -> Expr:
        return Add(
            *(axis[i] * sums[f"moment {pick}"][i] for i in range(3) if axis[i] != 0),
            *(along[i] * sums[f"force {pick}"][i] for i in range(3) if along[i] != 0),
        )

    return Balance(
        principle,
        projected("momentum"),
        projected("rate"),
        Add(*(axis[i] * sums["moving"][i] for i in range(3) if axis[i] != 0)),
        projected("applied"),
        {
            symbol: canonical(axis.dot(moment(unit, centre.position)) + along.dot(unit.force))
            for symbol, unit in let_in.items()
        },
    )


def _sums(
    centre: PointMotion,
    parts: Sequence[tuple[BodyMotion, tuple[Matrix, Matrix]]],
    loads: Sequence[Action],
) -> dict[str, Matrix]:
    """Momenta about the moving point, their rates by the product rule, loads and v_B x P."""
    about, speed = centre.position, centre.velocity
    force = {"momentum": zeros(3, 1), "rate": zeros(3, 1), "applied": zeros(3, 1)}
    turn = {"momentum": zeros(3, 1), "rate": zeros(3, 1), "applied": zeros(3, 1)}
    for motion, (spin, growth) in parts:
        mass, c = motion.body.mass, motion.centre
        arm, arm_rate = c.position - about, c.velocity - speed
        force["momentum"] += mass * c.velocity
        force["rate"] += mass * c.acceleration
        turn["momentum"] += spin + mass * arm.cross(c.velocity)
        turn["rate"] += growth + mass * (arm_rate.cross(c.velocity) + arm.cross(c.acceleration))
    for load in loads:
        force["applied"] += load.force
        turn["applied"] += moment(load, about)
    sums = {f"force {pick}": value for pick, value in force.items()}
    sums |= {f"moment {pick}": value for pick, value in turn.items()}
    sums["moving"] = speed.cross(force["momentum"])
    return sums


def _centre(scene: Scene, principle: Principle) -> PointMotion:
    """Motion of the geometric moment centre: a point of the scene plus an offset."""
    base = chain.point_motion(scene, principle.point)
    if principle.offset == zeros(3, 1):
        return base
    table = rate_table(scene)
    first = rates(principle.offset, table)
    return PointMotion(
        base.position + principle.offset,
        base.velocity + first,
        base.acceleration + rates(first, table),
    )


def _full_rank(
    scene: Scene, balances: tuple[Balance, ...], system: System
) -> tuple[System, tuple[Balance, ...]]:
    """The first rows of full rank, in the order of the candidates; 0 = 0 is among the dropped.

    Raises
    ------
    SingularError
        When the candidates do not determine the motion.
    """
    wanted = len(scene.u)
    left = system.mass.row_join(system.reaction_matrix)
    rows = independent_rows(left.tolist())[:wanted]
    if len(rows) < wanted:
        raise SingularError(
            f"{scene.name}: the moving-point principles give {len(rows)} independent equations"
            f" for {wanted} speeds: are the reactions complete and the mass matrix regular?"
        )
    # Read from the ground outward, as one would write them down.
    order = list(reversed(rows))
    picked = System(
        system.mass.extract(order, list(range(system.mass.cols))),
        system.forcing.extract(order, [0]),
        system.reaction_matrix.extract(order, list(range(system.reaction_matrix.cols))),
    )
    return picked, tuple(balances[row] for row in order)
