"""Rows of constraints, composed along the links, from the reactions that maintain them.

    c = sum +-E . v_P,      v_P = v_C + omega x d,      d = CP                                (1)
    c' = row y - b,         row = what the joints take of the force E at P                   (2)
    b = -sum +-E . (a_C + alpha x d + omega x d'),      y = 0, without gravity                (3)

A reaction has the power of its constraint, so that the row is its generalized force. E are fixed
in the inertial frame; those of one point are rotated together, their rows with them:

    E = (a, n x a, n)       on a rotor of axle e, |d| = r, e . d = 0, a = (e x d)/r, a . n = 0   (4)

The condition along a holds the rotor's total rate times r, the one along n no heading. In a plane,
E are the axes of the last frame on the way that are in it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.mechanism import GROUND, Constraint, Reaction, inputs_of
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.interpret import Nodes
from mechanics.program.operations import ARITY, OPERATIONS
from mechanics.program.program import reachable
from mechanics.program.residues import Residues
from mechanics.program.vectors import Vector, add, cross, dot, scale, times, zeros
from mechanics.recursions.constrained_trees.motion import Motion, taken_inwards, without
from mechanics.recursions.constrained_trees.tree import AXES, Rotor, Tree
from mechanics.recursions.frames import collect, negated
from mechanics.recursions.loads import span

Direction = tuple[Vector, int]
"""A unit vector in a frame."""


@dataclass(frozen=True)
class Arm:
    """Where a body touches.

    Attributes
    ----------
    link : int
        No rotor.
    rotor : Rotor or None
        The body, where it is one.
    offset : Vector
        Of the body's centre C from the root of the link.
    arm, rate : Vector
        d, and d' in the frame of the link.
    sign : int
        -1 of the body that the reaction acts on with the opposite.
    """

    link: int
    rotor: Rotor | None
    offset: Vector
    arm: Vector
    rate: Vector
    sign: int


@dataclass(frozen=True)
class Contact:
    """Constraints of one point.

    Attributes
    ----------
    members : tuple of int
        The constraints.
    declared : tuple of Vector
        E as they are declared, in the inertial frame.
    rotated : tuple of Direction
        E of the rows.
    rows : tuple of tuple of Node
    bias : tuple of Node
        b.
    """

    members: tuple[int, ...]
    declared: tuple[Vector, ...]
    rotated: tuple[Direction, ...]
    rows: tuple[tuple[Node, ...], ...]
    bias: tuple[Node, ...]


def contacts(tree: Tree, moving: Motion, constraints: Sequence[Constraint]) -> list[Contact] | None:
    """All constraints; None where one is not maintained by a force in a fixed direction."""
    mechanism = tree.mechanism
    groups: dict[tuple[int, int, int], list[tuple[int, Reaction]]] = {}
    for i, constraint in enumerate(constraints):
        if len(constraint.reactions) != 1:
            return None
        reaction = mechanism.reactions[constraint.reactions[0]]
        if reaction.parts or reaction.at is None:
            return None
        groups.setdefault((reaction.on, reaction.by, reaction.at), []).append((i, reaction))
    composing, found = _Composing(tree, moving), []
    for (on, by, at), members in groups.items():
        declared = tuple(collect(mechanism, own.along, 0) for _, own in members)
        sides = [(body, sign) for body, sign in ((on, 1), (by, -1)) if body != GROUND]
        arms = [composing.arm(body, at, sign) for body, sign in sides]
        if any(inputs_of(e) & set(mechanism.rates) for e in declared):
            return None
        known = [arm for arm in arms if arm is not None]
        if len(known) < len(arms):
            return None
        found.append(composing.contact(tuple(i for i, _ in members), declared, known))
    return found


@dataclass(frozen=True)
class _Composing:
    tree: Tree
    moving: Motion

    @property
    def zero(self) -> Node:
        return self.tree.mechanism.builder.zero

    def frame(self, link: int) -> int:
        return self.tree.links[link].frame

    # ------------------------------------------------------------------ arms

    def arm(self, body: int, at: int, sign: int) -> Arm | None:
        """None where the body is on no link, or d is given in a frame that moves otherwise."""
        tree, mechanism = self.tree, self.tree.mechanism
        spot = tree.body(body)
        rotor = None
        if spot is None or spot.link == GROUND:
            return None
        if spot.link in tree.rotors:
            rotor, spot = tree.rotors[spot.link], tree.carried(spot)
            if spot is None:
                return None
        steps = span(mechanism, mechanism.bodies[body].centre, at)
        home, moves = self.frame(spot.link), set(mechanism.rates)
        rates, units = dict(mechanism.rates), {}
        for frame in {frame for frame, _ in steps}:
            for k in AXES:
                unit = tuple(self.zero + 1 if i == k else self.zero for i in AXES)
                units[frame, k] = tree.express(unit, frame, home)
                if inputs_of(units[frame, k]) & moves:
                    if frame != 0:
                        return None
                    turning = cross(units[frame, k], self.moving.omegas[spot.link])
                    rates |= dict(zip(units[frame, k], turning, strict=True))
        own = [entry for unit in units.values() for entry in unit]
        total = zeros(mechanism.builder)
        for frame, column in steps:
            for k, entry in enumerate(column):
                size = rewritten(entry, own)
                total = add(total, scale(size, units[frame, k]))
        filter_ = Residues(mechanism.builder)
        total = tuple(self.zero if filter_.is_zero(entry) else entry for entry in total)
        return Arm(spot.link, rotor, spot.offset, total, tuple(tangent(total, rates)), sign)

    # ------------------------------------------------------------------ directions

    def contact(
        self, members: tuple[int, ...], declared: tuple[Vector, ...], arms: Sequence[Arm]
    ) -> Contact:
        rotated: list[Direction] | None = None
        length: Node | None = None
        levers: dict[int, Node] = {}
        if len(arms) == 1 and len(declared) == 3 and arms[0].rotor is not None:
            length = self.length(arms[0])
            if length is not None:
                rotated, levers = self.polar(arms[0], declared, length)
        elif len(arms) == 1 and len(declared) == 2:
            rotated = self.in_plane(arms[0].link, declared)
        if rotated is None:
            rotated = [(e, 0) for e in declared]
        rows, bias = [], []
        for k, direction in enumerate(rotated):
            row = [self.zero] * len(self.tree.mechanism.u)
            rest = self.zero
            for arm in arms:
                own, part = self.row(arm, direction, levers.get(k))
                row = [a + b if arm.sign > 0 else a - b for a, b in zip(row, own, strict=True)]
                rest = rest - part if arm.sign > 0 else rest + part
            rows.append(tuple(row))
            bias.append(rest)
        return Contact(members, declared, tuple(rotated), tuple(rows), tuple(bias))

    def length(self, arm: Arm) -> Node | None:
        """The parameter that is |d|, if d is across the axle."""
        mechanism = self.tree.mechanism
        if arm.rotor is None or not arm.arm[arm.rotor.place].is_zero:
            return None
        filter_ = Residues(mechanism.builder)
        sizes = [mechanism.builder.input(n) for n, s in mechanism.signs.items() if s == "positive"]
        square, *squares = filter_.values([dot(arm.arm, arm.arm), *(p * p for p in sizes)])
        return next((p for p, own in zip(sizes, squares, strict=True) if own == square), None)

    def polar(
        self, arm: Arm, declared: Sequence[Vector], length: Node
    ) -> tuple[list[Direction] | None, dict[int, Node]]:
        """Equation (4), and the lever of each about the axle."""
        assert arm.rotor is not None
        home, filter_ = self.frame(arm.link), Residues(length.builder)
        ahead = cross(arm.rotor.axis, tuple(entry / length for entry in arm.arm))
        for e in declared:
            normal = self.tree.express(e, 0, home)
            if filter_.is_zero(dot(ahead, normal)):
                found = [(ahead, home), (cross(normal, ahead), home), (e, 0)]
                return found, {0: length, 1: self.zero, 2: self.zero}
        return None, {}

    def in_plane(self, link: int, declared: Sequence[Vector]) -> list[Direction] | None:
        """Axes of the last frame on the way to a link that are in the plane of two directions."""
        normal = cross(*declared)
        places = [k for k in AXES if not normal[k].is_zero]
        if len(places) != 1 or normal[places[0]].constant is None:
            return None
        (place,) = places
        while link != GROUND:
            frame = self.frame(link)
            if all(e.constant is not None for e in self.tree.express(normal, 0, frame)):
                axes = [(place + 1) % 3, (place + 2) % 3]
                one = self.zero + 1
                return [(tuple(one if i == k else self.zero for i in AXES), frame) for k in axes]
            link = self.tree.links[link].parent
        return None

    # ------------------------------------------------------------------ rows

    def row(self, arm: Arm, direction: Direction, lever: Node | None) -> tuple[list[Node], Node]:
        """The row of one side, and E . a_P at y = 0."""
        tree, moving, k = self.tree, self.moving, arm.link
        home, omega, alpha = self.frame(k), moving.omegas[k], moving.alphas[k]
        along = tree.express(*direction, home)
        moment = cross(arm.arm, along)
        rotor = arm.rotor
        ground = tree.express(moving.ground, 0, home)
        a = add(moving.accelerations[k], negated(ground), times(moving.matrices[k], arm.offset))
        swept = add(arm.rate, cross(omega, arm.arm))
        if rotor is not None:
            # The rotor turns with its own total rate, and relatively to its carrier.
            relative = scale(tree.mechanism.u[rotor.coordinate], cross(omega, rotor.axis))
            alpha = add(without(alpha, rotor.place), relative)
            total = scale(moving.total(tree, rotor), rotor.axis)
            omega = add(without(omega, rotor.place), total)
        a = add(a, cross(alpha, arm.arm), cross(omega, swept))
        couple = add(cross(arm.offset, along), moment)
        if rotor is not None:
            couple = add(cross(arm.offset, along), without(moment, rotor.place))
        row = taken_inwards(tree, {k: (couple, along)}, direction)
        if rotor is not None:
            row[rotor.coordinate] = moment[rotor.place] if lever is None else lever
        filter_ = Residues(self.zero.builder)
        return [self.zero if filter_.is_zero(entry) else entry for entry in row], dot(a, along)


def rewritten(node: Node, known: Sequence[Node]) -> Node:
    """A node in terms of known ones that are equal to parts of it at a point of a field."""
    build = node.builder
    filter_ = Residues(build)
    first: dict[int, Node] = {}
    for other, value in zip(known, filter_.values(known), strict=True):
        if other.constant is None:
            first.setdefault(value, other)
            first.setdefault(-value % filter_.prime, -other)
    numbers = reachable(build, [node.number])
    found: dict[int, Node] = {}
    operations = Nodes(build).operations
    for number, value in zip(
        numbers, filter_.values([Node(build, n) for n in numbers]), strict=True
    ):
        code = build.operations[number]
        if ARITY[code] and value in first:
            found[number] = first[value]
        elif not ARITY[code]:
            found[number] = Node(build, number)
        else:
            operands = (found[build.operands[k][number]] for k in range(ARITY[code]))
            found[number] = operations[OPERATIONS[code].name](*operands)
    return found[node.number]
