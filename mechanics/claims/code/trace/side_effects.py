"""What calls of a function change that outlives them: its result may depend on more than arguments.

    p["l"] *= 2        global n; n += 1        self.k *= 2        seen.append(x)

All that a function reaches is compared before and after a call: arguments, defaults, what it
closes over, names of its file, attributes of its object and of classes.
"""

import random
import types
from array import array
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from itertools import count
from typing import Any

import numpy as np
from sympy import Basic

from mechanics.claims.code.python.closure_numbers import content
from mechanics.claims.code.python.containers import of_library
from mechanics.claims.code.python.objects import attributes, methods_of, names_in
from mechanics.claims.code.trace.tracer import Traced

MOST, DEEPEST = 20_000, 6
"""Values that are compared, and things in things."""

Seen = dict[str, Any]


def seen(function: Callable[..., Any], arguments: Mapping[str, Any]) -> Seen:
    """What a function reaches, by its name in words."""
    left = iter(range(MOST))
    found = {f"its argument {name}": _still(v, left, 0) for name, v in arguments.items()}
    for name, value in _reached(function, set()):
        found.setdefault(name, ())
        found[name] += (_still(value, left, 0),)
    found["random numbers"] = hash(random.getstate()), _still(np.random.get_state(), count(), 0)
    return found


def changed(before: Seen, after: Seen) -> list[str]:
    """Names of what is not what it was."""
    return [name for name in {**before, **after} if before.get(name) != after.get(name)]


def _reached(function: Any, known: set[int]) -> Iterator[tuple[str, Any]]:
    """What a function reaches, but for functions, and what these reach again."""
    bound = getattr(function, "__self__", None)
    inner = getattr(function, "__func__", function)
    if id(inner) in known or not isinstance(inner, types.FunctionType):
        return
    known.add(id(inner))
    if bound is not None:
        yield from ((f"self.{name}", value) for name, value in attributes(bound).items())
        yield from _of_kind(type(bound), "its class", known)
    names = dict.fromkeys(names_in(inner.__code__))
    table = inner.__globals__
    cells = zip(inner.__code__.co_freevars, inner.__closure__ or (), strict=True)
    held = [(name, content(cell)) for name, cell in cells]
    held += [(name, table[name]) for name in names if name in table]
    defaults = (*(inner.__defaults__ or ()), *(inner.__kwdefaults__ or {}).values())
    yield from ((f"a default of {inner.__name__}", value) for value in defaults)
    yield from ((f"{inner.__name__}.{name}", value) for name, value in vars(inner).items())
    for name, value in held:
        if isinstance(value, types.FunctionType | types.MethodType):
            yield from _reached(value, known)
        elif isinstance(value, type):
            yield from _of_kind(value, name, known)
        elif isinstance(value, types.ModuleType):
            parts = [(n, vars(value)[n]) for n in names if n in vars(value)]
            yield from ((f"{name}.{n}", part) for n, part in parts if not callable(part))
        else:
            yield name, value
            yield from _of_kind(type(value), f"the class of {name}", known)


def _of_kind(kind: type, name: str, known: set[int]) -> Iterator[tuple[str, Any]]:
    """What is kept in a class of a person's, and what its methods reach."""
    if of_library(kind):
        return
    for method in methods_of(kind).values():
        yield from _reached(method, known)
    for base in kind.__mro__:
        for attribute, value in vars(base).items():
            if not attribute.startswith("__") and not callable(value):
                yield f"{name}.{attribute}", value


def _still(value: Any, left: Iterator[int], depth: int) -> Any:
    """A value as something that stays and can be compared."""
    if next(left, None) is None or depth > DEEPEST:
        return id(value)
    match value:
        case Traced():
            return value.expr
        case Basic():
            return value  # it cannot be changed, but remembers what was asked of it
        case int() | str() | bytes() | None:
            return type(value), value
        case float() | complex() | count() | np.generic():
            return type(value), repr(value)
        case np.ndarray() if value.dtype != object:
            return value.shape, hash(value.tobytes())
        case np.ndarray():
            return value.shape, tuple(_still(v, left, depth + 1) for v in value.flat)
        case list() | tuple() | deque():
            return type(value), tuple(_still(v, left, depth + 1) for v in value)
        case dict():
            entries = ((_still(k, left, depth + 1), _still(v, left, depth + 1))
                       for k, v in value.items())  # fmt: skip
            return dict, tuple(entries)
        case bytearray() | memoryview() | array():
            return type(value), bytes(value)
        case random.Random():
            return hash(value.getstate())
        case np.random.RandomState():
            return repr(value.get_state())
        case np.random.Generator():
            return repr(value.bit_generator.state)
        case set() | frozenset():
            return type(value), frozenset(_still(v, left, depth + 1) for v in value)
    if isinstance(value, type | types.FunctionType | types.MethodType | types.ModuleType):
        return id(value)
    if hasattr(type(value), "__next__"):
        return object()  # an iterator: each call may find it somewhere else
    own = attributes(value)
    return (type(value), _still(own, left, depth + 1)) if own else id(value)
