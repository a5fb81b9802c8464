"""Joints as their author named them: what each has to be, from its kind and its arguments alone.

    child = B exp([n] angle), at + distance n ...         a joint that carries its child       (1)
    what the kind holds is held where the loop is closed  a joint that closes a loop           (2)
    F . v + T . w = 0      on each twist (w, v) of the kind; F at the child's point            (3)
    F, T along the axis of the frame for which a reaction is named                             (4)

A scene holds frames, points and reactions that its joints have made. Routes and other checks read
these, so that a joint that turns about another axis, or the other way, is a right scene to them.
This one reads what the author gave once more: turns are exponentials of matrices, a quaternion
turns by Hamilton's product, and nothing of `mechanics.scene.joints` is used. What rolls and ropes
are stands in `rolling` and `ropes`.
"""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

from flint import arb, arb_mat
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.checks.as_declared import Motion, cross, dot
from mechanics.checks.joint_rows import AXES, LETTERS, NONE, place, rotation, same, turn, vector
from mechanics.checks.rolling import rolling
from mechanics.checks.ropes import rope_rows
from mechanics.checks.states import State
from mechanics.checks.virtual_power import Row, tried
from mechanics.kernel import Finding
from mechanics.scene import Joint, Rope, Scene
from mechanics.scene.euler import Euler

Twist = tuple[arb_mat, arb_mat]
"""Angular velocity and velocity of the child's point, relative to the parent."""


def check_joints(scene: Scene, states: Sequence[State]) -> Iterator[Finding]:
    """Statements (1) to (4), joint by joint.

    Parameters
    ----------
    states : sequence of State
        From `drawn_states`.
    """
    for joint in scene.joints:
        if joint.given:
            subject = f"joint {joint.name}: what a {joint.given['kind']} is"
            yield tried(subject, states, partial(_rows, scene, joint))


def _rows(scene: Scene, joint: Joint | Rope, state: State) -> Iterator[Row]:
    motion = Motion(scene, next(iter(state.virtual_motions(1))))
    if isinstance(joint, Rope):
        yield from rope_rows(motion, joint)
    elif joint.given["kind"] == "roll":
        yield from rolling(motion, joint)
    else:
        yield from _joint(motion, joint)


def _joint(motion: Motion, joint: Joint) -> Iterator[Row]:
    basis, axis = _basis(motion, joint)
    span = place(motion, joint.point) - place(motion, joint.at)
    turned = rotation(motion, joint.frame)
    if not joint.carries:
        yield from _closed(motion, joint, basis, axis, span)
    else:
        moved, own = _pose(motion, joint, basis, axis)
        yield from same(f"{joint.name}: the child's point", span, moved)
        yield from same(f"{joint.name}: the child's frame", turned, basis * own)
    yield from _reactions(motion, joint, basis, list(_twists(motion, joint, basis, axis)))


def _basis(motion: Motion, joint: Joint) -> tuple[arb_mat, arb_mat]:
    """Axes of the parent's frame as columns, and the joint's axis; z where it has none."""
    axis, frame = joint.given.get("axis"), joint.given.get("frame")
    if axis is None:
        basis = rotation(motion, frame)
        return basis, basis * AXES[2]
    ((_, frame),) = axis.args
    column = vector(motion, axis)
    return rotation(motion, frame), column * (1 / dot(column, column).sqrt())


def _pose(
    motion: Motion, joint: Joint, basis: arb_mat, axis: arb_mat
) -> tuple[arb_mat, arb_mat]:  # fmt: skip
    """Equation (1): from the parent's point to the child's, and the turn from basis to child."""
    given = joint.given
    distance = motion.number(given["distance"]) if "distance" in given else arb(0)
    moved, own = axis * distance, turn(AXES[0], arb(0))
    if given.get("angle") is not None:
        own = turn(basis.transpose() * axis, motion.number(given["angle"]))
    for k, coordinate in enumerate(given.get("coordinates", ())):
        moved = moved + basis * AXES[k] * motion.number(coordinate)
    for letter, angle in _named_turns(given):
        own = own * turn(AXES[LETTERS.index(letter)], motion.number(angle))
    if given.get("rotation") is not None and not isinstance(given["rotation"], Euler):
        own = _hamilton([motion.number(e) for e in given["rotation"].coordinates])
    return moved, own


