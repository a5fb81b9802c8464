"""Numbers that an object, or the function around, makes of what is passed by the same name.

    def __init__(self, l): self.l = l/2        l of the object is half of what is passed as l
    l = 0.5; l *= 2                            so does l of a file
    self.R = diameter                          nothing says that it is the radius
    self.m, self.l = mass, float(l)            these are what is passed

Their values say nothing of a formula, but where a name is two numbers, it is open which one the
scene's is.
"""

import ast
from collections.abc import Callable, Iterator
from typing import Any

from sympy import Expr

from mechanics.claims.code.python.closure_assignments import around, file_of, kinds_of, paired
from mechanics.claims.names import key

MAKES = ("__new__", "__init__", "__post_init__")


def changed(function: Callable[..., Any], name: str, symbol: Expr) -> str:
    """What a number that a function holds is made of, where that is not what it is called.

    Parameters
    ----------
    function : callable
    name : str
        Of the number in the code.
    symbol : Expr
        What it is taken for.
    """
    meaning = {*str(getattr(symbol, "meaning", "")).lower().split()}
    owners = [(node, True) for kind in kinds_of(function) for node in _constructors(kind)]
    for node, owned in (*owners, *((node, False) for node in around(function))):
        for target, value in _assigned(node):
            own = isinstance(target, ast.Attribute) if owned else isinstance(target, ast.Name)
            if own and _word(target) == name and _differs(name, value, meaning):
                return ast.unparse(value)
    for target, value in (pair for lines in file_of(function) for pair in _assigned(lines)):
        computed = (n for n in ast.walk(value) if isinstance(n, ast.BinOp | ast.UnaryOp))
        parts = (part for one in computed for part in ast.walk(one) if isinstance(part, ast.Name))
        if _word(target) == name and any(part.id == name for part in parts):
            return ast.unparse(value)
    return ""


def _constructors(kind: ast.ClassDef) -> list[ast.FunctionDef]:
    """Methods that run when an object is made: those of Python's names, and what these call."""
    methods = {node.name: node for node in kind.body if isinstance(node, ast.FunctionDef)}
    found: dict[str, ast.FunctionDef] = {}
    todo = [*MAKES]
    while todo:
        name = todo.pop()
        if name in methods and name not in found:
            found[name] = methods[name]
            calls = (n.func for n in ast.walk(methods[name]) if isinstance(n, ast.Call))
            todo += [call.attr for call in calls if isinstance(call, ast.Attribute)]
    return list(found.values())


def _assigned(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """What is assigned to names and attributes, those of frozen objects too."""
    for one in ast.walk(node):
        match one:
            case ast.Assign(targets=targets, value=value):
                for target in targets:
                    yield from paired(target, value)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield target, value
            case ast.AugAssign(target=target, op=op, value=value):
                yield target, ast.BinOp(target, op, value)
            case ast.Call(
                func=ast.Attribute(attr="__setattr__") | ast.Name(id="setattr"),
                args=[ast.expr() as owner, ast.Constant(value=str() as name), value],
            ):
                yield ast.Attribute(owner, name), value


def _differs(name: str, value: ast.expr, meaning: set[str]) -> bool:
    """Whether a value is computed from one of the same name, or is one of another name."""
    if isinstance(value, ast.Name):
        return not _same(name, value.id, meaning)
    computed = (n for n in ast.walk(value) if isinstance(n, ast.BinOp | ast.UnaryOp))
    words = (_word(part) for one in computed for part in ast.walk(one))
    return any(word and key(word) == key(name) for word in words)


def _same(name: str, passed: str, meaning: set[str]) -> bool:
    """Whether an argument is called as a number, begins with its letters, or says what it is."""
    short, long = (one.strip("_").lower().replace("_", "") for one in (name, passed))
    letters = iter(long)
    spelled = long[:1] == short[:1] and all(letter in letters for letter in short)
    spelled = spelled or short.startswith(long)
    return spelled or {*passed.lower().strip("_").split("_")} <= meaning


def _word(node: ast.AST) -> str:
    """The name of a variable, of an attribute, or of an entry."""
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
        case ast.Subscript(slice=ast.Constant(value=str() as name)):
            return name
    return ""
