"""Scenes as JSON: they come back as they were, and hostile ones get one line."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from sympy import Matrix

from mechanics import crosscheck, from_json, to_json
from mechanics.errors import MechanicsError
from mechanics.mechanism import lower
from mechanics.program import Builder, Program
from mechanics.routes import kane
from mechanics.scene import Scene
from mechanics.scene.json import schema
from mechanics.scene.system import System
from systems import EVERY, slider_crank

DOCS = Path(__file__).parents[2] / "docs"
PENDULUM = re.search(r"example: scene -->\n```json\n(.*?)```", (DOCS / "json.md").read_text(), re.S)
assert PENDULUM


def heavy(mass: str) -> str:
    """The pendulum with that text for the mass of its bob."""
    return PENDULUM[1].replace('"mass": "m"', f'"mass": {mass}')


def rows(scene: Scene) -> Program:
    """What Kane's method derives."""
    mechanism = lower(scene, Builder())
    return mechanism.builder.program({"rows": kane.derive(mechanism).values})


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", [system.name for system in EVERY])
def test_a_scene_comes_back_with_the_same_equations(name: str) -> None:
    (system,) = (system for system in EVERY if system.name == name)
    scene = system.scene()
    tree = to_json(scene)
    back = from_json(json.dumps(tree))
    assert to_json(back) == tree
    assert to_json(from_json(json.dumps(tree, sort_keys=True))) == tree
    assert rows(back) == rows(scene)
    pytest.importorskip("jsonschema").Draft202012Validator(schema()).validate(tree)


PUBLISHING = [system for system in EVERY if system.published]


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", PUBLISHING, ids=lambda system: system.name)
def test_published_equations_come_back(system: System) -> None:
    tree = to_json(system)
    back = from_json(json.dumps(tree))
    assert back.name == system.name
    assert len(back.published) == len(system.published) > 0
    for mine, other in zip(back.published, system.published, strict=True):
        assert (mine.tag, mine.label, mine.note) == (other.tag, other.label, other.note)
        assert mine.quantity == other.quantity or "Part" in str(other.quantity)
        for one, two in zip(mine.sides, other.sides, strict=True):
            # Rates that the source leaves to be taken are taken.
            assert one == two or not any(Matrix([one - two]).doit().expand())
    again = to_json(back)
    assert to_json(from_json(json.dumps(again))) == again
    pytest.importorskip("jsonschema").Draft202012Validator(schema()).validate(tree)


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("system", PUBLISHING, ids=lambda system: system.name)
def test_a_system_from_json_has_the_verdicts_of_the_one_that_ships(system: System) -> None:
    ours, back = (crosscheck(one) for one in (system, from_json(to_json(system))))
    assert [(f.subject, f.verdict) for f in back.findings] == [
        (f.subject, f.verdict) for f in ours.findings
    ]
    assert [(e.row.tag, e.finding.verdict) for e in back.published] == [
        (e.row.tag, e.finding.verdict) for e in ours.published
    ]
    assert back.ok


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ({"quantity": {"kind": "os"}}, r"quantity.kind: one of position, velocity"),
        ({"quantity": {"kind": "momentum"}}, r"quantity: bodies is missing"),
        ({"quantity": {"kind": "momentum", "bodies": 3}}, r"quantity.bodies: a text"),
        ({"quantity": {"kind": "mass", "body": {"kind": "disc"}}}, r"body.kind: one of part, comp"),
        ({"sides": []}, r"sides: a list of sides expected"),
        ({"sides": [{"matrix": [[1], [2, 3]]}]}, r"matrix: rows of as many entries"),
        ({"sides": [{"word": "x" * 2000}]}, r"a text of at most 1000"),
        ({"sides": ["nothing"]}, r"'nothing' is no coordinate"),
        ({"extra": 1}, r"an object with entries of label, note, quantity"),
    ],
    ids=range(9),
)
def test_a_published_row_that_is_wrong_is_named(row: dict[str, Any], words: str) -> None:
    whole = json.loads(PENDULUM[1]) | {"system": "mine"}
    right = {"tag": "T", "quantity": {"kind": "kinetic energy"}, "sides": [0]}
    assert from_json(whole | {"published": [right]}).published[0].tag == "T"
    with pytest.raises(MechanicsError, match=words) as error:
        from_json(whole | {"published": [right | row]})
    assert str(error.value).startswith("scene, at $.published[0]")
    assert "\n" not in str(error.value)


