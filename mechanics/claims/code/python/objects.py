"""An object whose methods are followed: another one of its kind, with copies for its methods.

    self.mass_matrix(q)        self.total_mass (a property)        type(self) stays what it was

Its attributes may be in slots, or be the fields of a tuple: these are copied, too.
The person's object is not changed.
"""

import inspect
import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property, partial
from typing import Any

from mechanics.claims.code.python.wrappers import unwrapped

Function = types.FunctionType
Kept = (property, staticmethod, classmethod)
Getter = (property, cached_property)
NO_VALUES = ("__dict__", "__weakref__")


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


def methods_of(kind: type) -> dict[str, Function]:
    """All methods of a class and of those that it is derived from, getters of properties too."""
    found = {name: _inner(value) for name, value in of_classes(kind).items()}
    return {name: function for name, function in found.items() if function is not None}


def of_classes(kind: type) -> dict[str, Any]:
    """Attributes of a class and of those it is derived from."""
    return {name: value for base in reversed(kind.__mro__) for name, value in vars(base).items()}


def class_with_methods(kind: type, copies: Mapping[str, Callable[..., Any]]) -> type:
    """A class derived from another, with copies in place of methods; itself where none can be."""
    parts = {n: _like(inspect.getattr_static(kind, n), copy) for n, copy in copies.items()}
    make: Callable[..., type] = type(kind)
    try:
        return make(kind.__name__, (kind,), {"__module__": kind.__module__, **parts})
    except (TypeError, AttributeError, ValueError):
        return kind


def with_methods(bound: Any, copies: Mapping[str, Callable[..., Any]]) -> Any:
    """Another object with the same attributes, and copies in place of methods of these names.

    The object itself where its kind is made in another way.
    """
    kind, own = type(bound), attributes(bound)
    plain = hasattr(bound, "__dict__")
    if not (own or plain) or isinstance(bound, types.ModuleType | type):
        return bound
    parts = {n: _like(inspect.getattr_static(kind, n), copy) for n, copy in copies.items()}
    fields = _fields(kind)
    parts = {**_of_fields(fields), **parts}
    make: Callable[..., type] = type(kind)
    try:
        kind = kind if plain and not parts else make(kind.__name__, (kind,), parts)
        other: Any = tuple.__new__(kind, bound) if fields else object.__new__(kind)
        for name, value in own.items():
            setter(other, name)(value)
    except (TypeError, AttributeError):
        return bound
    return other


def attributes(value: Any) -> dict[str, Any]:
    """Attributes of an object: in slots, as fields of a tuple, or neither."""
    kind = type(value)
    found = {n: getattr(value, n) for n in (*_slots(kind), *_fields(kind)) if hasattr(value, n)}
    return found | dict(getattr(value, "__dict__", {}))


def setter(other: Any, name: str) -> Callable[[Any], None]:
    """What puts an attribute into a class or an object, a frozen one, too."""
    if isinstance(other, type):
        return partial(setattr, other, name)
    if name in _slots(type(other)):
        return partial(object.__setattr__, other, name)
    return partial(other.__dict__.__setitem__, name)


def _slots(kind: type) -> list[str]:
    """Names of what is in slots, as they are found: ``__m`` is private to its class."""
    found = []
    for base in kind.__mro__:
        slots = vars(base).get("__slots__", ())
        for name in (slots,) if isinstance(slots, str) else slots:
            private = name.startswith("__") and not name.endswith("__")
            found.append(f"_{base.__name__.lstrip('_')}{name}" if private else name)
    return [name for name in found if name not in NO_VALUES]


def _fields(kind: type) -> tuple[str, ...]:
    """Names of the entries of a tuple that has some."""
    names = getattr(kind, "_fields", ()) if issubclass(kind, tuple) else ()
    return names if isinstance(names, tuple) and all(isinstance(n, str) for n in names) else ()


def _of_fields(fields: tuple[str, ...]) -> dict[str, Any]:
    """What makes a tuple look its entries up among its attributes."""

    def entries(self: Any) -> tuple[Any, ...]:
        return tuple(self.__dict__[name] for name in fields)

    asked = {name: _looked_up(name) for name in fields}
    whole = {"__iter__": lambda self: iter(entries(self)),
             "__getitem__": lambda self, place: entries(self)[place]}  # fmt: skip
    return {**whole, **asked} if fields else {}


def _looked_up(name: str) -> property:
    return property(lambda self: self.__dict__[name])


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
