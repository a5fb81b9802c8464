"""A scene from JSON. What is read may come from anybody: it is checked, and its size is bounded.

No text in it is ever evaluated, and no name in it names a file or a function.
"""

import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from types import UnionType
from typing import Any, get_args, get_origin

from sympy import Expr, Function, Matrix, Symbol
from sympy.core.relational import Relational
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector, dynamicsymbols, outer

from mechanics.errors import InputError, MechanicsError
from mechanics.scene.conditions import Condition, condition
from mechanics.scene.declaration import REFUSE
from mechanics.scene.joints.joint import Joint
from mechanics.scene.json.expressions import Names, number, read, refuse, relation
from mechanics.scene.json.joints import FUNCTIONS, HINTS, arguments_of, required_of
from mechanics.scene.json.kinds import FORMAT, KINDS, NAME_OF, PARTS, entries, required
from mechanics.scene.json.order import kinds_of_joints, placing_order
from mechanics.scene.json.published import read_rows
from mechanics.scene.parameters import Parameter, typical_value
from mechanics.scene.rotations import Rotation
from mechanics.scene.scene import Scene
from mechanics.scene.system import System
from mechanics.scene.unit_names import dimension_of_unit

LARGEST_TEXT = 1 << 22
"""Characters."""
MOST_PARTS = 2000
"""Entries of a list or an object."""
LONGEST_NAME = 200
SYMBOL = re.compile(r"[^\W\d]\w{0,63}")
WORDS = (
    "positive", "negative", "nonnegative", "nonpositive", "nonzero", "real", "finite", "integer",
)  # fmt: skip
KEYS = (
    "format", "name", "coordinates", "inputs", "speeds", "parameters", "inertial", "origin",
    "frames", "points", *PARTS, "plane", "definitions", "example", "equilibria", "notes",
    "redundant", "system", "variables", "published",
)  # fmt: skip
ROOTS = {"frames": "inertial", "points": "origin"}
ENTRIES = {
    "frames": ("name", "in", "axis", "angle", "matrix", "quaternion"),
    "points": ("name", "from", "by"),
}


def from_json(source: str | Mapping[str, Any]) -> Any:
    """The scene of a text, or of its tree; see ``docs/scene.schema.json``.

    Parameters
    ----------
    source : str or dict

    Returns
    -------
    Scene, or System
        A System where its name, ``"system"``, stands there.

    Raises
    ------
    InputError
        Names the place, as ``$.bodies[0].mass``, and what is wrong there.
    SceneError
        When the scene cannot be right.

    Examples
    --------
    >>> from systems import four_bar
    >>> from mechanics.scene.json.write import to_json
    >>> from_json(to_json(four_bar.scene()))
    <scene four-bar linkage: 3 bodies, 3 coordinates, 2 constraints>
    """
    if isinstance(source, Mapping):
        source = json.dumps(source)
    if not isinstance(source, str):
        raise InputError(f"scene: JSON expected, {type(source).__name__} found")
    if len(source) > LARGEST_TEXT:
        raise InputError(f"scene: {len(source)} characters, at most {LARGEST_TEXT} are read")
    try:
        # Decimals stay the fractions that they print.
        whole = json.loads(source, parse_float=Decimal, parse_int=_whole, parse_constant=_infinite,
                           object_pairs_hook=_once)  # fmt: skip
    except InputError:
        raise
    except (ValueError, RecursionError, ArithmeticError) as error:
        reason = str(error).partition("\n")[0]
        raise InputError(f"scene: this is no JSON that can be read: {reason}") from None
    if not isinstance(whole, dict) or whole.get("format") != FORMAT:
        raise InputError(f'scene, at $: an object with "format": "{FORMAT}" expected')
    if "system" in whole:
        return _system(whole)
    return _scene(whole)[0]


def _system(whole: dict[str, Any]) -> System:
    name = _text(whole["system"], "$.system")
    _, reader = _scene(whole)
    rows = read_rows(reader, _list(whole.get("published", []), "$.published"))
    return System(name, lambda: _scene(whole)[0], rows)


def _whole(text: str) -> int:
    if len(text) > LONGEST_NAME:
        raise InputError(f"scene: a number of {len(text)} digits, at most {LONGEST_NAME} are read")
    return int(text)


