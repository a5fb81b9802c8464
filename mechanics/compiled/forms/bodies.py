"""Which forms of forward dynamics a mechanism has that start from its bodies, not from M and f."""

from dataclasses import replace

from mechanics.equations import Equations
from mechanics.mechanism import Mechanism
from mechanics.recursions.joints import Link, joint_tree
from mechanics.recursions.pseudo_inertia import grouped, moments


def joint_trees(mechanism: Mechanism) -> list[tuple[Link, ...]]:
    """The tree of joints with one freedom each, masses as declared and grouped; none for others."""
    trees = (joint_tree(mechanism, ways(mechanism)) for ways in (moments, grouped))
    return [links for links in trees if links is not None]


def no_tree(equations: Equations) -> str:
    """Why the bodies are no tree; empty where they are."""
    if equations.rows is None:
        return f"the equations by {equations.route} are not those of the scene's bodies"
    if equations.scene.constraints:
        named = ", ".join(constraint.name for constraint in equations.scene.constraints)
        return f"the bodies are no tree, for {named} constrains them"
    return _friction(equations)


def no_loops(equations: Equations) -> str:
    """Why there are no constraints to take along; empty where there are."""
    if equations.rows is None:
        return f"the equations by {equations.route} are not those of the scene's bodies"
    if not equations.scene.constraints:
        return "nothing constrains the coordinates: form 'recursive' is for trees"
    return _friction(equations)


def no_joint_tree(equations: Equations) -> str:
    """Why the bodies are no tree of joints with one freedom each; empty where they are."""
    return no_tree(equations) or _no_joints(equations)


def no_spanning_tree(equations: Equations) -> str:
    """The same, constraints aside."""
    if not equations.scene.constraints:
        return no_joint_tree(equations)
    return no_loops(equations) or _no_joints(equations)


def _no_joints(equations: Equations) -> str:
    mechanism, _ = equations.program
    if joint_trees(replace(mechanism, constraints=())):
        return ""
    return f"{mechanism.name} is no tree of joints with one freedom each"


def _friction(equations: Equations) -> str:
    mechanism, _ = equations.program
    if not mechanism.frictions:
        return ""
    named = ", ".join(load.name for load in mechanism.frictions)
    return f"{named} depends on a reaction, which this form does not hold"
