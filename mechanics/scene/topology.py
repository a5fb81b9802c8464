"""The tree of bodies: who hangs on whom, loops cut at the reactions that a constraint names."""

from dataclasses import dataclass

from sympy import Symbol

from mechanics.scene.joints.joint import Joint
from mechanics.scene.reactions import Reaction
from mechanics.scene.scene import Scene

GROUND = ""


@dataclass(frozen=True)
class Tree:
    """Bodies in tree order, from the ground outward.

    Attributes
    ----------
    order : tuple of str
        Parents before children.
    parent : dict of str to str
        Inboard neighbour; `GROUND` for none.
    joints : dict of str to tuple of Reaction
        The reactions between a body and its parent.
    """

    order: tuple[str, ...]
    parent: dict[str, str]
    joints: dict[str, tuple[Reaction, ...]]

    def subtree(self, name: str) -> tuple[str, ...]:
        """The body and everything outboard of it, in tree order."""
        inside = {name}
        for body in self.order:
            if self.parent[body] in inside:
                inside.add(body)
        return tuple(body for body in self.order if body in inside)


def multipliers(scene: Scene) -> tuple[Symbol, ...]:
    """Reactions that maintain constraints, in the order of the constraints."""
    by_name = {reaction.name: reaction.symbol for reaction in scene.reactions}
    return tuple(by_name[name] for c in scene.constraints for name in c.reactions)


def tree(scene: Scene) -> Tree:
    """Spanning tree of the bodies over the reactions that stay after the cut.

    A body that no reaction ties to another hangs on the ground: it is free, or slides on it
    without a reaction in the directions that the scene uses. One that a joint carries hangs on the
    parent of the joint, whatever else ties it.
    """
    cut = set(multipliers(scene))
    kept = [reaction for reaction in scene.reactions if reaction.symbol not in cut]
    tied = {frozenset((reaction.on, reaction.by or GROUND)) for reaction in kept}
    carrier = {
        joint.child: joint.parent or GROUND
        for joint in scene.joints
        if isinstance(joint, Joint) and joint.carries
        and (not joint.reactions or {joint.child, joint.parent or GROUND} in tied)
    }  # fmt: skip
    order: list[str] = []
    parent: dict[str, str] = {}

    def grow(front: list[str]) -> None:
        while front:
            inner = front.pop(0)
            for reaction in kept:
                ends = (reaction.on, reaction.by or GROUND)
                if inner in ends:
                    outer = ends[1] if ends[0] == inner else ends[0]
                    if (
                        outer != GROUND
                        and outer not in parent
                        and inner == carrier.get(outer, inner)
                    ):
                        parent[outer] = inner
                        order.append(outer)
                        front.append(outer)

    grow([GROUND])
    for body in scene.bodies:
        if body.name not in parent:
            parent[body.name] = GROUND
            order.append(body.name)
            grow([body.name])
    joints = {
        name: tuple(r for r in kept if {r.on, r.by or GROUND} == {name, parent[name]})
        for name in order
    }
    return Tree(tuple(order), parent, joints)
