"""Motions that a reaction forbids: along each of them it does power, so an equation holds it.

    v = e + n x (r - r_0),    omega = n        of the bodies that move

For a reaction of a joint everything outboard moves along (or turns about) its direction. A reaction
that closes a loop of bodies belongs to no joint: for it one body is moved alone, in the first way
whose equation does not follow from those of the other reactions.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sympy import Expr, Matrix, S, eye, zeros

from mechanics.errors import SingularError
from mechanics.kinematics.manifold import on_the_manifold
from mechanics.scene import Scene
from mechanics.scene.actions import Action, acting_reactions
from mechanics.scene.reactions import Reaction
from mechanics.scene.topology import GROUND, Tree, loop_reactions, tree
from mechanics.symbolic import generic_rank


@dataclass(frozen=True)
class Opening:
    """A motion of some bodies: a translation or a rotation about a hinge, inertial components."""

    bodies: tuple[str, ...]
    along: Matrix
    about: Matrix
    hinge: Matrix

    def velocity(self, at: Matrix) -> Matrix:
        """Velocity at a place of a moved body."""
        return self.along + self.about.cross(at - self.hinge)

    def power(self, actions: Sequence[Action]) -> Expr:
        """Power of actions on the bodies that are moved."""
        total = S.Zero
        for action in actions:
            if action.body in self.bodies:
                total += self.velocity(action.at).dot(action.force) + self.about.dot(action.couple)
        return total


def openings(scene: Scene, sought: Sequence[Reaction]) -> tuple[Opening, ...]:
    """For each reaction the motion that opens its joint or loop.

    Raises
    ------
    SingularError
        When nothing that a body can do opens a loop.
    """
    bodies = tree(scene)
    loops = loop_reactions(scene, bodies)
    found = {r.name: _of_joint(scene, bodies, r) for r in sought if r.symbol not in loops}
    if loops:
        _open_loops(scene, sought, found)
    return tuple(found[reaction.name] for reaction in sought)


def _open_loops(scene: Scene, sought: Sequence[Reaction], found: dict[str, Opening]) -> None:
    """Add the missing openings, such that their equations determine every reaction."""
    units = acting_reactions(scene)
    columns = [units[reaction.symbol] for reaction in sought]
    rows = [[opening.power(pair) for pair in columns] for opening in found.values()]
    closed = on_the_manifold(scene)
    for reaction in sought:
        if reaction.name in found:
            continue
        for opening in _alone(scene, reaction):
            row = [opening.power(pair) for pair in columns]
            if generic_rank([*rows, row], closed) > len(rows):
                found[reaction.name] = opening
                rows.append(row)
                break
        else:
            raise SingularError(
                f"reaction {reaction.name}: no motion of a body opens its loop: is it redundant?"
            )


def _of_joint(scene: Scene, bodies: Tree, reaction: Reaction) -> Opening:
    """Everything outboard of the joint that the reaction belongs to."""
    outer = next(name for name in bodies.order if reaction in bodies.joints[name])
    along, none = scene.vector(reaction.along, reaction.name), zeros(3, 1)
    if reaction.at is not None:
        return Opening(bodies.subtree(outer), along, none, none)
    return Opening(bodies.subtree(outer), none, along, scene.position(scene.body(outer).centre))


def _alone(scene: Scene, reaction: Reaction) -> Iterator[Opening]:
    """Ways to move one body alone, first of the bodies that the reaction ties to each other."""
    ends = [name for name in (reaction.on, reaction.by or GROUND) if name != GROUND]
    others = [body.name for body in scene.bodies if body.name not in ends]
    along, none = scene.vector(reaction.along, reaction.name), zeros(3, 1)
    for name in (*ends, *others):
        hinge = scene.position(scene.body(name).centre)
        yield Opening((name,), along, none, none)
        for i in range(3):
            yield Opening((name,), none, eye(3)[:, i], hinge)
        for i in range(3):
            yield Opening((name,), eye(3)[:, i], none, none)
