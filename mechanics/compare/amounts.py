"""Causes that have an amount, found by least squares: the forces are linear in it.

    observed = ours + sum_k x_k (ours changed by unit k - ours)

A changed inertia, mass, gravity, armature or damping. What x has to be for the cause to be the
cause is a part of the row: any field of gravity, an armature of no negative sign, an inertia that
is taken otherwise for whole bodies.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from mechanics.compare.change import AMOUNTS as ADDED
from mechanics.compare.change import Array, Change
from mechanics.compare.ours import Ours, carried
from mechanics.scene.joints import Joint

SHARP = 1e-6
"""How far a fitted factor may be from the whole number that it has to be."""


@dataclass(frozen=True)
class Amount:
    """A cause with an amount.

    Attributes
    ----------
    units : callable
        From our numbers to the changes whose factors are fitted.
    told : callable
        From our numbers, the factors, and what is nothing beside the largest, to words; "" where
        they are not this cause.
    whole : bool
        Whether each factor is 0 or 1.
    """

    name: str
    units: Callable[[Ours], list[Change]]
    told: Callable[[Ours, Array, float], str]
    whole: bool = False


def together(changes: Sequence[Change], factors: Sequence[float]) -> Change:
    """The sum of changes, each times its factor."""
    total: dict[str, Any] = {}
    for change, factor in zip(changes, factors, strict=True):
        for name in ADDED:
            part = getattr(change, name)
            if part is not None and factor:
                total[name] = total.get(name, 0.0) + factor * part
    return Change(**total)


def stacked(changes: Sequence[Change], count: int) -> Change:
    """The changes one after the other, each for so many states."""
    rows: dict[str, Any] = {}
    for name in ADDED:
        parts = [getattr(change, name) for change in changes]
        known = next((np.asarray(part) for part in parts if part is not None), None)
        if known is not None:
            table = [np.zeros_like(known) if part is None else part for part in parts]
            rows[name] = np.repeat(np.stack(table), count, axis=0)
    return Change(**rows)


def joined(one: Change, two: Change) -> Change:
    """Both changes."""
    both = together((one, two), (1.0, 1.0))
    return replace(
        both,
        opened=one.opened or two.opened,
        locked={**one.locked, **two.locked},
    )


def _of_one_sign(
    words: str, without: str, unit: str, have: Callable[[Ours], Array]
) -> Callable[[Ours, Array, float], str]:
    """Amounts that are added, or left out of what the scene has."""

    def told(ours: Ours, x: Array, sharp: float) -> str:
        large = np.abs(x).max(initial=0.0)
        least = sharp * large
        if not large or x.min() < -least < least < x.max():
            return ""
        if np.any(x < -have(ours) * (1 + sharp) - least):
            return ""
        kept = [(n, abs(v)) for n, v in zip(ours.labels, x, strict=True) if abs(v) > least]
        return f"{words if x.max() > least else without}: " + ", ".join(
            f"{number(v)} {unit} at {n}" for n, v in kept
        )

    return told


def _rotors(ours: Ours) -> Array:
    """Bodies that no joint carries are rotors; how large they are is not asked."""
    loose = {body.name for body in ours.scene.bodies} - set(carried(ours.scene))
    return np.full(len(ours.speeds), np.inf if loose else 0.0)


def _damping(ours: Ours) -> Array:
    return np.abs(np.diagonal(ours.damping(ours.zero)[0]))


def _friction(ours: Ours) -> Array:
    """What does not grow with the speed, of the forces that change sign with it."""
    still, n = np.zeros((1, len(ours.speeds))), len(ours.speeds)
    odd = [
        (ours.forces(ours.zero, unit[None], still) - ours.forces(ours.zero, -unit[None], still)) / 2
        for unit in np.eye(n)
    ]
    return np.abs([odd[k][0, k] for k in range(n)] - np.diagonal(ours.damping(ours.zero)[0]))


def _gravity(ours: Ours, x: Array, sharp: float) -> str:
    own, field = ours.gravity, ours.gravity + x
    least = sharp * max(np.abs(own).max(), np.abs(field).max())
    if np.abs(x).max() <= least:
        return ""
    before = ", ".join(number(e, least) for e in own)
    after = ", ".join(number(e, least) for e in field)
    if np.abs(field).max() <= least:
        return f"gravity is left out: 0 in place of ({before}) m/s^2"
    if np.abs(field + own).max() <= least:
        return f"gravity has the opposite sign: ({after}) in place of ({before}) m/s^2"
    if np.abs(np.cross(field, own)).max() <= least * np.abs(own).max():
        return f"gravity has another size: ({after}) in place of ({before}) m/s^2"
    return f"gravity has another direction: ({after}) in place of ({before}) m/s^2"


def _implicit(ours: Ours, x: Array, sharp: float) -> str:
    if x[0] <= 0:
        return ""
    return f"the accelerations are those of an implicit step of {number(x[0])} s, damped at its end"


Inertia = Callable[[float, Array, Array], Array]
"""From the mass of a body, the way from its joint to its centre, and its inertia, to a change."""


def _per_body(change: Inertia) -> Callable[[Ours], list[Change]]:
    """The same change of one body after the other."""
    return lambda ours: [
        _of_body(ours, place, change(*entries)) for place, entries in enumerate(arms(ours))
    ]


def _of_body(ours: Ours, place: int, inertia: Array, mass: float = 0.0) -> Change:
    count = len(ours.mechanism.bodies)
    masses, inertias = np.zeros(count), np.zeros((count, 3, 3))
    masses[place] = mass
    if ours.mechanism.bodies[place].inertia is not None:
        inertias[place] = inertia
    return Change(masses=masses, inertias=inertias)


def arms(ours: Ours) -> list[tuple[float, Array, Array]]:
    """Of each body its mass, the way from its joint to its centre, its inertia; in its frame."""
    poses = {name: at for name, (at, _) in ours.links(ours.zero).items()}
    found = []
    for body, (mass, centre, turn, inertia) in zip(
        ours.mechanism.bodies, ours.bodies(ours.zero), strict=True
    ):
        origin = poses.get(body.name)
        arm = np.zeros(3) if origin is None else turn.T @ (centre - origin[0])
        found.append((float(mass), arm, inertia))
    return found


def about(mass: float, arm: Array) -> Array:
    """m (c.c 1 - c c^T): what an inertia grows by away from the mass centre."""
    return mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))


def _mass_units(ours: Ours) -> list[Change]:
    return [Change(masses=unit) for unit in np.eye(len(ours.mechanism.bodies))]


def _masses(ours: Ours, x: Array, sharp: float) -> str:
    masses = np.array([mass for mass, _, _ in arms(ours)])
    least = sharp * max(masses.max(), np.abs(x).max())
    kept = [
        f"{number(mass + more)} in place of {number(mass)} kg of {body.name}"
        for body, mass, more in zip(ours.mechanism.bodies, masses, x, strict=True)
        if abs(more) > least
    ]
    # Several would be fitted to whatever shifts what is carried.
    return f"another mass: {kept[0]}" if len(kept) == 1 else ""


def _lost(ours: Ours) -> list[Change]:
    return [
        _of_body(ours, place, -inertia, -mass)
        for place, (mass, _, inertia) in enumerate(arms(ours))
    ]


def _by_default(ours: Ours) -> list[Change]:
    """What Bullet gives a link without inertia: 1 kg, and 1 kg m^2 about each axis."""
    return [
        _of_body(ours, place, np.eye(3) * bare, float(bare))
        for place, (mass, _, inertia) in enumerate(arms(ours))
        for bare in (not mass and not inertia.any(),)
    ]


def _impossible(mass: float, arm: Array, inertia: Array) -> Array:
    """One principal moment exceeds the sum of the others: readers of files correct that."""
    moments = np.linalg.eigvalsh(inertia)
    beyond = moments[0] < 0 or moments[2] > (moments[0] + moments[1]) * (1 + SHARP)
    return -inertia * beyond


def _names(
    words: str, of: Callable[[Ours], Sequence[str]] | None = None
) -> Callable[[Ours, Array, float], str]:
    """Which of the bodies, or of others, have a factor."""

    def told(ours: Ours, x: Array, sharp: float) -> str:
        every = [body.name for body in ours.mechanism.bodies] if of is None else of(ours)
        names = [name for name, factor in zip(every, x, strict=True) if factor]
        return f"{words}: {', '.join(names)}" if names else ""

    return told


def _turned(order: Sequence[int]) -> Inertia:
    return lambda mass, arm, inertia: inertia[np.ix_(order, order)] - inertia


def _products(order: Sequence[int] | None) -> Inertia:
    """Products of inertia (xy, yz, zx) in another order, or of the other sign."""

    def change(mass: float, arm: Array, inertia: Array) -> Array:
        xy, yz, zx = own = inertia[0, 1], inertia[1, 2], inertia[0, 2]
        a, b, c = (-xy, -yz, -zx) if order is None else (own[k] for k in order)
        return np.array([[0, a - xy, c - zx], [a - xy, 0, b - yz], [c - zx, b - yz, 0]])

    return change


def turnings(ours: Ours) -> Iterator[tuple[str, list[Change]]]:
    """Inertias that were not turned, or turned the other way, by the fixed turn before the joint,
    or from their own frame into that of the joint.
    """
    poses = ours.links(ours.zero)
    parents = {j.child: j.parent for j in ours.scene.joints if isinstance(j, Joint)}
    turns: dict[str, list[Array]] = {"frame of the link before": [], "frame of the joint": []}
    for body, (_, _, own, _) in zip(ours.mechanism.bodies, ours.bodies(ours.zero), strict=True):
        link = poses.get(body.name, (None, None))[1]
        before = poses.get(parents.get(body.name) or "", (None, None))[1]
        base = np.eye(3) if before is None else before[0]
        turns["frame of the link before"].append(base.T @ own)
        turns["frame of the joint"].append(np.eye(3) if link is None else link[0].T @ own)
    for words, matrices in turns.items():
        for way, text in ((1, f"is taken in the {words}"), (-1, f"is turned twice by the {words}")):
            units = []
            for place, (turn, (_, _, inertia)) in enumerate(zip(matrices, arms(ours), strict=True)):
                # Components that are those of another frame are R^T I R in the body's own.
                right = turn if way > 0 else turn.T
                units.append(_of_body(ours, place, right.T @ inertia @ right - inertia))
            yield text, units


def _same(units: list[Change], ours: Ours) -> list[Change]:
    return units


def number(value: float, least: float = 0.0) -> str:
    """Six digits; 0 for what is not more than rounding."""
    return f"{0.0 if abs(value) <= least else value:.6g}"


def _inertia(name: str, words: str, change: Inertia) -> Amount:
    return Amount(name, _per_body(change), _names(words), whole=True)


POINT = "inertia about the wrong point"
TURNED = "inertia turned"
ORDER = "order or sign of the products of inertia"

AMOUNTS: tuple[Amount, ...] = (
    Amount(
        "gravity",
        lambda ours: [Change(gravity=unit) for unit in np.eye(3)],
        _gravity,
    ),
    Amount(
        "a link without inertia",
        _by_default,
        _names("links that have no inertia are given 1 kg and 1 kg m^2"),
        whole=True,
    ),
    _inertia("impossible inertia", "inertias that no body has are taken for zero", _impossible),
    Amount("implicit integration", lambda ours: [Change(step=1.0)], _implicit),
    Amount(
        "armature",
        lambda ours: [Change(armature=unit) for unit in np.eye(len(ours.speeds))],
        _of_one_sign("rotors' inertia is added", "rotors' inertia is left out", "kg m^2", _rotors),
    ),
    Amount(
        "joint damping",
        lambda ours: [Change(damping=unit) for unit in np.eye(len(ours.speeds))],
        _of_one_sign("joints are damped", "damping of joints is left out", "N m s/rad", _damping),
    ),
    Amount(
        "dry friction",
        lambda ours: [Change(friction=unit) for unit in np.eye(len(ours.speeds))],
        _of_one_sign("joints rub", "dry friction of joints is left out", "N m", _friction),
    ),
    Amount(
        "a load left out",
        lambda ours: [Change(loads=unit) for unit in np.eye(len(ours.loads))],
        _names("left out of the loads", lambda ours: ours.loads),
        whole=True,
    ),
    _inertia(
        POINT,
        "the inertia is taken about the joint, not about the mass centre",
        lambda mass, arm, inertia: -about(mass, arm),
    ),
    _inertia(
        POINT,
        "the inertia is taken about the mass centre after it was moved to the joint",
        lambda mass, arm, inertia: about(mass, arm),
    ),
    _inertia(ORDER, "products of inertia have the other sign", _products(None)),
    _inertia(
        ORDER,
        "products of inertia are left out",
        lambda m, c, inertia: np.diag(np.diag(inertia)) - inertia,
    ),
    _inertia(ORDER, "products of inertia yz and zx are exchanged", _products((0, 2, 1))),
    _inertia(ORDER, "products of inertia xy and yz are exchanged", _products((1, 0, 2))),
    _inertia(ORDER, "products of inertia xy and zx are exchanged", _products((2, 1, 0))),
    _inertia(TURNED, "axes x and y of the inertia are exchanged", _turned((1, 0, 2))),
    _inertia(TURNED, "axes y and z of the inertia are exchanged", _turned((0, 2, 1))),
    _inertia(TURNED, "axes x and z of the inertia are exchanged", _turned((2, 1, 0))),
    _inertia(TURNED, "the axes of the inertia are taken as y, z, x", _turned((1, 2, 0))),
    _inertia(TURNED, "the axes of the inertia are taken as z, x, y", _turned((2, 0, 1))),
    Amount("a body left out", _lost, _names("without mass and inertia"), whole=True),
    _inertia("a body left out", "without inertia", lambda mass, arm, inertia: -inertia),
    Amount("mass", _mass_units, _masses),
)
"""Each cause that has an amount."""


def amounts(ours: Ours) -> Iterator[Amount]:
    """The table for a scene, with the turns that its own frames make possible."""
    for amount in AMOUNTS:
        if amount is AMOUNTS[-1]:
            for words, units in turnings(ours):
                told = _names(f"the inertia {words}")
                yield Amount(TURNED, partial(_same, units), told, whole=True)
        if amount.units(ours):
            yield amount
