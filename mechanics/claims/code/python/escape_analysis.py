"""Where an object of a file, which a function reads, may be changed through another name.

CFG = [-1]
def f(x): return CFG[0]*x       reads it
T = CFG                         the same object: what changes T changes it
random.shuffle(CFG)             it escapes: what is called may change it
print(CFG, CFG[0], len(CFG))    does not: these read, or copy

A whitelist: an object escapes where it stands by itself and is not read, copied, or given to a
function of the file that does none of this to it.
"""

import ast
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property
from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType
from typing import Any

READERS = frozenset(
    ("abs", "all", "any", "dumps", "float", "format", "isinstance", "join", "len", "linspace",
     "max", "mean", "min", "norm", "pprint", "print", "range", "repr", "round", "str", "sum")
)  # fmt: skip
"""Functions that give numbers and texts of what they are given."""
COPIERS = frozenset(
    ("asarray", "asdict", "astuple", "copy", "deepcopy", "dict", "enumerate", "fields", "get",
     "hstack", "index", "items", "keys", "list", "reversed", "set", "sorted", "tolist", "tuple",
     "union", "values", "zip", "_asdict", "count", "dot", "vstack", "column_stack")
)  # fmt: skip
"""Functions and methods that hand out its entries, or another object of the same."""
METHODS = frozenset(("copy", "count", "dot", "index", "max", "mean", "min", "sum", "tolist"))
"""Methods that give numbers, or a copy."""
NUMBERS = ("fractions", "decimal", "sympy", "casadi", "enum", "datetime", "re", "pathlib")
"""Modules whose objects are numbers, names and formulas."""
PLAIN = (int, float, complex, str, bytes, bool, type(None), range, frozenset, type, property,
         FunctionType, BuiltinFunctionType, MethodType, ModuleType)  # fmt: skip
"""What is not changed in place; of functions and modules, lines that do so are found elsewhere."""
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
PARTS = (ast.Attribute, ast.Subscript)


@dataclass(frozen=True)
class Escape:
    """Where an object may be changed.

    Attributes
    ----------
    name : str
        As which it stands there.
    line : int
    """

    name: str
    line: int


def same_objects(name: str, values: Mapping[str, Any]) -> set[str]:
    """All names of a file for the object that one of them is; none where nothing changes it."""
    value = values.get(name)
    if not _is_mutable(value):
        return set()
    return {other for other, one in values.items() if one is value}


def escape(
    tree: ast.Module, name: str, values: Mapping[str, Any], called: Container[str]
) -> Escape | None:
    """The first place at which an object escapes; None where all of them only read it.

    Parameters
    ----------
    tree : ast.Module
        The file.
    name : str
        Of the object.
    values : mapping of str to object
        What names of the file are.
    called : container of str
        Functions and classes in which it is seen what they change.
    """
    return _File(tree, called).escape(tree, name, values[name], frozenset())


