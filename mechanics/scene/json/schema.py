"""The layout of a scene as a JSON Schema, made from the dataclasses: ``docs/scene.schema.json``."""

from collections.abc import Mapping
from types import UnionType
from typing import Any, get_args, get_origin

from sympy import Expr
from sympy.core.relational import Relational
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector

from mechanics.scene.declaration import DROP, REFUSE
from mechanics.scene.json.expressions import FUNCTIONS, MANY, RELATIONS
from mechanics.scene.json.joints import FUNCTIONS as FUNCTIONS_OF_JOINTS
from mechanics.scene.json.joints import HINTS, arguments_of, required_of
from mechanics.scene.json.kinds import FORMAT, KINDS, NAME_OF, PARTS, entries, required
from mechanics.scene.json.published import VOCABULARY
from mechanics.scene.json.read import KEYS, LONGEST_NAME, MOST_PARTS, WORDS

TEXT = {"type": "string", "maxLength": LONGEST_NAME}
_PLAIN = {
    Expr: "expression",
    Point: "name of a point",
    ReferenceFrame: "name of a frame",
    Vector: "vector",
    Relational: "relation",
}


def schema() -> dict[str, Any]:
    """A JSON Schema, draft 2020-12."""
    lists = {
        title: _list(_any(title, classes)) if title != "outputs" else _table(_any(title, classes))
        for title, classes in PARTS.items()
    }
    name = _to("symbol")
    properties: dict[str, Any] = {
        "format": {"const": FORMAT},
        "name": TEXT,
        "coordinates": _list(name),
        "inputs": _list(name),
        "speeds": _list(_row([name, _to("expression")])),
        "parameters": _table(_to("parameter")),
        "inertial": _to("name of a frame"),
        "origin": _to("name of a point"),
        "frames": _table(_to("frame")),
        "points": _table(_to("point")),
        **lists,
        "plane": _to("vector"),
        "definitions": _table(_to("expression")),
        "example": _table({"type": "number"}),
        "equilibria": _list(_table(_to("expression"))),
        "notes": _list({"type": "string"}),
        "redundant": {"enum": [REFUSE, DROP]},
        "system": TEXT,
        "variables": _list(name),
        "published": _list(_to("published")),
    }
    assert (*properties,) == KEYS
    whole = _object(properties, ["format", "name", "coordinates", "inertial", "origin", "frames",
                                 "points", "bodies"])  # fmt: skip
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A scene of mechanics",
        **whole,
        "$defs": _borders()
        | {name: _part(name, kind) for name, kind in KINDS.items()}
        | {kind: _joint(kind) for kind in FUNCTIONS_OF_JOINTS},
    }


def _borders() -> dict[str, Any]:
    """What is no part: expressions, vectors, frames, points and parameters."""
    tree, name, three = _to("expression"), _to("symbol"), {"minItems": 3, "maxItems": 3}
    column = {"type": "array", "items": tree, **three}
    matrix = {"type": "array", "items": column, **three}
    text = {"type": "string"}
    turns = [
        _object({"name": TEXT, "in": TEXT, "axis": {"enum": ["x", "y", "z"]}, "angle": tree},
                ["in", "axis", "angle"]),
        _object({"name": TEXT, "in": TEXT, "matrix": matrix}, ["in", "matrix"]),
        _object({"name": TEXT, "in": TEXT, "quaternion": {"type": "array", "items": name}},
                ["in", "quaternion"]),
        _object({"name": TEXT}),
    ]  # fmt: skip
    return {
        "symbol": {"type": "string", "pattern": r"^[^\W\d]\w{0,63}$"},
        "expression": _expression(tree, name),
        "relation": _row([{"enum": [*RELATIONS]}, tree, tree]),
        "vector": _table(column),
        "name of a frame": TEXT,
        "name of a point": TEXT,
        "frame": {"anyOf": turns},
        "point": _object({"name": TEXT, "from": TEXT, "by": _to("vector")}),
        "inertia": {
            "anyOf": [
                tree,
                _object({"matrix": matrix}, ["matrix"]),
                _object({"terms": _list(_row([tree, _to("vector"), _to("vector")]))}, ["terms"]),
            ]
        },
        "quantity": {"type": "object", "properties": {"kind": {"enum": [*VOCABULARY]}},
                     "required": ["kind"]},
        "published": _object(
            {"tag": text, "label": text, "note": text, "quantity": _to("quantity"),
             "sides": {"type": "array", "minItems": 1, "items": {"anyOf": [
                 tree, _object({"word": text}, ["word"]),
                 _object({"relation": _to("relation")}, ["relation"]),
                 _object({"matrix": {"type": "array"}}, ["matrix"]),
                 _object({"decimal": text, "times": tree}, ["decimal"])]}}},
            ["quantity", "sides"],
        ),
        "parameter": _object(
            {"is": {"type": "array", "items": {"enum": [*WORDS]}}, "unit": text, "meaning": text,
             "typical": text, "declared": {"type": "boolean"}}
        ),
    }  # fmt: skip


