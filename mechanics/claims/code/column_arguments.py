"""Arguments that a function takes as columns of NumPy: x[:2, :], x[1, 0].

def f(x, u): q = x[:2, :]; ... B @ u    ->    f is called with arrays of shapes (4, 1) and (1, 1)
"""

import ast
import inspect
import textwrap
from collections.abc import Callable
from typing import Any

import numpy as np


def with_column_arguments(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function that makes columns of such arguments; the function itself where there are none.

    Parameters
    ----------
    function : callable
    """
    columns = _columns(function)
    if not columns:
        return function

    def call(**arguments: Any) -> Any:
        shaped = {
            name: value.reshape(-1, 1)
            if name in columns and isinstance(value, np.ndarray)
            else value
            for name, value in arguments.items()
        }
        return function(**shaped)

    call.__name__ = getattr(function, "__name__", "function")
    call.__wrapped__ = function  # type: ignore[attr-defined]
    call.__signature__ = inspect.signature(function)  # type: ignore[attr-defined]
    return call


def _columns(function: Callable[..., Any]) -> frozenset[str]:
    """Arguments with an entry by row and column, and those beside them that `@` takes.

    No argument at all where a column beside the first one is named, or a row alone.
    """
    try:
        tree = ast.parse(textwrap.dedent("".join(inspect.getsourcelines(function)[0])))
        parameters = {*inspect.signature(function).parameters}
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return frozenset()
    taken: dict[str, list[bool]] = {}
    beside: set[str] = set()
    for node in ast.walk(tree):
        match node:
            case ast.Subscript(value=ast.Name(id=name), slice=place) if name in parameters:
                taken.setdefault(name, []).append(_of_column(place))
            case ast.BinOp(left=left, op=ast.MatMult(), right=right):
                beside |= {side.id for side in (left, right) if isinstance(side, ast.Name)}
            case ast.Name(id=name, ctx=ast.Store()):
                parameters.discard(name)  # it may be of another shape from there on
    columns = taken.keys() & parameters
    if not columns or not all(all(places) for places in taken.values()):
        return frozenset()
    return frozenset(columns | (beside & parameters))


def _of_column(place: ast.expr) -> bool:
    """Whether it is a place in an array of one column: by row, and all columns or the first."""
    match place:
        case ast.Tuple(elts=[row, ast.Constant(value=0) | ast.Slice(None, None, None)]):
            number = isinstance(row, ast.Constant) and type(row.value) is int
            return number or isinstance(row, ast.Slice | ast.UnaryOp)
    return False
