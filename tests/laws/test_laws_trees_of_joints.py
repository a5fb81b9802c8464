"""Random trees of joints of every kind: four routes agree with each other and with a recursion.

The recursion is a textbook's in plain NumPy. It knows turns and slides about coordinate axes: here
a joint is a chain of them on links without mass, what is fixed a link that does not move.
"""

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, eye, pi
from sympy.physics.mechanics import Point, ReferenceFrame, inertia
from trees_of_joints import STEPS, Drawn, joined, mass_of, trees

from benchmarks.space.textbook import Link, inverse_dynamics, turn
from mechanics import compile, derive
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.routes.derivation import ROUTES
from mechanics.scene import RigidBody, Scene, gravity

Array = np.ndarray
OBLIQUE = Matrix([[0, -3, 4], [5, 0, 0], [0, 4, 3]]) / 5
"""Its third column is the axis of an oblique pin."""


def offset_of(i: int) -> list[Rational]:
    return [Rational(2 + i, 10), Rational(-3, 10), Rational(1 + i, 5)]


def scene_of(tree: tuple[Drawn, ...]) -> Scene:
    N, O = ReferenceFrame("N"), Point("O")
    frames, points, names = [N], [O], [None]
    joints, bodies = [], []
    for i, drawn in enumerate(tree, start=1):
        outer = frames[drawn.parent]
        axis = (outer.x, outer.y, outer.z)[drawn.axis]
        fixed = outer.orientnew(f"F{i}", "Axis", (drawn.angle * pi / 6, axis))
        step = sum(c * e for c, e in zip(offset_of(i), (outer.x, outer.y, outer.z), strict=True))
        at = points[drawn.parent].locatenew(f"P{i}", step)
        joint = joined(drawn, f"J{i}", names[drawn.parent], at, fixed)
        mass, centre, moments = mass_of(i)
        own = joint.frame
        arm = sum(c * e for c, e in zip(centre, (own.x, own.y, own.z), strict=True))
        place = joint.point.locatenew(f"C{i}", arm)
        bodies.append(RigidBody(joint.child, place, own, mass, inertia(own, *moments)))
        joints.append(joint)
        frames.append(own)
        points.append(joint.point)
        names.append(joint.child)
    g = Rational(981, 100)
    return Scene("tree", N, O, bodies=tuple(bodies), joints=tuple(joints),
                 loads=(gravity(-g * N.z),))  # fmt: skip


def links_of(tree: tuple[Drawn, ...]) -> tuple[list[Link], list[int]]:
    """The links, and which of them have a coordinate."""
    links: list[Link] = []
    moving: list[int] = []
    last = [-1]
    none = np.zeros(3)

    def add(parent: int, axis: int, turning: bool, rotation: Array, offset: Array) -> int:
        links.append(Link(parent, axis, turning, rotation, offset, 0.0, none, np.zeros((3, 3))))
        return len(links) - 1

    for i, drawn in enumerate(tree, start=1):
        rotation = turn(drawn.axis, drawn.angle * np.pi / 6)
        at = add(last[drawn.parent], 0, False, rotation, np.array(offset_of(i), dtype=float))
        if drawn.kind == "oblique":
            matrix = np.array(OBLIQUE, dtype=float)
            at = add(at, 2, True, matrix, none)
            moving.append(at)
            at = add(at, 0, False, matrix.T, none)
        elif drawn.kind == "backward":
            flip = np.diag([-1.0, -1.0, 1.0])
            at = add(at, 1, True, flip, none)
            moving.append(at)
            at = add(at, 0, False, flip, none)
        else:
            for step in STEPS[drawn.kind]:
                at = add(at, "xyz".index(step.lower()), step.isupper(), np.eye(3), none)
                moving.append(at)
        mass, centre, (xx, yy, zz, xy, yz, zx) = mass_of(i)
        tensor = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]], dtype=float)
        links[at] = Link(**{**vars(links[at]), "mass": float(mass), "inertia": tensor,
                            "centre": np.array(centre, dtype=float)})  # fmt: skip
        last.append(at)
    return links, moving


def torques(tree: tuple[Drawn, ...], q: Array, u: Array, ud: Array) -> Array:
    links, moving = links_of(tree)
    every = np.zeros((3, len(links)))
    every[:, moving] = q, u, ud
    return inverse_dynamics(links, *every, 9.81)[moving]


def test_the_oblique_axis_is_the_third_of_a_rotation() -> None:
    assert eye(3) == OBLIQUE.T * OBLIQUE
    assert OBLIQUE.det() == 1


def assert_all_agree(tree: tuple[Drawn, ...], number: int) -> None:
    scene = scene_of(tree)
    programs = derive_rows(check_scene(scene), [route.name for route in ROUTES])
    assert all(finding.shown for finding in compare_pairs(programs.routes).values())
    assert all(finding.shown for finding in check_laws(programs))
    model = compile(derive(scene), compiler=None)
    rng = np.random.default_rng(number)
    q, u = rng.uniform(-1, 1, (2, len(scene.q)))
    found = model.forward_dynamics(q, u)
    left = torques(tree, q, u, found)
    sizes = np.abs(torques(tree, q, u, 0 * found)) + np.abs(found).max() + 1
    assert np.all(np.abs(left) < 1e-10 * sizes)


@pytest.mark.campaign
@pytest.mark.parametrize("kind", [kind for kind in STEPS if kind in ("oblique", "planar")])
def test_one_joint_agrees(kind: str) -> None:
    assert_all_agree((Drawn(0, kind, 0, 1),), 1)


@pytest.mark.campaign
@seed(13)
@settings(max_examples=12, deadline=None, phases=(Phase.explicit, Phase.generate), database=None)
@given(tree=trees(), number=st.integers(0, 99))
def test_random_trees_agree(tree: tuple[Drawn, ...], number: int) -> None:
    assert_all_agree(tree, number)