def _expression(tree: dict[str, Any], name: dict[str, Any]) -> dict[str, Any]:
    """One branch for each head: who validates looks at an operand once, not once a branch."""
    leaves = [_row([{"const": "constant"}, {"type": "string"}]), _row([{"const": "pi"}]),
              _row([{"const": "time"}]), _row([{"const": "reaction"}, TEXT]),
              _row([{"const": "derivative"}, name, {"enum": [1, 2, 3]}])]  # fmt: skip
    by_count: dict[int, list[str]] = {1: [], 2: [], 3: ["select"]}
    for head, (count, _) in FUNCTIONS.items():
        if head not in MANY:
            by_count[count].append(head)
    counts = [
        _if(_starts(heads), {"minItems": n + 1, "maxItems": n + 1}) for n, heads in by_count.items()
    ]
    heads = [*MANY, *(head for heads in by_count.values() for head in heads)]
    operation = {"prefixItems": [{"enum": heads}], "items": tree, "minItems": 2, "allOf": [
        *counts, _if(_starts([*MANY]), {"minItems": 3})]}  # fmt: skip
    own = ["constant", "pi", "time", "reaction", "derivative"]
    rows = {"minItems": 1, **_if(_starts(own), {"anyOf": leaves}, operation)}
    return _if({"type": "array"}, rows, {"anyOf": [name, {"type": "number"}]})


def _starts(heads: list[str]) -> dict[str, Any]:
    return {"prefixItems": [{"enum": heads}]}


def _if(condition: dict[str, Any], then: dict[str, Any], other: Any = True) -> dict[str, Any]:
    return {"if": condition, "then": then, "else": other}


def _part(name: str, kind: type) -> dict[str, Any]:
    own = entries(kind)
    properties = {"kind": {"const": name}} | {entry: _of(hint) for entry, _, hint in own}
    return _object(properties, ["kind", *(entry for entry, field, _ in own if required(field))])


def _of(hint: Any) -> dict[str, Any]:
    if get_origin(hint) is UnionType:
        if Dyadic in get_args(hint):
            return _to("inertia")
        nothing = {"type": "null"}
        return {"anyOf": [nothing if a is type(None) else _of(a) for a in get_args(hint)]}
    if get_origin(hint) is tuple:
        inner = get_args(hint)
        return _list(_of(inner[0])) if inner[-1] is ... else _row([_of(own) for own in inner])
    if hint in NAME_OF:
        return _to(NAME_OF[hint])
    if hint is bool:
        return {"type": "boolean"}
    if hint is str:
        return TEXT
    return _to(_PLAIN[hint]) if hint in _PLAIN else {"type": "object"}


def _joint(kind: str) -> dict[str, Any]:
    own = {entry: _of(HINTS[entry]) for entry in arguments_of(kind)}
    return _object({"kind": {"const": kind}} | own, ["kind", *required_of(kind)])


def _any(title: str, classes: tuple[type, ...]) -> dict[str, Any]:
    more = [*FUNCTIONS_OF_JOINTS] if title == "joints" else []
    return {"anyOf": [_to(name) for name in (*(NAME_OF[kind] for kind in classes), *more)]}


def _to(name: str) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{name.replace(' ', '%20')}"}


def _list(items: Mapping[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": items, "maxItems": MOST_PARTS}


def _row(items: list[dict[str, Any]]) -> dict[str, Any]:
    count = len(items)
    return {"type": "array", "prefixItems": items, "minItems": count, "maxItems": count}


def _table(values: Mapping[str, Any]) -> dict[str, Any]:
    return {"type": "object", "additionalProperties": values, "maxProperties": MOST_PARTS}


def _object(properties: dict[str, Any], needed: list[str] | None = None) -> dict[str, Any]:
    return {"type": "object", "properties": properties, "required": needed or [],
            "additionalProperties": False}  # fmt: skip
