"""What is inside of things that call a function: its text is what is followed.

lru_cache(f), numba.njit(f)   ->  f          partial(f, 1.0, m=2.0)  ->  f with these, m a default
"""

import functools
import inspect
import types
from collections.abc import Callable
from typing import Any

NAMED = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)

DEEPEST = 8
"""Things in things."""


def unwrapped(value: Any) -> Any:
    """A plain function for what calls one; other things as they are."""
    for _ in range(DEEPEST):
        if isinstance(value, functools.partial):
            value = _filled(value)
        elif isinstance(value, functools._lru_cache_wrapper):  # what lru_cache makes
            value = value.__wrapped__
        elif str(type(value).__module__).startswith("numba.") and isinstance(
            inner := inspect.getattr_static(value, "py_func", None), types.FunctionType
        ):
            value = inner  # it is compiled
        else:
            return value
    return value


def filled(function: Any) -> frozenset[str]:
    """Arguments that a `partial` in what is called has a value for, which is no default."""
    found: frozenset[str] = frozenset()
    while function is not None:
        found |= getattr(function, "filled", frozenset())
        function = getattr(function, "__wrapped__", None)
    return found


def _filled(value: functools.partial[Any]) -> Callable[..., Any]:
    """A function whose defaults are those of a `partial`, by their names where they have some."""
    function, given, named = value.func, value.args, value.keywords
    try:
        parameters = [p for p in inspect.signature(function).parameters.values() if p.kind in NAMED]
    except (TypeError, ValueError):
        parameters = []  # what follows says that its arguments are not known
    if len(parameters) >= len(given):
        named = {**{p.name: g for p, g in zip(parameters, given, strict=False)}, **named}
        value, given = functools.partial(function, **named), ()

    def call(*arguments: Any, **others: Any) -> Any:
        return function(*given, *arguments, **{**named, **others})

    call.__name__ = getattr(function, "__name__", "partial")
    call.__wrapped__ = function  # type: ignore[attr-defined]
    call.filled = frozenset(named)  # type: ignore[attr-defined]
    try:
        call.__signature__ = inspect.signature(value)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        return call  # it is called with nothing, and tells that it cannot be
    return call
