"""Energy: what the loads without a potential do is what the system gains.

    d(T + V)/dt = sum over loads without potential (F . v + tau . omega) + sum_j R_j w_j

w_j is the power of a unit of reaction j, for supports and constraints whose motion is prescribed.
Other ideal reactions do no work.
"""

from collections.abc import Mapping

from sympy import Add, Expr, S, Symbol

from mechanics.checks.agreement import Pairs, proof_pays, solve
from mechanics.checks.laws import power_of
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.exact import Arithmetic, Finding, collect_linear, decide
from mechanics.kinematics import differentiate
from mechanics.kinematics.constraints import velocity_forms
from mechanics.kinematics.manifold import settle
from mechanics.kinematics.motion import BodyMotion, inertia_matrix
from mechanics.scene import Scene
from mechanics.scene.actions import carrier_of, frictions, load_actions, unit_reactions
from mechanics.scene.loads import CONSERVATIVE, Load, Spring
from mechanics.scene.potential import load_potential
from mechanics.scene.rates import rate, rate_table, rates
from mechanics.scene.topology import multipliers


def check_energy(equations: Equations, support: Equations | None = None) -> Finding:
    """The rate of T + V, at the accelerations of a route, is the power of the other loads.

    Parameters
    ----------
    equations : Equations
        Of the route in question.
    support : Equations, optional
        Of a route that gives reactions: needed where a support moves in a prescribed way, and for
        friction where the route in question does not tell what presses.

    Raises
    ------
    InputError
        When a load depends on a reaction that neither tells.
    """
    scene = equations.scene
    values = (dict(support.reactions) if support is not None else {}) | dict(equations.reactions)
    pressing = _pressing(scene, values)
    motions = {m.body.name: m for m in differentiate.body_motions(scene)}
    table = rate_table(scene)
    stored = [load for load in scene.loads if _stores(scene, load)]
    growth = Add(
        *(_kinetic_rate(scene, motion) for motion in motions.values()),
        *(rate(load_potential(scene, load), table) for load in stored),
    )
    power = Add(
        *(
            power_of(motions[action.body], action)
            for load in scene.loads
            if load not in stored
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
        for symbol in pressing:
            a.assign(symbol, a.value(values[symbol]))
        total = a.value(power)
        for symbol, left in driving.items():
            total = total + a.value(values.get(symbol, symbol)) * a.value(left)
        return [(a.value(growth), total)]

    subject = f"{equations.route}: rate of energy = power of the loads"
    return decide(subject, experiment, try_normal=proof_pays(scene))


def _pressing(scene: Scene, values: Mapping[Symbol, Expr]) -> list[Symbol]:
    """The reactions that friction depends on."""
    found = [Symbol(load.normal, real=True) for load in frictions(scene)]
    if lost := [symbol.name for symbol in found if symbol not in values]:
        raise InputError(
            f"{scene.name}: friction depends on {', '.join(lost)}, which these equations do not"
            " tell: pass those of free_body as support="
        )
    return found


def _stores(scene: Scene, load: Load) -> bool:
    """Whether a load has a potential that only the coordinates change.

    Work goes into a spring where its support is moved by hand, too: there its force counts.
    """
    if not isinstance(load, CONSERVATIVE):
        return False
    given = {symbol for symbol in rate_table(scene) if symbol not in {*scene.q, *scene.u}}
    if isinstance(load, Spring):
        for point, carrier in ((load.first, load.by), (load.second, load.on)):
            moved = scene.position(point).free_symbols & given
            if moved and carrier_of(scene, load, point, carrier) is None:
                return False
    return not load_potential(scene, load).free_symbols & given


def _driving(scene: Scene, motions: Mapping[str, BodyMotion]) -> dict[Symbol, Expr]:
    """For each reaction of a support or constraint that moves by itself the power of a unit."""
    still = dict.fromkeys(scene.u, S.Zero)
    moved = any(form.xreplace(still) != 0 for form in velocity_forms(scene))
    found = {}
    for symbol, pair in unit_reactions(scene).items():
        power = Add(*(power_of(motions[action.body], action) for action in pair))
        _, left = collect_linear(power, scene.u)
        if left != 0 or (moved and symbol in multipliers(scene)):
            found[symbol] = power
    return found


def _kinetic_rate(scene: Scene, motion: BodyMotion) -> Expr:
    """dT/dt of one body: m v . a + omega . (d(I omega)/dt), as omega . (I' omega) cancels."""
    speed, gain = motion.centre.velocity, motion.centre.acceleration
    linear = motion.body.mass * Add(*(v * a for v, a in zip(speed, gain, strict=True)))
    if not motion.turns:
        return linear
    spin = inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    return linear + motion.angular_velocity.dot(rates(spin, rate_table(scene)))
