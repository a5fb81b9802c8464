"""Joints that cannot be right are refused in one line that says what to write."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from sympy.physics.vector import Vector

from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from mechanics.scene import (
    Joint,
    Particle,
    RigidBody,
    Scene,
    ball,
    euler,
    free,
    holonomic,
    parameters,
    pin,
    planar,
    reaction,
    roll,
    slide,
    universal,
    weld,
)
from mechanics.scene.joints.fixed import absolute_coordinates

N, O = ReferenceFrame("N"), Point("O")
q1, q2, q3, q4 = dynamicsymbols("q1:5")
s = parameters("s", positive=False)[0]
L, m, J = parameters("L m J", units="m kg kg*m^2", typical="1 1 1")


def arm() -> Scene:
    """Two links."""
    first = pin("A", None, "one", at=O, axis=N.z, angle=q1)
    elbow = O.locatenew("E", L * first.frame.x)
    second = pin("B", "one", "two", at=elbow, axis=first.frame.z, angle=q2)
    bodies = tuple(
        RigidBody(name, at.locatenew(f"C{name}", L / 2 * joint.frame.x), joint.frame, m,
                  inertia(joint.frame, J, J, J))
        for name, at, joint in (("one", O, first), ("two", elbow, second))
    )  # fmt: skip
    return Scene("arm", N, O, bodies=bodies, joints=(first, second))


def test_a_scene_has_what_its_joints_declare_once() -> None:
    scene = arm()
    assert scene.coordinates == (q1, q2)
    names = [reaction.name for reaction in scene.reactions]
    assert names == [f"{j}_{word}" for j in "AB" for word in ("x", "y", "z", "mx", "my")]
    copy = replace(scene, name="copy")
    assert copy.coordinates == scene.coordinates
    assert copy.reactions == scene.reactions


def test_a_body_that_no_joint_carries_is_named() -> None:
    scene = arm()
    loose = Particle("bob", O.locatenew("P", q3 * N.y), m)
    with pytest.raises(SceneError, match=r"body bob: no joint carries it: add one, as in weld"):
        replace(scene, bodies=(*scene.bodies, loose), coordinates=(q3,))


def test_a_joint_of_no_body_is_named() -> None:
    scene = arm()
    with pytest.raises(SceneError, match="joint B: there is no body 'two': the bodies are one"):
        replace(scene, bodies=scene.bodies[:1])


def test_two_joints_that_carry_one_body_are_named() -> None:
    scene = arm()
    again = pin("D", None, "two", at=O, axis=N.z, angle=q3)
    with pytest.raises(SceneError, match=r"joints B and D both carry two: .* onto=P"):
        replace(scene, joints=(*scene.joints, again))


def test_a_body_in_the_frame_of_another_is_named() -> None:
    scene = arm()
    one, two = scene.bodies
    wrong = RigidBody("two", two.centre, one.frame, m, inertia(one.frame, J, J, J))
    with pytest.raises(SceneError, match=r"joint B carries two, .* turns .* by q2: use B.frame"):
        replace(scene, bodies=(one, wrong))


def test_a_centre_along_the_frame_of_another_is_named() -> None:
    scene = arm()
    one, two = scene.bodies
    aside = scene.joints[1].point.locatenew("W", L * one.frame.x)
    wrong = RigidBody("two", aside, two.frame, m, inertia(two.frame, J, J, J))
    with pytest.raises(SceneError, match=r"centre of two moves against the joint by q2: place it"):
        replace(scene, bodies=(one, wrong))


def test_a_point_of_another_body_is_named() -> None:
    scene = arm()
    first, second = scene.joints
    tip = second.point.locatenew("T", L * second.frame.x)
    third = pin("D", "one", "three", at=tip, axis=N.z, angle=q3)
    rod = RigidBody("three", tip, third.frame, m, inertia(third.frame, J, J, J))
    with pytest.raises(SceneError, match=r"D: its point T moves against one by q2: take a point"):
        replace(scene, bodies=(*scene.bodies, rod), joints=(first, second, third))


def tilted(joint: Callable[[Point, ReferenceFrame], Joint]) -> Scene:
    """A body that turns about x, and on it a joint."""
    first = pin("A", None, "one", at=O, axis=N.x, angle=q1)
    second = joint(O.locatenew("E", L * first.frame.y), first.frame)
    bodies = tuple(
        RigidBody(own.child, own.point, own.frame, m, inertia(own.frame, J, J, J))
        for own in (first, second)
    )
    return Scene("tilted", N, O, bodies=bodies, joints=(first, second))


TURNING: dict[str, tuple[Callable[[Point, ReferenceFrame], Joint], str]] = {
    "pin": (
        lambda E, F: pin("B", "one", "two", at=E, axis=N.z, angle=q2),
        r"joint B: N.z of its axis= turns against one by q1: .* as in axis=A\.z",
    ),
    "oblique pin": (
        lambda E, F: pin("B", "one", "two", at=E, axis=N.x + N.y, angle=q2),
        r"N.x \+ N.y of its axis= turns against one by q1: .* as in axis=A\.z",
    ),
    "slide along the axis": (
        lambda E, F: slide("B", "one", "two", at=E, axis=N.x, distance=q2),
        r"N.y of its axis= turns against one by q1: .* as in axis=A\.z",
    ),
    "weld": (
        lambda E, F: weld("B", "one", "two", at=E, frame=N),
        r"N.y of its frame= turns against one by q1: .* as in frame=A",
    ),
    "universal": (
        lambda E, F: universal("B", "one", "two", at=E, frame=N, axes="yz", angles=(q2, q3)),
        r"N.y of its frame= turns against one by q1: .* as in frame=A",
    ),
    "planar": (
        lambda E, F: planar("B", "one", "two", at=E, frame=N, coordinates=(q2, q3), angle=q4),
        r"N.z of its frame= turns against one by q1: .* as in frame=A",
    ),
    "wheel": (
        lambda E, F: roll("B", "one", "two", at=E, normal=N.x, axis=N.z, radius=L,
                          coordinates=(q2,), angles=(q3,)),
        r"N.y of its normal= turns against one by q1: .* as in normal=A\.z",
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", TURNING)
def test_an_axis_that_turns_in_the_parent_is_named(kind: str) -> None:
    make, message = TURNING[kind]
    with pytest.raises(SceneError, match=message) as refusal:
        tilted(make)
    assert "\n" not in str(refusal.value)


def test_an_axis_that_turns_in_the_child_is_named() -> None:
    scene = arm()
    one, two = scene.joints
    closing = pin("D", None, "two", at=O, axis=N.z, onto=(two.point, N.x))
    with pytest.raises(
        SceneError, match=r"D: N.x of its onto= turns against two by q1, q2: .* onto=\(P, B"
    ):
        replace(scene, joints=(one, two, closing))


@pytest.mark.parametrize("axis", [N.x, -2 * N.x])
def test_the_angle_about_an_axis_of_the_ground_is_absolute_and_said_so(axis: Vector) -> None:
    scene = tilted(lambda E, F: pin("B", "one", "two", at=E, axis=axis, angle=q2))
    (said,) = absolute_coordinates(scene)
    assert said == (
        "Joint B counts q2 from N, against which one turns by q1: they are not relative to it."
    )
    relative = tilted(lambda E, F: pin("B", "one", "two", at=E, axis=F.x, angle=q2))
    assert not [*absolute_coordinates(relative)]


def test_a_loop_that_is_closed_twice_is_named() -> None:
    scene = arm()
    twice = [ball(name, None, "two", at=O, frame=N, onto=scene.joints[1].point) for name in "DE"]
    with pytest.raises(SceneError, match="joints D and E close one loop twice"):
        replace(scene, joints=(*scene.joints, *twice))


def test_a_particle_on_a_pin_is_named() -> None:
    scene = arm()
    bob = Particle("two", scene.bodies[1].centre, m)
    with pytest.raises(SceneError, match=r"inertia\(B.frame, 0, 0, 0\)"):
        replace(scene, bodies=(scene.bodies[0], bob))


def flat_arm(plane: Vector | None) -> Scene:
    """Two links with scalar inertias."""
    scene = arm()
    flat = tuple(replace(body, inertia=J) for body in scene.bodies)
    return Scene("flat", N, O, bodies=flat, joints=scene.joints, plane=plane)


def test_in_a_plane_joints_hold_what_the_plane_does_not() -> None:
    scene = flat_arm(3 * N.z)
    assert [reaction.name for reaction in scene.reactions] == ["A_x", "A_y", "B_x", "B_y"]
    assert len(check_scene(scene).u) == 2
    assert replace(scene, name="copy").reactions == scene.reactions


def test_a_reaction_that_was_typed_by_hand_is_never_left_out() -> None:
    typed = reaction("A_z", at=O, on="one", by=None, along=N.z)
    scene = replace(flat_arm(N.z), reactions=(typed,))
    names = [reaction.name for reaction in scene.reactions]
    assert names == ["A_z", "A_x", "A_y", "B_x", "B_y"]


@pytest.mark.parametrize(
    ("plane", "message"),
    [
        (None, r"body one: its inertia is a scalar, .* plane=N\.z"),
        (N.x, r"joint B: A turns out of the plane normal to N\.x"),
        (N.y + N.z, "joint A: A_y along N.y is oblique"),
        ("z", "plane is 'z', a str"),
    ],
)
def test_another_plane_is_refused(plane: Vector | None, message: str) -> None:
    with pytest.raises(SceneError, match=message) as refusal:
        flat_arm(plane)
    assert "\n" not in str(refusal.value)


WRONG: dict[str, tuple[Callable[[], Joint], str]] = {
    "no length": (
        lambda: pin("A", None, "one", at=O, axis=0 * N.x, angle=q1), "joint A: the axis has no len",
    ),
    "no vector": (lambda: pin("A", None, "one", at=O, axis="z", angle=q1), "give a vector"),
    "two frames": (
        lambda: pin("A", None, "one", at=O, angle=q1,
                    axis=N.x + N.orientnew("B", "Axis", (q2, N.z)).x),
        r"stands in several frames \(",
    ),
    "moving axis": (lambda: pin("A", None, "one", at=O, axis=q1 * N.x, angle=q2), "moves in N"),
    "no sign": (
        lambda: pin("A", None, "one", at=O, axis=s * N.x, angle=q1),
        r"leave the length out, as in axis=N\.x",
    ),
    "a body": (lambda: pin("A", O, "one", at=O, axis=N.x, angle=q1), "None for the ground"),
    "no child": (lambda: pin("A", "one", None, at=O, axis=N.x, angle=q1), "its child is None"),
    "no point": (lambda: pin("A", None, "one", at=N, axis=N.x, angle=q1), "at is N"),
    "no frame": (lambda: ball("A", None, "one", at=O, frame=O), "frame is O"),
    "half an end": (
        lambda: slide("A", None, "one", at=O, axis=N.x, onto=O),
        "give the child's point and frame",
    ),
    "two ways": (
        lambda: pin("A", None, "one", at=O, axis=N.x, angle=q1, onto=(O, N.x)),
        "has no coordinate, leave it out",
    ),
    "nowhere": (
        lambda: ball("A", None, "one", at=O, frame=N, onto=Point("Q")), "nothing places Q",
    ),
    "no angle": (lambda: pin("A", None, "one", at=O, axis=N.z), "joint A: angle is None"),
    "a number": (
        lambda: slide("A", None, "one", at=O, axis=N.z, distance=2), "joint A: distance is 2",
    ),
    "one axis twice": (
        lambda: universal("A", None, "one", at=O, frame=N, axes="xx", angles=(q1, q2)),
        "give two different axes",
    ),
    "two positions": (
        lambda: free("A", "one", at=O, frame=N, coordinates=(q1, q2),
                     rotation=euler("zxz", *dynamicsymbols("a b c"))),
        "joint A: 2 coordinates: give three",
    ),
    "no rotation": (
        lambda: ball("A", None, "one", at=O, frame=N, rotation=(q1, q2, q3)),
        r"give euler\(.*\) or quaternion\(",
    ),
    "neighbours": (lambda: euler("zzx", q1, q2, q3), "let neighbours differ"),
    "two angles": (lambda: euler("zxz", q1, q2), "give three axes and three angles"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_no_joint_is_refused(case: str) -> None:
    make, message = WRONG[case]
    with pytest.raises(SceneError, match=message) as refusal:
        make()
    assert "\n" not in str(refusal.value)


def a_body(*moments: float, plane: bool = False, notes: tuple[str, ...] = ()) -> Scene:
    hinge = pin("A", None, "one", at=O, axis=N.z, angle=q1)
    body = RigidBody("one", O.locatenew("C", hinge.frame.x), hinge.frame, 1,
                     inertia(hinge.frame, *moments))  # fmt: skip
    return Scene("one", N, O, bodies=(body,), joints=(hinge,), plane=N.z if plane else None,
                 notes=notes)  # fmt: skip


IMPOSSIBLE = {
    "sum": ((1, 1, 5), "principal moment 5 exceeds the sum of the others, 1 and 1: check"),
    "products": ((1, 1, 1, 0.6), "1.6 exceeds the sum of the others, 0.4 and 1"),
    "negative": ((1, 1, 1, 2), "negative about an axis, a principal moment is -1: give"),
}


@pytest.mark.parametrize("case", IMPOSSIBLE)
def test_an_inertia_that_no_body_has_is_refused(case: str) -> None:
    moments, message = IMPOSSIBLE[case]
    with pytest.raises(SceneError, match=message) as refusal:
        a_body(*moments)
    assert "\n" not in str(refusal.value)


def test_typical_values_that_no_body_has_are_refused_like_numbers() -> None:
    values = parameters("A C", units="kg*m^2 kg*m^2", typical="1 5")
    message = "at the typical values A = 1, C = 5: the principal moment 5 exceeds"
    with pytest.raises(SceneError, match=message) as refusal:
        a_body(values[0], values[0], values[1])
    assert "\n" not in str(refusal.value)
    assert a_body(*parameters("A B C", typical="2 4 5")).q == a_body(1, 1, 1).q
    assert a_body(*parameters("A B C", typical="- 4 5")).q == a_body(1, 1, 1).q


def test_flat_bodies_scenes_in_a_plane_and_files_that_tell_are_no_such_inertias() -> None:
    assert a_body(0.1, 0.7, 0.8).q == a_body(0, 0, 5).q
    assert a_body(1, 1, 5, plane=True).q == a_body(1, 1, 5, notes=("told: one",)).q


def test_what_holds_nothing_closes_no_loop() -> None:
    with pytest.raises(SceneError, match="joint F: it holds nothing, so it closes no loop: leave"):
        free("F", "one", at=O, frame=N, onto=O)


def test_a_joint_twice_is_named() -> None:
    hinge = pin("A", None, "one", at=O, axis=N.z, angle=q1)
    one = RigidBody("one", hinge.point, hinge.frame, 1, inertia(hinge.frame, 1, 1, 1))
    tip = hinge.point.locatenew("T", hinge.frame.x)
    closed = pin("C", None, "one", at=O, axis=N.z, onto=tip)
    with pytest.raises(SceneError, match="2 times a joint named 'C': names must differ"):
        Scene("twice", N, O, bodies=(one,), joints=(hinge, closed, closed), plane=N.z)


def test_a_quaternion_without_its_norm_is_refused() -> None:
    e = dynamicsymbols("e0:4")
    B = N.orientnew("B", "Quaternion", e)
    body = RigidBody("one", O, B, 1, inertia(B, 1, 2, 2.5))
    held = tuple(reaction(k, at=O, on="one", by=None, along=a)
                 for k, a in zip("XYZ", (N.x, N.y, N.z), strict=True))  # fmt: skip
    other = holonomic("other", e[1] - e[2], "X")
    for constraints in ((), (other,)):
        with pytest.raises(SceneError, match=r"norm of the quaternion e0 .* at 1: orient"):
            Scene("q", N, O, coordinates=e, bodies=(body,), reactions=held,
                  constraints=constraints)  # fmt: skip


@pytest.mark.parametrize(
    ("other", "message"),
    [
        ({"kind": "hinge"}, "joint B: given has the kind 'hinge', a str: leave given out"),
        ({"turn": 1}, "joint B: given has angle, axis, kind, onto, turn: a pin has kind, axis,"),
        ({"axis": 2}, "joint B: given has axis = 2, a int: no pin has that"),
        ({"axis": Vector(0)}, "joint B: given has axis = 0, a Vector: no pin has that"),
        ({"onto": O}, "joint B: given has onto=O: this joint closes no such loop"),
    ],
)
def test_arguments_that_no_joint_of_the_kind_has_are_refused(
    other: dict[str, object], message: str
) -> None:
    """Of a scene in JSON, which may hold any."""
    scene = arm()
    first, second = scene.joints
    said = replace(second, given={**second.given, **other})
    with pytest.raises(SceneError, match=f"^{message}"):
        replace(scene, joints=(first, said))


def test_a_loop_is_closed_onto_a_point() -> None:
    """Three links and the ground: two conditions, each with the force that maintains it."""
    scene = arm()
    second = scene.joints[1]
    end = second.point.locatenew("T", L * second.frame.x)
    post = O.locatenew("G", 2 * L * N.x)
    third = pin("C", None, "three", at=post, axis=N.z, angle=q3)
    rod = RigidBody("three", post.locatenew("C3", L / 2 * third.frame.x), third.frame, m,
                    inertia(third.frame, J, J, J))  # fmt: skip
    tip = post.locatenew("U", L * third.frame.x)
    closing = pin("D", "two", "three", at=end, axis=second.frame.z, onto=tip)
    loop = replace(scene, bodies=(*scene.bodies, rod), joints=(*scene.joints, third, closing))
    assert loop.degrees_of_freedom == 1
    gap = tip.pos_from(end)
    assert loop.constraints == tuple(
        holonomic(f"D_{word}_closes", gap.dot(axis), f"D_{word}")
        for word, axis in (("x", second.frame.x), ("y", second.frame.y))
    )
