"""What a joint is, read from its kind and arguments alone."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from sympy import pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.checks.joints import check_joints
from mechanics.checks.virtual_power import drawn_states
from mechanics.kernel import Verdict
from mechanics.scene import (
    Joint,
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
    said = replace(sleeve, given={**sleeve.given, "kind": "pin"})
    for joint, expected in ((sleeve, Verdict.SUPPORTED), (said, Verdict.REFUTED)):
        scene = Scene("closed", N, O, bodies=(body,), joints=(air, joint))
        first, second = check_joints(scene, drawn_states(scene))
        assert first.verdict is Verdict.SUPPORTED
        assert second.verdict is expected


def test_a_reaction_about_another_axis_is_refuted() -> None:
    joint = JOINTS["pin"]()
    turned = [replace(own, along=F.z) if own.at is None else own for own in joint.reactions]
    assert verdict(on(replace(joint, reactions=tuple(turned)))) is Verdict.REFUTED