@dataclass(frozen=True)
class _File:
    tree: ast.Module
    called: Container[str]

    @cached_property
    def parents(self) -> dict[ast.AST, ast.AST]:
        return {c: one for one in ast.walk(self.tree) for c in ast.iter_child_nodes(one)}

    @cached_property
    def functions(self) -> dict[str, ast.FunctionDef]:
        return {one.name: one for one in self.tree.body if isinstance(one, ast.FunctionDef)}

    def escape(
        self, scope: ast.AST, name: str, value: Any, seen: frozenset[tuple[str, str]]
    ) -> Escape | None:
        """Where an object escapes inside of a node in which it has this name."""
        for one in self._mentions(scope, name):
            node, part = self._part(one, value)
            if not _is_mutable(part) and part is not _UNKNOWN:
                continue
            if not self._is_read(node, part, seen):
                return Escape(name, one.lineno)
        return None

    def _mentions(self, scope: ast.AST, name: str) -> Iterator[ast.Name]:
        """Where a name is read, outside of functions in which it is another thing."""
        for part in ast.iter_child_nodes(scope):
            if isinstance(part, FUNCTIONS) and name in _own(part):
                continue
            if isinstance(part, (ast.FunctionDef, ast.ClassDef)) and part.name in self.called:
                continue
            if isinstance(part, ast.Name) and part.id == name and isinstance(part.ctx, ast.Load):
                yield part
            yield from self._mentions(part, name)

    def _part(self, node: ast.expr, value: Any) -> tuple[ast.expr, Any]:
        """The part of an object that an expression reads, as a node, and what it is."""
        while isinstance(parent := self.parents.get(node), PARTS) and parent.value is node:
            above = self.parents.get(parent)
            called = isinstance(above, ast.Call) and above.func is parent
            if isinstance(parent, ast.Attribute) and called:
                break
            node, value = parent, _entry(value, parent)
        return node, value

    def _is_read(self, node: ast.expr, value: Any, seen: frozenset[tuple[str, str]]) -> bool:
        """Whether an object that stands by itself is only read, or copied."""
        parent = self.parents.get(node)
        if not isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            return True  # a change, which is looked at elsewhere
        match parent:
            case ast.Attribute(attr=method):
                copies = method in COPIERS and _is_flat(value)
                return method in METHODS or copies or self._is_of_import(node)
            case ast.Call(func=func) if func is node:
                return True
            case ast.Call() if self._is_of_import(node):
                return True
            case ast.Call():
                return self._is_read_by(parent, node, None, value, seen)
            case ast.keyword(arg=None) | ast.Starred():
                return _is_flat(value)
            case ast.keyword(arg=str() as keyword):
                call = self.parents.get(parent)
                assert isinstance(call, ast.Call)  # keywords have no other place
                return self._is_read_by(call, node, keyword, value, seen)
            case ast.Tuple() | ast.List() if isinstance(self.parents.get(parent), ast.Compare):
                return True
            case ast.For(iter=whole) | ast.comprehension(iter=whole) if whole is node:
                return _is_flat(value)
            case ast.Assign(targets=[ast.Name()]):
                return self.parents.get(parent) is self.tree  # another name, which is known
            case ast.Assign(targets=[ast.Tuple(elts=parts)]):
                return _is_flat(value) and all(isinstance(p, ast.Name) for p in parts)
        reads = (ast.FormattedValue, ast.Compare, ast.BinOp, ast.UnaryOp, ast.Expr, ast.If,
                 ast.Assert, ast.While, ast.arg)  # fmt: skip
        return isinstance(parent, reads)

    def _is_of_import(self, node: ast.AST) -> bool:
        """Whether it stands in a line that only calls, and is run before any function is."""
        while not isinstance(node, ast.stmt):
            node = self.parents[node]
        return isinstance(node, ast.Expr) and self.parents[node] is self.tree

    def _is_read_by(
        self, call: ast.Call, node: ast.expr, keyword: str | None, value: Any,
        seen: frozenset[tuple[str, str]],
    ) -> bool:  # fmt: skip
        """Whether a function only reads what it is given at a place."""
        name = call.func.attr if isinstance(call.func, ast.Attribute) else (
            call.func.id if isinstance(call.func, ast.Name) else "")  # fmt: skip
        if name in self.called:
            return True
        one = self.functions.get(name) if isinstance(call.func, ast.Name) else None
        if one is None:
            return name in READERS or (name in COPIERS and _is_flat(value))
        takes = [a.arg for a in one.args.args]
        taken = keyword or (takes[call.args.index(node)] if call.args.index(node) < len(takes)
                            else "")  # fmt: skip
        if not taken or one.args.vararg or (name, taken) in seen:
            return (name, taken) in seen
        changes = any(
            isinstance(p, (*PARTS, ast.Name)) and not isinstance(p.ctx, ast.Load)
            and root_name(p) == taken for p in ast.walk(one)
        )  # fmt: skip
        inside = ast.Module(one.body, [])
        return not changes and self.escape(inside, taken, value, seen | {(name, taken)}) is None


_UNKNOWN = object()
"""A part of an object, where nothing tells which."""


def _entry(value: Any, node: ast.expr) -> Any:
    """A part of an object; unknown where its place is computed and it holds what can change."""
    try:
        match node:
            case ast.Attribute(attr=name):
                return getattr(value, name)
            case ast.Subscript(slice=ast.Constant(value=key)):
                return value[key]
    except (AttributeError, LookupError, TypeError):
        return _UNKNOWN
    return None if _is_flat(value) else _UNKNOWN


def _is_mutable(value: Any) -> bool:
    """Whether an object can be changed in place."""
    kind = type(value)
    library = (kind.__module__ or "sympy").partition(".")[0]
    if isinstance(value, PLAIN) or library in NUMBERS:
        return False
    if isinstance(value, tuple):
        return any(map(_is_mutable, value))
    if library == "numpy":
        return getattr(value, "shape", ()) != () or kind.__name__ == "Generator"
    if is_dataclass(value) and kind.__dataclass_params__.frozen:
        return any(_is_mutable(getattr(value, field.name)) for field in fields(value))
    return True


def _is_flat(value: Any) -> bool:
    """Whether nothing in an object can be changed in place."""
    if isinstance(value, dict):
        return not any(map(_is_mutable, value.values()))
    if isinstance(value, (list, set, tuple)):
        return not any(map(_is_mutable, value))
    return getattr(value, "ndim", 2) < 2


def _own(node: ast.AST) -> set[str]:
    """Names that are a function's own."""
    assert isinstance(node, FUNCTIONS)
    taken = {a.arg for a in ast.walk(node.args) if isinstance(a, ast.arg)}
    inside = [*ast.walk(node)]
    shared = {n for one in inside if isinstance(one, ast.Global) for n in one.names}
    stored = {one.id for one in inside if isinstance(one, ast.Name)
              and isinstance(one.ctx, ast.Store)}  # fmt: skip
    return taken | (stored - shared)


def root_name(target: ast.AST) -> str:
    """The name of which a place is a part: x of x[0].y; empty for what has none."""
    while isinstance(target, (*PARTS, ast.Starred)):
        target = target.value
    return target.id if isinstance(target, ast.Name) else ""
