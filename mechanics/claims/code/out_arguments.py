"""Arguments that a function only writes: what it computes, as if it were returned.

def f(t, y, dydt): dydt[0] = y[1]; ...    ->    f(t, y) returns dydt
"""

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterable
from operator import is_
from typing import Any

import numpy as np

from mechanics.errors import InputError


def returning(
    function: Callable[..., Any], size: int, explained: Iterable[str]
) -> Callable[..., Any]:
    """A function that returns what the other one writes; the function itself where that is nothing.

    Parameters
    ----------
    function : callable
    size : int
        Entries of an array that is written by more than numbers in brackets.
    explained : iterable of str
        Arguments that a person says what they are.

    Raises
    ------
    InputError
        When what is returned is called, and the other one returns something besides.
    """
    sizes = {n: k or size for n, k in _written(function).items() if n not in explained}
    if not sizes:
        return function
    signature = inspect.signature(function)
    if any(signature.parameters[n].default is not inspect.Parameter.empty for n in sizes):
        return function

    def call(**arguments: Any) -> Any:
        arrays = {name: np.zeros(k) for name, k in sizes.items()}
        result = function(**arguments, **arrays)
        found: Any = tuple(arrays.values()) if len(arrays) > 1 else next(iter(arrays.values()))
        if result is None or is_(result, found) or _is_status(result):
            return found
        raise InputError(
            f"it fills {', '.join(arrays)} and returns something else, too: which of them is to be"
            " judged is not plain: return all of it, or have a function for each"
        )

    others = [p for n, p in signature.parameters.items() if n not in sizes]
    call.__name__ = getattr(function, "__name__", "function")
    call.__wrapped__ = function  # type: ignore[attr-defined]
    call.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]
    return call


def _is_status(result: Any) -> bool:
    """Whether a result is 0, which solvers take as success: no computed number is an integer."""
    return type(result) in (int, bool) and result == 0


def _written(function: Callable[..., Any]) -> dict[str, int]:
    """Arguments that are only written, entry by entry: how many entries, 0 where that is open."""
    try:
        tree = ast.parse(textwrap.dedent("".join(inspect.getsourcelines(function)[0])))
        parameters = list(inspect.signature(function).parameters)
    except (OSError, TypeError, SyntaxError, ValueError, RecursionError):
        return {}
    used = {name: 0 for name in parameters}
    stored: dict[str, list[int]] = {}
    for node in ast.walk(tree):
        match node:
            case ast.Subscript(value=ast.Name(id=name), ctx=ast.Store(), slice=place):
                known = place.value if isinstance(place, ast.Constant) else None
                stored.setdefault(name, []).append(known + 1 if isinstance(known, int) else 0)
                used[name] = used.get(name, 0) - 1
            case ast.Return(value=ast.Name(id=name)):
                used[name] = used.get(name, 0) - 1
            case ast.AugAssign(target=ast.Subscript(value=ast.Name(id=name))):
                used[name] = used.get(name, 0) + 1  # it is read, too
        if isinstance(node, ast.Name):
            used[node.id] = used.get(node.id, 0) + 1
    return {
        name: max(places) if min(places) > 0 else 0
        for name, places in stored.items()
        if name in parameters and used[name] == 0
    }
