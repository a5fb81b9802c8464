"""How code takes its arguments apart: which names it gives to their entries.

    A, C, m = p      m = p[2]      double m = p[2];      p["m"]      p.m      return xdd, thdd

Where these are names of the scene, they tell which entry is which, better than any usual order.
"""

import ast
import inspect
import re
import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

from sympy import Expr

PLACE_IN_C = re.compile(r"\b([A-Za-z_]\w*)\s*=\s*([A-Za-z_]\w*)\s*\[\s*(\d{1,2})\s*\]\s*[;,]")

ENTRY_IN_C = re.compile(r"\b([A-Za-z_]\w*)\s*\[\s*[1-9]\d?\s*\]")
"""An entry behind the first one: what has it is no number."""


@dataclass(frozen=True)
class Record:
    """An argument whose entries have names: a dictionary, or an object with attributes."""

    keys: tuple[str, ...]
    symbols: tuple[Expr, ...]
    attributes: bool

    def __iter__(self) -> Iterator[Expr]:
        return iter(self.symbols)

    def __len__(self) -> int:
        return len(self.symbols)

    def filled(self, number: Callable[[Expr], Any]) -> Any:
        """It, with what a symbol becomes."""
        found = {key: number(symbol) for key, symbol in zip(self.keys, self.symbols, strict=True)}
        return SimpleNamespace(**found) if self.attributes else found


@dataclass
class Apart:
    """What code does with one argument.

    Attributes
    ----------
    places : dict of int to set of str
        Names that it gives to entries.
    keys, attributes : dict of str to int
        Names by which it asks for entries, and the line where it does first.
    size : int, optional
        How many entries there are, where it takes them all at once.
    fields : bool
        Whether the names are those of a type, not of variables.
    vector : bool
        Whether it takes entries by their places.
    """

    places: dict[int, set[str]] = field(default_factory=dict)
    keys: dict[str, int] = field(default_factory=dict)
    attributes: dict[str, int] = field(default_factory=dict)
    size: int | None = None
    fields: bool = False
    vector: bool = False

    def give(self, place: int, name: str) -> None:
        """Learn a name of an entry."""
        self.places.setdefault(place, set()).add(name)

    @property
    def order(self) -> tuple[str, ...]:
        """Names of all entries in their order; empty where they are not plain."""
        if set(self.places) != set(range(len(self.places))):
            return ()
        if any(len(names) > 1 for names in self.places.values()):
            return ()
        return tuple(next(iter(self.places[k])) for k in range(len(self.places)))


def in_python(function: Callable[..., Any]) -> tuple[dict[str, Apart], tuple[str, ...]]:
    """What a function does with its arguments, and the names of what it returns.

    Nothing where its text is not at hand.
    """
    try:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return {}, ()
    found: dict[str, Apart] = {}
    returned = []
    for node in ast.walk(tree):
        line = first - 1 + getattr(node, "lineno", 1)
        match node:
            case ast.Assign(targets=[ast.Tuple() | ast.List() as target], value=value):
                for names, mine in _unpacked(target, value):
                    _of(found, mine).size = len(names)
                    for place, entry in enumerate(names):
                        _of(found, mine).give(place, entry)
            case ast.Assign(targets=[ast.Name(id=local)], value=ast.Subscript(
                    value=ast.Name(id=mine), slice=ast.Constant(value=int(place)))):  # fmt: skip
                _of(found, mine).give(place, local)
            case ast.Subscript(value=ast.Name(id=mine), slice=ast.Constant(value=str(key))):
                _of(found, mine).keys.setdefault(key, line)
            case ast.Subscript(value=ast.Name(id=mine)):
                _of(found, mine).vector = True
            case ast.Call(func=ast.Attribute(value=ast.Name(id=mine), attr="get"),
                          args=[ast.Constant(value=str(key)), *_]):  # fmt: skip
                _of(found, mine).keys.setdefault(key, line)
            case ast.Attribute(value=ast.Name(id=mine), attr=attribute):
                _of(found, mine).attributes.setdefault(attribute, line)
            case ast.Return(value=value) if value is not None:
                returned.append(value)
    return found, _names(returned[0]) if len(returned) == 1 else ()


def _unpacked(target: ast.expr, value: ast.expr) -> Iterator[tuple[list[str], str]]:
    """Names that an assignment gives to all entries: ``a, b = q`` or ``(a, b), c = q, qd``."""
    if not isinstance(target, ast.Tuple | ast.List):
        return
    if isinstance(value, ast.Name):
        names = [part.id for part in target.elts if isinstance(part, ast.Name)]
        if len(names) == len(target.elts):
            yield names, value.id
    elif isinstance(value, ast.Tuple | ast.List) and len(value.elts) == len(target.elts):
        for one, other in zip(target.elts, value.elts, strict=True):
            yield from _unpacked(one, other)


def _of(found: dict[str, Apart], mine: str) -> Apart:
    return found.setdefault(mine, Apart())


def _names(value: ast.expr) -> tuple[str, ...]:
    """``return xdd``, ``return xdd, thdd``, ``return np.array([xdd, thdd])``."""
    match value:
        case ast.Call(func=ast.Attribute(attr="array" | "asarray") | ast.Name(id="array"),
                      args=[inner, *_]):  # fmt: skip
            return _names(inner)
        case ast.Name(id=name):
            return (name,)
        case ast.Tuple(elts=parts) | ast.List(elts=parts):
            names = [part.id for part in parts if isinstance(part, ast.Name)]
            return tuple(names) if len(names) == len(parts) else ()
    return ()


def in_c(plain: str) -> dict[str, Apart]:
    """What C does with arrays; its text without comments."""
    found: dict[str, Apart] = {}
    for match in PLACE_IN_C.finditer(plain):
        _of(found, match[2]).give(int(match[3]), match[1])
    for match in ENTRY_IN_C.finditer(plain):
        _of(found, match[1]).vector = True
    return found