def _infinite(text: str) -> Any:
    raise InputError(f"scene: {text} is no number of JSON")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise InputError("scene: an entry is given twice")
    return found


def _scene(whole: dict[str, Any]) -> tuple[Scene, "_Reader"]:
    """The scene, and the reader that knows its names."""
    _known(whole, KEYS, "$")
    reader = _Reader(_moving(whole), whole)
    reader.place()
    made: dict[str, Any] = {}
    for title, classes in PARTS.items():
        own = whole.get(title)
        if title == "outputs":
            table = _table(own or {}, "$.outputs")
            made[title] = {n: reader.part(v, f"$.outputs.{n}", classes) for n, v in table.items()}
        else:
            rows = _list(own or [], f"$.{title}")
            ready: Mapping[int, Any] = reader.joints if title == "joints" else {}
            made[title] = tuple(
                ready[k] if k in ready else reader.part(v, f"$.{title}[{k}]", classes)
                for k, v in enumerate(rows)
            )
    speeds = []
    for k, pair in enumerate(_list(whole.get("speeds", []), "$.speeds")):
        path = f"$.speeds[{k}]"
        speeds.append((reader.names.moving[pair[0]], reader.expression(pair[1], f"{path}[1]")))
    plane = whole.get("plane")
    tables = {
        title: _table(whole.get(title, {}), f"$.{title}") for title in ("definitions", "example")
    }
    equilibria = _list(whole.get("equilibria", []), "$.equilibria")
    scene = Scene(
        _text(whole.get("name"), "$.name"),
        reader.frame(whole.get("inertial"), "$.inertial"),
        reader.point(whole.get("origin"), "$.origin"),
        coordinates=tuple(reader.names.moving[q] for q in whole.get("coordinates", [])),
        inputs=tuple(reader.names.moving[f] for f in whole.get("inputs", [])),
        speeds=tuple(speeds),
        definitions={
            reader.parameter(name, f"$.definitions.{name}"): reader.expression(
                tree, f"$.definitions.{name}"
            )
            for name, tree in tables["definitions"].items()
        },
        example={
            name: _float(value, f"$.example.{name}") for name, value in tables["example"].items()
        },
        equilibria=tuple(
            {
                name: reader.expression(tree, f"$.equilibria[{k}].{name}")
                for name, tree in _table(one, f"$.equilibria[{k}]").items()
            }
            for k, one in enumerate(equilibria)
        ),
        plane=None if plane is None else reader.vector(plane, "$.plane"),
        notes=tuple(
            _text(note, f"$.notes[{k}]", 10_000)
            for k, note in enumerate(_list(whole.get("notes", []), "$.notes"))
        ),
        redundant=_text(whole.get("redundant", REFUSE), "$.redundant"),
        **made,
    )
    return scene, reader


def _moving(whole: dict[str, Any]) -> dict[str, Expr]:
    """Coordinates, inputs and speeds."""
    titled = [(title, _list(whole.get(title, []), f"$.{title}"))
              for title in ("coordinates", "inputs", "variables")]  # fmt: skip
    for k, pair in enumerate(_list(whole.get("speeds", []), "$.speeds")):
        if not isinstance(pair, list) or len(pair) != 2:
            raise refuse(f"$.speeds[{k}]", "a pair of name and definition expected")
        titled.append((f"speeds[{k}]", pair[:1]))
    turns = [
        (f"rotations[{k}]", turn)
        for k, turn in enumerate(_list(whole.get("rotations", []), "$.rotations"))
    ]
    for k, tree in kinds_of_joints(whole).values():
        if isinstance(turn := tree.get("rotation"), dict) and turn.get("kind") == "quaternion":
            turns.append((f"joints[{k}].rotation", turn))
    for path, turn in turns:
        for title in ("coordinates", "speeds"):
            own = turn.get(title) if isinstance(turn, dict) else None
            titled.append((f"{path}.{title}", _list(own, f"$.{path}.{title}")))
    found: dict[str, Expr] = {}
    for title, names in titled:
        for k, name in enumerate(names):
            found.setdefault(name, Function(_symbol(name, f"$.{title}[{k}]"))(dynamicsymbols._t))
    return found


