"""Laws that hold whatever the route: kinematics, loads against potentials, mass matrix, energy.

v, omega, a, alpha by differentiation = by composition along the chain
sum F . dv/du = -(dV/dq) N                               each conservative load
a unit of a reaction has no power:  sum F . dv/du + tau . domega/du = 0
M = dr/du' = d2T/du2                                     rows r power-conjugate to u
u . r = d(T + V)/dt - power of the loads without a potential              where nothing is driven
dT/dt = power of the loads + sum_j R_j w_j,    w_j the power of a unit of reaction j    elsewhere

What is said of reactions holds on the velocities that the constraints admit.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from mechanics.checks.agreement import Derived
from mechanics.checks.energy import kinetic
from mechanics.checks.statements import each_or_all, equal
from mechanics.equations import Rows
from mechanics.kernel import Finding
from mechanics.kinematics import chain, differentiate
from mechanics.kinematics.motion import Motions
from mechanics.mechanism import Mechanism, inputs_of
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.vectors import dot
from mechanics.routes.lagrange import virtual_power
from mechanics.routes.loads import (
    Wrench,
    acting_reactions,
    applied,
    conservative,
    elongation,
    other,
    potential,
    unit_reactions,
)
from mechanics.routes.rows import (
    coefficients,
    remainder,
    substitute,
    velocity_forms,
)


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


def check_potentials(mechanism: Mechanism) -> Iterator[Finding]:
    """Each conservative load: its forces are minus the gradient of its potential."""
    for name, alone in by_load(mechanism):
        motions = chain.motions(alone)
        wrenches = conservative(alone, motions.poses)
        if wrenches:
            slopes = gradient([potential(alone, motions.poses)], [1], alone.q)
            released = [-slope for slope in gradient(alone.q_rates, slopes, alone.u)]
            forces = virtual_power(alone, motions, wrenches)
            subject = f"load {name}: force = -gradient of potential"
            yield equal(subject, alone, forces, released)


def check_dampers(mechanism: Mechanism) -> Iterator[Finding]:
    """Each damper: its generalized forces are -c d' (dd'/du), so that it takes out c d'^2."""
    for name, alone in by_load(mechanism):
        for line in alone.lines:
            if line.coefficient.is_zero:
                continue
            motions = chain.motions(alone)
            forces = virtual_power(alone, motions, other(alone, motions))
            distance, _ = elongation(motions.poses, line)
            (rate,) = tangent([distance], alone.rates)
            slopes = gradient([rate], [-(line.coefficient * rate)], alone.u)
            yield equal(f"load {name}: power = -c rate^2", alone, forces, slopes)


def check_frictions(mechanism: Mechanism) -> Iterator[Finding]:
    """Each friction takes out mu N |v|, a loss where the reaction presses."""
    motions = chain.motions(mechanism)
    for load in mechanism.frictions:
        pure, leaning = (
            units(mechanism, motions.poses)[load.reaction]
            for units in (unit_reactions, acting_reactions)
        )
        power = _power(mechanism, motions, leaning) - _power(mechanism, motions, pure)
        lost = -(load.coefficient * abs(load.sliding))
        yield equal(f"load {load.name}: power = -mu N |sliding|", mechanism, [power], [lost])


def by_load(mechanism: Mechanism) -> Iterator[tuple[str, Mechanism]]:
    """Each load's name, and the mechanism with that load alone."""
    kinds = ("fields", "lines", "pushes", "torsions")
    none: Any = ()
    bare = replace(mechanism, fields=none, lines=none, pushes=none, torsions=none, frictions=none)
    for kind in kinds:
        for load in getattr(mechanism, kind):
            alone: dict[str, Any] = {kind: (load,)}
            yield load.name, replace(bare, **alone)


def check_ideal(mechanism: Mechanism, filter_: Residues) -> Iterator[Finding]:
    """Each reaction: a unit of it has no power on the velocities that the scene admits.

    With constraints A u + a = 0 its power is a combination of their rows:

        sum F . dv/du + tau . domega/du = c^T A,      c from columns where A is regular

    `filter_` is that of the states at which the constraints hold.
    """
    motions = chain.motions(mechanism)
    table = coefficients(velocity_forms(mechanism), mechanism.u)
    columns = _regular_columns(table, filter_)
    sides = []
    for pair in unit_reactions(mechanism, motions.poses):
        power = virtual_power(mechanism, motions, pair)
        sides.append((power, _combination(mechanism, table, columns, power)))
    subjects = [f"reaction {reaction.name}: no power" for reaction in mechanism.reactions]
    yield from each_or_all("reactions: no power", subjects, mechanism, sides)


