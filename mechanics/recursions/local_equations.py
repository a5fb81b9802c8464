"""Derivatives of forward dynamics, from the equations of each joint and link.

    (alpha, a) = those of the parent, at the root, + velocity terms                       (1)
    (N, F) = inertia (alpha + e u', a) + velocity terms + (N, F) of the children          (2)
    tau = e . N  or  e . F                                                                (3)

These are linear in accelerations and forces. Along a coordinate, a speed, an input or a parameter
they change as the same equations with other right sides: the derivatives of (1) to (3) with
accelerations and forces kept, among them those of the axes e, where a parameter turns a joint. What
is kept stands as inputs of its own while (1) to (3) are differentiated, so that only what changes
there is seen, and articulated bodies, which do not change, solve for each column.

The implicit function theorem on the recursion, instead of on the mass matrix as in Carpentier and
Mansard, Analytical derivatives of rigid body dynamics algorithms, Robotics: Science and Systems,
2018.
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.interpret import include
from mechanics.program.vectors import Vector, add, cross, dot, scale, times
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import Articulated, Motion, total
from mechanics.recursions.frames import acceleration_matrix, collect, express, negated
from mechanics.recursions.joints import Link, rotated
from mechanics.recursions.pseudo_inertia import Moments, spin


def jacobian(
    mechanism: Mechanism, links: Sequence[Link], variables: Sequence[Node]
) -> tuple[tuple[Node, ...], ...]:
    """Derivatives of u' by variables among q, u, inputs and parameters; a row for each speed.

    Parameters
    ----------
    links : sequence of Link
        Of `joint_tree`.
    """
    equations = _LocalEquations(mechanism, links)
    columns = [equations.column(variable) for variable in variables]
    build, width = mechanism.builder, len(variables)
    program = build.program({"all": [entry for column in columns for entry in column]})
    kept = {name: node for name, node in equations.kept.items() if name in program.inputs}
    flat = include(build, program, kept)["all"]
    size = len(links)
    rows = {link.coordinate: flat[k::size] for k, link in enumerate(links)}
    assert all(len(row) == width for row in rows.values())
    return tuple(rows[i] for i in range(size))


class _LocalEquations:
    """Equations (1) to (3) at the motion that they determine."""

    def __init__(self, mechanism: Mechanism, links: Sequence[Link]) -> None:
        self.mechanism, self.links = mechanism, links
        self.system = system = Articulated(mechanism, links)
        self.kept: dict[str, Node] = {}
        build, order = mechanism.builder, range(len(links))
        unloaded = replace(mechanism, fields=())
        forces = newton_euler.rows(unloaded, Moments())
        tau = [-forces[link.coordinate] for link in links]
        pull = [collect(mechanism, load.acceleration, 0) for load in mechanism.fields]
        self.ground: Motion = (system.none, negated(add(system.none, *pull)))
        self.omegas: list[Vector] = []
        added = [self.velocity_motion(k) for k in order]
        first = [
            total(system.outwards(k, self.ground), added[k])
            if links[k].parent == GROUND
            else added[k]
            for k in order
        ]
        quick = [self.velocity_load(k) for k in order]
        rates, final = system.solve(tau, first, quick)
        motions = [self.keep(f"motion {k}", final[k]) for k in order]
        totals = [total(system.body(k, final[k]), quick[k]) for k in order]
        for k in reversed(order):
            if links[k].parent != GROUND:
                handed = system.inwards(k, totals[k])
                totals[links[k].parent] = total(totals[links[k].parent], handed)
        own = [self.own_motion(k, self.keep_scalar(f"rate {k}", rates[k])) for k in order]
        self.arrivals = [
            total(first[k], own[k])
            if links[k].parent == GROUND
            else total(system.outwards(k, motions[links[k].parent]), added[k], own[k])
            for k in order
        ]
        self.loads = [total(system.body(k, motions[k]), quick[k]) for k in order]
        carried = [self.keep(f"load {k}", totals[k]) for k in order]
        self.tau = [tau[k] - self.along(k, carried[k]) for k in order]
        self.handed = [
            system.inwards(k, carried[k])
            if links[k].parent != GROUND
            else (system.none, system.none)
            for k in order
        ]
        self.build = build

    def keep(self, name: str, motion: Motion) -> Motion:
        """Inputs in the place of a motion or load; constants stay."""
        found = [
            tuple(
                self.keep_scalar(f"{kind} {name} {axis}", node)
                for axis, node in zip("xyz", vector, strict=True)
            )
            for kind, vector in zip(("angular", "linear"), motion, strict=True)
        ]
        return found[0], found[1]

    def keep_scalar(self, name: str, node: Node) -> Node:
        """An input in the place of a value; constants stay."""
        if node.constant is not None:
            return node
        self.kept[name] = node
        return self.mechanism.builder.input(name)

    def own_motion(self, k: int, rate: Node) -> Motion:
        """e u' of equation (1)."""
        own = scale(rate, self.system.axes[k])
        return (own, self.system.none) if self.links[k].turning else (self.system.none, own)

    def along(self, k: int, load: Motion) -> Node:
        """Right side of equation (3)."""
        return dot(self.system.axes[k], load[0 if self.links[k].turning else 1])

    def velocity_motion(self, k: int) -> Motion:
        """Velocity terms of equation (1); keeps the angular velocity."""
        link, system = self.links[k], self.system
        outer, home = system.outer(k), system.homes[k]
        turning = system.none if link.parent == GROUND else self.omegas[link.parent]
        arm = system.arm(k)
        a = cross(turning, cross(turning, arm))
        a = express(self.mechanism, a, outer, home)
        carried = express(self.mechanism, turning, outer, home) if link.carried else system.none
        own = scale(self.mechanism.u[link.coordinate], system.axes[k])
        if link.turning:
            self.omegas.append(add(carried, own))
            return cross(carried, own), a
        self.omegas.append(carried)
        return system.none, add(a, scale(2, cross(carried, own)))

    def velocity_load(self, k: int) -> Motion:
        """Velocity terms of equation (2)."""
        link, system, omega = self.links[k], self.system, self.omegas[k]
        U = acceleration_matrix(omega, system.none)
        second = rotated(self.mechanism, link.second, link.frame, system.homes[k])
        return spin(U, omega, system.none, second), times(U, system.firsts[k])

    def column(self, variable: Node) -> list[Node]:
        """Derivatives of u' by one variable, by links."""
        order = range(len(self.links))
        flat = list(self.tau)
        for motion in (*self.arrivals, *self.loads, *self.handed):
            flat += [*motion[0], *motion[1]]
        rates = tangent(flat, {variable: self.build.one})
        size = len(self.links)
        pieces = [
            (tuple(rates[at : at + 3]), tuple(rates[at + 3 : at + 6]))
            for at in range(size, len(rates), 6)
        ]
        arrivals, loads = pieces[:size], pieces[size : 2 * size]
        for k in order:
            if self.links[k].parent != GROUND:
                parent = self.links[k].parent
                loads[parent] = total(loads[parent], pieces[2 * size + k])
        found, _ = self.system.solve(rates[:size], arrivals, loads)
        return found