@dataclass
class _Reader:
    """Symbols, frames and points by their names."""

    moving: Mapping[str, Expr]
    whole: dict[str, Any]
    frames: dict[str, ReferenceFrame] = field(default_factory=dict)
    points: dict[str, Point] = field(default_factory=dict)
    joints: dict[int, Joint] = field(default_factory=dict)

    def __post_init__(self) -> None:
        table = _table(self.whole.get("parameters", {}), "$.parameters")
        constants = {name: _parameter(name, own) for name, own in table.items()}
        self.names = Names(self.moving, constants, frozenset(_reactions(self.whole)))

    def place(self) -> None:
        """Frames, points and joints of a kind."""
        roots = {title: _text(self.whole.get(own), f"$.{own}") for title, own in ROOTS.items()}
        for title in ROOTS:
            _table(self.whole.get(title, {}), f"$.{title}")
        taken = {*self.whole.get("frames", {}), *self.whole.get("points", {})}
        known = (*(NAME_OF[kind] for kind in PARTS["joints"]), *FUNCTIONS)
        for k, tree in enumerate(_list(self.whole.get("joints") or [], "$.joints")):
            kind = _table(tree, f"$.joints[{k}]").get("kind")
            if kind not in known:
                words = ", ".join(map(repr, known))
                raise refuse(f"$.joints[{k}].kind", f"{_shown(kind)}, one of {words} expected")
            if kind in FUNCTIONS:
                name = _text(tree.get("name"), f"$.joints[{k}].name")
                if name in taken:
                    raise refuse(f"$.joints[{k}].name", f"{name[:40]!r} is the name of another")
                taken.add(name)
        for title, name in placing_order(self.whole, roots):
            if title == "joints":
                self._jointed(name)
                continue
            path, own = f"$.{title}.{name}", self.whole[title][name]
            _known(own, ENTRIES[title], path)
            called = _text(own.get("name", name), f"{path}.name")
            if title == "frames":
                root = name == roots[title]
                made = ReferenceFrame(called) if root else self._turned(called, own, path)
                self.frames[name] = made
            elif name == roots[title]:
                self.points[name] = Point(called)
            else:
                by = self.vector(own.get("by"), f"{path}.by")
                self.points[name] = self.points[own["from"]].locatenew(called, by)

    def _jointed(self, name: str) -> None:
        place, tree = kinds_of_joints(self.whole)[name]
        path, kind = f"$.joints[{place}]", tree["kind"]
        _known(tree, ("kind", *arguments_of(kind)), path)
        made: dict[str, Any] = {}
        for entry in arguments_of(kind):
            if entry in tree:
                made[entry] = self.value(tree[entry], HINTS[entry], f"{path}.{entry}", made)
            elif entry in required_of(kind):
                raise refuse(path, f"{entry} is missing")
        joint = self.joints[place] = FUNCTIONS[kind](**made)
        self.frames[name], self.points[name] = joint.frame, joint.point

    def _turned(self, name: str, own: dict[str, Any], path: str) -> ReferenceFrame:
        parent = self.frames[own["in"]]
        if "axis" in own:
            if own["axis"] not in ("x", "y", "z"):
                raise refuse(f"{path}.axis", '"x", "y" or "z" expected')
            angle = self.expression(own.get("angle"), f"{path}.angle")
            return parent.orientnew(name, "Axis", (angle, getattr(parent, own["axis"])))
        if "quaternion" in own:
            for k, turn in enumerate(self.whole.get("rotations", [])):
                if turn.get("coordinates") == own["quaternion"]:
                    found = self.part(turn, f"$.rotations[{k}]", (Rotation,))
                    return found.orient(name, parent)
            raise refuse(f"{path}.quaternion", "the coordinates of one of $.rotations expected")
        frame = ReferenceFrame(name)
        # `orient_explicit` would differentiate and simplify, for what nobody asks.
        frame._dcm(parent, self.matrix(own.get("matrix"), f"{path}.matrix"))
        return frame

    def expression(self, tree: Any, path: str) -> Expr:
        """A tree of operations."""
        return read(tree, self.names, path)

    def parameter(self, name: str, path: str) -> Symbol:
        """A parameter."""
        if name not in self.names.constants:
            raise refuse(path, "this is no parameter: declare it in parameters")
        return self.names.constants[name]

    def frame(self, name: Any, path: str) -> ReferenceFrame:
        """A frame that was placed before."""
        if not isinstance(name, str) or name not in self.frames:
            raise refuse(path, f"{_shown(name)} is none of $.frames")
        return self.frames[name]

    def point(self, name: Any, path: str) -> Point:
        """A point that was placed before."""
        if not isinstance(name, str) or name not in self.points:
            raise refuse(path, f"{_shown(name)} is none of $.points")
        return self.points[name]

    def vector(self, tree: Any, path: str) -> Vector:
        """Components by frame."""
        parts = []
        for name, column in _table(tree, path).items():
            rows = _list(column, f"{path}.{name}")
            if len(rows) != 3:
                raise refuse(f"{path}.{name}", f"{len(rows)} components, 3 expected")
            entries_ = [self.expression(e, f"{path}.{name}[{k}]") for k, e in enumerate(rows)]
            parts.append((Matrix(entries_), self.frame(name, path)))
        return Vector(parts)

    def matrix(self, tree: Any, path: str) -> Matrix:
        """3 x 3."""
        rows = [_list(row, f"{path}[{i}]") for i, row in enumerate(_list(tree, path))]
        if len(rows) != 3 or any(len(row) != 3 for row in rows):
            raise refuse(path, "three rows of three entries expected")
        return Matrix(3, 3, lambda i, j: self.expression(rows[i][j], f"{path}[{i}][{j}]"))

    def part(self, tree: Any, path: str, classes: Sequence[type]) -> Any:
        """A part of one of the kinds."""
        table = _table(tree, path)
        kind = KINDS.get(str(table.get("kind")))
        if kind is None or kind not in classes:
            known = ", ".join(repr(NAME_OF[own]) for own in classes)
            raise refuse(f"{path}.kind", f"{_shown(table.get('kind'))}, one of {known} expected")
        _known(table, ("kind", *(name for name, _, _ in entries(kind))), path)
        made: dict[str, Any] = {}
        for name, own, hint in entries(kind):
            if name in table:
                made[own.name] = self.value(table[name], hint, f"{path}.{name}", made)
            elif required(own):
                raise refuse(path, f"{name} is missing")
        if kind is Joint and len(made["reactions"]) != len(made["directions"]):
            raise refuse(f"{path}.directions", "one for each of its reactions expected")
        return condition(**made) if kind is Condition else kind(**made)

    def value(self, tree: Any, hint: Any, path: str, made: Mapping[str, Any]) -> Any:
        """An entry of the type that the dataclass declares."""
        if get_origin(hint) is UnionType:
            if tree is None and type(None) in get_args(hint):
                return None
            if Dyadic in get_args(hint) and isinstance(tree, dict):
                return self._inertia(tree, path, made["frame"])
            if {*get_args(hint)} <= {*NAME_OF}:
                return self.part(tree, path, get_args(hint))
            hint = get_args(hint)[0]
        if get_origin(hint) is tuple:
            rows, inner = _list(tree, path), get_args(hint)
            if inner[-1] is ...:
                inner = (inner[0],) * len(rows)
            if len(rows) != len(inner):
                raise refuse(path, f"{len(rows)} entries, {len(inner)} expected")
            return tuple(
                self.value(one, own, f"{path}[{k}]", made)
                for k, (one, own) in enumerate(zip(rows, inner, strict=True))
            )
        if hint in NAME_OF:
            return self.part(tree, path, (hint,))
        if hint is bool:
            if not isinstance(tree, bool):
                raise refuse(path, "true or false expected")
            return tree
        if hint is str:
            return _text(tree, path)
        if hint is Relational:
            return relation(tree, self.names, path)
        ways: dict[Any, Callable[[Any, str], Any]] = {
            Expr: self.expression, Point: self.point, ReferenceFrame: self.frame,
            Vector: self.vector,
        }  # fmt: skip
        if hint in ways:
            return ways[hint](tree, path)
        return {
            _text(name, path): self._given(one, f"{path}.{name}")
            for name, one in _table(tree, path).items()
        }

    def _inertia(self, tree: dict[str, Any], path: str, frame: ReferenceFrame) -> Dyadic:
        _known(tree, ("matrix", "terms"), path)
        total = Dyadic(0)
        if "matrix" in tree:
            matrix = self.matrix(tree["matrix"], f"{path}.matrix")
            axes = (frame.x, frame.y, frame.z)
            for i, one in enumerate(axes):
                for j, two in enumerate(axes):
                    total += matrix[i, j] * outer(one, two)
            return total
        for k, term in enumerate(_list(tree.get("terms"), f"{path}.terms")):
            own = f"{path}.terms[{k}]"
            if not isinstance(term, list) or len(term) != 3:
                raise refuse(own, "a factor and two vectors expected")
            one, two = (self.vector(term[i], f"{own}[{i}]") for i in (1, 2))
            total += self.expression(term[0], f"{own}[0]") * outer(one, two)
        return total

    def _given(self, tree: Any, path: str) -> Any:
        if isinstance(tree, list):
            return tuple(self._given(one, f"{path}[{k}]") for k, one in enumerate(tree))
        if isinstance(tree, dict):
            if len(tree) != 1:
                raise refuse(path, "an object with one entry expected")
            ((kind, inner),) = tree.items()
            ways = {"vector": self.vector, "frame": self.frame, "point": self.point,
                    "expression": self.expression}  # fmt: skip
            if kind in ways:
                return ways[kind](inner, f"{path}.{kind}")
            if kind == "part":
                return self.part(inner, f"{path}.part", (*NAME_OF,))
            raise refuse(path, f"{_shown(kind)}, one of {', '.join([*ways, 'part'])} expected")
        if tree is None or isinstance(tree, bool):
            return tree
        return _text(tree, path)


