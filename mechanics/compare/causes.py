"""The causes for which engines differ: each a change of the scene or a reading of it, to be tried.

A row yields trials; a trial is a cause where the numbers that it predicts are those that were
observed. Causes with an amount, such as an armature, are in `mechanics.compare.amounts`.

    sign of an axis        tau = S rows(S q, S v, S a)                       S = diag(+-1)
    degrees                tau = rows(pi/180 q, ...)
    other speeds           v = B(q) w:   tau_w = B^T rows(q, B w, B w' + B' w)
    locked joint           a_i = v_i = 0, q_i fixed
    mimic ignored          constraints left out
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations

import numpy as np

from mechanics.compare.change import Array, Change
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import (
    FORCE,
    FORWARD,
    INVERSE,
    JACOBIAN,
    MASS,
    MOMENTUM_RATE,
    VELOCITY,
    Reading,
    kind_of,
)
from mechanics.compare.states import States
from mechanics.scene.joints import Joint
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import name_of

MANY = 7
"""Joints up to which every subset of signs is tried."""
FEW = 5
"""Joints up to which every order is tried."""
RADIAN = np.pi / 180


@dataclass(frozen=True, eq=False)
class Trial:
    """A cause as it may be: in words, and as a reading of the scene."""

    words: str
    reading: Reading


@dataclass(frozen=True)
class Cause:
    """A row of the table.

    Attributes
    ----------
    name : str
    trials : callable
        From our numbers, and the shape of what was observed by quantity, to what is tried.
    """

    name: str
    trials: Callable[[Ours, dict[str, tuple[int, ...]]], Iterator[Trial]]


Shapes = dict[str, tuple[int, ...]]


def upper_triangle(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Only one triangle of M is filled, and used."""
    for words, part in (("upper", np.triu), ("lower", np.tril)):

        def half(quantity: str, values: Array, states: States, part: Callable = part) -> Array:
            mass = ours.mass_matrix(states.q)
            if quantity == MASS:
                return part(values)
            if quantity == INVERSE:
                return values - np.einsum("nij,nj->ni", mass - part(mass), states.a)
            if quantity == FORWARD:
                forces = np.einsum("nij,nj->ni", mass, values)
                return _solved(part(mass), forces)
            return values

        told = f"only the {words} triangle of the mass matrix is filled"
        yield Trial(told, Reading(values=half))
        yield Trial(told, Reading(values=half, only=(MASS,)))
        yield Trial(f"{told}, and used", Reading(values=half, only=(INVERSE, FORWARD)))


