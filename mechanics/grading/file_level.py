"""What a file of Python computes when it is run, before its function is called.

K = os.environ.get("K")        if "pytest" in sys.modules: def f(...)        math.sin = g

Such names are something else elsewhere, and such functions are no longer what their names say.
"""

import ast
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from types import CodeType, FunctionType
from typing import Any

from mechanics.claims.code.tracing_modules import OUTSIDE, outside
from mechanics.errors import InputError

ELSEWHERE = {*OUTSIDE, "__name__", "__file__", "__builtins__", "globals", "locals", "setattr"}
"""Names whose values are others elsewhere, or that give values to other names."""
LIBRARIES = ("builtins", "math", "cmath", "operator", "functools", "numpy", "scipy", "mechanics")


@contextmanager
def libraries_unchanged() -> Iterator[None]:
    """Put back what is changed in modules of libraries.

    Raises
    ------
    InputError
        When something was.
    """
    modules = [m for n, m in sys.modules.items() if n.partition(".")[0] in LIBRARIES]
    before = [dict(vars(module)) for module in modules]
    yield
    changed = []
    for module, values in zip(modules, before, strict=True):
        for name, value in values.items():
            if name != "__warningregistry__" and vars(module).get(name, before) is not value:
                changed.append(f"{module.__name__}.{name}")
                setattr(module, name, value)
    if changed:
        raise InputError(f"it changes {changed[0]}, which is not its own: leave that out")


def used_by(names: dict[str, Any], chosen: str) -> set[str]:
    """Names of a file that one of its functions uses, and what it calls."""
    classes = [thing for thing in names.values() if isinstance(thing, type)]
    found, todo = {chosen}, [names[chosen]] if chosen in names else classes
    while todo:
        thing = todo.pop()
        parts = vars(type(thing)).values() if not isinstance(thing, FunctionType) else (thing,)
        for part in (*parts, *(vars(thing).values() if isinstance(thing, type) else ())):
            new = _names(part.__code__) - found if isinstance(part, FunctionType) else set()
            found |= new
            todo += [names[name] for name in new if name in names]
    return found


def _names(code: CodeType) -> set[str]:
    inner = [_names(part) for part in code.co_consts if isinstance(part, CodeType)]
    return {*code.co_names}.union(*inner)


def different_elsewhere(code: str) -> set[str]:
    """Names of a file whose values depend on where, when or by whom it is run."""
    found = set(ELSEWHERE)
    for _ in range(2):  # a function may stand behind its use
        _learn(ast.parse(code).body, found, depends=False)
    return found - ELSEWHERE


def _learn(body: Sequence[ast.AST], found: set[str], depends: bool) -> None:
    for one in body:
        match one:
            case ast.Import(names=parts):
                found |= {p.asname or p.name.partition(".")[0] for p in parts if outside(p.name)}
            case ast.ImportFrom(module=module, names=parts):
                found |= {p.asname or p.name for p in parts if outside(module or "")}
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name) if depends:
                found.add(name)
            case ast.FunctionDef(name=name) if _depends(one, found):
                found.add(name)
            case ast.If(test=test, body=inner, orelse=others):
                program = ast.unparse(test) == "__name__ == '__main__'"
                if not program:
                    _learn(inner, found, depends or _depends(test, found))
                _learn(others, found, depends or program or _depends(test, found))
            case ast.Assign() | ast.AugAssign() | ast.AnnAssign() | ast.NamedExpr():
                if depends or (one.value is not None and _depends(one.value, found)):
                    targets = one.targets if isinstance(one, ast.Assign) else [one.target]
                    found |= {_root(target) for target in targets}
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=owner)) as call):
                if any(_depends(part, found) for part in (*call.args, *call.keywords)):
                    found.add(_root(owner))
            case ast.For() | ast.While() | ast.With() | ast.Try():
                inside = list(ast.iter_child_nodes(one))
                there = depends or any(
                    _depends(part, found) for part in inside if isinstance(part, ast.expr)
                )
                if there and isinstance(one, ast.For):
                    found.add(_root(one.target))
                _learn(inside, found, there)
            case ast.ExceptHandler(body=inner):
                _learn(inner, found, depends)


def _depends(part: ast.AST, found: set[str]) -> bool:
    """Whether a part of a file has one of some names, or random numbers."""
    for one in ast.walk(part):
        if isinstance(one, ast.Name) and one.id in found:
            return True
        if isinstance(one, ast.Attribute) and one.attr == "random":
            return True
    return False


def _root(target: ast.AST) -> str:
    """The name that is given a value, as a whole or in a part."""
    names = (one.id for one in ast.walk(target) if isinstance(one, ast.Name))
    return next(names, "")
