"""Names of a file of Python whose values are the same whoever runs it.

K = 2; l = np.sqrt(2)/K; P = Params(K)        are        K = 1 if "pytest" in sys.modules else 2
try: from numba import njit                   is         if __name__ == "__main__": K = 2   is not
except ImportError: def njit(f): return f

A whitelist: a name is the same everywhere where all that binds it stands in every run of the file,
and is a formula of numbers, of modules that are known here, and of other such names.
"""

import ast
import builtins
import inspect
import sys
import types
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mechanics.claims.code.python.changed_numbers import MAKES
from mechanics.claims.code.python.closure_numbers import called_by, content, named, owner_of
from mechanics.claims.code.python.escape_analysis import escape, root_name, same_objects
from mechanics.errors import InputError

KNOWN = {
    "__future__", "abc", "autograd", "casadi", "cmath", "collections", "copy", "dataclasses",
    "decimal", "enum", "fractions", "functools", "itertools", "jax", "math", "mpmath", "numba",
    "numbers", "numpy", "operator", "scipy", "sympy", "types", "typing", "typing_extensions",
}  # fmt: skip
"""Modules that have the same values everywhere."""
ASKING = {"__file__", "__name__", "__builtins__", "__import__", "compile", "delattr", "dir", "eval",
          "exec", "getattr", "globals", "hasattr", "hash", "id", "input", "locals", "open",
          "setattr", "vars"}  # fmt: skip
"""Names of Python's own that tell who runs a file, or that read what is elsewhere."""
BUILTINS = {*vars(builtins)} - ASKING - {"get_ipython", "display", "copyright", "_", "__spec__"}
READING = {"load", "loadtxt", "genfromtxt", "fromfile", "memmap", "read_csv"}
"""Functions of known modules whose values are elsewhere."""
REACHED = {"argv", "builtins", "environ", "importlib", "inspect", "io", "modules", "os", "platform",
           "random", "subprocess", "sys"}  # fmt: skip
"""Modules that those of others hold, and what tells who runs them."""
SEEN = {"logging", "random", "time", "warnings"}
"""Modules of Python's own whose use is seen when a method is followed."""
HIDDEN = {"globals", "exec", "setattr", "delattr", "__builtins__", "__dict__"}
"""What binds names without saying them."""


@dataclass(frozen=True)
class _Bound:
    """What gives a name a value.

    Attributes
    ----------
    node : ast.AST
        An import, a definition, or the expression; None where it is not plain.
    sure : bool
        Whether it stands in every run.
    line : int
    """

    node: ast.AST | None
    sure: bool
    line: int
    other: str = ""
    by: str = ""


def refuse_unsettled(function: Callable[..., Any], standing: Container[str] = ()) -> None:
    """Refuse a function that uses a name of its file with other values elsewhere.

    Parameters
    ----------
    function : callable
    standing : container of str
        Names for which parameters stand, whatever their values are.

    Raises
    ------
    InputError
    """
    inner, bound = owner_of(function)
    origin = inspect.unwrap(inner) if inner is not None else None
    if not isinstance(origin, types.FunctionType):
        return
    called = called_by(origin, bound)
    for owner in {id(f.__globals__): f for f in called}.values():
        try:
            tree = ast.parse("".join(inspect.findsource(owner)[0]))
        except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
            continue
        own = [f for f in called if f.__globals__ is owner.__globals__]
        names = {name for f in own for name in globals_of(f.__code__)}
        # A function inside of another one holds what that one computes.
        roots = {f.__qualname__.partition(".")[0]: f for f in own}
        names |= {n for n, f in roots.items() if "<locals>" not in f.__qualname__}
        around = {n for n, f in roots.items() if "<locals>" in f.__qualname__ and _holds(f)}
        if why := unsettled(tree, names, owner.__globals__, {*roots}, around, standing):
            raise InputError(f"function {origin.__name__}: {why}")


def _holds(function: types.FunctionType) -> bool:
    """Whether a function holds more than functions of what is around it."""
    held = map(content, function.__closure__ or ())
    return any(not isinstance(one, types.FunctionType | type) for one in held)


def globals_of(code: types.CodeType) -> set[str]:
    """Names of the file that code has, and functions that are defined in it; no attributes."""
    inner = [globals_of(part) for part in code.co_consts if isinstance(part, types.CodeType)]
    return {*named(code)}.union(*inner)


