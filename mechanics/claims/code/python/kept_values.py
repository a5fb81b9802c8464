"""Values that an object or a function computed before, and keeps: are they still what it computes?

    body.inertia; body.l = 2.0      cached_property keeps the inertia of the l before
    @lru_cache def inertia(): ...   so does what is kept of a call

What is judged computes with what it keeps, tracing computes anew: where these differ, nothing of
what is traced is what the code gives.
"""

import functools
import gc
import types
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any

import numpy as np

from mechanics.claims.code.python.closure_numbers import called_by, content, named, owner_of
from mechanics.claims.code.python.containers import library, of_library
from mechanics.claims.code.python.objects import attributes, names_in, of_classes, with_methods
from mechanics.errors import InputError

Cached = functools._lru_cache_wrapper
"""What `lru_cache` and `cache` make."""
DEEPEST = 4
"""Objects in objects."""


def refuse_stale(function: Callable[..., Any]) -> None:
    """Refuse a function that uses a value which was computed before something of it changed.

    Raises
    ------
    InputError
        When a value that is kept is not what its function gives now.
    """
    inner, bound = owner_of(function)
    if inner is None:
        return
    called = called_by(inner, bound)
    asked = {name for one in called for name in names_in(one.__code__)}
    things = [] if bound is None else [bound]
    things += [value for one in called for value in _used(one)]
    for thing in _inside(things, asked):
        for name, kept, now in (*_properties(thing), *_calls(thing)):
            if not _same(kept, now):
                raise InputError(
                    f"{name} was computed before what it is made of changed: it is {kept} there,"
                    f" and {now} when it is computed now"
                )


def _used(function: types.FunctionType) -> Iterator[Any]:
    """What a function finds under names of its file and of the functions around."""
    for name in named(function.__code__):
        yield function.__globals__.get(name)
    yield from map(content, function.__closure__ or ())


def _inside(things: list[Any], asked: set[str]) -> Iterator[Any]:
    """Things of a person, and what is in their attributes, once each."""
    seen: set[int] = set()
    for _ in range(DEEPEST):
        new = [one for one in things if id(one) not in seen and _of_person(one)]
        seen |= {id(one) for one in new}
        yield from new
        things = [part for one in new for part in _parts(one, asked)]


def _of_person(thing: Any) -> bool:
    if isinstance(thing, Cached):
        return True
    if isinstance(thing, types.ModuleType):
        return not library(thing.__name__)
    return not of_library(thing if isinstance(thing, type) else type(thing))


def _parts(thing: Any, asked: set[str]) -> list[Any]:
    if isinstance(thing, Cached):
        wrapped = thing.__wrapped__
        return [*_used(wrapped)] if isinstance(wrapped, types.FunctionType) else []
    if isinstance(thing, types.ModuleType):
        return [value for name, value in vars(thing).items() if name in asked]
    return [*attributes(thing).values()]


def _properties(thing: Any) -> Iterator[tuple[str, Any, Any]]:
    """Properties that are computed once: what they are, and what they would be now."""
    if isinstance(thing, type | types.ModuleType | Cached):
        return
    parts, kept = of_classes(type(thing)), getattr(thing, "__dict__", {})
    once = {n: p.func for n, p in parts.items() if isinstance(p, cached_property)}
    if any(name in kept for name in once):
        anew = with_methods(thing, once)  # one may be computed from another
        for name in once.keys() & kept.keys():
            yield name, kept[name], _value(getattr, anew, name)


def _calls(thing: Any) -> Iterator[tuple[str, Any, Any]]:
    """Calls whose results are kept, with what they would give now."""
    parts = [thing] if isinstance(thing, Cached) else [*of_classes(type(thing)).values()]
    for one in parts:
        one = one.fget if isinstance(one, property) else getattr(one, "__func__", one)
        if isinstance(one, Cached) and one.cache_info().currsize:
            for arguments in _arguments(one):
                if one is not thing and all(part is not thing for part in arguments[:1]):
                    continue  # it is kept of another object
                name = getattr(one, "__name__", "a call")
                yield name, _value(one, *arguments), _value(one.__wrapped__, *arguments)


def _arguments(function: Any) -> Iterator[tuple[Any, ...]]:
    """Arguments of the calls whose results a function keeps: the keys of its only dictionary."""
    for kept in gc.get_referents(function):
        if type(kept) is dict and kept and kept is not getattr(function, "__dict__", None):
            for key in [*kept]:
                parts = tuple(key) if isinstance(key, tuple | list) else (key,)
                if all(type(part) is not object for part in parts):  # a mark before keywords
                    yield parts


def _value(call: Callable[..., Any], *arguments: Any) -> Any:
    """What a call gives."""
    try:
        return call(*arguments)
    except Exception as error:
        words = f"{type(error).__name__}: {error}"
        raise InputError(f"a value that was kept cannot be computed again: {words}") from None


def _same(kept: Any, now: Any) -> bool:
    """Whether two values are equal, as the same arithmetic makes them; what is no number is left
    to calls of the whole function.
    """
    try:
        a, b = np.asarray(kept, dtype=float), np.asarray(now, dtype=float)
    except (TypeError, ValueError):
        return True
    return bool(np.array_equal(a, b, equal_nan=True))
