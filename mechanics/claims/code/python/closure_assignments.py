"""Where the numbers that a function holds are assigned: its file, its class, the function around.

x = ...  is "x"        self.x = ...  is ".x"        of a file, what is assigned last

What is assigned twice elsewhere is not plain.
"""

import ast
import inspect
import types
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import Any

from mechanics.claims.code.python.closure_numbers import called_by, content, owner_of
from mechanics.claims.code.python.containers import is_number
from mechanics.claims.code.python.objects import attributes

Stores = Iterable[tuple[str, ast.expr | None]]


@dataclass(frozen=True)
class Scope:
    """Where names are assigned.

    Attributes
    ----------
    assigned : dict of str to ast.expr
        What is assigned once; attributes of the object begin with a dot.
    values : mapping of str to object
        What they are now; nan for an argument of the function around, which nothing keeps.
    around : Scope, optional
        Where other names are looked up.
    """

    assigned: dict[str, ast.expr]
    values: Mapping[str, Any]
    around: "Scope | None" = None


def scopes(function: Callable[..., Any]) -> Iterator[Scope]:
    """Where the numbers that a function holds are assigned."""
    inner, bound = owner_of(function)
    if inner is None:
        return
    # What wraps a function has a file of its own.
    origin = inspect.unwrap(inner)
    inner = origin if isinstance(origin, types.FunctionType) else inner
    tree = _tree(inner)
    names = {
        n for f in called_by(inner, bound) for n in (*f.__code__.co_names, *f.__code__.co_freevars)
    }
    whole = inner.__globals__
    file = Scope(_last(_stores(tree.body)), whole) if tree else Scope({}, whole)
    used = {name: node for name, node in file.assigned.items() if name in names}
    yield Scope(used, whole, file)
    if tree is not None:
        yield from _around(inner, tree, file)
    if bound is not None:
        yield from _object(bound, file)


def around(function: Callable[..., Any]) -> Iterator[ast.FunctionDef]:
    """The function around one, as it is written."""
    inner, _ = owner_of(function)
    origin = inspect.unwrap(inner) if inner is not None else None
    tree = _tree(origin) if isinstance(origin, types.FunctionType) else None
    outer, found, _ = getattr(origin, "__qualname__", "").rpartition(".<locals>.")
    node = (
        _defined(tree.body, outer.replace(".<locals>", "").split(".")) if tree and found else None
    )
    if isinstance(node, ast.FunctionDef):
        yield node


def file_of(function: Callable[..., Any]) -> Iterator[ast.Module]:
    """The lines of a function's file that are run before it is called."""
    inner, _ = owner_of(function)
    origin = inspect.unwrap(inner) if inner is not None else None
    tree = _tree(origin) if isinstance(origin, types.FunctionType) else None
    if tree is not None:
        inside = (ast.FunctionDef, ast.ClassDef, ast.AsyncFunctionDef)
        lines = [one for one in tree.body if not isinstance(one, inside)]
        yield ast.Module(lines, [])


def kinds_of(function: Callable[..., Any]) -> Iterator[ast.ClassDef]:
    """Classes of the object whose method a function is, as they are written."""
    _, bound = owner_of(function)
    if bound is not None:
        yield from _kinds(bound)


def _kinds(bound: Any) -> Iterator[ast.ClassDef]:
    """Classes of an object, those that others are derived from first."""
    for base in reversed(type(bound).__mro__):
        # A method knows its file, even where the class is of a file that is no module.
        methods = [part for part in vars(base).values() if isinstance(part, types.FunctionType)]
        tree = _tree(methods[0]) if methods else None
        kind = _defined(tree.body, base.__qualname__.split(".")) if tree else None
        if isinstance(kind, ast.ClassDef):
            yield kind


def _around(function: types.FunctionType, tree: ast.Module, file: Scope) -> Iterator[Scope]:
    """The functions around one that keeps their numbers."""
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=True)
    values = {name: content(cell) for name, cell in cells if is_number(content(cell))}
    outer, _, _ = function.__qualname__.rpartition(".<locals>.")
    node = _defined(tree.body, outer.replace(".<locals>", "").split("."))
    if values and isinstance(node, ast.FunctionDef):
        stores = list(_stores(node.body))
        passed = {a.arg for a in (*node.args.args, *node.args.kwonlyargs)}
        unknown = passed - values.keys() - {name for name, _ in stores}
        yield Scope(_once(stores), {**values, **dict.fromkeys(unknown, nan)}, file)


