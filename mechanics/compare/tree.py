"""A tree of joints in numbers, as other engines take their models.

pose of a link at q = 0:   R, p in the frame of the link before
joint                      turns about, or slides along, an axis e of the link's own frame
body                       mass, centre and inertia about it, in the link's frame
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from mechanics.compare.ours import Array, Ours
from mechanics.errors import InputError
from mechanics.scene import Force, Gravity, Torque
from mechanics.scene.joints import Joint
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import name_of

TAKEN = ("pin", "slide", "weld", "free", "ball")


@dataclass(frozen=True, eq=False)
class Link:
    """A joint and the body that it carries.

    Attributes
    ----------
    name, joint : str
        Of the body, and of the joint.
    before : int
        Index of the link that carries it, -1 for the ground.
    kind : str
        ``"pin"``, ``"slide"``, ``"weld"``, ``"free"`` or ``"ball"``.
    axis : (3,)
    turn, offset : (3, 3), (3,)
        v_before = turn v, and where the joint is, in the frame of the link before.
    mass : float
    centre : (3,)
    inertia : (3, 3)
    q, v : tuples of int
        Coordinates and speeds of the joint in the scene.
    """

    name: str
    joint: str
    before: int
    kind: str
    axis: Array
    turn: Array
    offset: Array
    mass: float
    centre: Array
    inertia: Array
    q: tuple[int, ...]
    v: tuple[int, ...]


def links(ours: Ours, whole: bool = True) -> tuple[Link, ...]:
    """The tree of a scene, links after those that carry them.

    Parameters
    ----------
    ours : Ours
    whole : bool
        Whether loads and constraints are looked at: an engine that reads a file has its own.

    Raises
    ------
    InputError
        For what engines have no common word for: other joints, loops, springs, other loads.
    """
    scene = ours.scene
    _refuse(ours, whole)
    zero, names = ours.zero, [*scene.coordinates]
    poses, columns = ours.links(zero), ours.jacobians(zero)
    bodies = {
        body.name: entry
        for body, entry in zip(ours.mechanism.bodies, ours.bodies(zero), strict=True)
    }
    waiting = [joint for joint in scene.joints if isinstance(joint, Joint) and joint.carries]
    found: dict[str, Link] = {}
    while waiting:
        joint = next(j for j in waiting if j.parent is None or j.parent in found)
        waiting.remove(joint)
        at, turn = (pose[0] for pose in poses[joint.child])
        base_at, base = np.zeros(3), np.eye(3)
        if joint.parent is not None:
            base_at, base = (pose[0] for pose in poses[joint.parent])
        kind = str(joint.given["kind"])
        places = tuple(names.index(q) for q in joint.coordinates)
        speeds = tuple(_speeds(ours, joint))
        axis = np.zeros(3)
        if kind in ("pin", "slide"):
            rows = slice(3, 6) if kind == "pin" else slice(0, 3)
            axis = turn.T @ columns[joint.child][0][rows, speeds[0]]
        if kind in ("free", "ball"):
            places = (*places, *(names.index(q) for q in joint.given["rotation"].coordinates))
        mass, centre, own, inertia = bodies[joint.child]
        way = turn.T @ own
        found[joint.child] = Link(
            joint.child, joint.name, [*found, None].index(joint.parent) if joint.parent else -1,
            kind, axis, base.T @ turn, base.T @ (at - base_at), float(mass),
            turn.T @ (centre - at), way @ inertia @ way.T, places, speeds,
        )  # fmt: skip
    return tuple(found.values())


def _speeds(ours: Ours, joint: Joint) -> list[int]:
    rates = [ours.scene.qd[[*ours.scene.coordinates].index(q)].name for q in joint.coordinates]
    turning = [name_of(u) for rotation in joint.rotations for u in rotation.speeds]
    return [ours.speeds.index(name) for name in (*rates, *turning)]


def _refuse(ours: Ours, whole: bool) -> None:
    scene = ours.scene
    carried = {j.child for j in scene.joints if isinstance(j, Joint) and j.carries}
    counts = {len(carried), len(scene.bodies), len(scene.joints)}
    if (whole and (scene.constraints or len(counts) > 1)) or not carried:
        raise InputError(
            f"{scene.name}: engines take a tree, in which one joint carries each body and nothing"
            " closes a loop: declare joints, or pass the engine's answers as functions"
        )
    for joint in scene.joints:
        if not isinstance(joint, Joint) or not joint.carries:
            continue
        kind = str(joint.given.get("kind"))
        angles = not isinstance(joint.given.get("rotation"), Rotation)
        if kind not in TAKEN or (kind in ("free", "ball") and angles):
            words = f"{kind} without a quaternion" if kind in TAKEN else kind
            raise InputError(
                f"joint {joint.name} is {words}: engines' models are made of {', '.join(TAKEN)}"
            )
    for load in scene.loads if whole else ():
        drives = isinstance(load, Torque | Force) and any(
            column.has(*scene.inputs) for column, _ in load.vector.args if scene.inputs
        )
        if not isinstance(load, Gravity) and not drives:
            raise InputError(
                f"load {load.name}: engines' models are made with gravity and inputs alone: leave"
                " it out of the scene"
            )


def fixed_base(engine: str, tree: tuple[Link, ...]) -> tuple[Link, ...]:
    """A tree without free links, for an adapter that takes no others.

    Raises
    ------
    InputError
        Names the free joint.
    """
    for link in tree:
        if link.kind in ("free", "ball"):
            raise InputError(
                f"joint {link.joint} is {link.kind}: the adapter of {engine} takes pin, slide and"
                " weld: compare with pinocchio or mujoco"
            )
    return tree
