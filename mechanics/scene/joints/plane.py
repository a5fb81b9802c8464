"""Joints in a plane: what they hold in it.

With the normal n of the plane a force stays whose direction is normal to n, and a couple whose axis
is n; the others go, and the constraints that they maintain with them.
"""

from itertools import pairwise

from sympy import Expr, Matrix
from sympy.core.function import AppliedUndef
from sympy.physics.vector import ReferenceFrame

from mechanics.errors import SceneError
from mechanics.scene.declaration import Declaration
from mechanics.scene.geometry import frame_path, relative_rotation
from mechanics.scene.joints.axes import constant_column
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope
from mechanics.symbolic import canonical


def out_of_plane(scene: Declaration, joint: Joint | Rope) -> set[str]:
    """Names of the reactions of a joint that act out of the plane of a scene.

    Raises
    ------
    SceneError
        When the joint leaves the plane, or stands oblique to it.
    """
    if scene.plane is None or isinstance(joint, Rope):
        return set()
    found = set()
    for reaction, along in zip(joint.reactions, joint.directions, strict=True):
        column, frame = constant_column(f"reaction {reaction.name}", along)
        normal = _normal(scene, joint, frame)
        across = canonical(column.dot(normal)) == 0
        parallel = column.cross(normal).applyfunc(canonical).is_zero_matrix
        if not across and not parallel:
            raise SceneError(
                f"joint {joint.name}: {reaction.name} along {along} is oblique to the plane normal"
                f" to {scene.plane}: take a frame of which one axis is the normal"
            )
        if parallel if reaction.at is not None else across:
            found.add(reaction.name)
    return found


def _normal(scene: Declaration, joint: Joint, frame: ReferenceFrame) -> Matrix:
    """The normal in a frame, in which it has to be fixed."""
    normal, own = constant_column(f"{scene.name}: plane", scene.plane)
    if own != scene.frame:
        raise SceneError(
            f"{scene.name}: plane = {scene.plane} is given in {own.name}: give the normal in the"
            f" frame of the scene, as in plane={scene.frame.name}.z"
        )
    for parent, child in pairwise(frame_path(scene.frame, frame)):
        normal = (relative_rotation(parent, child).T * normal).applyfunc(_reduced)
        if normal.atoms(AppliedUndef):
            raise SceneError(
                f"joint {joint.name}: {child.name} turns out of the plane normal to {scene.plane}:"
                f" let axes be {scene.plane}, or leave plane= out"
            )
    return normal


def _reduced(entry: Expr) -> Expr:
    return entry if entry.atoms(AppliedUndef) else canonical(entry)
