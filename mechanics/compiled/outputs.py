"""The outputs of a mechanism as programs, from the cheapest way to its rows.

    inverse dynamics    tau = rows(q, u, u')                 Newton and Euler's recursion, or Kane's
    mass matrix         M = d tau / d u', or composite bodies
    forcing             f = -tau(q, u, 0)
    forward dynamics    M u' = f, or articulated bodies
    jacobians           M dx = -(d tau)(q, u, x)             x = u', along each entry of the state,
                        or the derivatives of articulated bodies

All rows are power-conjugate to u, so that they are equal and not only equivalent: which of them an
output is made from is a matter of operations alone. `mechanics.checks.programs.outputs` shows each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mechanics.errors import InputError
from mechanics.mechanism import Mechanism
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient, tangent
from mechanics.program.elimination import expand_solves
from mechanics.program.vectors import Vector, add, cross, scale, times, zeros
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import Link, joint_tree
from mechanics.recursions.local_equations import jacobian
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes.programs import chain, free_body, kane
from mechanics.routes.programs.lagrange import kinetic_energy
from mechanics.routes.programs.loads import potential
from mechanics.routes.programs.motion import body_motions, poses
from mechanics.routes.programs.rows import coefficients, remainder, substitute

Rows = tuple[Node, ...]
Outputs = dict[str, Sequence[Node]]


def kane_rows(mechanism: Mechanism) -> Rows:
    """Rows by partial velocities, inertial components."""
    return kane.derive(mechanism).values


def plain_recursion(mechanism: Mechanism) -> Rows:
    """Rows by recursion, with masses and inertias as they are declared."""
    return newton_euler.rows(mechanism, moments(mechanism))


def grouped_recursion(mechanism: Mechanism) -> Rows:
    """Rows by recursion, with masses and inertias grouped over the joints."""
    return newton_euler.rows(mechanism, grouped(mechanism))


ROWS: tuple[Callable[[Mechanism], Rows], ...] = (kane_rows, plain_recursion, grouped_recursion)
"""Ways to the same rows."""


@dataclass(frozen=True)
class Solvable:
    """M and f of rows that are linear in u'."""

    mass: Sequence[Sequence[Node]]
    forcing: Sequence[Node]

    def accelerations(self, mechanism: Mechanism) -> Rows:
        """u' of M u' = f."""
        return mechanism.builder.solve(self.mass, self.forcing, symmetric=True)


def solvable(mechanism: Mechanism, rows: Rows) -> Solvable:
    """M and f of rows."""
    mass = coefficients(rows, mechanism.ud)
    rest = remainder(mechanism.builder, rows, mechanism.ud)
    return Solvable(mass, [-entry for entry in rest])


def cheapest_rows(mechanism: Mechanism) -> Rows:
    """The way to the rows that takes the fewest operations; what follows from them does, too."""
    ways = [rows(mechanism) for rows in ROWS]
    return min(ways, key=lambda rows: mechanism.builder.program({"rows": rows}).count)


def programs(mechanism: Mechanism) -> dict[str, Program]:
    """The programs of a tree of bodies by name; see the outputs of `mechanics.compiled.Model`.

    Raises
    ------
    InputError
        For a mechanism with constraints or friction, whose rows hold unknown reactions.
    """
    if mechanism.constraints or mechanism.frictions:
        raise InputError(
            f"{mechanism.name}: constraints and friction are compiled from equations that SymPy"
            " writes out, and these are too long: derive a smaller scene"
        )
    rows = cheapest_rows(mechanism)
    system = solvable(mechanism, rows)
    trees = joint_trees(mechanism)
    masses = [system.mass, *(mass_matrix(mechanism, links) for links in trees)]
    solutions = [Solvable(mass, system.forcing).accelerations(mechanism) for mass in masses]
    bias = [-entry for entry in system.forcing]
    solutions += [forward_dynamics(mechanism, links, bias) for links in trees]
    found: dict[str, Outputs] = {
        "forward_dynamics": _cheapest(mechanism, [{"ud": solution} for solution in solutions]),
        "mass_matrix": _cheapest(mechanism, [{"mass_matrix": _flat(mass)} for mass in masses]),
        "forcing": {"forcing": system.forcing},
        "inverse_dynamics": {"forces": rows},
        "energy": energies(mechanism),
        "momenta": momenta(mechanism),
        "coordinate_rates": {"qd": mechanism.q_rates},
        "jacobians": _jacobians_of_trees(mechanism, trees) or jacobians(mechanism, rows, system),
        "reactions": reactions(mechanism, system),
    }
    return {name: mechanism.builder.program(outputs) for name, outputs in found.items() if outputs}