def unsettled(
    tree: ast.Module, names: Iterable[str], values: Mapping[str, Any],
    called: Container[str] = (), around: Iterable[str] = (), standing: Container[str] = (),
) -> str:  # fmt: skip
    """Which of some names that a function uses is another one elsewhere, in a sentence.

    Parameters
    ----------
    tree : ast.Module
        The file.
    names : iterable of str
        What functions that are followed later use, and these.
    values : mapping of str to object
        What names of the file are.
    called : container of str
        These functions, and their classes: what they change is seen when they are followed.
    around : iterable of str
        Functions in which these are defined, and whose numbers they hold.
    standing : container of str
        Names for which parameters stand.
    """
    file = _File(tree, called)
    file.done |= {(n, strict): "" for n in file.bound if n in standing for strict in (True, False)}
    names = {name for name in names if name not in standing}
    objects = {other: name for name in names for other in same_objects(name, values)}
    every = (*map(file.used, sorted(names | objects.keys())), *map(file.around, around))
    if why := next((why for why in every if why), ""):
        return why
    places = (escape(tree, name, values, called) for name in sorted(objects))
    place = next(filter(None, places), None)
    return (
        f"{objects[place.name]} may be changed in line {place.line}, where {place.name} is passed"
        " on: write what it is" if place else ""
    )  # fmt: skip


class _File:
    def __init__(self, tree: ast.Module, called: Container[str]) -> None:
        self.bound: dict[str, list[_Bound]] = {}
        self.done: dict[tuple[str, bool], str] = {}
        self.others: list[ast.ImportFrom] = []
        self.starred: set[str] = set()
        for name, found in _bindings(tree.body, sure=True):
            if found.by and found.by in called:
                continue
            self.bound.setdefault(name, []).append(found)
        for one in self.bound.pop("*", ()):
            if isinstance(one.node, ast.ImportFrom) and _is_known(one.node) and one.sure:
                module = sys.modules.get(one.node.module or "")
                self.starred |= {n for n in vars(module) if n[0] != "_"} if module else set()
            elif isinstance(one.node, ast.ImportFrom):
                self.others.append(one.node)

    def used(self, name: str) -> str:
        """What is wrong with a name that a function uses which is followed later."""
        if name not in self.bound:
            return next((why for node in self.others if (why := _elsewhere(node, name))), "")
        for one in self.bound[name]:
            if not one.sure and not self._alike(name):
                return _conditional(name, one)
            match one.node:
                case ast.ImportFrom() if why := _elsewhere(one.node, one.other):
                    return why
                case ast.Import() | ast.ImportFrom():
                    continue  # what it means is seen where it is used
                case ast.FunctionDef():
                    if word := self._values(_outside(one.node), {name}):
                        return _depends(name, one, word)
                case ast.ClassDef():
                    if word := self._class(one.node, name):
                        return _depends(name, one, word)
                case _:
                    if word := self._value(one.node, {name}):
                        return _depends(name, one, word)
        return ""

    def around(self, name: str) -> str:
        """What is wrong with a function whose numbers another one inside of it holds."""
        for one in self.bound.get(name, ()):
            if isinstance(one.node, ast.FunctionDef):
                bare = ast.FunctionDef(name, one.node.args, one.node.body, [])
                if word := self._free(bare, {name}, strict=False):
                    return _depends(name, one, word)
        return ""

    def _alike(self, name: str) -> bool:
        """Whether a name is one thing of known modules, or leaves a function as it is."""
        taken = set()
        for one in self.bound[name]:
            match one.node:
                case ast.Import() | ast.ImportFrom() if _is_known(one.node):
                    taken |= {one.other} - {""}
                case ast.FunctionDef() if _is_identity(one.node):
                    pass
                case _:
                    return False
        return len(taken) <= 1 and all(one.sure or one.other != "?" for one in self.bound[name])

    def _class(self, node: ast.ClassDef, name: str) -> str:
        for part in node.body:
            match part:
                case ast.FunctionDef() if part.name in MAKES:
                    if word := self._free(part, {name}, strict=False):
                        return word
                case ast.FunctionDef() | ast.Pass() | ast.AsyncFunctionDef():
                    if isinstance(part, ast.FunctionDef) and (
                        word := self._values(part.decorator_list, {name}, strict=False)
                    ):
                        return word
                case ast.Assign() | ast.AnnAssign():
                    inside = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)
                              and isinstance(n.ctx, ast.Store)}  # fmt: skip
                    if part.value is not None and (
                        word := self._value(part.value, {name, *inside}, strict=False)
                    ):
                        return word
                case ast.If() | ast.Try() | ast.While() | ast.With() | ast.Match():
                    return "a condition"
        return ""

    def _values(self, nodes: Iterable[ast.AST], near: set[str], strict: bool = True) -> str:
        return next((word for n in nodes if (word := self._value(n, near, strict))), "")

    def _value(self, node: ast.AST | None, near: set[str], strict: bool = True) -> str:
        """The first word of an expression that is run with the file and is no such name."""
        if node is None:
            return "what is not plain"
        if isinstance(node, ast.FunctionDef | ast.Lambda):
            return self._free(node, near, strict)
        made = {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and not isinstance(
            n.ctx, ast.Load)}  # fmt: skip
        made |= {n.arg for n in ast.walk(node) if isinstance(n, ast.arg)}
        for one in ast.walk(node):
            if isinstance(one, ast.Attribute):
                if _tells(one.attr) and (strict or one.attr != "random"):
                    return one.attr
                if one.attr in READING and strict:
                    return one.attr
            word = one.id if isinstance(one, ast.Name) else ""
            if word and word not in made | near and (found := self._run(word, strict)):
                return found
        return ""

    def _run(self, name: str, strict: bool) -> str:
        """What is wrong with a name that is used while the file is run."""
        if name not in self.bound:
            return "" if name in BUILTINS or name in self.starred else name
        if (name, strict) in self.done:
            return self.done[name, strict]
        self.done[name, strict] = ""
        self.done[name, strict] = found = self._bound(name, strict)
        return found

    def _bound(self, name: str, strict: bool) -> str:
        for one in self.bound[name]:
            if not one.sure and not self._alike(name):
                return name
            match one.node:
                case ast.Import() | ast.ImportFrom():
                    if not (_is_known(one.node) if strict else _is_no_asker(one.node)):
                        return name
                case ast.ClassDef():
                    # A method may be called, too.
                    parts = [p for p in one.node.body if isinstance(p, ast.FunctionDef)]
                    word = self._class(one.node, name) or self._values(parts, {name}, False)
                    if word:
                        return word
                case _:
                    if word := self._value(one.node, {name}, strict):
                        return word
        return ""

    def _free(self, node: ast.FunctionDef | ast.Lambda, near: set[str], strict: bool) -> str:
        """The first word of a function that is called while the file is run."""
        inner = [ast.Module(node.body, [])] if isinstance(node, ast.FunctionDef) else [node.body]
        own = {n.arg for n in ast.walk(node) if isinstance(n, ast.arg)}
        own |= {n.name for n in ast.walk(node) if isinstance(n, ast.FunctionDef | ast.ClassDef)}
        for part in ast.walk(node):
            match part:
                case ast.Import() | ast.ImportFrom():
                    if not (_is_known(part) if strict else _is_no_asker(part)):
                        return part.names[0].name
                    own |= {_called(alias) for alias in part.names}
        return self._values([*inner, *_outside(node)], near | own, strict)


