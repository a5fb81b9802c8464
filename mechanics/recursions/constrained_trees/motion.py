"""M y = f of a tree of joints with rotors, by the recursion of Newton and Euler at y = 0.

    omega = R^T omega_parent + e u,    alpha = R^T alpha_parent + R^T omega_parent x e u     (1)
    a = R^T (a_parent + U_parent c) + 2 omega x e u                   the last of a slide    (2)
    F = m a + U h - loads,             N = spin(E) + h x a - couples                         (3)
    N = omega x (e J Omega)            of a rotor on its carrier, Omega its total rate       (4)

in the frame of each link, U c = alpha x c + omega x (omega x c), and -g the acceleration of the
ground. Loads are taken inwards to the root of the parent; each joint takes e . N or e . F.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from mechanics.mechanism import GROUND
from mechanics.program.builder import Node
from mechanics.program.vectors import Matrix, Vector, add, cross, dot, scale, times, zeros
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.constrained_trees.tree import Rotor, Tree
from mechanics.recursions.frames import acceleration_matrix, collect, negated
from mechanics.recursions.loads import loads
from mechanics.recursions.pseudo_inertia import spin

Load = tuple[Vector, Vector]
"""A couple and a force about the root of a link, in its frame."""


@dataclass(frozen=True)
class Motion:
    """Equations (1) and (2) by links; a rotor has none of its own."""

    omegas: Mapping[int, Vector]
    alphas: Mapping[int, Vector]
    matrices: Mapping[int, Matrix]
    accelerations: Mapping[int, Vector]
    ground: Vector

    def bias(self, rotor: Rotor) -> Node:
        """e . alpha of the carrier of a rotor."""
        return self.alphas[rotor.carrier][rotor.place]

    def total(self, tree: Tree, rotor: Rotor) -> Node:
        """The angular velocity of a rotor about its axis."""
        rate = tree.mechanism.u[rotor.coordinate]
        return rate + self.omegas[rotor.carrier][rotor.place]


def motion(tree: Tree) -> Motion:
    """The motion of every link."""
    mechanism, none = tree.mechanism, zeros(tree.mechanism.builder)
    pull = [collect(mechanism, load.acceleration, 0) for load in mechanism.fields]
    ground = negated(add(none, *pull))
    omegas: dict[int, Vector] = {}
    alphas: dict[int, Vector] = {}
    matrices: dict[int, Matrix] = {}
    places: dict[int, Vector] = {}
    for k, link in enumerate(tree.links):
        if k in tree.rotors:
            continue
        rate = scale(mechanism.u[link.coordinate], link.axis)
        carried, alpha, a, source = none, none, ground, 0
        if link.parent != GROUND:
            p, source = link.parent, tree.links[link.parent].frame
            a = add(places[p], times(matrices[p], link.offset))
            if link.carried:
                carried = tree.express(omegas[p], source, link.frame)
                alpha = tree.express(alphas[p], source, link.frame)
        a = tree.express(a, source, link.frame)
        if link.turning:
            alpha = add(alpha, cross(carried, rate))
            carried = add(carried, rate)
        else:
            a = add(a, scale(2, cross(carried, rate)))
        omegas[k], alphas[k], places[k] = carried, alpha, a
        matrices[k] = acceleration_matrix(carried, alpha)
    return Motion(omegas, alphas, matrices, places, ground)


def taken_inwards(
    tree: Tree, waiting: Mapping[int, Load], steady: tuple[Vector, int] | None = None
) -> list[Node]:
    """What each joint takes of loads on links.

    Parameters
    ----------
    steady : (Vector, int), optional
        The force, where it is one alone, in a frame in which it is short.
    """
    rows = [tree.mechanism.builder.zero] * len(tree.mechanism.u)
    left = dict(waiting)
    for k in reversed(range(len(tree.links))):
        if k not in left:
            continue
        link, (couple, force) = tree.links[k], left.pop(k)
        rows[link.coordinate] = dot(link.axis, couple if link.turning else force)
        if link.parent == GROUND:
            continue
        home = tree.links[link.parent].frame
        vector, source = (force, link.frame) if steady is None else steady
        force = tree.express(vector, source, home)
        moment = cross(link.offset, force)
        if link.carried:
            moment = add(tree.express(couple, link.frame, home), moment)
        left[link.parent] = _sum(left.get(link.parent), (moment, force))
    return rows


def _sum(one: Load | None, two: Load) -> Load:
    return two if one is None else (add(one[0], two[0]), add(one[1], two[1]))


def matrix(tree: Tree) -> tuple[tuple[Node, ...], ...]:
    """M, rows and columns in the order of u."""
    places = {k: i for i, k in enumerate(k for k in range(len(tree.links)) if k not in tree.rotors)}
    links = [
        replace(tree.links[k], parent=places.get(tree.links[k].parent, GROUND)) for k in places
    ]
    rows = [list(row) for row in mass_matrix(tree.mechanism, links)]
    for rotor in tree.rotors.values():
        rows[rotor.coordinate][rotor.coordinate] = rotor.inertia
    return tuple(map(tuple, rows))


def forcing(tree: Tree, moving: Motion) -> list[Node] | None:
    """f; None where a load acts on what turns about the axis of a rotor."""
    none, zero = zeros(tree.mechanism.builder), tree.mechanism.builder.zero
    waiting: dict[int, Load] = {}
    for k in moving.omegas:
        link, U, a = tree.links[k], moving.matrices[k], moving.accelerations[k]
        force = add(scale(link.mass, a), times(U, link.first))
        own = spin(U, moving.omegas[k], moving.alphas[k], link.second)
        waiting[k] = add(own, cross(link.first, a)), force
    for rotor in tree.rotors.values():
        momentum = scale(rotor.inertia * moving.total(tree, rotor), rotor.axis)
        couple = cross(moving.omegas[rotor.carrier], momentum)
        waiting[rotor.carrier] = _sum(waiting[rotor.carrier], (couple, none))
    forces, couples = loads(tree.mechanism)
    own_rows = {k: zero for k in tree.rotors}
    for push in forces:
        spot = tree.joints.spots.get(push.point)
        spot = None if spot is None else spot if spot.link == GROUND else tree.carried(spot)
        if spot is None:
            return None
        if spot.link != GROUND:
            vector = tree.express(negated(push.vector), push.frame, tree.links[spot.link].frame)
            load = cross(spot.offset, vector), vector
            waiting[spot.link] = _sum(waiting[spot.link], load)
    for twist in couples:
        for on, sign in ((twist.on, -1), (twist.by, 1)):
            k = GROUND if on == GROUND else tree.joints.carriers[tree.joints.rigid[on]]
            if k == GROUND:
                continue
            carrier = tree.rotors[k].carrier if k in tree.rotors else k
            vector = tree.express(twist.vector, twist.frame, tree.links[carrier].frame)
            vector = scale(sign, vector)
            if k in tree.rotors:
                place = tree.rotors[k].place
                own_rows[k] = own_rows[k] + vector[place]
                vector = without(vector, place)
            waiting[carrier] = _sum(waiting[carrier], (vector, none))
    rows = taken_inwards(tree, waiting)
    for k, row in own_rows.items():
        rows[tree.rotors[k].coordinate] = row
    return [-row for row in rows]


def without(vector: Vector, place: int) -> Vector:
    """The vector less its component along one axis."""
    zero = vector[0].builder.zero
    return tuple(zero if k == place else entry for k, entry in enumerate(vector))
