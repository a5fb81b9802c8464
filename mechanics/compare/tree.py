"""A tree of joints in numbers, as other engines take their models.

pose of a link at q = 0:   R, p in the frame of the link before
joint                      turns about, or slides along, an axis e of the link's own frame
body                       mass, centre and inertia about it, in the link's frame
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mechanics.compare.change import Array
from mechanics.compare.ours import Ours, of_scene
from mechanics.compare.quantities import Answer
from mechanics.compare.states import draw
from mechanics.errors import InputError
from mechanics.scene import Force, Gravity, Scene, Torque
from mechanics.scene.joints import Joint
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import name_of

SAMPLES = 16
EXACT = 1e-11
"""Part of the largest force that is left by rounding."""
TAKEN = ("pin", "slide", "weld", "planar", "free", "ball")


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
        ``"pin"``, ``"slide"``, ``"weld"``, ``"planar"``, ``"free"`` or ``"ball"``. The plane is
        that of x and y of the frame in which the joint is.
    axis : (3,)
    turn, offset : (3, 3), (3,)
        v_before = turn v, and where the joint is, in the frame of the link before.
    centre : (3,)
    inertia : (3, 3)
    q, v : tuples of int
        Coordinates and speeds of the joint in the scene.
    stiffness, rest, damping : float
        Of the force -k (q - r) - b v at its one coordinate.
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
    stiffness: float = 0.0
    rest: float = 0.0
    damping: float = 0.0


def links(ours: Ours, whole: bool = True) -> tuple[Link, ...]:
    """The tree of a scene, links after those that carry them.

    Parameters
    ----------
    whole : bool
        Whether loads and constraints are looked at: an engine that reads a file has its own.

    Raises
    ------
    InputError
        For what engines have no common word for: other joints, loops, other loads than gravity,
        inputs, and springs and dampers at joints.
    """
    scene = ours.scene
    _refuse(ours, whole)
    passive = _passive(ours) if whole else {}
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
            *(passive.get(speeds[0], ()) if len(speeds) == 1 else ()),
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


def _passive(ours: Ours) -> dict[int, tuple[float, float, float]]:
    """Stiffness, rest and damping by speed, from the generalized forces of the other loads."""
    scene = ours.scene
    others = [
        load for load in scene.loads if not isinstance(load, Gravity) and not _drives(load, scene)
    ]
    if not others:
        return {}
    bare = replace(scene, loads=tuple(load for load in scene.loads if load not in others))
    known = {symbol.name for symbol in bare.parameters}
    empty = of_scene(bare, {n: value for n, value in ours.values.items() if n in known})
    states, found = draw(scene, SAMPLES, ours.values), {}
    still = np.zeros_like(states.v)
    force = empty.forces(states.q, states.v, still) - ours.forces(states.q, states.v, still)
    for speed, values in enumerate(force.T):
        if not values.any():
            continue
        rates, x = scene.u[speed] in scene.qd, np.zeros(3)
        if rates:
            q, v = states.q[:, ours.coordinate(speed)], states.v[:, speed]
            columns = np.stack([-q, -v, np.ones(SAMPLES)], axis=1)
            x = np.linalg.lstsq(columns, values, rcond=None)[0]
            x[np.abs(x) < EXACT * np.abs(x).max()] = 0.0
        left = values - columns @ x if rates else values
        if np.abs(left).max() > EXACT * np.abs(values).max() or (x[2] and not x[0]):
            raise InputError(
                f"load{'s' * (len(others) > 1)} {', '.join(load.name for load in others)}: engines'"
                " models are made with gravity, inputs, and springs and dampers that are linear in"
                " the coordinate of one joint: leave what is neither out of the scene"
            )
        stiffness, damping, constant = map(float, x)
        found[speed] = stiffness, constant / stiffness if stiffness else 0.0, damping
    stored = sum(
        stiffness * (states.q[:, ours.coordinate(speed)] - rest) ** 2 / 2
        for speed, (stiffness, rest, _) in found.items()
    )
    own, less = (one.energies(states.q, still)[1] for one in (ours, empty))
    if np.ptp(own - less - stored) > EXACT * np.abs(own).max():
        raise InputError(
            f"{', '.join(load.name for load in others)}: a spring without potential energy, which"
            " engines give to every spring: declare torsion_spring(...) or spring(...)"
        )
    return found


def _drives(load: Any, scene: Scene) -> bool:
    """Whether it is the force or torque of an input."""
    return isinstance(load, Torque | Force) and any(
        column.has(*scene.inputs) for column, _ in load.vector.args if scene.inputs
    )


def with_passive(answers: Mapping[str, Answer], tree: tuple[Link, ...]) -> dict[str, Answer]:
    """The answers of an engine that knows no springs and dampers at joints, with these added."""
    moved = [link for link in tree if link.stiffness or link.damping]
    if not moved:
        return dict(answers)

    def force(q: Any, v: Any) -> Any:
        total = np.zeros(len(v))
        for one in moved:
            total[one.v[0]] -= one.stiffness * (q[one.q[0]] - one.rest) + one.damping * v[one.v[0]]
        return total

    def stored(q: Any, v: Any) -> Any:
        return sum(one.stiffness * (q[one.q[0]] - one.rest) ** 2 / 2 for one in moved)

    added: dict[str, Answer] = {
        "bias": lambda q, v: answers["bias"](q, v) - force(q, v),
        "inverse_dynamics": lambda q, v, a: answers["inverse_dynamics"](q, v, a) - force(q, v),
        "forward_dynamics": lambda q, v, f: answers["forward_dynamics"](q, v, f + force(q, v)),
        "potential_energy": lambda q, v: answers["potential_energy"](q, v) + stored(q, v),
    }
    return {**answers, **{name: answer for name, answer in added.items() if name in answers}}


def fixed_base(engine: str, tree: tuple[Link, ...]) -> tuple[Link, ...]:
    """A tree of pins, slides and welds, for an adapter that takes no others.

    Raises
    ------
    InputError
        Names another joint.
    """
    for link in tree:
        if link.kind in ("planar", "free", "ball"):
            raise InputError(
                f"joint {link.joint} is {link.kind}: the adapter of {engine} takes pin, slide and"
                " weld: compare with pinocchio or mujoco"
            )
    return tree
