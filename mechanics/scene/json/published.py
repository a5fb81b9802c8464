"""Published equations as JSON: a quantity of the closed vocabulary, and the sides of each row.

{"tag": "(6)", "label": "momentum of the cart", "quantity": {"kind": "momentum", "bodies": "cart",
 "along": "x"}, "sides": [["multiply", "M", ["derivative", "x", 1]]]}
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from types import ModuleType, UnionType
from typing import Any, Protocol, get_args, get_origin, get_type_hints

from sympy import Expr, Float, ImmutableMatrix, MatrixBase, S, Symbol, sympify
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from mechanics.scene import composite, linear_quantities, quantities, shapes
from mechanics.scene.json.expressions import Names, refuse, relation
from mechanics.scene.json.kinds import entries, required
from mechanics.scene.published import Published
from mechanics.scene.symbols import name_of

CAPITAL = re.compile(r"(?<=[a-z])(?=[A-Z])")
DECIMAL = re.compile(r"-?\d{1,40}(\.\d{1,40})?", re.ASCII)
LONGEST = 1000
"""Characters of a label or a note."""


def _words(modules: Sequence[ModuleType]) -> dict[str, type]:
    own = [kind for module in modules for kind in vars(module).values()
           if isinstance(kind, type) and kind.__module__ == module.__name__]  # fmt: skip
    leaves = [kind for kind in own if is_dataclass(kind) and not kind.__subclasses__()]
    return {CAPITAL.sub(" ", kind.__name__).lower(): kind for kind in leaves}


VOCABULARY = _words((quantities, linear_quantities, composite, shapes))
"""What rows can be about, and what that is made of, by name."""
NAME_OF = {kind: name for name, kind in VOCABULARY.items()}


class Writer(Protocol):
    """What the writer of a scene knows."""

    def expression(self, value: Any) -> Any:
        """A tree of operations."""


class Reader(Protocol):
    """What the reader of a scene knows."""

    names: Names

    def expression(self, tree: Any, path: str) -> Expr:
        """The expression of a tree."""


@cache
def hints_of(kind: type) -> dict[str, Any]:
    """Types of the fields."""
    return get_type_hints(kind)


def variables(rows: Sequence[Published]) -> list[str]:
    """Names of functions of time in rows, in order: those of the scene, and those of the source."""
    found = {name_of(f) for row in rows for side in row.sides if not isinstance(side, str | int)
             for f in side.atoms(AppliedUndef)}  # fmt: skip
    return sorted(found)


def write_rows(writer: Writer, rows: Sequence[Published]) -> list[dict[str, Any]]:
    """Rows as JSON."""
    found = []
    for row in rows:
        sides = [_side(writer, side) for side in row.sides]
        own = {"tag": row.tag, "label": row.label, "note": row.note,
               "quantity": _written(writer, row.quantity), "sides": sides}  # fmt: skip
        found.append({key: value for key, value in own.items() if value != ""})
    return found


def _side(writer: Writer, side: Any) -> Any:
    if isinstance(side, str):
        return {"word": side}
    if isinstance(side, Relational):
        return {"relation": [side.rel_op, *(writer.expression(e) for e in side.args)]}
    if isinstance(side, MatrixBase):
        return {"matrix": _written(writer, side)}
    return _printed(writer, side)


def _written(writer: Writer, value: Any) -> Any:
    if is_dataclass(value) and not isinstance(value, type):
        kind = type(value)
        own = {f.name: getattr(value, f.name) for f in fields(kind)}
        kept = [f.name for f in fields(kind) if required(f) or own[f.name] != f.default]
        return {"kind": NAME_OF[kind], **{n: _written(writer, own[n]) for n in kept}}
    if isinstance(value, MatrixBase):
        return [[_printed(writer, e) for e in value.row(i)] for i in range(value.rows)]
    if isinstance(value, tuple | list):
        return [_written(writer, one) for one in value]
    if value is None or isinstance(value, str | bool | int):
        return value
    return writer.expression(value)


def _printed(writer: Writer, value: Expr | int) -> Any:
    """A number that is printed, alone or in front of a product, keeps its digits."""
    number, rest = sympify(value).as_coeff_Mul()
    if not isinstance(number, Float) or not DECIMAL.fullmatch(str(number)):
        return writer.expression(value)
    times = {} if rest is S.One else {"times": writer.expression(rest)}
    return {"decimal": str(number), **times}


def read_rows(reader: Reader, rows: list[Any]) -> tuple[Published, ...]:
    """Rows of JSON.

    Raises
    ------
    InputError
        Names the place, and what is wrong there.
    """
    return tuple(_row(reader, row, f"$.published[{k}]") for k, row in enumerate(rows))


def _row(reader: Reader, row: Any, path: str) -> Published:
    _known(row, {"tag", "label", "note", "quantity", "sides"}, path)
    tag, label, note = (_text(row.get(n, ""), f"{path}.{n}") for n in ("tag", "label", "note"))
    quantity = _made(reader, row.get("quantity"), quantities.Quantity, f"{path}.quantity")
    sides = row.get("sides")
    if not isinstance(sides, list) or not sides:
        raise refuse(f"{path}.sides", "a list of sides expected")
    read = (_read_side(reader, side, f"{path}.sides[{k}]") for k, side in enumerate(sides))
    return Published(tag, quantity, tuple(read), label, note)


def _read_side(reader: Reader, side: Any, path: str) -> Any:
    if not isinstance(side, dict):
        return reader.expression(side, path)
    ((kind, inner),) = side.items() if len(side) == 1 else (("", None),)
    if kind == "word":
        return _text(inner, f"{path}.word")
    if kind == "relation":
        return relation(inner, reader.names, f"{path}.relation")
    if kind == "matrix":
        return _matrix(reader, inner, f"{path}.matrix")
    if "decimal" in side:
        return _number(reader, side, path)
    raise refuse(path, "a tree, or an object with one of word, relation, matrix, decimal expected")


def _value(reader: Reader, tree: Any, hint: Any, path: str) -> Any:
    """A value of the type that the vocabulary declares."""
    if get_origin(hint) is UnionType:
        kinds = [kind for kind in get_args(hint) if kind is not type(None)]
        if tree is None and len(kinds) < len(get_args(hint)):
            return None
        if isinstance(tree, dict):
            return _made(reader, tree, hint, path)
        several = isinstance(tree, list) and [k for k in kinds if get_origin(k) is tuple]
        return _value(reader, tree, several[0] if several else kinds[0], path)
    if get_origin(hint) is tuple:
        inner = get_args(hint)
        if not isinstance(tree, list) or (inner[-1] is not ... and len(tree) != len(inner)):
            raise refuse(path, "a list of as many entries as it has expected")
        each = [inner[0]] * len(tree) if inner[-1] is ... else inner
        return tuple(_value(reader, one, own, f"{path}[{k}]")
                     for k, (one, own) in enumerate(zip(tree, each, strict=True)))  # fmt: skip
    if hint is str:
        return _text(tree, path)
    if hint in (bool, int):
        if type(tree) is not hint:
            raise refuse(path, f"{hint.__name__} expected")
        return tree
    if hint is ImmutableMatrix:
        return _matrix(reader, tree, path)
    if hint in (Expr, Symbol):
        value = reader.expression(tree, path)
        if not isinstance(value, hint):
            raise refuse(path, "the name of a symbol expected")
        return value
    return _made(reader, tree, hint, path)


def _made(reader: Reader, tree: Any, hint: Any, path: str) -> Any:
    kind = VOCABULARY.get(str(tree.get("kind"))) if isinstance(tree, dict) else None
    if kind is None or not issubclass(kind, hint):
        fitting = ", ".join(n for n, one in VOCABULARY.items() if issubclass(one, hint))
        raise refuse(f"{path}.kind", f"one of {fitting} expected")
    _known(tree, {"kind", *hints_of(kind)}, path)
    made = {}
    for name, own, hint_ in entries(kind):
        if name in tree:
            made[name] = _value(reader, tree[name], hint_, f"{path}.{name}")
        elif required(own):
            raise refuse(path, f"{name} is missing")
    return kind(**made)


def _matrix(reader: Reader, tree: Any, path: str) -> ImmutableMatrix:
    rows: list[Any] = tree if isinstance(tree, list) and tree else [None]
    if not all(isinstance(row, list) and row and len(row) == len(rows[0]) for row in rows):
        raise refuse(path, "rows of as many entries each expected")
    return ImmutableMatrix([
        [_number(reader, e, f"{path}[{i}][{j}]") for j, e in enumerate(row)]
        for i, row in enumerate(rows)
    ])  # fmt: skip


def _number(reader: Reader, entry: Any, path: str) -> Expr:
    if not isinstance(entry, dict):
        return reader.expression(entry, path)
    _known(entry, {"decimal", "times"}, path)
    text = entry.get("decimal")
    if not isinstance(text, str) or not DECIMAL.fullmatch(text):
        raise refuse(path, 'a tree, or {"decimal": "0.618", "times": tree}, expected')
    number = Float(text, "")  # of as many digits as are printed
    times = reader.expression(entry["times"], f"{path}.times") if "times" in entry else S.One
    return number * times


def _text(value: Any, path: str) -> str:
    if not isinstance(value, str) or len(value) > LONGEST or not value.isprintable():
        raise refuse(path, f"a text of at most {LONGEST} characters expected")
    return value


def _known(tree: Any, keys: set[str], path: str) -> None:
    if not isinstance(tree, Mapping) or not keys.issuperset(tree):
        raise refuse(path, f"an object with entries of {', '.join(sorted(keys))} expected")
