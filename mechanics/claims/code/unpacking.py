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

import numpy as np
from sympy import Expr

from mechanics.claims.code import array_language

PLACE_IN_C = re.compile(r"\b([A-Za-z_]\w*)\s*=\s*([A-Za-z_]\w*)\s*\[\s*(\d{1,2})\s*\]\s*[;,]")

LAST = -1
"""The place of the last entry, as Python counts."""
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


@dataclass(frozen=True)
class Diagonal(Record):
    """A matrix with entries on its diagonal alone: an inertia about principal axes."""

    def filled(self, number: Callable[[Expr], Any]) -> Any:
        """It, with what a symbol becomes."""
        found = np.zeros((len(self), len(self)), dtype=object)
        for k, symbol in enumerate(self.symbols):
            found[k, k] = number(symbol)
        return found


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
    matrix : bool
        Whether these are of rows and columns.
    least : int
        How many entries there are at least.
    """

    places: dict[int, set[str]] = field(default_factory=dict)
    keys: dict[str, int] = field(default_factory=dict)
    attributes: dict[str, int] = field(default_factory=dict)
    size: int | None = None
    fields: bool = False
    vector: bool = False
    matrix: bool = False
    least: int = 0

    def give(self, place: int, name: str) -> None:
        """Learn a name of an entry."""
        self.places.setdefault(place, set()).add(name)

    def count_from_the_end(self) -> None:
        """Give the last entry its number, which is the next one where others have names."""
        last = self.places.pop(LAST, set())
        if last and self.places and self.size is None:
            self.size = max(self.places) + 2
            self.places[self.size - 1] = last

    def reach(self, last: ast.expr) -> None:
        """Learn up to which entry it goes, where names do not tell."""
        if isinstance(last, ast.Constant) and isinstance(last.value, int):
            self.least = max(self.least, last.value)

    @property
    def order(self) -> tuple[str, ...]:
        """Names of all entries in their order; empty where they are not plain."""
        if set(self.places) != set(range(len(self.places))) or self.least > len(self.places):
            return ()
        if any(len(names) > 1 for names in self.places.values()):
            return ()
        return tuple(next(iter(self.places[k])) for k in range(len(self.places)))


def in_python(function: Callable[..., Any]) -> tuple[dict[str, Apart], tuple[str, ...], str]:
    """What a function does with its arguments, the names of what it returns, and its text.

    The text has the comments above it. Nothing where its text is not at hand.
    """
    try:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return {}, (), ""
    found: dict[str, Apart] = {}
    returned = []
    if getattr(function, "__globals__", {}).get("get") is array_language.get:
        tree = _Entries(tree).visit(tree)
    parts: dict[str, tuple[str, int]] = {}  # of which argument a local name is a part, from where
    for node in ast.walk(tree):
        line = first - 1 + getattr(node, "lineno", 1)
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            for one, other in _pairs(node.targets[0], node.value):
                _learn(found, parts, one, _plain(other))
        match node:
            case ast.Subscript(value=ast.Name(id=mine), slice=ast.Constant(value=str(key))):
                _of(found, mine).keys.setdefault(key, line)
            case ast.Subscript(value=ast.Name(id=mine)):
                _of(found, mine).vector = True
            case ast.Call(
                func=ast.Name(id="get"),
                args=[ast.Name(id=mine), ast.Call(func=ast.Name(id="steps"), args=[*_, last])],
            ):
                _of(found, mine).vector = True  # x(1:3) of MATLAB
                _of(found, mine).reach(last)
            case ast.Call(
                func=ast.Name(id="get"),
                args=[ast.Name(id=mine), ast.Constant(), ast.Constant()],
            ):
                _of(found, mine).vector = _of(found, mine).matrix = True  # I(2, 2) of MATLAB
            case ast.BinOp(op=ast.MatMult()):
                for side in (node.left, node.right):
                    if isinstance(side, ast.Name):
                        _of(found, side.id).vector = True
            case ast.Call(func=ast.Attribute(value=ast.Name(id=mine), attr="get"),
                          args=[ast.Constant(value=str(key)), *_]):  # fmt: skip
                _of(found, mine).keys.setdefault(key, line)
            case ast.Attribute(value=ast.Name(id=mine), attr=attribute):
                _of(found, mine).attributes.setdefault(attribute, line)
            case ast.Return(value=value) if value is not None:
                returned.append(value)
    for apart in found.values():
        apart.count_from_the_end()
    names = _names(returned[0]) if len(returned) == 1 else ()
    return found, names, (inspect.getcomments(function) or "") + "".join(lines)


class _Entries(ast.NodeTransformer):
    """MATLAB's x(2) of an argument that is set later, as x[1] before that."""

    def __init__(self, tree: ast.AST) -> None:
        loops = any(isinstance(one, ast.For | ast.While) for one in ast.walk(tree))
        self.set: dict[str, int] = {}
        for one in ast.walk(tree):
            if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store):
                line = 0 if loops else one.lineno
                self.set[one.id] = min(line, self.set.get(one.id, line))

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """An entry, by its number."""
        match node:
            case ast.Call(
                func=ast.Name(id="get"),
                args=[ast.Name(id=mine) as array, ast.Constant(value=int(k))],
            ) if k > 0 and node.lineno < self.set.get(mine, 0):
                place = ast.copy_location(ast.Constant(k - 1), node)
                return ast.copy_location(ast.Subscript(array, place, ast.Load()), node)
        return self.generic_visit(node)


