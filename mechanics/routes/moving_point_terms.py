"""Principles in which the reactions do not enter, term by term in SymPy: what blame looks at.

    sum tau_B = dH_B/dt + v_B x P                  (1)     about a moving point B
    sum F . e = dP/dt . e                          (2)     along a direction e

v_B is the velocity of the geometric point B, not of a material one. Candidates are the outboard
subtrees of the tree of bodies; `mechanics.routes.twists` finds, for each, the principles in which
the reactions that cross its boundary do not enter. Velocities come from
`mechanics.kinematics.textbook.chain`.
"""

from collections.abc import Iterator, Mapping, Sequence

from sympy import Dummy, Symbol, sign, zeros

from mechanics.kinematics.textbook.chain import Chain, body_motions, point_motion
from mechanics.kinematics.textbook.directions import used_directions
from mechanics.kinematics.textbook.motion import BodyMotion, PointMotion, inertia_matrix
from mechanics.routes.balance import Balance, Part, dot
from mechanics.routes.twists import Principle, principles
from mechanics.scene import Scene
from mechanics.scene.actions import Action, acting_reactions, applied_actions, by_body, moment
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.topology import loop_reactions, multipliers, tree
from mechanics.symbolic import canonical


def candidates(scene: Scene) -> Iterator[Balance]:
    """Every candidate principle of every outboard subtree, from the leaves inward."""
    bodies = tree(scene)
    kept = {*multipliers(scene), *loop_reactions(scene, bodies)}
    chain = Chain(scene)
    motions = {motion.body.name: motion for motion in body_motions(scene, chain)}
    loads = by_body(applied_actions(scene))
    reactions = acting_reactions(scene)
    every = [action for group in loads.values() for action in group]
    every += [action for pair in reactions.values() for action in pair]
    directions = used_directions(tuple(motions.values()), every)
    parts = {name: _part(scene, motion) for name, motion in motions.items()}
    for name in reversed(bodies.order):
        inside = bodies.subtree(name)
        crossing = _crossing(reactions, inside)
        stopped = {symbol: unit for symbol, unit in crossing.items() if symbol not in kept}
        let_in = {symbol: unit for symbol, unit in crossing.items() if symbol in kept}
        for principle in principles(scene, inside, stopped, directions):
            yield _balance(
                chain,
                principle,
                tuple(parts[body] for body in inside),
                tuple(load for body in inside for load in loads.get(body, [])),
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


def _part(scene: Scene, motion: BodyMotion) -> Part:
    if not motion.turns:
        return Part(motion, zeros(3, 1), zeros(3, 1))
    spin = inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    return Part(motion, spin, rates(spin, rate_table(scene)))


def _balance(
    chain: Chain,
    principle: Principle,
    parts: tuple[Part, ...],
    loads: tuple[Action, ...],
    let_in: Mapping[Symbol, Action],
) -> Balance:
    """Equation (1) along the axis plus pitch times (2), or (2) alone."""
    centre = _centre(chain, principle)
    held = {
        symbol: canonical(
            dot(principle.axis, moment(unit, centre.position)) + dot(principle.along, unit.force)
        )
        for symbol, unit in let_in.items()
    }
    return Balance(principle, centre, parts, loads, held)


def _centre(chain: Chain, principle: Principle) -> PointMotion:
    """Motion of the geometric moment centre: a point of the scene plus an offset."""
    base = point_motion(chain, principle.point)
    if principle.offset == zeros(3, 1):
        return base
    table = rate_table(chain.scene)
    # Friction turns the reaction, and moves its axis, where sliding changes its sign; not between.
    held = {jump: Dummy(str(jump), real=True) for jump in principle.offset.atoms(sign)}
    back = {stand_in: jump for jump, stand_in in held.items()}
    offset = principle.offset.xreplace(held)
    first = rates(offset, table)
    second = rates(first, table)
    return PointMotion(
        base.position + principle.offset,
        base.velocity + first.xreplace(back),
        base.acceleration + second.xreplace(back),
    )