def _elsewhere(node: ast.ImportFrom, name: str) -> str:
    """What is wrong with a name in a file of the person's own that this one takes it from."""
    root = (node.module or "").partition(".")[0]
    if root in KNOWN or root in sys.stdlib_module_names:
        return ""
    module = sys.modules.get(node.module or "")
    path = getattr(module, "__file__", None) or ""
    if not path.endswith(".py") or "site-packages" in path:
        return ""
    try:
        tree = ast.parse(Path(path).read_text(encoding="utf-8"))
        why = unsettled(tree, {name}, vars(module))
    except (OSError, SyntaxError, ValueError, RecursionError):
        return f"{name} of {node.module} is not read: write what it is"
    return f"{node.module}.py: {why}" if why else ""


def _conditional(name: str, one: _Bound) -> str:
    how = f"set by {one.by}()" if one.by else "set under a condition"
    return f"{name} depends on where the file is run: {how}, in line {one.line}: write what it is"


def _depends(name: str, one: _Bound, word: str) -> str:
    why = "" if word == name else f", by {word}"
    return f"{name} depends on where the file is run{why}, in line {one.line}: write what it is"


def _outside(node: ast.FunctionDef | ast.Lambda) -> list[ast.expr]:
    """What of a function is run when it is defined."""
    around = node.decorator_list if isinstance(node, ast.FunctionDef) else []
    return [*around, *node.args.defaults, *(d for d in node.args.kw_defaults if d)]


def _tells(name: str) -> bool:
    """Whether an attribute is a module of Python's own, or holds names."""
    return name in REACHED or name in HIDDEN


def _roots(node: ast.Import | ast.ImportFrom) -> list[str]:
    if isinstance(node, ast.Import):
        return [part.name for part in node.names]
    return [f"{'.' * node.level}{node.module or ''}.{part.name}" for part in node.names]


