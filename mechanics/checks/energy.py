"""Energy: what the loads without a potential do is what the system gains.

    d(T + V)/dt = sum over loads without potential (F . v + tau . omega) + sum_j R_j w_j

w_j is the power of a unit of reaction j that is left when every speed is zero: that of a support
whose motion is prescribed. Other ideal reactions do no work.
"""

from collections.abc import Mapping

from sympy import Add, Expr, Symbol

from mechanics.checks.agreement import Pairs, proof_pays, solve
from mechanics.checks.laws import power_of
from mechanics.checks.manifold import settle
from mechanics.equations import Equations
from mechanics.exact import Arithmetic, Finding, collect_linear, decide
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import BodyMotion, inertia_matrix
from mechanics.scene import Scene
from mechanics.scene.actions import load_actions, unit_reactions
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import potential
from mechanics.scene.rates import rate, rate_table, rates


def check_energy(equations: Equations, support: Equations | None = None) -> Finding:
    """The rate of T + V, at the accelerations of a route, is the power of the other loads.

    Parameters
    ----------
    equations : Equations
        Of the route in question.
    support : Equations, optional
        Of a route that gives reactions: needed where a support moves in a prescribed way.
    """
    scene = equations.scene
    motions = {m.body.name: m for m in differentiate.body_motions(scene)}
    growth = Add(
        *(_kinetic_rate(scene, motion) for motion in motions.values()),
        rate(potential(scene), rate_table(scene)),
    )
    power = Add(
        *(
            power_of(motions[action.body], action)
            for load in scene.loads
            if not isinstance(load, CONSERVATIVE)
            for action in load_actions(scene, load)
        )
    )
    driving = _driving(scene, motions)

    def experiment(a: Arithmetic) -> Pairs:
        settle(scene, a)
        known = dict(zip(equations.unknowns, solve(a, equations), strict=True))
        if driving and support is not None:
            # Multipliers by the support's names; at the same accelerations, if the routes agree.
            known |= dict(zip(support.unknowns, solve(a, support), strict=True)) | known
        for symbol, number in known.items():
            a.assign(symbol, number)
        total = a.value(power)
        values = dict(support.reactions) if support is not None else {}
        for symbol, left in driving.items():
            total = total + a.value(values.get(symbol, symbol)) * a.value(left)
        return [(a.value(growth), total)]

    subject = f"{equations.route}: rate of energy = power of the loads"
    return decide(subject, experiment, try_normal=proof_pays(scene))


def _driving(scene: Scene, motions: Mapping[str, BodyMotion]) -> dict[Symbol, Expr]:
    """For each reaction of a moving support the power of a unit of it at zero speeds."""
    found = {}
    for symbol, pair in unit_reactions(scene).items():
        power = Add(*(power_of(motions[action.body], action) for action in pair))
        _, left = collect_linear(power, scene.u)
        if left != 0:
            found[symbol] = left
    return found


def _kinetic_rate(scene: Scene, motion: BodyMotion) -> Expr:
    """dT/dt of one body: m v . a + omega . (d(I omega)/dt), as omega . (I' omega) cancels."""
    speed, gain = motion.centre.velocity, motion.centre.acceleration
    linear = motion.body.mass * Add(*(v * a for v, a in zip(speed, gain, strict=True)))
    if not motion.turns:
        return linear
    spin = inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    return linear + motion.angular_velocity.dot(rates(spin, rate_table(scene)))
