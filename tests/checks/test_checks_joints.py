"""What a joint is, read from its kind and arguments alone."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from sympy import pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.checks.joints import check_joints
from mechanics.checks.virtual_power import drawn_states
from mechanics.kernel import Verdict
from mechanics.scene import (
    Joint,
    Particle,
    RigidBody,
    Scene,
    ball,
    cylindrical,
    euler,
    free,
    parameters,
    pin,
    planar,
    quaternion,
    roll,
    rope,
    slide,
    universal,
)

x, y, z, a, b, c = dynamicsymbols("x y z a b c")
N, O = ReferenceFrame("N"), Point("O")
F = N.orientnew("F", "Axis", (pi / 5, N.x))
m, J = parameters("m J")

JOINTS: dict[str, Callable[[], Joint]] = {
    "pin": lambda: pin("J", None, "one", at=O, axis=-F.z, angle=a),
    "oblique": lambda: pin("J", None, "one", at=O, axis=F.x + 2 * F.z, angle=a),
    "slide": lambda: slide("J", None, "one", at=O, axis=F.y - F.x, distance=x),
    "cylindrical": lambda: cylindrical("J", None, "one", at=O, axis=F.z, angle=a, distance=x),
    "universal": lambda: universal("J", None, "one", at=O, frame=F, axes="xz", angles=(a, b)),
    "planar": lambda: planar("J", None, "one", at=O, frame=F, coordinates=(x, y), angle=a),
    "ball": lambda: ball("J", None, "one", at=O, frame=F, rotation=euler("zxz", a, b, c)),
    "quaternion": lambda: ball(
        "J", None, "one", at=O, frame=F, rotation=quaternion("e0 e1 e2 e3", "wx wy wz")
    ),
    "free": lambda: free(
        "J", "one", at=O, frame=F, coordinates=(x, y, z), rotation=euler("xyz", a, b, c)
    ),
}


def on(joint: Joint) -> Scene:
    body = RigidBody("one", joint.point, joint.frame, m, inertia(joint.frame, J, J, J))
    return Scene("one body", N, O, bodies=(body,), joints=(joint,))


def verdict(scene: Scene) -> Verdict:
    (finding,) = check_joints(scene, drawn_states(scene))
    return finding.verdict


@pytest.mark.parametrize("kind", JOINTS)
def test_a_joint_is_what_its_name_says(kind: str) -> None:
    assert verdict(on(JOINTS[kind]())) is Verdict.SUPPORTED


@pytest.mark.parametrize("kind", JOINTS)
def test_a_joint_that_moves_otherwise_is_refuted(kind: str) -> None:
    """What was made with arguments is said to have been given others."""
    joint = JOINTS[kind]()
    given = dict(joint.given)
    if "axis" in given:
        given["axis"] = -given["axis"]
    elif "angles" in given:
        given["angles"] = given["angles"][::-1]
    elif "coordinates" in given:
        given["coordinates"] = given["coordinates"][::-1]
    elif kind == "quaternion":
        e0, e1, e2, e3 = given["rotation"].coordinates
        given["rotation"] = replace(given["rotation"], coordinates=(e0, e2, e1, e3))
    else:
        given["rotation"] = euler("zyz", a, b, c)
    assert verdict(on(replace(joint, given=given))) is Verdict.REFUTED


def test_what_a_loop_leaves_open_is_refuted() -> None:
    """A sleeve said to be closed by a pin may slide."""
    air = free("air", "one", at=O, frame=N, coordinates=(x, y, z), rotation=euler("xyz", a, b, c))
    body = RigidBody("one", air.point, air.frame, m, inertia(air.frame, J, J, J))
    sleeve = cylindrical("S", None, "one", at=O, axis=N.x, onto=(air.point, air.frame.x))
    own = {name: value for name, value in sleeve.given.items() if name != "distance"}
    said = replace(sleeve, given={**own, "kind": "pin"})
    for joint, expected in ((sleeve, Verdict.SUPPORTED), (said, Verdict.REFUTED)):
        scene = Scene("closed", N, O, bodies=(body,), joints=(air, joint))
        first, second = check_joints(scene, drawn_states(scene))
        assert first.verdict is Verdict.SUPPORTED
        assert second.verdict is expected


def test_a_reaction_about_another_axis_is_refuted() -> None:
    joint = JOINTS["pin"]()
    turned = [replace(own, along=F.z) if own.at is None else own for own in joint.reactions]
    assert verdict(on(replace(joint, reactions=tuple(turned)))) is Verdict.REFUTED


WHEEL = {"normal": F.z, "radius": m, "at": O}
WHEELS: dict[str, tuple[Callable[[], Joint], dict[str, Any]]] = {
    "backwards": (
        lambda: roll("J", None, "one", coordinates=(x, y), angles=(a, b, c), **WHEEL),
        {"angles": (a, b, -c)},
    ),
    "below the plane": (
        lambda: roll("J", None, "one", coordinates=(x, y), angles=(a, b, c), **WHEEL),
        {"normal": -F.z},
    ),
    "another radius": (
        lambda: roll("J", None, "one", coordinates=(x,), angles=(a,), axis=F.x, **WHEEL),
        {"radius": 2 * m},
    ),
    "about another axis": (
        lambda: roll("J", None, "one", coordinates=(x,), angles=(a,), axis=F.x, **WHEEL),
        {"axis": -F.x},
    ),
    "on the ring, not in it": (
        lambda: roll("J", None, "one", angles=(a, b), axis=F.x, inside=3 * m, **WHEEL),
        {"inside": None, "outside": 3 * m},
    ),
    "in another ring": (
        lambda: roll("J", None, "one", angles=(a, b), axis=F.x, outside=3 * m, **WHEEL),
        {"outside": 4 * m},
    ),
}


@pytest.mark.parametrize("kind", WHEELS)
def test_a_wheel_rolls_as_its_arguments_say(kind: str) -> None:
    make, other = WHEELS[kind]
    joint = make()
    said = replace(joint, given={**joint.given, **other})
    assert verdict(on(joint)) is Verdict.SUPPORTED
    assert verdict(on(said)) is Verdict.REFUTED


def test_the_total_spin_rate_and_the_velocities_of_the_contact_are_speeds() -> None:
    w, v, u = dynamicsymbols("w v u")
    joint = roll("J", None, "one", coordinates=(x, y), angles=(a, b, c), speeds=(w, v, u), **WHEEL)
    assert verdict(on(joint)) is Verdict.SUPPORTED
    (q, spin, definition), *others = joint.own
    wrong = replace(joint, own=((q, spin, definition + a.diff()), *others))
    assert verdict(on(wrong)) is Verdict.REFUTED


@pytest.mark.parametrize(
    "other",
    [
        lambda own: {"radius": (m, m, 2 * m)}, lambda own: {"normal": F.x},
        lambda own: {"axis": own.y}, lambda own: {"radius": 2 * m},
    ],
)  # fmt: skip
def test_what_touches_is_round_as_its_arguments_say(
    other: Callable[[ReferenceFrame], dict[str, Any]],
) -> None:
    air = free("air", "one", at=O, frame=F, coordinates=(x, y, z), rotation=euler("zxy", a, b, c))
    body = RigidBody("one", air.point, air.frame, m, inertia(air.frame, J, J, J))
    touch = roll("T", None, "one", onto=(air.point, air.frame), **WHEEL)
    said = replace(touch, given={**touch.given, **other(air.frame)})
    for joint, expected in ((touch, Verdict.SUPPORTED), (said, Verdict.REFUTED)):
        scene = Scene("touching", N, O, bodies=(body,), joints=(air, joint))
        *_, finding = check_joints(scene, drawn_states(scene))
        assert finding.verdict is expected


def test_a_rope_is_as_long_and_pulls_as_its_arguments_say() -> None:
    air = free("air", "one", at=O, frame=N, coordinates=(x, y, z))
    bob, hook = Particle("one", air.point, m), O.locatenew("H", J * N.x)
    tied = rope("T", (None, hook), ("one", air.point), length=2 * J)
    slack = replace(tied, given={**tied.given, "length": 3 * J})
    (tension,) = tied.reactions
    pushing = replace(tied, reactions=(replace(tension, along=-tension.along),))
    elsewhere = replace(tied, given={**tied.given, "ends": ((None, O), ("one", air.point))})
    for line, expected in (
        (tied, Verdict.SUPPORTED), (slack, Verdict.REFUTED), (pushing, Verdict.REFUTED),
        (elsewhere, Verdict.REFUTED),
    ):  # fmt: skip
        scene = Scene("tied", N, O, bodies=(bob,), joints=(air, line))
        *_, finding = check_joints(scene, drawn_states(scene))
        assert finding.verdict is expected
