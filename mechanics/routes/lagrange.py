"""Lagrange's equations, in the speeds of the scene.

    T = sum m v^2 / 2 + omega . I omega / 2
    d/dt (dT/dq') - dT/dq + dV/dq = Q + A^T lambda                          (1)
    N^T (1),   q' = N u + n,   q'' = d/dt (N u + n)                         (2)
    Q_u = sum F . dv/du + T . domega/du     of all that has no potential    (3)

The rows (2) are power-conjugate to u. Friction enters with the reaction N that presses as an
unknown, which the equation of an opened joint gives: all that is outboard of N is let move by s
along it, and (1) is written for s at s = s' = 0.
"""

from collections.abc import Iterator, Mapping, Sequence

from mechanics.equations import Rows
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import Motions, PointMotion, poses
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.vectors import Vector, add, dot, scale, times, transpose
from mechanics.routes import loads
from mechanics.routes.elimination import without_pressing
from mechanics.routes.loads import Wrench, other, potential
from mechanics.routes.rows import acceleration_forms, substitute


def derive(mechanism: Mechanism) -> Rows:
    """Rows power-conjugate to u, with a multiplier for every constraint."""
    build = mechanism.builder
    conservative = _conservative(mechanism)
    if mechanism.u != mechanism.qd:
        second = tangent(mechanism.q_rates, mechanism.rates)
        speeds = dict(zip(mechanism.qd, mechanism.q_rates, strict=True))
        values = speeds | dict(zip(mechanism.qdd, second, strict=True))
        conservative = substitute(build, conservative, values)
        # N^T: weights of q' on u.
        conservative = tuple(gradient(mechanism.q_rates, conservative, mechanism.u))
    motions = differentiate.motions(mechanism)
    pressing = {
        load.reaction: build.input(mechanism.reactions[load.reaction].name)
        for load in mechanism.frictions
    }
    wrenches = [*other(mechanism, motions), *pressing_loads(mechanism, motions, pressing)]
    forces = virtual_power(mechanism, motions, wrenches)
    rows = [row - force for row, force in zip(conservative, forces, strict=True)]
    multipliers = tuple(build.input(f"lambda{i + 1}") for i in range(len(mechanism.constraints)))
    if multipliers:
        pulls = gradient(acceleration_forms(mechanism), multipliers, mechanism.ud)
        rows = [row - pull for row, pull in zip(rows, pulls, strict=True)]
    every = [*wrenches, *loads.conservative(mechanism, motions.poses)] if pressing else []
    opened = [_opened(mechanism, motions, index, every) for index in pressing]
    names = [reaction.name for reaction in mechanism.reactions]
    kept, pressed = without_pressing(mechanism.filters, rows, opened, pressing, names)
    reactions = {names[index]: value for index, value in pressed.items()}
    return Rows("lagrange", kept, multipliers, conjugate=not pressing, reactions=reactions)


def kinetic_energy(mechanism: Mechanism) -> Node:
    """T in q and q', in J."""
    half, total = mechanism.builder.one / 2, mechanism.builder.zero
    for mass, velocity, spin in kinetic_parts(mechanism):
        total = total + half * mass * dot(velocity, velocity)
        total = total + half * spin
    return total


def kinetic_parts(mechanism: Mechanism) -> Iterator[tuple[Node, Vector, Node]]:
    """m, v and omega . I omega of every body, in q and q'."""
    where = poses(mechanism)
    table = mechanism.coordinate_rates
    for body in mechanism.bodies:
        velocity = tuple(tangent(where.positions[body.centre], table))
        if body.frame is None or body.inertia is None:
            yield body.mass, velocity, mechanism.builder.zero
            continue
        rotation = where.rotations[body.frame]
        flat = tangent([entry for row in rotation for entry in row], table)
        columns = transpose(rotation)
        turning = transpose([flat[3 * k : 3 * k + 3] for k in range(3)])
        # [omega]x = R^T dR/dt in the body's frame, where its inertia is constant.
        omega = (
            dot(columns[2], turning[1]),
            dot(columns[0], turning[2]),
            dot(columns[1], turning[0]),
        )
        yield body.mass, velocity, dot(omega, times(body.inertia, omega))


def _conservative(mechanism: Mechanism) -> tuple[Node, ...]:
    """d/dt (dL/dq') - dL/dq in q, q' and q''."""
    energy = kinetic_energy(mechanism) - potential(mechanism, poses(mechanism))
    gradients = gradient([energy], [1], (*mechanism.q, *mechanism.qd))
    n = len(mechanism.q)
    rates = tangent(gradients[n:], mechanism.coordinate_rates)
    return tuple(rate - slope for rate, slope in zip(rates, gradients[:n], strict=True))


def pressing_loads(
    mechanism: Mechanism, motions: Motions, unknown: Mapping[int, Node]
) -> list[Wrench]:
    """Reactions that press, with their friction, as loads."""
    units = loads.acting_reactions(mechanism, motions.poses) if unknown else []
    return [
        Wrench(unit.name, unit.body, unit.at, scale(size, unit.force), unit.couple)
        for index, size in unknown.items()
        for unit in units[index]
    ]


def _opened(mechanism: Mechanism, motions: Motions, index: int, wrenches: Sequence[Wrench]) -> Node:
    """Lagrange's equation of the motion s that opens a joint along a reaction, at s = s' = 0."""
    build = mechanism.builder
    reaction = mechanism.reactions[index]
    along = motions.poses.vector(reaction.along)
    s, rate, gain = (build.input(f"opening {order} of {reaction.name}") for order in range(3))
    table = mechanism.rates | {s: rate, rate: gain}
    inside = set(mechanism.subtree(reaction.on))
    energy, force = build.zero, build.zero
    for i in sorted(inside):
        body = mechanism.bodies[i]
        position = add(motions.points[body.centre].position, scale(s, along))
        velocity = tangent(position, table)
        energy = energy + body.mass * dot(velocity, velocity) / 2
    for wrench in wrenches:
        if wrench.body in inside:
            force = force + dot(wrench.force, along)
    momentum, slope = gradient([energy], [1], (rate, s))
    (growth,) = tangent([momentum], table)
    closed = dict.fromkeys((s, rate, gain), build.zero)
    return substitute(build, [growth - slope - force], closed)[0]


def virtual_power(mechanism: Mechanism, motions: Motions, wrenches: list[Wrench]) -> list[Node]:
    """sum F . dv/du + T . domega/du; forces act at their points."""
    velocities: list[Node] = []
    weights: list[Node] = []
    for wrench in wrenches:
        body = mechanism.bodies[wrench.body]
        centre: PointMotion = motions.points[body.centre]
        velocities += centre.velocity
        weights += wrench.force
        if body.frame is not None:
            velocities += motions.frames[body.frame].omega
            weights += wrench.moment(centre.position)
    if not velocities:
        return [mechanism.builder.zero] * len(mechanism.u)
    return gradient(velocities, weights, mechanism.u)