def _reactions(whole: dict[str, Any]) -> list[str]:
    return [
        own["name"]
        for own in _list(whole.get("reactions", []), "$.reactions")
        if isinstance(own, dict) and isinstance(own.get("name"), str)
    ]


def _parameter(name: str, own: Any) -> Symbol:
    path = f"$.parameters.{name}"
    _symbol(name, path)
    table = _table(own, path)
    _known(table, ("is", "unit", "meaning", "typical", "declared"), path)
    words = _list(table.get("is", ["positive"]), f"{path}.is")
    if not all(isinstance(word, str) and word in WORDS for word in words):
        raise refuse(f"{path}.is", f"words of {', '.join(WORDS)} expected")
    unit, meaning, typical = (
        _text(table.get(title, ""), f"{path}.{title}", 1000)
        for title in ("unit", "meaning", "typical")
    )
    signs: dict[str, Any] = dict.fromkeys(words, True)
    try:
        if table.get("declared") is False:
            return Symbol(name, **signs)
        dimension_of_unit(unit, f"parameter {name}")
        return Parameter(name, unit, meaning, *typical_value(name, typical), **signs)
    except MechanicsError as error:
        raise refuse(path, str(error)) from None
    except ValueError as error:
        raise refuse(f"{path}.is", " ".join(str(error).split())[:100]) from None