def _is_known(node: ast.Import | ast.ImportFrom) -> bool:
    return all(
        path.partition(".")[0] in KNOWN and not any(map(_tells, path.split(".")[1:]))
        for path in _roots(node)
    )


def _is_no_asker(node: ast.Import | ast.ImportFrom) -> bool:
    strange = {*sys.stdlib_module_names, "IPython", "psutil"} - KNOWN - SEEN
    return all(path.partition(".")[0] not in strange for path in _roots(node))


def _is_identity(node: ast.FunctionDef) -> bool:
    """Whether a function returns what it is given, or another such function."""
    strange = (ast.BinOp, ast.UnaryOp, ast.Await, ast.Yield, ast.Subscript, ast.Attribute)
    returned = [n.value for n in ast.walk(node) if isinstance(n, ast.Return)]
    return not any(isinstance(n, strange) for n in ast.walk(node)) and all(
        isinstance(value, ast.Name | ast.Lambda | ast.IfExp) for value in returned
    )


def _called(alias: ast.alias) -> str:
    return alias.asname or alias.name.partition(".")[0]


def _bindings(body: Sequence[ast.stmt], sure: bool) -> Iterator[tuple[str, _Bound]]:
    """All that gives names of a file values, or changes these."""
    for one in body:
        line = one.lineno
        match one:
            case ast.Import(names=parts):
                for alias in parts:
                    yield _called(alias), _Bound(ast.Import([alias]), sure, line)
            case ast.ImportFrom(names=parts):
                for alias in parts:
                    single = ast.ImportFrom(one.module, [alias], one.level)
                    yield _called(alias), _Bound(single, sure, line, alias.name)
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name):
                yield name, _Bound(one if isinstance(one, ast.FunctionDef) else None, sure, line)
                yield from _changed_by(one)
            case ast.ClassDef(name=name):
                yield name, _Bound(one, sure, line)
                yield from _changed_by(one)
            case ast.If() | ast.While() | ast.Try() | ast.TryStar() | ast.With() | ast.Match():
                for part in ast.iter_child_nodes(one):
                    if isinstance(part, ast.expr | ast.withitem):
                        yield from _stored(part, None, False, line)
                for block in _blocks(one):
                    yield from _bindings(block, sure=False)
            case ast.For():
                yield from _stored(one.target, one.iter, sure, line)
                yield from _bindings([*one.body, *one.orelse], sure)
            case ast.Assign(targets=targets, value=value):
                for target in targets:
                    yield from _stored(target, value, sure, line)
                yield from _stored(value, value, sure, line)
            case ast.AugAssign(target=target, value=value):
                yield from _stored(target, value, sure, line)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield from _stored(target, value, sure, line)
            case ast.Delete(targets=targets):
                for target in targets:
                    yield root_name(target), _Bound(None, sure, line)
            case ast.Expr(value=value):
                yield from _stored(value, value, sure, line)
                if isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute):
                    arguments = ast.Tuple([*value.args, *(k.value for k in value.keywords)])
                    yield root_name(value.func), _Bound(arguments, sure, line)


def _blocks(node: ast.AST) -> Iterator[list[ast.stmt]]:
    for name in ("body", "orelse", "finalbody"):
        yield getattr(node, name, [])
    for part in (*getattr(node, "handlers", ()), *getattr(node, "cases", ())):
        yield part.body


def _stored(
    target: ast.AST, value: ast.AST | None, sure: bool, line: int
) -> Iterator[tuple[str, _Bound]]:
    """Names that are given values in a part of a line."""
    for one in ast.walk(target):
        if isinstance(getattr(one, "ctx", None), ast.Store) and (root := root_name(one)):
            yield root, _Bound(value, sure, line)


def _changed_by(node: ast.AST) -> Iterator[tuple[str, _Bound]]:
    """Names of the file that a function of it changes when it is called."""
    for one in ast.walk(node):
        if isinstance(one, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            inside = [n for n in ast.walk(one)]
            shared = {n for g in inside if isinstance(g, ast.Global) for n in g.names}
            local = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)
                     and isinstance(n.ctx, ast.Store)} - shared  # fmt: skip
            local |= {n.arg for n in ast.walk(node) if isinstance(n, ast.arg)}
            for part in inside:
                if not isinstance(getattr(part, "ctx", None), ast.Store):
                    continue
                if root_name(part) not in {"", getattr(node, "name", ""), *local}:
                    yield (
                        root_name(part),
                        _Bound(
                            None, False, getattr(part, "lineno", 0), by=getattr(node, "name", "")
                        ),
                    )
