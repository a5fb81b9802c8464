"""Numbers that a Python function gives to names of the scene's parameters inside of it.

    def f(x):                          def make(l):
        L = 0.5                            def f(x):
        l = L / 2                              L = 0.5
        return -g / l * sin(x)                 return -g / l * sin(x)

They stand for the parameters, as numbers of the file and of what is around the function do.
"""

import ast
import inspect
import linecache
import types
from collections.abc import Callable, Container
from typing import Any

from mechanics.claims.code.python.closure_assignments import paired
from mechanics.claims.code.python.closure_numbers import content, owner_of
from mechanics.claims.code.python.containers import is_number

NUMERIC = (ast.BinOp, ast.UnaryOp, ast.Constant, ast.Name, ast.operator, ast.unaryop, ast.Load)
"""What a number is made of."""
OF_NUMBERS = {"float": float, "abs": abs}
"""Functions of Python that make one of it."""


def with_local_numbers(
    function: Callable[..., Any], constants: Container[str]
) -> Callable[..., Any]:
    """The function with such numbers around it; itself where there are none, or no text.

    Parameters
    ----------
    function : callable
    constants : container of str
        Names of parameters.
    """
    inner, bound = owner_of(function)
    node = None if inner is None else _definition(inner)
    if inner is None or node is None:
        return function
    node.body = [part for one in node.body for part in _apart(one)]
    values = _numbers(node, inner)
    own = {name: value for name, value in values.items() if name in constants}
    if not own:
        return function
    node.decorator_list = []
    node.body = [one for one in node.body if _name(one) not in own] or [ast.Pass()]
    cells = zip(inner.__code__.co_freevars, inner.__closure__ or (), strict=True)
    around = {name: content(cell) for name, cell in cells} | own
    maker = ast.parse(f"def make({', '.join(around)}):\n  return {node.name}").body[0]
    assert isinstance(maker, ast.FunctionDef)
    maker.body.insert(0, node)
    space: dict[str, Any] = {}
    page = ast.fix_missing_locations(ast.Module([maker], []))
    try:
        exec(compile(page, inner.__code__.co_filename, "exec"), inner.__globals__, space)
    except SyntaxError:  # super() of a class, a name of its cell
        return function
    made = space["make"](**around)
    made.__defaults__, made.__kwdefaults__ = inner.__defaults__, inner.__kwdefaults__
    made.__module__, made.__qualname__ = inner.__module__, inner.__qualname__
    made.__doc__ = inner.__doc__
    return made if bound is None else types.MethodType(made, bound)


def _definition(function: types.FunctionType) -> ast.FunctionDef | None:
    """The part of its file that defines a function, with the lines that it has there."""
    code = function.__code__
    try:
        text = "".join(linecache.getlines(code.co_filename)) or inspect.getsource(function)
        whole = ast.parse(text)
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return None
    for node in ast.walk(whole):
        first = [*getattr(node, "decorator_list", []), node]
        if (
            isinstance(node, ast.FunctionDef) and node.name == code.co_name
            and first[0].lineno == code.co_firstlineno
        ):  # fmt: skip
            return node
    return None


def _apart(node: ast.stmt) -> list[ast.stmt]:
    """A line that gives several names numbers as one line for each: m, l = 1.0, 0.5; m = l = 1.0.

    Values that have one of these names stay together: l, m = m, l.
    """
    pairs: list[tuple[ast.expr, ast.expr]] = []
    match node:
        case ast.Assign(targets=targets, value=value):
            pairs = [pair for target in targets for pair in paired(target, value)]
        case ast.AnnAssign(target=ast.Name() as target, value=ast.expr() as value):
            pairs = [(target, value)]
    names = [target.id for target, _ in pairs if isinstance(target, ast.Name)]
    used = {n.id for _, value in pairs for n in ast.walk(value) if isinstance(n, ast.Name)}
    plain = all(_is_numeric(value) for _, value in pairs)
    if not pairs or len(names) < len(pairs) or used & {*names} or not plain:
        return [node]
    return [ast.copy_location(ast.Assign([target], value), node) for target, value in pairs]


def _is_numeric(node: ast.expr) -> bool:
    """Whether it is made of numbers, names and operations: no text, list or call of others."""
    return all(
        isinstance(one, NUMERIC)
        or (isinstance(one, ast.Call) and getattr(one.func, "id", "") in OF_NUMBERS)
        for one in ast.walk(node)
    )


def _name(node: ast.stmt) -> str:
    """The name that a line assigns; empty for other lines."""
    if isinstance(node, ast.Assign) and len(node.targets) == 1:
        target = node.targets[0]
        return target.id if isinstance(target, ast.Name) else ""
    return ""


def _numbers(node: ast.FunctionDef, function: types.FunctionType) -> dict[str, float]:
    """Names that are assigned once, to what is made of numbers alone, and these numbers."""
    stored = [
        one.id for one in ast.walk(node)
        if isinstance(one, ast.Name) and not isinstance(one.ctx, ast.Load)
    ] + [one.arg for one in ast.walk(node) if isinstance(one, ast.arg)]  # fmt: skip
    table = dict(function.__globals__)
    found: dict[str, float] = {}
    for line in node.body:
        name = _name(line)
        if not name or stored.count(name) > 1 or not isinstance(line, ast.Assign):
            continue
        value = _number(line.value, {n: v for n, v in table.items() if n not in stored} | found)
        if value is not None:
            found[name] = value
    return found


def _number(node: ast.expr, numbers: dict[str, Any]) -> float | None:
    """The value of what is made of numbers and their operations; None for all else."""
    if not _is_numeric(node):
        return None
    calls = {one.func.id for one in ast.walk(node)
             if isinstance(one, ast.Call) and isinstance(one.func, ast.Name)}  # fmt: skip
    names = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)} - calls
    if calls & numbers.keys() or not all(is_number(numbers.get(name)) for name in names):
        return None
    code = compile(ast.Expression(node), "number", "eval")
    try:
        value = eval(code, {"__builtins__": OF_NUMBERS, **{name: numbers[name] for name in names}})
    except (ArithmeticError, TypeError, ValueError):
        return None
    return value if is_number(value) else None