def axis_signs(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Some joints turn or slide the other way."""
    n = len(ours.speeds)
    if ours.scene.rotations or ours.scene.speeds:
        return
    sizes = range(1, n + 1) if n <= MANY else (1, 2, n)
    every = [chosen for size in sizes for chosen in combinations(range(n), size)]
    for chosen in dict.fromkeys((_negative(ours), *every)):
        sign = np.ones(n)
        sign[list(chosen)] = -1.0
        words = f"the axes of {', '.join(ours.labels[k] for k in chosen)} point the other way"
        if chosen:
            yield Trial(words, _consistent(np.diag(sign)))
            reading = _consistent(np.diag(sign), np.eye(n))
            yield Trial(f"{words} for speeds and forces, not for angles", reading)


def _negative(ours: Ours) -> tuple[int, ...]:
    """Joints whose axis is one such as (0, -1, 0) in the frame of the link."""
    found, zero = [], ours.zero
    columns, poses = ours.jacobians(zero), ours.links(zero)
    for joint in ours.scene.joints:
        if not isinstance(joint, Joint) or not joint.carries or len(joint.coordinates) != 1:
            continue
        speed = ours.scene.coordinates.index(joint.coordinates[0])
        rows = slice(3, 6) if joint.given.get("kind") == "pin" else slice(0, 3)
        axis = poses[joint.child][1][0].T @ columns[joint.child][0][rows, speed]
        if axis[np.abs(axis).argmax()] < 0:
            found.append(speed)
    return tuple(found)


def joint_orders(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """The joints stand in another order, such as that of the alphabet."""
    n = len(ours.speeds)
    if ours.scene.rotations or ours.scene.speeds or n < 2:
        return
    names = [symbol.name for symbol in ours.scene.q]
    orders: list[Sequence[int]] = [sorted(range(n), key=lambda k: names[k]), range(n)[::-1]]
    if n <= FEW:
        orders += permutations(range(n))
    for i, k in combinations(range(n), 2):
        order = list(range(n))
        order[i], order[k] = k, i
        orders.append(order)
    for way in dict.fromkeys(map(tuple, orders)):
        if list(way) != list(range(n)):
            matrix = np.eye(n)[list(way)].T
            words = ", ".join(names[k] for k in way)
            yield Trial(f"the joints stand in the order {words}", _consistent(matrix))


def _consistent(matrix: Array, of_angles: Array | None = None) -> Reading:
    """Other coordinates, q = B r with a constant B, of what is given and of what is told."""
    inverse, angles = np.linalg.inv(matrix), matrix if of_angles is None else of_angles

    def arguments(states: States) -> States:
        v, a = (x @ matrix.T for x in (states.v, states.a))
        return States(states.q @ angles.T, v, a, states.f @ inverse, states.wrench)

    def values(quantity: str, found: Array, states: States) -> Array:
        kind = kind_of(quantity)
        if kind == MASS:
            return matrix.T @ found @ matrix
        if kind == FORWARD:
            return found @ inverse.T
        if found.ndim == 3 or (found.ndim == 2 and kind != VELOCITY):
            return found @ matrix
        return found

    return Reading(arguments=arguments, values=values)


def degrees(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Angles are taken in degrees."""
    lengths = {
        name_of(joint.given["distance"])
        for joint in ours.scene.joints
        if isinstance(joint, Joint) and joint.given.get("distance") is not None
    }
    if ours.scene.rotations or ours.scene.speeds:
        return
    angle = np.array([symbol.name not in lengths for symbol in ours.scene.q])
    for factor, words in (
        (1 / RADIAN, "angles in degrees are taken for radians"),
        (RADIAN, "angles in radians are taken for degrees"),
    ):
        scale = np.where(angle, factor, 1.0)
        for count, what in ((1, ""), (2, ", speeds too"), (3, ", speeds and accelerations too")):

            def arguments(s: States, scale: Array = scale, count: int = count) -> States:
                v = s.v * scale if count > 1 else s.v
                a = s.a * scale if count > 2 else s.a
                return States(s.q * scale, v, a, s.f, s.wrench)

            yield Trial(words + what, Reading(arguments=arguments))


def quaternion_orders(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Quaternions begin or end with their scalar part, or turn the other way."""
    orders = {
        "(w, x, y, z) is taken for (x, y, z, w)": (3, 0, 1, 2),
        "(x, y, z, w) is taken for (w, x, y, z)": (1, 2, 3, 0),
    }
    names = [*ours.scene.coordinates]
    if not ours.scene.rotations:
        return
    for words, order in orders.items():

        def arguments(states: States, order: tuple[int, ...] = order) -> States:
            q = states.q.copy()
            for rotation in ours.scene.rotations:
                places = [names.index(entry) for entry in rotation.coordinates]
                q[:, places] = q[:, [places[k] for k in order]]
            return States(q, states.v, states.a, states.f, states.wrench)

        yield Trial(f"the quaternion {words}", Reading(arguments=arguments))

    def turned_back(states: States) -> States:
        q = states.q.copy()
        for rotation in ours.scene.rotations:
            q[:, [names.index(entry) for entry in rotation.coordinates[1:]]] *= -1
        return States(q, states.v, states.a, states.f, states.wrench)

    yield Trial("the quaternion turns the other way", Reading(arguments=turned_back))


def velocity_frames(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """The velocity of a free body is given in another frame."""
    for joint in ours.scene.joints:
        if not isinstance(joint, Joint) or joint.given.get("kind") != "free":
            continue
        if not isinstance(joint.given["rotation"], Rotation):
            continue
        linear = [ours.scene.coordinates.index(e) for e in joint.given["coordinates"]]
        names = [u.name for u in ours.scene.u]
        turning = [names.index(name_of(u)) for u in joint.given["rotation"].speeds]
        moving = [ours.speeds.index(ours.scene.qd[k].name) for k in linear]
        for words, body, world in (
            (f"the velocity of {joint.child} is taken in its own frame", True, False),
            (f"the angular velocity of {joint.child} is taken in the inertial frame", False, True),
            (f"the velocity of {joint.child} is taken in its own frame, the angular velocity in the"
             " inertial one", True, True),
        ):  # fmt: skip
            yield Trial(words, _other_speeds(ours, joint.child, moving, turning, body, world))


def _other_speeds(
    ours: Ours, name: str, moving: list[int], turning: list[int], body: bool, world: bool
) -> Reading:
    n = len(ours.speeds)

    def frames(states: States) -> tuple[Array, Array, Array]:
        """B with v = B w, v, and B' by R' = R [omega]x, omega having components in the body."""
        turn, every = ours.links(states.q)[name][1], range(len(states))
        back = np.swapaxes(turn, 1, 2)
        matrix = np.tile(np.eye(n), (len(states), 1, 1))
        if body:
            matrix[np.ix_(every, moving, moving)] = turn
        if world:
            matrix[np.ix_(every, turning, turning)] = back
        speeds, rate = np.einsum("nij,nj->ni", matrix, states.v), np.zeros_like(matrix)
        spin = np.cross(speeds[:, None, turning], np.eye(3)).swapaxes(1, 2)
        if body:
            rate[np.ix_(every, moving, moving)] = turn @ spin
        if world:
            rate[np.ix_(every, turning, turning)] = -spin @ back
        return matrix, speeds, rate

    def arguments(states: States) -> States:
        matrix, v, rate = frames(states)
        a = np.einsum("nij,nj->ni", matrix, states.a) + np.einsum("nij,nj->ni", rate, states.v)
        f = _solved(np.swapaxes(matrix, 1, 2), states.f)
        return States(states.q, v, a, f, states.wrench)

    def values(quantity: str, found: Array, states: States) -> Array:
        matrix, speeds, rate = frames(states)
        kind = kind_of(quantity)
        if kind == MASS:
            return np.swapaxes(matrix, 1, 2) @ found @ matrix
        if kind == MOMENTUM_RATE:
            return found @ matrix + ours.momentum_matrices(states.q, speeds)[0] @ rate
        if found.ndim == 3:
            return found @ matrix
        if kind == FORWARD:
            return _solved(matrix, found - np.einsum("nij,nj->ni", rate, states.v))
        if kind == VELOCITY or found.ndim == 1:
            return found
        return np.einsum("nji,nj->ni", matrix, found)

    return Reading(arguments=arguments, values=values)


def locked_joints(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """A joint does not move."""
    n = len(ours.speeds)
    for speed, own in enumerate(ours.scene.u):
        if own not in ours.scene.qd:
            continue
        shorter = any(shape[-1:] == (n - 1,) for shape in shapes.values())
        for value in (0.0, *(k * np.pi / 4 for k in (1, 2, 3, 4, -1, -2, -3))):
            words = f"{ours.scene.q[ours.coordinate(speed)]} is locked at {value:.6g}"
            yield Trial(words, Reading(Change(locked={speed: value}), shorter=shorter))
        yield Trial(f"{own} is taken for zero", Reading(arguments=_still(n, speed)))


def _solved(matrices: Array, right: Array) -> Array:
    return np.asarray(np.linalg.solve(matrices, right[..., None])[..., 0], dtype=np.float64)


def _still(n: int, speed: int) -> Callable[[States], States]:
    """The states with one speed and its rate taken for zero."""
    kept = np.arange(n) != speed

    def arguments(states: States) -> States:
        return States(states.q, states.v * kept, states.a * kept, states.f, states.wrench)

    return arguments


def mimics(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Constraints, such as joints that mimic others, are left out."""
    if ours.scene.constraints:
        names = ", ".join(constraint.name for constraint in ours.scene.constraints)
        yield Trial(f"left out: {names}", Reading(Change(opened=True)))


def jacobian_frames(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """Velocities of a frame in another frame, or of another point."""

    def reading(way: Callable[[Array, Array, Array], Array]) -> Reading:
        def values(quantity: str, found: Array, states: States) -> Array:
            kind = kind_of(quantity)
            name = quantity.removeprefix(kind)
            if kind not in (JACOBIAN, VELOCITY) or name not in (poses := ours.links(states.q)):
                return found
            at, turn = poses[name]
            columns = found if found.ndim == 3 else found[..., None]
            moved = way(columns, at, turn)
            return moved if found.ndim == 3 else moved[..., 0]

        return Reading(values=values)

    def local(columns: Array, at: Array, turn: Array) -> Array:
        back = np.swapaxes(turn, 1, 2)
        return np.concatenate([back @ columns[:, :3], back @ columns[:, 3:]], axis=1)

    def spatial(columns: Array, at: Array, turn: Array) -> Array:
        linear = columns[:, :3] + np.cross(at[:, :, None], columns[:, 3:], axis=1)
        return np.concatenate([linear, columns[:, 3:]], axis=1)

    def swapped(columns: Array, at: Array, turn: Array) -> Array:
        return np.concatenate([columns[:, 3:], columns[:, :3]], axis=1)

    yield Trial("velocities are those in the frame of the body", reading(local))
    yield Trial("velocities are those of the body's point at the origin", reading(spatial))
    yield Trial("the angular velocity stands before the velocity", reading(swapped))
    yield Trial(
        "in the frame of the body, the angular velocity first",
        reading(lambda c, at, turn: swapped(local(c, at, turn), at, turn)),
    )


def momentum_points(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """d/dt H_G = d/dt H_P - v_G x p for P at rest, where the mass centre G is."""

    def values(quantity: str, found: Array, states: States) -> Array:
        if quantity != MOMENTUM_RATE:
            return found
        matrix, _, velocity = ours.momentum_matrices(states.q, states.v)
        added = np.cross(velocity[:, :, None], matrix[:, :3], axis=1)
        return found + np.concatenate([np.zeros_like(added), added], axis=1)

    words = (
        "the rate of the momentum matrix is that about a point at rest, where the mass centre is"
    )
    yield Trial(words, Reading(values=values))


def force_frames(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """External forces in another frame, at another point, or of the other sign."""

    def reading(way: Callable[[Array, Array, Array], Array]) -> Reading:
        def values(quantity: str, found: Array, states: States) -> Array:
            kind = kind_of(quantity)
            name = quantity.removeprefix(kind)
            if kind != FORCE or name not in (poses := ours.links(states.q)):
                return found
            at, turn = poses[name]
            wrench = way(states.wrench, at, turn)
            return np.einsum("nij,ni->nj", ours.jacobians(states.q)[name], wrench)

        return Reading(values=values)

    def local(wrench: Array, at: Array, turn: Array) -> Array:
        parts = wrench.reshape(-1, 2, 3)
        return np.einsum("nij,nkj->nki", turn, parts).reshape(-1, 6)

    def at_origin(wrench: Array, at: Array, turn: Array) -> Array:
        couple = wrench[:, 3:] - np.cross(at, wrench[:, :3])
        return np.hstack([wrench[:, :3], couple])

    yield Trial("the force is taken in the frame of the body", reading(local))
    yield Trial("the force is taken to act at the origin", reading(at_origin))
    yield Trial(
        "the couple stands before the force", reading(lambda w, *_: w[:, [3, 4, 5, 0, 1, 2]])
    )
    yield Trial("the force has the opposite sign", reading(lambda w, *_: -w))
    yield Trial(
        "in the frame of the body, the couple first",
        reading(lambda w, at, turn: local(w[:, [3, 4, 5, 0, 1, 2]], at, turn)),
    )
    yield Trial(
        "the force in the frame of the body has the opposite sign",
        reading(lambda w, at, turn: -local(w, at, turn)),
    )


def not_computed(ours: Ours, shapes: Shapes) -> Iterator[Trial]:
    """What an engine keeps in its data, read without being computed, or before."""

    def before(values: Array) -> Array:
        return np.concatenate([np.zeros_like(values[:1]), values[:-1]])

    for quantity in shapes:
        for words, way in (
            ("is left at zero: nothing computes it", np.zeros_like),
            ("is that of the state before: it is read before it is computed", before),
        ):

            def values(name: str, found: Array, states: States, way: Callable = way) -> Array:
                return np.asarray(way(found))

            yield Trial(f"{quantity} {words}", Reading(values=values, only=(quantity,)))


CAUSES: tuple[Cause, ...] = (
    Cause("not computed", not_computed),
    Cause("upper triangle only", upper_triangle),
    Cause("frame of a velocity", jacobian_frames),
    Cause("frame of an external force", force_frames),
    Cause("point of a momentum", momentum_points),
    Cause("order of a quaternion", quaternion_orders),
    Cause("frame of a velocity", velocity_frames),
    Cause("degrees", degrees),
    Cause("mimic ignored", mimics),
    Cause("locked joint", locked_joints),
    Cause("order of the joints", joint_orders),
    Cause("sign of a joint axis", axis_signs),
)
"""Each cause that has no amount."""
