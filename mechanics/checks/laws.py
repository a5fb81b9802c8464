"""Laws that hold whatever the route: kinematics, energy, mass matrix, loads against potentials.

v, omega, a, alpha by differentiation = by composition along the chain
M = sum over bodies of m J_v^T J_v + J_w^T I J_w          (rows power-conjugate to u)
sum F . dv/du = - (dV/dq) N                               (each conservative load)
"""

from collections.abc import Sequence

from sympy import Add, Expr, Matrix, Symbol

from mechanics.checks.agreement import Pairs, proof_pays
from mechanics.checks.metric import metric
from mechanics.equations import Equations
from mechanics.exact import Arithmetic, Finding, collect_linear, decide
from mechanics.kinematics import chain, differentiate
from mechanics.kinematics.manifold import settle
from mechanics.kinematics.motion import BodyMotion
from mechanics.scene import Scene
from mechanics.scene.actions import Action, elongation, load_actions, unit_reactions
from mechanics.scene.loads import CONSERVATIVE, Damper
from mechanics.scene.potential import load_potential
from mechanics.scene.rates import rate, rate_table


def check_kinematics(scene: Scene) -> Finding:
    """Both kinematics modules give the same motions."""

    def experiment(a: Arithmetic) -> Pairs:
        pairs: Pairs = []
        both = zip(differentiate.body_motions(scene), chain.body_motions(scene), strict=True)
        for one, two in both:
            for left, right in zip(_parts(one), _parts(two), strict=True):
                pairs += [(a.value(x), a.value(y)) for x, y in zip(left, right, strict=True)]
        return pairs

    return decide("kinematics: differentiated = composed", experiment, try_normal=proof_pays(scene))


def _parts(motion: BodyMotion) -> tuple[Matrix, ...]:
    centre = motion.centre
    return (
        centre.velocity,
        centre.acceleration,
        motion.angular_velocity,
        motion.angular_acceleration,
    )


def check_potentials(scene: Scene) -> tuple[Finding, ...]:
    """Each conservative load: its force is minus the gradient of its potential."""
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    found = []
    for load in scene.loads:
        if not isinstance(load, CONSERVATIVE):
            continue
        power = Add(*(power_of(motions[a.body], a) for a in load_actions(scene, load)))
        stored = load_potential(scene, load)
        released = -rate(
            stored, {q: scene.coordinate_rates[qd] for q, qd in zip(scene.q, scene.qd, strict=True)}
        )
        subject = f"load {load.name}: force = -gradient of potential"
        lefts = [*collect_linear(power, scene.u)[0]]
        rights = [*collect_linear(released, scene.u)[0]]
        found.append(_equal(scene, subject, lefts, rights))
    return tuple(found)


def check_dampers(scene: Scene) -> tuple[Finding, ...]:
    """Each damper: its generalized forces are -c d' (dd'/du), so that it takes out c d'^2."""
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    found = []
    for load in scene.loads:
        if isinstance(load, Damper):
            actions = load_actions(scene, load)
            distance, _ = elongation(scene, load)
            speed = rate(distance, rate_table(scene))
            tension = scene.plain(load.coefficient, load.name) * speed
            given = [
                Add(*(_generalized(motions[action.body], action, u) for action in actions))
                for u in scene.u
            ]
            taken = [-tension * speed.diff(u) for u in scene.u]
            found.append(_equal(scene, f"load {load.name}: power = -c rate^2", given, taken))
    return tuple(found)


def check_ideal(scene: Scene) -> tuple[Finding, ...]:
    """Each reaction: a unit of it has no power on the velocities that the scene admits."""
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    found = []
    for symbol, pair in unit_reactions(scene).items():
        power = Add(*(power_of(motions[action.body], action) for action in pair))
        # Prescribed motions may do work on a moving support; the ideal part is linear in u.
        coefficients, _ = collect_linear(power, scene.u)
        found.append(_powerless(scene, f"reaction {symbol}: no power", coefficients))
    return tuple(found)


def _generalized(motion: BodyMotion, action: Action, u: Symbol) -> Expr:
    """F . dv/du + tau . domega/du."""
    arm = action.at - motion.centre.position
    omega = motion.angular_velocity.diff(u)
    velocity = motion.centre.velocity.diff(u) + omega.cross(arm)
    return action.force.dot(velocity) + action.couple.dot(omega)


def _powerless(scene: Scene, subject: str, coefficients: Sequence[Expr]) -> Finding:
    def experiment(a: Arithmetic) -> Pairs:
        settle(scene, a, virtual=True)
        total = a.rational(0)
        for factor, u in zip(coefficients, scene.u, strict=True):
            total = total + a.value(factor) * a.value(u)
        return [(total, a.rational(0))]

    return decide(subject, experiment, try_normal=proof_pays(scene))


def check_mass_matrix(equations: Equations) -> Finding:
    """M of a route whose rows are power-conjugate to u is the metric of the kinetic energy.

    This shows M symmetric, and positive semidefinite for masses and inertias that are.
    """
    scene = equations.scene
    wanted = metric(scene, chain.body_motions(scene))
    subject = f"{equations.route}: M = sum of J^T m J"
    return _equal(scene, subject, list(equations.mass), list(wanted))


def power_of(motion: BodyMotion, action: Action) -> Expr:
    """F . v + tau . omega of one action on one body, in W."""
    arm = action.at - motion.centre.position
    velocity = motion.centre.velocity + motion.angular_velocity.cross(arm)
    return action.force.dot(velocity) + action.couple.dot(motion.angular_velocity)


def _equal(scene: Scene, subject: str, lefts: Sequence[Expr], rights: Sequence[Expr]) -> Finding:
    def experiment(a: Arithmetic) -> Pairs:
        return [(a.value(x), a.value(y)) for x, y in zip(lefts, rights, strict=True)]

    return decide(subject, experiment, try_normal=proof_pays(scene))
