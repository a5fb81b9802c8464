"""A tree of joints with unknown accelerations y that make M and the constraints short.

    rotor     y = e . alpha = u' + e . alpha_carrier                                        (1)
    slides    y = R^T u'                       two of the ground, before a turn across them     (2)
    else      y = u'

A rotor is a leaf whose mass is symmetric about the axis that it turns about: a wheel. What of it
turns with its carrier is added to that, a gyrostat, and its total angular acceleration stands in
its own equation alone. (2): the base moves in directions that turn with it, and no heading is left
in M. Source: Wittenburg, Dynamics of Multibody Systems, 2nd edition, 2008, section 3.6.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.vectors import Vector, add, scale
from mechanics.recursions.frames import express
from mechanics.recursions.joints import JointTree, Link, Spot, placed_joint_tree, rotated
from mechanics.recursions.pseudo_inertia import Moments, outer

AXES = range(3)


@dataclass(frozen=True)
class Rotor:
    """What turns about its axis of symmetry.

    Attributes
    ----------
    carrier : int
        A link that is no rotor.
    place : int
        Number of the axis, a coordinate axis of the carrier's frame.
    axis : Vector
        Its unit vector there.
    inertia : Node
        About the axis, kg m^2.
    offset : Vector
        Of its root from that of the carrier, m.
    """

    coordinate: int
    carrier: int
    place: int
    axis: Vector
    inertia: Node
    offset: Vector


@dataclass(frozen=True)
class Tree:
    """Links and rotors.

    Attributes
    ----------
    joints : JointTree
        As it was found; its links still have the masses of their rotors.
    links : tuple of Link
        With the masses of their rotors; those at the places of rotors are to be left out.
    rotors : mapping of int to Rotor
        By the number of the link.
    slides : tuple of int
        The two links of equation (2), or none.
    """

    mechanism: Mechanism
    joints: JointTree
    links: tuple[Link, ...]
    rotors: Mapping[int, Rotor]
    slides: tuple[int, ...]

    def express(self, vector: Vector, source: int, target: int) -> Vector:
        """Components in another frame."""
        return express(self.mechanism, vector, source, target)

    def body(self, body: int) -> Spot | None:
        """Link of a body, and its mass centre from the root of that; None where they differ."""
        own, joints = self.mechanism.bodies[body], self.joints
        centre = joints.spots[own.centre]
        if own.frame is None or joints.rigid[own.frame] == 0:
            return centre
        link = joints.carriers[joints.rigid[own.frame]]
        if link == centre.link:
            return centre
        if joints.roots[joints.rigid[own.frame]] == centre:
            return Spot(link, tuple(entry * 0 for entry in centre.offset))
        return None

    def carried(self, spot: Spot) -> Spot | None:
        """The same place on a link that is no rotor; None where it turns about the axis of one."""
        if spot.link not in self.rotors:
            return spot
        rotor, link = self.rotors[spot.link], self.links[spot.link]
        along = next(k for k in AXES if not link.axis[k].is_zero)
        if any(not entry.is_zero for k, entry in enumerate(spot.offset) if k != along):
            return None
        offset = scale(spot.offset[along], rotor.axis)
        return Spot(rotor.carrier, add(rotor.offset, offset))

    def accelerations(self, y: Sequence[Node], bias: Callable[[Rotor], Node]) -> list[Node]:
        """u' of y, equations (1) and (2).

        Parameters
        ----------
        bias : callable
            e . alpha of the carrier of a rotor where y = 0.
        """
        found = list(y)
        if self.slides:
            own = [self.links[k] for k in self.slides]
            moved = add(*(scale(y[link.coordinate], link.axis) for link in own))
            moved = self.express(moved, own[0].frame, 0)
            for link in own:
                found[link.coordinate] = sum(
                    (a * e for a, e in zip(link.axis, moved, strict=True)), y[0].builder.zero
                )
        turning: dict[int, Vector] = {}
        for rotor in self.rotors.values():
            own_alpha = self._turning(rotor.carrier, y, turning)[rotor.place]
            found[rotor.coordinate] = y[rotor.coordinate] - (own_alpha + bias(rotor))
        return found

    def _turning(self, k: int, y: Sequence[Node], known: dict[int, Vector]) -> Vector:
        """What y adds to the angular acceleration of a link, in its frame."""
        if k not in known:
            link = self.links[k]
            alpha: Vector = (y[0].builder.zero,) * 3
            if link.parent != GROUND and link.carried:
                outer_alpha = self._turning(link.parent, y, known)
                alpha = self.express(outer_alpha, self.links[link.parent].frame, link.frame)
            if link.turning:
                alpha = add(alpha, scale(y[link.coordinate], link.axis))
            known[k] = alpha
        return known[k]


def build_tree(mechanism: Mechanism, moments: Moments) -> Tree | None:
    """The tree that remains without constraints; None where that is none of joints.

    Parameters
    ----------
    moments : Moments
        Of its masses: as they are, or grouped.
    """
    plain = replace(mechanism, constraints=())
    joints = placed_joint_tree(plain, moments)
    if joints is None:
        return None
    links, rotors = list(joints.links), {}
    for k in range(len(links)):
        rotor = _rotor(plain, links, k)
        if rotor is not None:
            rotors[k] = rotor
    slides = _slides(plain, links)
    for k in slides:
        (turn,) = (link for link in links if link.parent == max(slides))
        links[k] = replace(links[k], frame=turn.frame)
    return Tree(plain, joints, tuple(links), rotors, slides)


def _rotor(mechanism: Mechanism, links: list[Link], k: int) -> Rotor | None:
    """A leaf that is one; its carrier takes its mass."""
    link, one = links[k], mechanism.builder.one
    inner = any(other.parent == k for other in links)
    if inner or not (link.turning and link.carried) or link.parent == GROUND:
        return None
    along = next((k for k in AXES if link.axis[k] == one), None)
    if along is None or sum(not entry.is_zero for entry in link.axis) > 1:
        return None
    across = [k for k in AXES if k != along]
    second, carrier = link.second, links[link.parent]
    if any(not second[i][j].is_zero for i in AXES for j in AXES if i != j):
        return None
    if any(not link.first[k].is_zero for k in across):
        return None
    if second[across[0]][across[0]] != second[across[1]][across[1]]:
        return None
    # What lies along the axis has the same components in the frame that it turns against.
    source = mechanism.frames[link.frame].parent
    axis = express(mechanism, link.axis, source, carrier.frame)
    places = [k for k in AXES if axis[k] == one]
    if not places:
        return None
    half, zero = second[across[0]][across[0]], mechanism.builder.zero
    rest = second[along][along] + half
    matrix = tuple(tuple(rest if i == j == along else zero for j in AXES) for i in AXES)
    first = express(mechanism, link.first, source, carrier.frame)
    weighed = scale(link.mass, link.offset)
    parts = (
        carrier.second, rotated(mechanism, matrix, source, carrier.frame),
        outer(weighed, link.offset), outer(link.offset, first), outer(first, link.offset),
    )  # fmt: skip
    links[link.parent] = replace(
        carrier,
        mass=carrier.mass + link.mass,
        first=add(carrier.first, first, weighed),
        second=tuple(add(*(part[i] for part in parts)) for i in AXES),
    )
    return Rotor(link.coordinate, link.parent, places[0], axis, half * 2, link.offset)


def _slides(mechanism: Mechanism, links: Sequence[Link]) -> tuple[int, ...]:
    """Two slides of the ground that a turn follows whose axis is across both."""
    slides: list[int] = []
    parent, one = GROUND, mechanism.builder.one
    while True:
        outer_links = [k for k, link in enumerate(links) if link.parent == parent]
        if len(outer_links) != 1:
            return ()
        link = links[outer_links[0]]
        if link.turning:
            break
        if sum(not entry.is_zero for entry in link.axis) > 1 or one not in link.axis:
            return ()
        slides.append(outer_links[0])
        parent = outer_links[0]
    frame = mechanism.frames[link.frame]
    along = next((k for k in AXES if link.axis[k] == one), None)
    if (
        len(slides) != 2
        or along is None
        or frame.parent != 0
        or frame.rotation[along][along] != one
    ):
        return ()
    if any(not entry.is_zero for entry in link.offset):
        return ()
    if any(not links[k].axis[along].is_zero for k in slides):
        return ()
    return tuple(slides)