def _object(bound: Any, file: Scope) -> Iterator[Scope]:
    """An object, and what its class assigns."""
    assigned: list[tuple[str, ast.expr | None]] = []
    local: list[tuple[str, ast.expr | None]] = []
    parts: dict[str, Any] = {}
    for base in reversed(type(bound).__mro__):
        parts |= vars(base)
    for kind in _kinds(bound):
        assigned += [(f".{name}", node) for name, node in _stores(kind.body)]
        for method in kind.body:
            if isinstance(method, ast.FunctionDef):
                own = method.name in ("__init__", "__post_init__") or _only_sets(method)
                stores = list(_stores(method.body))
                assigned += [(n, v if own else None) for n, v in stores if n.startswith(".")]
                local += [(n, v) for n, v in stores if own and not n.startswith(".")]
    parts |= attributes(bound)
    values = {f".{name}": value for name, value in parts.items()}
    once = _once(assigned)
    # self.m = m says that m in __init__ is what self.m is.
    same = {v.id: _attribute(n) for n, v in once.items() if isinstance(v, ast.Name)}
    names = {**_once(local), **same}
    yield Scope(once, values, Scope(names, values, file))


def _only_sets(method: ast.FunctionDef) -> bool:
    """Whether a method without arguments only assigns, once each and without calls."""
    plain = all(isinstance(s, ast.Assign | ast.AnnAssign | ast.Expr) for s in method.body)
    calls = any(isinstance(node, ast.Call) for node in ast.walk(method))
    return plain and not calls and len(method.args.args) == 1 and not method.decorator_list


def _attribute(key: str) -> ast.expr:
    return ast.Attribute(ast.Name("self"), key.lstrip("."))


def _last(stores: Stores) -> dict[str, ast.expr]:
    """What is assigned plainly, each time; a file is run from its top."""
    found: dict[str, list[ast.expr | None]] = {}
    for name, node in stores:
        found.setdefault(name, []).append(node)
    return {n: v[-1] for n, v in found.items() if v[-1] is not None and None not in v}


def _once(stores: Stores) -> dict[str, ast.expr]:
    """What is assigned once, and plainly."""
    found: dict[str, list[ast.expr | None]] = {}
    for name, node in stores:
        found.setdefault(name, []).append(node)
    return {n: v[0] for n, v in found.items() if len(v) == 1 and v[0] is not None}


def _stores(body: Sequence[ast.stmt]) -> Iterator[tuple[str, ast.expr | None]]:
    """Every assignment to a name or to an attribute of self; None for what is not plain."""
    for statement in body:
        match statement:
            case ast.FunctionDef() | ast.ClassDef() | ast.AsyncFunctionDef():
                yield statement.name, None
                continue
            case ast.Assign(targets=targets, value=value):
                pairs = [pair for target in targets for pair in paired(target, value)]
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                pairs = list(paired(target, value))
            case _:
                pairs = []
        plain = {id(target): value for target, value in pairs}
        for node in ast.walk(statement):
            if isinstance(getattr(node, "ctx", None), ast.Store):
                if isinstance(node, ast.Name):
                    yield node.id, plain.get(id(node))
                elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                    mine = plain.get(id(node)) if node.value.id == "self" else None
                    yield f".{node.attr}", mine
            elif isinstance(node, ast.alias):
                yield node.asname or node.name, None


def paired(target: ast.expr, value: ast.expr) -> Iterator[tuple[ast.expr, ast.expr]]:
    """``a, b = 1, 2`` is two assignments."""
    many = (ast.Tuple, ast.List)
    if isinstance(target, many) and isinstance(value, many):
        if len(target.elts) == len(value.elts):
            yield from zip(target.elts, value.elts, strict=True)
    else:
        yield target, value


def _defined(body: Sequence[ast.stmt], names: Sequence[str]) -> ast.stmt | None:
    """What is defined under a dotted name."""
    kinds = (ast.FunctionDef, ast.ClassDef)
    found = [s for s in body if isinstance(s, kinds) and s.name == names[0]]
    if len(found) != 1:
        return None
    return found[0] if len(names) == 1 else _defined(found[0].body, names[1:])


def _tree(thing: Any) -> ast.Module | None:
    """The file of a function or class; None where it is not at hand."""
    try:
        return ast.parse("".join(inspect.findsource(thing)[0]))
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return None