def test_the_schema_that_is_published_is_the_one_that_is_read() -> None:
    assert json.loads((DOCS / "scene.schema.json").read_text()) == schema()


def test_the_scene_of_the_documentation_swings() -> None:
    scene = from_json(PENDULUM[1])
    assert str(scene) == "<scene pendulum: 1 body, 1 coordinate, 0 constraints>"
    assert {p.name: p.unit for p in scene.parameters} == {"L": "m", "g": "m/s^2", "m": "kg"}


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (("bodies", 0, "mass"), "__import__('os')", r"\$.bodies\[0\].mass: .* is no coordinate"),
        (("bodies", 0, "mass"), ["eval", "m"], "'eval' is no operation"),
        (("bodies", 0, "mass"), ["power", 10, ["constant", "9" * 9]], "an exponent of at most 64"),
        (("bodies", 0, "mass"), ["power", ["power", 99999, 64], 64], "more than 200 digits"),
        (("bodies", 0, "mass"), ["floor", ["exp", 9999]], "of constants: write the number"),
        (("bodies", 0, "mass"), ["divide", 1, 0], "is not finite and real"),
        (("bodies", 0, "mass"), ["sqrt", -1], "is not finite and real"),
        (("bodies", 0, "mass"), ["sin"], "sin has 0 operands, 1 expected"),
        (("bodies", 0, "mass"), ["less", "m", 1], "a truth value"),
        (("bodies", 0, "mass"), -1, "the mass -1 is negative"),
        (("bodies", 0, "kind"), "os", "'os', one of 'particle', 'rigid body' expected"),
        (("bodies", 0, "extra"), 1, "entry 'extra' is not known"),
        (("frames", "A", "in"), "B", r"\$.frames.A.in: 'B' is none of"),
        (("points", "P", "from"), "P", "nothing leads to it from 'O': a circle"),
        (("points", "P", "by"), {"A": [1, 2]}, "2 components, 3 expected"),
        (("parameters", "m", "typical"), "1e999999", "is no number"),
        (("parameters", "m", "unit"), "apple", "the unit 'apple' is not known"),
        (("coordinates",), ["x1:1000000"], "is no name of letters"),
        (("coordinates",), ["theta"] * 3000, "a list of at most 2000 entries"),
        (("format",), "2", "expected"),
    ],
)
def test_what_is_wrong_is_named_in_one_line(path: tuple[Any, ...], value: Any, words: str) -> None:
    tree = json.loads(PENDULUM[1])
    place = tree
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    with pytest.raises(MechanicsError, match=words) as error:
        from_json(tree)
    assert "\n" not in str(error.value)


def test_a_joint_that_lost_a_direction_is_named() -> None:
    tree = to_json(slider_crank.scene())
    del tree["joints"][0]["directions"][0]
    with pytest.raises(MechanicsError, match=r"\$.joints\[0\].directions: one for each"):
        from_json(tree)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "this is no JSON"),
        ("[" * 100_000, "this is no JSON"),
        (
            heavy("[" * 500 + "1" + "]" * 500),
            "a list such as",
        ),
        (
            heavy('["sin",' * 200 + "1" + "]" * 200),
            "100 deep",
        ),
        (heavy("NaN"), "NaN is no number"),
        (heavy("9" * 5000), "5000 digits"),
        (heavy("1e99999999"), "at most 200 digits"),
        (heavy('"m", "mass": "L"'), "given twice"),
        (" " * (1 << 23), "at most 4194304 are read"),
    ],
    ids=range(9),
)
def test_hostile_texts_get_one_line(text: str, words: str) -> None:
    with pytest.raises(MechanicsError, match=words) as error:
        from_json(text)
    assert "\n" not in str(error.value)
