"""Accelerations and multipliers of a tree of joints under constraints.

    [[M, A^T], [A, 0]] (y, -lambda) = (f, b)          M, f of the tree, A, b of the contacts     (1)
    F = sum lambda_j E_j,      e_i . F                the declared reactions                     (2)

Constraints whose entry for an unknown is a number or a positive parameter are eliminated first:
rolling is that, in the unknowns and directions of `tree` and `contacts`.
"""

from collections.abc import Callable, Sequence

from mechanics.mechanism import Mechanism, name_of
from mechanics.program.builder import Node
from mechanics.program.interpret import include
from mechanics.program.residues import Residues
from mechanics.program.saddle_point import solve_saddle_point
from mechanics.program.vectors import add, dot, scale
from mechanics.recursions.constrained_trees.contacts import Contact, contacts
from mechanics.recursions.constrained_trees.motion import forcing, matrix, motion
from mechanics.recursions.constrained_trees.tree import Rotor, Tree, build_tree
from mechanics.recursions.joint_frames import joint_frames
from mechanics.recursions.least_constraint.solution import known_nonzero
from mechanics.recursions.pseudo_inertia import grouped, moments

Solution = tuple[list[Node], list[Node]]
"""u', and mu with M u' = f + A^T mu, A u' = b as the constraints are declared."""


def forward_dynamics(mechanism: Mechanism, closing: Sequence[Node]) -> list[Solution]:
    """By masses as declared and grouped, in frames as declared and in those of the joints.

    Parameters
    ----------
    mechanism : Mechanism
    closing : sequence of Node
        A u' - b of the constraints as they are declared.

    Returns
    -------
    list of Solution
        Empty for a mechanism that is no tree of joints with one freedom each, or where constraints
        are maintained in another way than by forces in fixed directions.
    """
    turned = joint_frames(mechanism)
    ways = [mechanism] if turned is mechanism else [mechanism, turned]
    trees = [build_tree(way, masses(way)) for way in ways for masses in (moments, grouped)]
    found = (_solution(mechanism, tree, closing) for tree in trees if tree is not None)
    return [solution for solution in found if solution is not None]


def _solution(mechanism: Mechanism, tree: Tree, closing: Sequence[Node]) -> Solution | None:
    moving = motion(tree)
    force, touching = forcing(tree, moving), contacts(tree, moving, mechanism.constraints)
    if force is None or touching is None:
        return None
    signs = _signs(tree, closing, moving.bias, touching)
    if signs is None:
        return None
    n, rows = len(mechanism.u), [row for contact in touching for row in contact.rows]
    bias = [entry for contact in touching for entry in contact.bias]
    found = solve_saddle_point(matrix(tree), rows, [*force, *bias], known_nonzero(mechanism))
    multipliers = [mechanism.builder.zero] * len(rows)
    left = found[n:]
    for contact in touching:
        own, left = left[: len(contact.rows)], left[len(contact.rows) :]
        for i, value in _reactions(tree, contact, [-entry for entry in own]).items():
            multipliers[i] = value if signs[i] > 0 else -value
    return tree.accelerations(found[:n], moving.bias), multipliers


def _reactions(tree: Tree, contact: Contact, sizes: Sequence[Node]) -> dict[int, Node]:
    """Equation (2), by constraint; added up in the frame of the root, where rows have E already."""
    root = tree.links[0].frame
    found = {}
    for i, e in zip(contact.members, contact.declared, strict=True):
        if (e, 0) in contact.rotated:
            found[i] = sizes[contact.rotated.index((e, 0))]
            continue
        parts = [
            scale(size, tree.express(*direction, root))
            for size, direction in zip(sizes, contact.rotated, strict=True)
        ]
        found[i] = dot(e, tree.express(add(*parts), root, 0))
    return found


def _signs(
    tree: Tree,
    closing: Sequence[Node],
    bias: Callable[[Rotor], Node],
    touching: Sequence[Contact],
) -> dict[int, int] | None:
    """Of c against what is declared; None where it is another constraint."""
    mechanism, build = tree.mechanism, tree.mechanism.builder
    filter_ = Residues(build)
    rates = tree.accelerations(mechanism.ud, bias)
    names = dict(zip(map(name_of, mechanism.ud), rates, strict=True))
    program = build.program({"closing": closing})
    given = {name: rate for name, rate in names.items() if name in program.inputs}
    declared = include(build, program, given)["closing"]
    found = {}
    for contact in touching:
        own = [
            dot(row, mechanism.ud) - rest
            for row, rest in zip(contact.rows, contact.bias, strict=True)
        ]
        for i, e in zip(contact.members, contact.declared, strict=True):
            sides = [tree.express(*direction, 0) for direction in contact.rotated]
            form = sum((dot(e, s) * part for s, part in zip(sides, own, strict=True)), build.zero)
            for sign in (1, -1):
                if filter_.is_zero(declared[i] - form if sign > 0 else declared[i] + form):
                    found[i] = sign
            if i not in found:
                return None
    return found
