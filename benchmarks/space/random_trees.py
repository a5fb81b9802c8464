"""Random trees of turning and sliding joints, as scenes with symbols and as links with numbers."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from hypothesis import strategies as st
from sympy import Expr, Symbol, pi

from benchmarks.space.scenes import Joint, general, real, scene
from benchmarks.space.textbook import Link, turn
from mechanics.scene import Scene


@st.composite
def trees(draw: st.DrawFn, largest: int = 7) -> tuple[Joint, ...]:
    joints = []
    for i in range(1, draw(st.integers(1, largest)) + 1):
        axes = st.integers(0, 2)
        angles = st.sampled_from([pi / 2, -pi / 2, pi, *real(f"beta{i}")])
        offset = real(f"rx{i}", f"ry{i}", f"rz{i}")
        joints.append(
            Joint(
                draw(st.integers(-1, i - 2)),
                draw(axes),
                draw(st.sampled_from([True, True, False])),
                tuple(draw(st.lists(st.tuples(axes, angles), max_size=2))),
                tuple(r if draw(st.booleans()) else 0 for r in offset),
                **general(i),
            )
        )
    return tuple(joints)


def build(joints: tuple[Joint, ...]) -> Scene:
    return scene("random tree", joints)


def numbers(joints: tuple[Joint, ...], seed: int) -> tuple[list[Link], dict[str, float]]:
    """The links at drawn numbers, and the numbers by the names of the scene."""
    draw = np.random.default_rng(seed)
    values: dict[str, float] = {"g": 9.81}
    for joint in joints:
        angles = [angle for _, angle in joint.turns if not angle.is_number]
        fixed = [entry for entry in joint.offset if entry != 0]
        named = (*angles, *fixed, *joint.centre, joint.mass, *joint.inertia)
        drawn = (
            *draw.uniform(-3, 3, len(angles)), *draw.uniform(-1, 1, len(fixed) + 3),
            draw.uniform(0.5, 2), *draw.uniform(1, 2, 3), *draw.uniform(-0.4, 0.4, 3),
        )  # fmt: skip
        values |= {symbol.name: value for symbol, value in zip(named, drawn, strict=True)}
    return links(joints, values), values


def links(joints: tuple[Joint, ...], values: Mapping[str, Any]) -> list[Link]:
    """The links at values by the names of the scene, which may be complex."""

    def at(entry: Expr | int) -> Any:
        return values[entry.name] if isinstance(entry, Symbol) else float(entry)

    found = []
    for joint in joints:
        rotation = np.eye(3)
        for axis, angle in joint.turns:
            step = turn(axis, at(angle))
            rotation = rotation @ (np.round(step) if angle.is_number else step)
        xx, yy, zz, xy, yz, zx = map(at, joint.inertia)
        found.append(
            Link(
                joint.parent, joint.axis, joint.turning, rotation,
                np.array([at(entry) for entry in joint.offset]), at(joint.mass),
                np.array([at(entry) for entry in joint.centre]),
                np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]),
            )
        )  # fmt: skip
    return found


def state(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, float]]:
    """q, q', q'' and the same by the names of the scene."""
    draw = np.random.default_rng(seed)
    q, qd, qdd = draw.uniform(-3, 3, (3, count))
    values: dict[str, float] = {}
    for i in range(count):
        values |= {f"q{i + 1}": q[i], f"q{i + 1}_dot": qd[i], f"q{i + 1}_ddot": qdd[i]}
    return q, qd, qdd, values
