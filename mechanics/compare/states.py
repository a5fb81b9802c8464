"""States at which engines are compared: drawn over the model's range, the same ones each time.

    coordinates     uniform between the limits that the scene declares as conditions, or in
                    (-pi, pi), distances of sliders in (-1, 1) m, quaternions on the unit sphere
    v, a, forces    uniform in (-2, 2), wrenches too

Where constraints hold, q is projected by Newton's method, v and a by least squares.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sympy.core.function import AppliedUndef

from mechanics.scene import Scene
from mechanics.scene.joints import Joint
from mechanics.scene.symbols import name_of

Array = NDArray[np.float64]
LARGEST = 2.0
SEED = 20


@dataclass(frozen=True, eq=False)
class States:
    """N states, a row each.

    Attributes
    ----------
    q : (N, coordinates)
    v, a, f : (N, speeds)
        Speeds, their rates, and generalized forces that are given where accelerations are asked.
    wrench : (N, 6)
        Force in N and couple in N m, that act on a named frame.
    """

    q: Array
    v: Array
    a: Array
    f: Array
    wrench: Array

    def __len__(self) -> int:
        return len(self.q)

    def repeated(self, times: int) -> States:
        """So many copies of the states, one after the other."""
        groups = (self.q, self.v, self.a, self.f, self.wrench)
        return States(*(np.tile(group, (times, 1)) for group in groups))

    @property
    def rows(self) -> list[tuple[Array, Array, Array, Array, Array]]:
        """(q, v, a, f, wrench) of each state."""
        return list(zip(self.q, self.v, self.a, self.f, self.wrench, strict=True))


def draw(scene: Scene, count: int, values: Mapping[str, float]) -> States:
    """States without regard to constraints; numbers of parameters for limits that hold some."""
    random = np.random.default_rng(SEED)
    limits, names = limits_of(scene, values), [symbol.name for symbol in scene.q]
    q = np.stack([random.uniform(*limits[name], count) for name in names], axis=1)
    for rotation in scene.rotations:
        places = [names.index(name_of(entry)) for entry in rotation.coordinates]
        turned = random.normal(size=(count, 4))
        q[:, places] = turned / np.linalg.norm(turned, axis=1, keepdims=True)
    v, a, f = (random.uniform(-LARGEST, LARGEST, (count, len(scene.u))) for _ in range(3))
    return States(q, v, a, f, random.uniform(-LARGEST, LARGEST, (count, 6)))


def limits_of(scene: Scene, values: Mapping[str, float]) -> dict[str, tuple[float, float]]:
    """The range of each coordinate by its name."""
    found = {symbol.name: (-np.pi, np.pi) for symbol in scene.q}
    for joint in scene.joints:
        if isinstance(joint, Joint) and joint.given.get("kind") in ("slide", "cylindrical"):
            distance = joint.given.get("distance")
            if distance is not None:
                found[name_of(distance)] = (-1.0, 1.0)
        if isinstance(joint, Joint) and joint.given.get("kind") == "free":
            found |= {name_of(entry): (-1.0, 1.0) for entry in joint.given["coordinates"]}
    for condition in scene.conditions:
        held = condition.margin.atoms(AppliedUndef)
        if len(held) != 1 or not held <= set(scene.coordinates):
            continue
        (own,) = held
        margin = condition.margin.xreplace({s: values.get(s.name, s) for s in scene.parameters})
        slope = margin.diff(own)
        if slope.is_number and slope != 0:
            edge = float((own - margin / slope).expand())
            low, high = found[name_of(own)]
            found[name_of(own)] = (edge, max(edge, high)) if slope > 0 else (min(edge, low), edge)
    return found