def _pairs(target: ast.expr, value: ast.expr) -> Iterator[tuple[ast.expr, ast.expr]]:
    """What is assigned to what: ``(a, b), c = q, qd`` is two assignments."""
    lists = ast.Tuple | ast.List
    if isinstance(target, lists) and isinstance(value, lists):
        if len(target.elts) == len(value.elts):
            for one, other in zip(target.elts, value.elts, strict=True):
                yield from _pairs(one, other)
    else:
        yield target, value


def _plain(value: ast.expr) -> ast.expr:
    """What entries are taken of: y in y.T, x[1] in x[1].item()."""
    match value:
        case ast.Attribute(value=inner, attr="T"):
            return _plain(inner)
        case ast.Call(func=ast.Attribute(value=inner, attr="item" | "copy" | "flatten" | "ravel"),
                      args=[]):  # fmt: skip
            return _plain(inner)
        case ast.Call(func=ast.Name(id="exactly"), args=[inner, _]):  # x.segment(0, 2) of Eigen
            return _plain(inner)
    return value


def _learn(
    found: dict[str, Apart], parts: dict[str, tuple[str, int]], target: ast.expr, value: ast.expr
) -> None:
    """What one assignment says of the entries of an argument, or of a part of one."""
    match target, value:
        case ((ast.Tuple() | ast.List()), ast.Name(id=name)):
            names = [part.id for part in target.elts if isinstance(part, ast.Name)]
            if len(names) == len(target.elts):
                mine, start = parts.get(name, (name, 0))
                if name not in parts:
                    _of(found, mine).size = len(names)
                for place, entry in enumerate(names):
                    _of(found, mine).give(start + place, entry)
        case ast.Name(id=local), ast.Subscript(value=ast.Name(id=name), slice=place):
            mine, start = parts.get(name, (name, 0))
            match place:
                case ast.Constant(value=int(number)):
                    _of(found, mine).give(start + number, local)
                case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)) if not start:
                    _of(found, mine).give(LAST, local)
                case ast.Slice(lower=lower, step=None) if lower is None or (
                    isinstance(lower, ast.Constant) and isinstance(lower.value, int)
                ):
                    begins = lower.value if isinstance(lower, ast.Constant) else 0
                    parts[local] = mine, start + (begins if isinstance(begins, int) else 0)


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
