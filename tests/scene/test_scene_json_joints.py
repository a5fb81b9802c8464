"""Joints in JSON by their kind alone: the scene is that of the functions."""

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from sympy import symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.errors import MechanicsError
from mechanics.scene import RigidBody, Scene, gravity, parameters, pin, slide
from mechanics.scene.json.read import from_json
from mechanics.scene.json.write import to_json

SCHEMA = json.loads(
    (Path(__file__).parents[2] / "docs" / "scene.schema.json").read_text(encoding="utf-8")
)
CRANE: dict[str, Any] = {
    "format": "mechanics scene 1", "name": "crane", "coordinates": ["x", "theta"],
    "parameters": {"m": {"unit": "kg"}, "M": {"unit": "kg"}, "L": {"unit": "m"},
                   "g": {"unit": "m/s^2"}, "J": {"unit": "kg*m^2"}},
    "inertial": "N", "origin": "O", "frames": {"N": {}},
    "points": {"O": {}, "P": {"from": "hook", "by": {"hook": [0, ["negate", "L"], 0]}}},
    "joints": [
        {"kind": "pin", "name": "hook", "parent": "trolley", "child": "load", "at": "rail",
         "axis": {"N": [0, 0, 1]}, "angle": "theta"},
        {"kind": "slide", "name": "rail", "parent": None, "child": "trolley", "at": "O",
         "axis": {"N": [1, 0, 0]}, "distance": "x"},
    ],
    "bodies": [
        {"kind": "rigid body", "name": "trolley", "centre": "rail", "frame": "rail", "mass": "M",
         "inertia": {"matrix": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}},
        {"kind": "rigid body", "name": "load", "centre": "P", "frame": "hook", "mass": "m",
         "inertia": {"matrix": [[0, 0, 0], [0, 0, 0], [0, 0, "J"]]}},
    ],
    "loads": [{"kind": "gravity", "field": {"N": [0, ["negate", "g"], 0]}}],
}  # fmt: skip


def crane() -> Scene:
    N, O = ReferenceFrame("N"), Point("O")
    x, theta = dynamicsymbols("x theta")
    m, M, L, g, J = parameters("m M L g J", "kg kg m m/s^2 kg*m^2")
    rail = slide("rail", None, "trolley", at=O, axis=N.x, distance=x)
    hook = pin("hook", "trolley", "load", at=rail.point, axis=N.z, angle=theta)
    end = hook.point.locatenew("P", -L * hook.frame.y)
    return Scene("crane", N, O, coordinates=(x, theta), joints=(hook, rail),
                 bodies=(RigidBody("trolley", rail.point, rail.frame, M, inertia(N, 0, 0, 0)),
                         RigidBody("load", end, hook.frame, m, inertia(hook.frame, 0, 0, J))),
                 loads=(gravity(-g * N.y),))  # fmt: skip


def test_the_scene_is_that_of_the_functions_whatever_the_order() -> None:
    Draft202012Validator(SCHEMA).validate(CRANE)
    assert to_json(from_json(CRANE)) == to_json(crane())
    back = CRANE | {"joints": CRANE["joints"][::-1]}
    assert {j.name for j in from_json(back).joints} == {"rail", "hook"}


def test_a_free_joint_brings_its_quaternion() -> None:
    turn = {"kind": "quaternion", "coordinates": ["e0", "e1", "e2", "e3"],
            "speeds": ["wx", "wy", "wz"]}  # fmt: skip
    tree = {
        "format": "mechanics scene 1", "name": "top", "coordinates": ["x", "y", "z"],
        "parameters": {"m": {"unit": "kg"}, "I": {"unit": "kg*m^2"}},
        "inertial": "N", "origin": "O", "frames": {"N": {}}, "points": {"O": {}},
        "joints": [{"kind": "free", "name": "base", "child": "top", "at": "O", "frame": "N",
                    "coordinates": ["x", "y", "z"], "rotation": turn}],
        "bodies": [{"kind": "rigid body", "name": "top", "centre": "base", "frame": "base",
                    "mass": "m", "inertia": {"matrix": [["I", 0, 0], [0, "I", 0], [0, 0, "I"]]}}],
    }  # fmt: skip
    Draft202012Validator(SCHEMA).validate(tree)
    scene = from_json(tree)
    assert len(scene.u) == 6 and scene.rotations[0].coordinates == (*dynamicsymbols("e0 e1 e2 e3"),)
    assert symbols("I", positive=True).name in {p.name for p in scene.parameters}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"angle": None}, r"\$.joints\[0\].angle"),
        ({"kind": "hinge"}, "'hinge', one of"),
        ({"at": "P"}, "a circle"),
        ({"name": "N"}, r"\$.joints\[0\].name: 'N' is the name of another"),
        ({"name": "rail"}, r"\$.joints\[1\].name: 'rail' is the name of another"),
        ({"name": None}, r"\$.joints\[0\].name: nothing, a text"),
        ({"at": "Q"}, r"\$.joints\[0\]: 'Q' is none of \$.points"),
        ({"axis": {"A": [0, 0, 1]}}, "'A' is none of"),
        ({"reactions": []}, "entry 'reactions' is not known"),
    ],
)
def test_what_is_wrong_is_named_in_one_line(change: dict[str, Any], words: str) -> None:
    tree = CRANE | {"joints": [CRANE["joints"][0] | change, CRANE["joints"][1]]}
    with pytest.raises(MechanicsError, match=words) as error:
        from_json(tree)
    assert "\n" not in str(error.value)
