"""Procedure (ii): free bodies and moment centres chosen so that the reactions drop out.

    sum tau_B = dH_B/dt + v_B x P                  (1)     about a moving point B
    sum F . e = dP/dt . e                          (2)     along a direction e

v_B is the velocity of the geometric point B, not of a material one. Candidates are the outboard
subtrees of the tree of bodies; `mechanics.routes.twists` finds, for each, the principles in which
the reactions that cross its boundary do not enter. Reactions that close a loop of bodies are let
in, and eliminated by algebra where no constraint names them. Velocities come from
`mechanics.kinematics.chain`.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from sympy import Dummy, Matrix, Symbol, sign, zeros

from mechanics.equations import Equations, Matrices
from mechanics.errors import SingularError
from mechanics.kinematics.chain import Chain, body_motions, point_motion
from mechanics.kinematics.constraints import constraint_rows
from mechanics.kinematics.directions import used_directions
from mechanics.kinematics.manifold import on_the_manifold
from mechanics.kinematics.motion import BodyMotion, PointMotion, inertia_matrix
from mechanics.routes.balance import Balance, Part, dot
from mechanics.routes.common import System, assemble
from mechanics.routes.elimination import Row, Solved, solve_for
from mechanics.routes.moving_point_steps import derivation_steps
from mechanics.routes.twists import Principle, principles
from mechanics.scene import Scene
from mechanics.scene.actions import Action, acting_reactions, applied_actions, by_body, moment
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.topology import loop_reactions, multipliers, tree
from mechanics.symbolic import canonical, independent_rows


def derive(scene: Scene) -> Equations:
    """Equations of motion from principles in which the reactions do not enter."""
    kept = multipliers(scene)
    loops = loop_reactions(scene, tree(scene))
    matrix, bias = constraint_rows(scene)
    balances, system = _first_of_full_rank(scene, candidates(scene), (*kept, *loops), matrix)
    solved: list[Solved] = []
    if loops:
        rows = [Row(b.principle.words, b.value, dict(b.coefficients)) for b in balances]
        solved = solve_for(rows, loops)
        system = assemble(scene, rows, kept)
    return Equations(
        scene,
        "moving_point",
        lambda: Matrices(system.mass, system.forcing, system.reaction_matrix, matrix, bias),
        kept,
        conjugate=False,
        chosen=tuple(balance.principle.words for balance in balances),
        explain=partial(derivation_steps, balances, solved),
        of_bodies=True,
    )


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


def _first_of_full_rank(
    scene: Scene, found: Iterator[Balance], kept: Sequence[Symbol], constraints: Matrix
) -> tuple[tuple[Balance, ...], System]:
    """The first candidates of full rank, together with the constraints and where these hold.

    With constraint rows there are as many as speeds and reactions that are let in. One that reads
    0 = 0 is among the dropped: the moment of a slider about the pin in its centre,
    which is beside it only where the loop is open.

    Raises
    ------
    SingularError
        When the candidates do not determine the motion.
    """
    size = len(scene.u)
    wanted = size + len(kept) - constraints.rows
    balances: list[Balance] = []
    rows: list[Matrix] = []
    independent: list[int] = []
    fixed = constraints.row_join(zeros(constraints.rows, len(kept))).tolist()
    closed = on_the_manifold(scene)
    for balance in found:
        system = assemble(scene, [balance], kept)
        balances.append(balance)
        rows.append(system.mass.row_join(system.reaction_matrix).row_join(system.forcing))
        if len(rows) >= wanted:
            every = [*fixed, *(row[:-1] for row in rows)]
            kept_rows = independent_rows(every, closed)
            independent = [i - len(fixed) for i in kept_rows if i >= len(fixed)]
            if len(independent) >= wanted:
                break
    if len(independent) < wanted:
        raise SingularError(
            f"{scene.name}: the moving-point principles give {len(independent)} independent"
            f" equations where {wanted} are needed: are the reactions complete and the mass"
            " matrix regular? A loop may need more coordinates, and holonomic(...) constraints"
            " that name its reactions"
        )
    # Read from the ground outward, as one would write them down.
    order = list(reversed(independent))
    whole = Matrix.vstack(*(rows[i] for i in order))
    system = System(whole[:, :size], whole[:, -1], whole[:, size:-1])
    return tuple(balances[i] for i in order), system
