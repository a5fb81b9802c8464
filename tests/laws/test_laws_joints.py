"""Joints of every kind, with another body on each: routes agree, reactions do no work, and more."""

from collections.abc import Callable, Mapping

import pytest
from sympy import Matrix, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import crosscheck
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.recursions.joints import joint_tree
from mechanics.recursions.pseudo_inertia import moments
from mechanics.routes.derivation import ROUTES
from mechanics.scene import (
    Joint,
    RigidBody,
    Rope,
    Scene,
    ball,
    cylindrical,
    euler,
    free,
    gravity,
    parameters,
    pin,
    planar,
    quaternion,
    roll,
    rope,
    slide,
    universal,
    weld,
)
from mechanics.scene.geometry import relative_rotation

x, y, z, a, b, c, s = dynamicsymbols("x y z a b c s")
N, O = ReferenceFrame("N"), Point("O")
F = N.orientnew("F", "Axis", (pi / 5, N.x))
g, L, m, A, B, C = parameters(
    "g L m A B C", units="m/s^2 m kg kg*m^2 kg*m^2 kg*m^2", typical="9.81 1/2 2 1/10 1/5 1/4"
)

JOINTS: Mapping[str, tuple[int, Callable[[str | None], Joint]]] = {
    "pin": (1, lambda on: pin("J", on, "one", at=O, axis=F.z, angle=a)),
    "pin about any axis": (1, lambda on: pin("J", on, "one", at=O, axis=F.x + 2 * F.z, angle=a)),
    "slide": (1, lambda on: slide("J", on, "one", at=O, axis=F.y - F.x, distance=x)),
    "cylindrical": (2, lambda on: cylindrical("J", on, "one", at=O, axis=F.z, angle=a, distance=x)),
    "universal": (2, lambda on: universal("J", on, "one", at=O, frame=F, axes="xz", angles=(a, b))),
    "planar": (3, lambda on: planar("J", on, "one", at=O, frame=F, coordinates=(x, y), angle=a)),
    "ball": (3, lambda on: ball("J", on, "one", at=O, frame=F, rotation=euler("zxz", a, b, c))),
    "ball, quaternion": (
        3, lambda on: ball("J", on, "one", at=O, frame=F,
                           rotation=quaternion("e0 e1 e2 e3", "wx wy wz")),
    ),
    "free": (
        6, lambda on: free("J", "one", at=O, frame=F, coordinates=(x, y, z),
                           rotation=euler("xyz", a, b, c)),
    ),
    "roll, leaning": (
        3, lambda on: roll("J", on, "one", at=O, normal=F.z, radius=L, coordinates=(x, y),
                           angles=(a, b, c)),
    ),
    "roll, upright": (
        1, lambda on: roll("J", on, "one", at=O, normal=-F.y, axis=F.z, radius=L,
                           coordinates=(x,), angles=(a,)),
    ),
    "roll, in a ring": (
        1, lambda on: roll("J", on, "one", at=O, normal=F.y, axis=F.x, inside=3 * L, radius=L,
                           angles=(a, b)),
    ),
}  # fmt: skip

LONG = {"pin", "pin about any axis", "universal", "ball", "ball, quaternion", "free"} | {
    kind for kind in JOINTS if kind.startswith("roll")
}
QUICK = [pytest.param(kind, marks=[pytest.mark.campaign] * (kind in LONG)) for kind in JOINTS]
LAST = [pytest.param(kind, marks=[pytest.mark.long] * (kind in LONG)) for kind in JOINTS]


def two_bodies(joint: Joint) -> Scene:
    """A body on the joint, and another on a hinge of that."""
    frame = joint.frame
    one = joint.point.locatenew("C1", L * frame.x + L / 3 * frame.y)
    elbow = one.locatenew("E", L * frame.y)
    hinge = pin("K", "one", "two", at=elbow, axis=frame.x, angle=s)
    two = elbow.locatenew("C2", L * hinge.frame.z)
    bodies = (
        RigidBody("one", one, frame, m, inertia(frame, A, B, C)),
        RigidBody("two", two, hinge.frame, m, inertia(hinge.frame, C, B, A)),
    )
    return Scene("two bodies", N, O, bodies=bodies, joints=(joint, hinge),
                 loads=(gravity(-g * N.y),))  # fmt: skip