def joint_trees(mechanism: Mechanism) -> list[tuple[Link, ...]]:
    """The tree of joints with one freedom each, masses as declared and grouped; none for others."""
    trees = (joint_tree(mechanism, ways(mechanism)) for ways in (moments, grouped))
    return [links for links in trees if links is not None]


def _cheapest(mechanism: Mechanism, candidates: Sequence[Outputs]) -> Outputs:
    """The candidate of the fewest operations, linear systems written out; the first of several."""
    return min(
        candidates, key=lambda outputs: expand_solves(mechanism.builder.program(outputs)).count
    )


def _jacobians_of_trees(mechanism: Mechanism, trees: Sequence[tuple[Link, ...]]) -> Outputs:
    found: list[Outputs] = []
    for links in trees:
        both = jacobian(mechanism, links, (*mechanism.q, *mechanism.u))
        n = len(mechanism.q)
        found.append(
            {
                "ud_q": [entry for row in both for entry in row[:n]],
                "ud_u": [entry for row in both for entry in row[n:]],
            }
        )
    return _cheapest(mechanism, found) if found else {}


def _flat(matrix: Sequence[Sequence[Node]]) -> list[Node]:
    return [entry for row in matrix for entry in row]


def jacobians(mechanism: Mechanism, rows: Rows, system: Solvable) -> Outputs:
    """du'/dq and du'/du, row by row.

    One solution of M serves every column: differentiating through it costs more.
    """
    build = mechanism.builder
    accelerations = system.accelerations(mechanism)
    values = dict(zip(mechanism.ud, accelerations, strict=True))
    found: Outputs = {}
    for name, group in (("ud_q", mechanism.q), ("ud_u", mechanism.u)):
        columns = []
        for entry in group:
            slopes = tangent(rows, {entry: build.one})
            right = [-slope for slope in substitute(build, slopes, values)]
            columns.append(build.solve(system.mass, right, symmetric=True))
        found[name] = [column[i] for i in range(len(rows)) for column in columns]
    return found


def energies(mechanism: Mechanism) -> Outputs:
    """Kinetic, potential and total energy, in J, in q and u."""
    kinetic = kinetic_energy(mechanism)
    if mechanism.u != mechanism.qd:
        speeds = dict(zip(mechanism.qd, mechanism.q_rates, strict=True))
        (kinetic,) = substitute(mechanism.builder, [kinetic], speeds)
    stored = potential(mechanism, poses(mechanism))
    return {"kinetic": [kinetic], "potential": [stored], "total": [kinetic + stored]}


def momenta(mechanism: Mechanism) -> Outputs:
    """Linear momentum, angular momentum about the origin, and dT/du."""
    none = zeros(mechanism.builder)
    linear: Vector = none
    angular: Vector = none
    motions = chain.motions(mechanism)
    for body, motion in zip(mechanism.bodies, body_motions(mechanism, motions), strict=True):
        momentum = scale(body.mass, motion.centre.velocity)
        linear = add(linear, momentum)
        angular = add(angular, cross(motion.centre.position, momentum))
        if motion.turning is not None and motion.inertia is not None:
            angular = add(angular, times(motion.inertia, motion.turning.omega))
    (kinetic,) = energies(mechanism)["kinetic"]
    generalized = gradient([kinetic], [1], mechanism.u)
    return {"linear": linear, "angular": angular, "generalized": generalized}


def reactions(mechanism: Mechanism, system: Solvable) -> Outputs:
    """All reactions as functions of the state, by procedure (i), in the order of the scene."""
    if not mechanism.reactions:
        return {}
    told = free_body.derive(mechanism).reactions
    values = dict(zip(mechanism.ud, system.accelerations(mechanism), strict=True))
    nodes = [told[reaction.name] for reaction in mechanism.reactions]
    return {"reactions": substitute(mechanism.builder, nodes, values)}
