"""Random trees of turning and sliding joints, as scenes with symbols and as links with numbers."""

import numpy as np
from hypothesis import strategies as st
from sympy import pi

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
    links = []
    for joint in joints:
        rotation, typical = np.eye(3), draw.uniform(-3, 3)
        for axis, angle in joint.turns:
            if angle.is_number:
                rotation = rotation @ np.round(turn(axis, float(angle)))
            else:
                rotation = rotation @ turn(axis, typical)
                values[angle.name] = typical
        offset = np.array([draw.uniform(-1, 1) if entry != 0 else 0.0 for entry in joint.offset])
        centre, mass = draw.uniform(-1, 1, 3), draw.uniform(0.5, 2)
        moments, products = draw.uniform(1, 2, 3), draw.uniform(-0.4, 0.4, 3)
        inertia = np.diag(moments)
        for (i, j), entry in zip(((0, 1), (1, 2), (0, 2)), products, strict=True):
            inertia[i, j] = inertia[j, i] = entry
        given = zip(joint.offset, offset, strict=True)
        values |= {symbol.name: value for symbol, value in given if symbol != 0}
        named = (joint.mass, *joint.centre, *joint.inertia)
        drawn = (mass, *centre, *moments, *products)
        values |= {symbol.name: value for symbol, value in zip(named, drawn, strict=True)}
        links.append(
            Link(joint.parent, joint.axis, joint.turning, rotation, offset, mass, centre, inertia)
        )
    return links, values


def state(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, float]]:
    """q, q', q'' and the same by the names of the scene."""
    draw = np.random.default_rng(seed)
    q, qd, qdd = draw.uniform(-3, 3, (3, count))
    values: dict[str, float] = {}
    for i in range(count):
        values |= {f"q{i + 1}": q[i], f"q{i + 1}_dot": qd[i], f"q{i + 1}_ddot": qdd[i]}
    return q, qd, qdd, values