def _shown(value: Any) -> str:
    return "nothing" if value is None else repr(value)[:40]


def _symbol(name: Any, path: str) -> str:
    if not isinstance(name, str) or not SYMBOL.fullmatch(name):
        raise refuse(path, f"{_shown(name)} is no name of letters, digits and _, at most 64")
    return name


def _text(value: Any, path: str, longest: int = LONGEST_NAME) -> str:
    if not isinstance(value, str) or len(value) > longest or not value.isprintable():
        raise refuse(path, f"{_shown(value)}, a text of at most {longest} characters expected")
    return value


def _list(value: Any, path: str) -> list[Any]:
    if not isinstance(value, list) or len(value) > MOST_PARTS:
        raise refuse(path, f"a list of at most {MOST_PARTS} entries expected")
    return value


def _table(value: Any, path: str) -> dict[str, Any]:
    if not isinstance(value, dict) or len(value) > MOST_PARTS:
        raise refuse(path, f"an object of at most {MOST_PARTS} entries expected")
    return value


def _known(value: Any, keys: Sequence[str], path: str) -> None:
    for key in _table(value, path):
        if key not in keys:
            raise refuse(path, f"entry {key[:40]!r} is not known: they are {', '.join(keys)}")


def _float(value: Any, path: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | Decimal):
        raise refuse(path, f"{_shown(value)}, a number expected")
    return float(number(value, path))