@pytest.mark.parametrize("kind", QUICK)
def test_all_routes_agree_and_all_laws_hold(kind: str) -> None:
    programs = derive_rows(check_scene(two_bodies(JOINTS[kind][1](None))), [r.name for r in ROUTES])
    pairs = compare_pairs(programs.routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    assert all(finding.shown for finding in check_laws(programs))


@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", JOINTS)
def test_what_a_joint_does_not_move_it_holds(kind: str) -> None:
    freedoms, make = JOINTS[kind]
    joint = make(None)
    assert len(joint.reactions) == 6 - freedoms
    scene = two_bodies(joint)
    assert scene.degrees_of_freedom == freedoms + 1
    for reaction in joint.reactions:
        along = [entry for axis in reaction.along.args for entry in axis[0]]
        assert sum(entry**2 for entry in along) == 1


@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", [k for k in JOINTS if not {"quaternion", "roll,"} & {*k.split()}])
def test_the_recursions_know_it_as_a_tree_of_single_joints(kind: str) -> None:
    mechanism = lower(two_bodies(JOINTS[kind][1](None)), Builder())
    tree = joint_tree(mechanism, moments(mechanism))
    assert tree is not None
    assert len(tree) == len(mechanism.q)


@pytest.mark.campaign
def test_a_weld_moves_with_its_parent_and_bears_its_load() -> None:
    hinge = pin("H", None, "base", at=O, axis=N.z, angle=a)
    base = RigidBody("base", O.locatenew("C0", L * hinge.frame.x), hinge.frame, m,
                     inertia(hinge.frame, A, B, C))  # fmt: skip
    fixed = weld("W", "base", "tip", at=base.centre, frame=hinge.frame)
    tip = RigidBody("tip", fixed.point.locatenew("C1", L * fixed.frame.y), fixed.frame, m,
                    inertia(fixed.frame, A, B, C))  # fmt: skip
    scene = Scene("welded", N, O, bodies=(base, tip), joints=(hinge, fixed),
                  loads=(gravity(-g * N.y),))  # fmt: skip
    assert len(fixed.reactions) == 6
    assert scene.degrees_of_freedom == 1
    programs = derive_rows(check_scene(scene), [route.name for route in ROUTES])
    assert all(finding.shown for finding in compare_pairs(programs.routes).values())


@pytest.mark.parametrize("order", ["zxz", "xyz", "yzy"])
def test_euler_angles_turn_about_the_axes_that_are_turned(order: str) -> None:
    joint = ball("J", None, "one", at=O, frame=N, rotation=euler(order, a, b, c))
    product = Matrix.eye(3)
    for axis, angle in zip(order, (a, b, c), strict=True):
        step = N.orientnew(f"S{axis}", "Axis", (angle, getattr(N, axis)))
        product = product * relative_rotation(N, step)
    assert N.dcm(joint.frame) == product


CLOSING: Mapping[str, tuple[int, Callable[[Point, ReferenceFrame], Joint | Rope]]] = {
    "ball": (3, lambda P, own: ball("J", None, "one", at=O, frame=N, onto=P)),
    "pin": (1, lambda P, own: pin("J", None, "one", at=O, axis=N.z, onto=(P, own.z))),
    "cylindrical": (
        2, lambda P, own: cylindrical("J", None, "one", at=O, axis=N.x, onto=(P, own.x)),
    ),
    "slide": (1, lambda P, own: slide("J", None, "one", at=O, axis=N.x + N.y, onto=(P, own))),
    "universal": (
        2, lambda P, own: universal("J", None, "one", at=O, frame=N, axes="xy", onto=(P, own.y)),
    ),
    "planar": (3, lambda P, own: planar("J", None, "one", at=O, frame=N, onto=(P, own.z))),
    "roll": (
        3, lambda P, own: roll("J", None, "one", at=O, normal=N.z, radius=(L, L, 2 * L),
                               onto=(P, own)),
    ),
    "rope": (
        5, lambda P, own: rope("J", (None, O.locatenew("Q", L * N.x)), ("one", P), length=L),
    ),
}  # fmt: skip


def free_and_closed(kind: str) -> Scene:
    """A body in the air that a joint holds by its constraints alone."""
    air = free("A", "one", at=O, frame=N, coordinates=(x, y, z), rotation=euler("xyz", a, b, c))
    hung = air.point.locatenew("P", L * air.frame.y)
    body = RigidBody("one", air.point, air.frame, m, inertia(air.frame, A, B, C))
    return Scene("closed", N, O, bodies=(body,), joints=(air, CLOSING[kind][1](hung, air.frame)),
                 loads=(gravity(-g * N.y),), example={"y": -0.5})  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", CLOSING)
def test_a_joint_that_closes_a_loop_leaves_its_freedoms(kind: str) -> None:
    """Its reactions are complete, do no work, and each maintains its constraint."""
    scene = free_and_closed(kind)
    assert len(check_scene(scene).reactions) == len(scene.constraints)
    assert scene.degrees_of_freedom == CLOSING[kind][0]


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", CLOSING)
def test_everything_is_shown_of_what_a_closed_loop_holds(kind: str) -> None:
    assert crosscheck(free_and_closed(kind)).ok


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", LAST)
def test_everything_of_the_cross_check_is_shown(kind: str) -> None:
    assert crosscheck(two_bodies(JOINTS[kind][1](None))).ok
