"""A scene as a tree of dicts, lists, text and numbers that `json.dumps` accepts."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from sympy import Expr, Matrix, Symbol, cos, sin, sympify
from sympy.core.relational import Relational
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import InputError, wanted
from mechanics.scene.declaration import REFUSE
from mechanics.scene.geometry import (
    components,
    dyadic_matrix,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.json import expressions
from mechanics.scene.json.kinds import FORMAT, NAME_OF, PARTS, entries, required
from mechanics.scene.json.published import variables, write_rows
from mechanics.scene.parameters import Parameter
from mechanics.scene.rotations import rotation_between
from mechanics.scene.scene import Scene
from mechanics.scene.symbols import name_of
from mechanics.scene.system import System


def to_json(scene: Scene | System) -> dict[str, Any]:
    """A scene as a tree, as ``docs/scene.schema.json`` says; `from_json` reads it.

    Parameters
    ----------
    scene : Scene or System

    Returns
    -------
    dict
        `json.dumps` accepts it. What joints and rotations add is in it; of a system, its name and
        published equations, too.

    Raises
    ------
    InputError
        If an expression has no place in JSON; it is named.
    """
    wanted(scene, (Scene, System), "to_json", "pass a scene")
    system = scene if isinstance(scene, System) else None
    scene = scene.scene() if isinstance(scene, System) else scene
    writer = _Writer(scene)
    parts = {title: writer.parts(getattr(scene, title)) for title in PARTS}
    later = {
        "speeds": [[name_of(u), writer.expression(e)] for u, e in scene.speeds],
        "definitions": {writer.expression(s): writer.expression(e)
                        for s, e in scene.definitions.items()},
        "equilibria": [{name: writer.expression(e) for name, e in one.items()}
                       for one in scene.equilibria],
        "plane": None if scene.plane is None else writer.vector(scene.plane),
    }  # fmt: skip
    more: dict[str, Any] = {}
    if system is not None:
        own = {
            name_of(f) for f in (*scene.coordinates, *scene.inputs, *(u for u, _ in scene.speeds))
        }
        more = {
            "system": system.name,
            "variables": [name for name in variables(system.published) if name not in own],
            "published": write_rows(writer, system.published),
        }
    whole = {
        "format": FORMAT,
        "name": scene.name,
        "coordinates": [name_of(q) for q in scene.coordinates],
        "inputs": [name_of(f) for f in scene.inputs],
        "speeds": later["speeds"],
        "parameters": writer.parameters,
        "inertial": writer.frame(scene.frame),
        "origin": writer.point(scene.origin),
        "frames": writer.frames,
        "points": writer.points,
        **parts,
        "plane": later["plane"],
        "definitions": later["definitions"],
        "example": {name: _plain(value) for name, value in scene.example.items()},
        "equilibria": later["equilibria"],
        "notes": list(scene.notes),
        "redundant": None if scene.redundant == REFUSE else scene.redundant,
        **more,
    }
    return {key: value for key, value in whole.items() if value not in ([], {}, None)}


def _plain(value: Any) -> int | float:
    return int(value) if float(value).is_integer() else float(value)


@dataclass
class _Writer:
    """What has been met on the way gets a name of its own."""

    scene: Scene
    parameters: dict[str, Any] = field(default_factory=dict)
    frames: dict[str, Any] = field(default_factory=dict)
    points: dict[str, Any] = field(default_factory=dict)
    _symbols: dict[str, Symbol] = field(default_factory=dict)
    _names: dict[Any, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._called(self.frames, self.scene.frame)
        self._called(self.points, self.scene.origin)
        self._reactions = {r.symbol for r in self.scene.reactions}

    def _called(self, table: dict[str, Any], thing: ReferenceFrame | Point) -> str:
        name, count = str(thing.name), 1
        while (own := name if count == 1 else f"{name}#{count}") in table:
            count += 1
        table[own] = {} if own == name else {"name": name}
        return self._names.setdefault(thing, own)

    def expression(self, value: Any) -> Any:
        """A tree of operations."""
        return expressions.write(value, self.symbol)

    def symbol(self, symbol: Symbol) -> Any:
        """The name of a parameter, which is noted; time; or a reaction."""
        if symbol == dynamicsymbols._t:
            return ["time"]
        if symbol in self._reactions:
            return ["reaction", symbol.name]
        if self._symbols.setdefault(symbol.name, symbol) != symbol:
            raise InputError(f"scene: there are two different parameters named {symbol}")
        if symbol.name not in self.parameters:
            self.parameters[symbol.name] = _parameter(symbol)
        return symbol.name

    def frame(self, frame: ReferenceFrame) -> str:
        """The name of a frame, which is noted with those that carry it."""
        if frame not in self._names:
            for parent, child in pairwise(frame_path(self.scene.frame, frame)):
                if child not in self._names:
                    turn = self._turn(parent, child)
                    name = self._called(self.frames, child)
                    self.frames[name] |= {"in": self._names[parent], **turn}
        return self._names[frame]

    def _turn(self, parent: ReferenceFrame, child: ReferenceFrame) -> dict[str, Any]:
        matrix = relative_rotation(parent, child)
        if found := rotation_between(self.scene.rotations, parent, child):
            return {"quaternion": [name_of(e) for e in found.coordinates]}
        for k, axis in enumerate("xyz"):
            i, j = (k + 1) % 3, (k + 2) % 3
            if isinstance(matrix[i, i], cos):
                for angle in (matrix[i, i].args[0], -matrix[i, i].args[0]):
                    if matrix == _about(k, angle) and matrix[j, i] == sin(angle):
                        return {"axis": axis, "angle": self.expression(angle)}
        return {"matrix": self.matrix(matrix)}

    def matrix(self, matrix: Matrix) -> list[list[Any]]:
        """Rows of trees."""
        return [[self.expression(e) for e in matrix.row(i)] for i in range(3)]

    def point(self, point: Point) -> str:
        """The name of a point, which is noted with those that carry it."""
        if point not in self._names:
            for parent, child in pairwise(point_path(self.scene.origin, point)):
                if child not in self._names:
                    step = self.vector(step_vector(parent, child))
                    name = self._called(self.points, child)
                    self.points[name] |= {"from": self._names[parent], "by": step}
        return self._names[point]

    def vector(self, vector: Vector) -> dict[str, Any]:
        """Components by frame."""
        return {
            self.frame(frame): [self.expression(e) for e in column]
            for frame, column in components(vector)
        }

    def parts(self, values: Any) -> Any:
        """Parts in a list, or by name."""
        if isinstance(values, Mapping):
            return {name: self.part(value) for name, value in values.items()}
        return [self.part(value) for value in values]

    def part(self, part: Any) -> dict[str, Any]:
        """A part with its kind, and the entries that are no defaults."""
        found: dict[str, Any] = {"kind": NAME_OF[type(part)]}
        kind: Any = type(part)
        for name, own, _ in entries(kind):
            value = getattr(part, own.name)
            if required(own) or not (value is own.default or value in ((), {})):
                found[name] = self.value(value, part, name)
        return found

    def value(self, value: Any, part: Any, entry: str) -> Any:
        """One entry of a part; what a joint was made of says what it is."""
        if entry == "given":
            return {name: self._given(one) for name, one in value.items()}
        if isinstance(value, Dyadic):
            return self._inertia(value, part.frame)
        if isinstance(value, Relational):
            return [value.rel_op, *(self.expression(side) for side in value.args)]
        if isinstance(value, tuple):
            return [self.value(one, part, "") for one in value]
        if type(value) in NAME_OF:
            return self.part(value)
        if isinstance(value, Vector):
            return self.vector(value)
        if isinstance(value, Point):
            return self.point(value)
        if isinstance(value, ReferenceFrame):
            return self.frame(value)
        return self.expression(value) if isinstance(value, Expr) else value

    def _inertia(self, dyadic: Dyadic, frame: ReferenceFrame) -> dict[str, Any]:
        owners = {owner for _, *ends in dyadic.args for end in ends for _, owner in end.args}
        if owners <= {frame}:
            return {"matrix": self.matrix(dyadic_matrix(dyadic, frame))}
        return {
            "terms": [
                [self.expression(size), self.vector(one), self.vector(two)]
                for size, one, two in dyadic.args
            ]
        }

    def _given(self, value: Any) -> Any:
        if isinstance(value, tuple | list):
            return [self._given(one) for one in value]
        for kind, name, write in (
            (Vector, "vector", self.vector), (ReferenceFrame, "frame", self.frame),
            (Point, "point", self.point), (Expr, "expression", self.expression),
        ):  # fmt: skip
            if isinstance(value, kind):
                return {name: write(value)}
        if type(value) in NAME_OF:
            return {"part": self.part(value)}
        if value is None or isinstance(value, str | bool):
            return value
        return {"expression": self.expression(sympify(value))}


def _about(k: int, angle: Expr) -> Matrix:
    i, j = (k + 1) % 3, (k + 2) % 3
    matrix = Matrix.zeros(3, 3)
    matrix[k, k] = 1
    matrix[i, i] = matrix[j, j] = cos(angle)
    matrix[i, j], matrix[j, i] = -sin(angle), sin(angle)
    return matrix


def _parameter(symbol: Symbol) -> dict[str, Any]:
    given = symbol._assumptions_orig
    if not all(value is True for value in given.values()):
        raise InputError(f"scene: parameter {symbol}: only what it is can be written, not what not")
    found: dict[str, Any] = {"is": sorted(given)}
    if not isinstance(symbol, Parameter):
        return {**found, "declared": False}
    typical: Any = symbol.typical
    if symbol.half_turns is not None:
        turns = symbol.half_turns
        typical = f"{turns.numerator}*pi/{turns.denominator}"
    told = {"unit": symbol.unit, "meaning": symbol.meaning, "typical": typical}
    return found | {key: str(value) for key, value in told.items() if value not in ("", None)}