def _regular_columns(table: Sequence[Sequence[Node]], filter_: Residues) -> list[int]:
    """Columns of the constraints' matrix that are independent where the constraints hold."""
    transposed = [filter_.values(column) for column in zip(*table, strict=True)]
    return [i for i, _ in filter_.eliminate(transposed, len(table))] if table else []


def _combination(
    mechanism: Mechanism,
    table: Sequence[Sequence[Node]],
    columns: Sequence[int],
    power: Sequence[Node],
) -> Sequence[Node | int]:
    """The combination of the rows of the table that has the power's entries in the columns."""
    if not columns or all(entry.is_zero for entry in power):
        return [0] * len(power)
    square = [[table[k][i] for k in range(len(table))] for i in columns]
    factors = mechanism.builder.solve(square, [power[i] for i in columns])
    return [dot(factors, [row[i] for row in table]) for i in range(len(power))]


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
    """Whether geometry, a constraint or what is stored in loads changes with time by itself."""
    motions = differentiate.motions(mechanism)
    stored = inputs_of([potential(mechanism, motions.poses)])
    if stored & set(mechanism.given_rates):
        return True
    still = dict.fromkeys(mechanism.u, mechanism.builder.zero)
    velocities = [entry for point in motions.points for entry in point.velocity]
    velocities += [entry for frame in motions.frames for entry in frame.omega]
    velocities += velocity_forms(mechanism)
    return any(not v.is_zero for v in substitute(mechanism.builder, velocities, still))


def check_energy(mechanism: Mechanism, rows: Rows) -> Finding:
    """u . r is the rate of T + V less the power of the loads that have no potential.

    Rows power-conjugate to u, of a mechanism that is not driven; constraints do no work, so that
    their reactions are left out.
    """
    work, growth = energy_rates(mechanism, rows)
    subject = f"{rows.route}: rate of energy = power of the loads"
    return equal(subject, mechanism, [work], [growth])


def energy_rates(mechanism: Mechanism, rows: Rows) -> tuple[Node, Node]:
    """u . r, and the rate of T + V less the power of the loads that have no potential, in W."""
    motions = differentiate.motions(mechanism)
    energy = kinetic(mechanism) + potential(mechanism, motions.poses)
    (growth,) = tangent([energy], mechanism.rates)
    power = _power(mechanism, motions, other(mechanism, motions))
    work = dot(mechanism.u, remainder(mechanism.builder, rows.values, rows.multipliers))
    return work, growth - power


def check_energy_balance(route: Derived, support: Derived) -> Finding:
    """The rate of T is the power of loads and reactions, those of what moves by itself among them.

    A support that is moved, a constraint that moves and friction do work by reactions; those that
    do none drop out.

    Parameters
    ----------
    route : Derived
        Whose accelerations are put in.
    support : Derived
        Of procedure (i), which tells the reactions.
    """
    mechanism, build = route.mechanism, route.mechanism.builder
    motions = differentiate.motions(mechanism)
    (growth,) = tangent([kinetic(mechanism)], mechanism.rates)
    power = _power(mechanism, motions, applied(mechanism, motions))
    anywhere, _ = mechanism.filters
    units = acting_reactions(mechanism, motions.poses)
    for reaction, pair in zip(mechanism.reactions, units, strict=True):
        work = _power(mechanism, motions, pair)
        if not anywhere.is_zero(work):
            known = support.rows.reactions.get(reaction.name)
            power = power + (build.input(reaction.name) if known is None else known) * work
    values = dict(zip(support.unknowns, support.solution, strict=True))
    values |= dict(zip(route.unknowns, route.solution, strict=True))
    left, right = substitute(build, [growth, power], values)
    subject = f"{route.rows.route}: rate of energy = power of the loads"
    return equal(subject, mechanism, [left], [right])


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
