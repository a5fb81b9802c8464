"""Laws that hold whatever the route: kinematics, loads against potentials, mass matrix, energy.

v, omega, a, alpha by differentiation = by composition along the chain
sum F . dv/du = -(dV/dq) N                               each conservative load
a unit of a reaction has no power:  sum F . dv/du + tau . domega/du = 0
M = dr/du' = d2T/du2                                     rows r power-conjugate to u
u . r = d(T + V)/dt - power of the loads without a potential              where nothing is driven
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from mechanics.checks.programs.energy import kinetic
from mechanics.checks.programs.statements import equal
from mechanics.kernel import Finding
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient, tangent
from mechanics.program.vectors import dot
from mechanics.routes.programs import chain, differentiate
from mechanics.routes.programs.lagrange import virtual_power
from mechanics.routes.programs.loads import Wrench, conservative, other, potential, unit_reactions
from mechanics.routes.programs.motion import Motions
from mechanics.routes.programs.rows import Rows, coefficients, substitute


def check_kinematics(mechanism: Mechanism) -> Finding:
    """Both kinematics give the same motions of mass centres and of bodies' frames."""
    left, right = (
        _all_motions(mechanism, kinematics.motions(mechanism))
        for kinematics in (differentiate, chain)
    )
    return equal("kinematics: differentiated = composed", mechanism, left, right)


def _all_motions(mechanism: Mechanism, motions: Motions) -> list[Node]:
    found: list[Node] = []
    for body in mechanism.bodies:
        centre = motions.points[body.centre]
        found += [*centre.velocity, *centre.acceleration]
        if body.frame is not None:
            turning = motions.frames[body.frame]
            found += [*turning.omega, *turning.alpha]
    return found


def check_potential(mechanism: Mechanism) -> Finding | None:
    """The forces of the conservative loads are minus the gradient of their potential."""
    motions = chain.motions(mechanism)
    wrenches = conservative(mechanism, motions.poses)
    if not wrenches:
        return None
    stored = potential(mechanism, motions.poses)
    slopes = gradient([stored], [1], mechanism.q)
    released = [-slope for slope in gradient(mechanism.q_rates, slopes, mechanism.u)]
    forces = virtual_power(mechanism, motions, wrenches)
    return equal("loads: force = -gradient of potential", mechanism, forces, released)


def check_ideal(mechanism: Mechanism) -> Iterator[Finding]:
    """Each reaction: a unit of it has no power on the velocities that the scene admits."""
    motions = chain.motions(mechanism)
    for reaction, pair in zip(
        mechanism.reactions, unit_reactions(mechanism, motions.poses), strict=True
    ):
        power = virtual_power(mechanism, motions, pair)
        subject = f"reaction {reaction.name}: no power"
        yield equal(subject, mechanism, power, [0] * len(power))


def check_mass_matrix(mechanism: Mechanism, rows: Rows) -> Finding:
    """M of rows that are power-conjugate to u is the metric of the kinetic energy.

    This shows M symmetric, and positive semidefinite for masses and inertias that are.
    """
    momenta = gradient([kinetic(mechanism)], [1], mechanism.u)
    metric = coefficients(momenta, mechanism.u)
    mass = coefficients(rows.values, mechanism.ud)
    left, right = ([entry for row in matrix for entry in row] for matrix in (mass, metric))
    return equal(f"{rows.route}: M = d2T/du2", mechanism, left, right)


def is_driven(mechanism: Mechanism) -> bool:
    """Whether geometry or constraints change with time by themselves."""
    motions = differentiate.motions(mechanism)
    still = dict.fromkeys(mechanism.u, mechanism.builder.zero)
    velocities = [entry for point in motions.points for entry in point.velocity]
    velocities += [entry for frame in motions.frames for entry in frame.omega]
    return any(not v.is_zero for v in substitute(mechanism.builder, velocities, still))


def check_energy(mechanism: Mechanism, rows: Rows) -> Finding:
    """u . r is the rate of T + V less the power of the loads that have no potential.

    Rows power-conjugate to u, of a mechanism that is not driven.
    """
    motions = differentiate.motions(mechanism)
    energy = kinetic(mechanism) + potential(mechanism, motions.poses)
    (growth,) = tangent([energy], mechanism.rates)
    power = _power(mechanism, motions, other(mechanism, motions))
    work = dot(mechanism.u, rows.values)
    subject = f"{rows.route}: rate of energy = power of the loads"
    return equal(subject, mechanism, [work], [growth - power])


def _power(mechanism: Mechanism, motions: Motions, wrenches: Sequence[Wrench]) -> Node:
    """sum F . v + tau . omega, in W."""
    total = mechanism.builder.zero
    for wrench in wrenches:
        body = mechanism.bodies[wrench.body]
        centre = motions.points[body.centre]
        total = total + dot(wrench.force, centre.velocity)
        if body.frame is not None:
            omega = motions.frames[body.frame].omega
            total = total + dot(wrench.moment(centre.position), omega)
    return total
