"""An object whose methods are followed: another one of its kind, with copies for its methods.

    self.mass_matrix(q)        self.total_mass (a property)        type(self) stays what it was

The person's object is not changed.
"""

import inspect
import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from typing import Any

from mechanics.reading.code.unwrapped import unwrapped

Function = types.FunctionType
Kept = (property, staticmethod, classmethod)
Getter = (property, cached_property)


def methods_used(bound: Any, functions: Iterable[Function]) -> dict[str, Function]:
    """Methods, and getters of properties, that functions use of an object, and these again."""
    found: dict[str, Function] = {}
    open_ones = list(functions)
    while open_ones:
        names = [name for name in names_in(open_ones.pop().__code__) if name not in found]
        for name in dict.fromkeys(names):
            function = _inner(inspect.getattr_static(type(bound), name, None))
            if function is not None:
                found[name] = function
                open_ones.append(function)
    return found


def with_methods(bound: Any, copies: Mapping[str, Callable[..., Any]]) -> Any:
    """Another object with the same attributes, and copies in place of methods of these names.

    The object itself where its kind is made in another way.
    """
    kind = type(bound)
    own = getattr(bound, "__dict__", None)
    if not isinstance(own, dict) or isinstance(bound, types.ModuleType | type):
        return bound
    parts = {n: _like(inspect.getattr_static(kind, n), copy) for n, copy in copies.items()}
    make: Callable[..., type] = type(kind)
    try:
        other: Any = object.__new__(make(kind.__name__, (kind,), parts) if parts else kind)
    except TypeError:
        return bound
    other.__dict__.update(own)
    return other


def _inner(value: Any) -> Function | None:
    """The function of a method or of the getter of a property."""
    if isinstance(value, Getter):
        value = value.fget if isinstance(value, property) else value.func
    elif isinstance(value, staticmethod | classmethod):
        value = value.__func__
    value = unwrapped(value)
    return value if isinstance(value, Function) else None


def _like(value: Any, copy: Callable[..., Any]) -> Any:
    if isinstance(value, Getter):
        return property(copy)
    return type(value)(copy) if isinstance(value, Kept) else copy


def names_in(code: types.CodeType) -> Iterator[str]:
    """Names of attributes and of globals that code uses, functions inside it included."""
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, types.CodeType):
            yield from names_in(inner)
