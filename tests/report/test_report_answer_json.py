"""The layout of the JSON of a check is a promise to programs."""

import json
from typing import Any

from mechanics.blame.result import Mistake
from mechanics.judge.check_json import to_json
from mechanics.report.answer.check import Check

STATEMENT = {
    "tag": str, "source": str, "place": str, "about": str, "verdict": str, "evidence": str,
    "error_bound": float, "witness": dict, "terms": list, "domain": str, "right_if": list,
    "blame": dict, "notes": list,
}  # fmt: skip
BLAME = {"differences": list, "repairs": list, "explanations": list, "searched": str}
DIFFERENCE = {"group": str, "written": str, "right": str, "origin": list}
REPAIR = {"edits": list, "repaired": str, "verdict": str, "evidence": str, "error_bound": float}
EDIT = {
    "mistake": str, "sentence": str, "written": str, "right": str, "definition": str, "span": list,
}  # fmt: skip


def fits(found: dict[str, Any], schema: dict[str, type]) -> bool:
    """Whether the keys are those of a schema, and each value of its kind, or null."""
    kinds = all(found[key] is None or isinstance(found[key], kind) for key, kind in schema.items())
    return set(found) == set(schema) and kinds


def test_layout(answered: Check) -> None:
    found = json.loads(json.dumps(to_json(answered), allow_nan=False))
    keys = {"scene", "verdict", "ok", "statements", "names", "remarks", "unjudged", "aside"}
    assert set(found) == keys
    assert all(fits(statement, STATEMENT) for statement in found["statements"])
    blames = [s["blame"] for s in found["statements"] if s["blame"] is not None]
    assert len(blames) == 3
    assert all(fits(blame, BLAME) for blame in blames)
    assert all(fits(row, DIFFERENCE) for blame in blames for row in blame["differences"])
    repairs = [repair for blame in blames for repair in blame["repairs"]]
    assert all(fits(repair, REPAIR) for repair in repairs)
    assert all(fits(edit, EDIT) for repair in repairs for edit in repair["edits"])


def test_spans_point_into_the_source(answered: Check) -> None:
    for statement in to_json(answered)["statements"]:
        blame = statement["blame"]
        for repair in blame["repairs"] if blame else ():
            for edit in repair["edits"]:
                start, stop = edit["span"]
                assert statement["source"][start:stop] == edit["written"]


def test_values(answered: Check) -> None:
    seven = to_json(answered)["statements"][1]
    assert seven["tag"] == "(7)"
    assert seven["right_if"] == ["theta is minus"]
    first = seven["blame"]["repairs"][0]
    assert first["verdict"] == "PROVED"
    assert first["edits"][0] == {
        "mistake": "FACTOR", "sentence": Mistake.FACTOR.value, "written": "12", "right": "3",
        "definition": "", "span": first["edits"][0]["span"],
    }  # fmt: skip
    assert seven["blame"]["differences"][2] == {
        "group": "gravity", "written": "", "right": r"M g \frac{L}{2} \sin \theta",
        "origin": ["load gravity"],
    }  # fmt: skip
    assert to_json(answered)["statements"][0]["blame"] is None