def _named_turns(given: Any) -> Iterator[tuple[str, Any]]:
    if "axes" in given:
        yield from zip(given["axes"].lower(), given["angles"], strict=True)
    elif isinstance(given.get("rotation"), Euler):
        yield from zip(given["rotation"].order, given["rotation"].angles, strict=True)


def _closed(
    motion: Motion, joint: Joint, basis: arb_mat, axis: arb_mat, span: arb_mat
) -> Iterator[Row]:
    """Statement (2)."""
    kind, onto = joint.given["kind"], joint.given["onto"]
    held = None if isinstance(onto, Point) else onto[1]
    point = onto if held is None else onto[0]
    span = span + place(motion, point) - place(motion, joint.point)
    # A pin in a plane holds the point across its axis, along which nothing moves.
    along = kind in ("slide", "cylindrical") or (kind == "pin" and held is None)
    normal = axis * dot(span, axis)
    words = f"{joint.name}: where the loop is closed"
    yield from same(words, normal if kind == "planar" else span - normal if along else span, NONE)
    if kind == "universal":
        yield words, dot(basis * _axis_of_cross(joint), vector(motion, held)), arb(0)
    elif isinstance(held, Vector):
        yield from same(words, cross(axis, vector(motion, held)), NONE)
    elif isinstance(held, ReferenceFrame):
        own = rotation(motion, held)
        for one in AXES:
            yield from same(words, cross(basis * one, own * one), NONE)


def _twists(motion: Motion, joint: Joint, basis: arb_mat, axis: arb_mat) -> Iterator[Twist]:
    """How the child may move, by the kind."""
    given, kind = joint.given, joint.given["kind"]
    if kind in ("pin", "cylindrical", "planar"):
        yield axis, NONE
    if kind in ("slide", "cylindrical"):
        yield NONE, axis
    if kind == "planar":
        yield from ((NONE, basis * one) for one in AXES[:2])
    if kind == "ball":
        yield from ((one, NONE) for one in AXES)
    if kind == "universal" and not joint.carries:
        yield basis * _axis_of_cross(joint), NONE
        yield vector(motion, given["onto"][1]), NONE
    elif kind == "universal":
        turned = turn(AXES[0], arb(0))
        for letter, angle in _named_turns(given):
            own = AXES[LETTERS.index(letter)]
            yield basis * turned * own, NONE
            turned = turned * turn(own, motion.number(angle))


def _axis_of_cross(joint: Joint) -> arb_mat:
    """About which the cross turns in the parent's frame."""
    return AXES[LETTERS.index(joint.given["axes"][0].lower())]


def _reactions(
    motion: Motion, joint: Joint, basis: arb_mat, twists: Sequence[Twist]
) -> Iterator[Row]:
    """Statements (3) and (4)."""
    named = {own.name: own for own in joint.reactions}
    point = place(motion, joint.point)
    for name, wrench in motion.reactions():
        if name not in named or wrench.body != joint.child:
            continue
        along = wrench.couple if named[name].at is None else wrench.force
        if named[name].at is not None:
            yield from same(f"{name}: where it acts", wrench.at, point)
        for omega, velocity in twists:
            moved = velocity + cross(omega, wrench.at - point)
            power = dot(wrench.force, moved) + dot(wrench.couple, omega)
            yield f"{name}: power on the joint's own motion", power, arb(0)
        if name[-1] in LETTERS and (joint.given["kind"], named[name].at) != ("universal", None):
            # The couple of a universal joint is about the cross, as its power says.
            own = basis * AXES[LETTERS.index(name[-1])]
            yield from same(f"{name}: its direction", cross(own, along), NONE)


def _hamilton(e: Sequence[arb]) -> arb_mat:
    """Columns e i e*, e j e*, e k e* over e e*."""
    size = sum((part * part for part in e), arb(0))
    back = [e[0], -e[1], -e[2], -e[3]]
    columns = [
        _times(_times(e, [arb(int(i == k)) for i in (-1, 0, 1, 2)]), back)[1:] for k in range(3)
    ]
    return arb_mat([[column[i] / size for column in columns] for i in range(3)])


def _times(a: Sequence[arb], b: Sequence[arb]) -> list[arb]:
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
