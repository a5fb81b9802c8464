"""Numbers in dictionaries, objects and classes that code finds under a name.

    P = {"m": 2.0}; P["m"]     P = Parameters(); P.m     class P: m = 2.0     import P; P.m

Another of the same kind stands in for each; the person's own is not changed.
"""

import sys
import types
from collections.abc import Callable, Iterator
from functools import cached_property, partial
from typing import Any

from sympy.core.function import UndefinedFunction

from mechanics.claims.code.python.instructions import instructions
from mechanics.claims.code.python.objects import attributes, of_classes, setter, with_methods

Put = Callable[[Any], None]
Learn = Callable[[str, float, Put], None]
"""What is told of a number: its name, its value, and what puts another there."""

NO_DATA = (types.FunctionType, types.MethodType, types.BuiltinFunctionType)
LIBRARIES = frozenset({"numpy", "scipy", "sympy", "casadi"})


def library(module: str) -> bool:
    """Whether a module is none of a person's."""
    return module.partition(".")[0] in sys.stdlib_module_names | LIBRARIES


def of_library(kind: type) -> bool:
    """Whether a class is none of a person's; that of SymPy's ``u(t)`` has no module."""
    return isinstance(kind, UndefinedFunction) or library(kind.__module__ or "")


def with_numbers(value: Any, asked: frozenset[str], learn: Learn) -> Any:
    """A copy whose numbers of these names can be put; the thing itself where it has none."""
    if type(value) is dict:
        known = {n: v for n, v in value.items() if n in asked and is_number(v)}
        other: Any = dict(value) if known else value
        for name, number in known.items():
            learn(name, number, partial(other.__setitem__, name))
        return other
    if isinstance(value, types.ModuleType):
        return _module(value, asked, learn)
    if isinstance(value, NO_DATA):
        return value
    kind = value if isinstance(value, type) else type(value)
    parts = of_classes(kind) | (attributes(value) if kind is not value else {})
    known = {n: v for n, v in parts.items() if n in asked and is_number(v)}
    other = _another(value) if known else value
    if other is not value:
        for name, number in known.items():
            learn(name, number, setter(other, name))
    return other


def _module(value: types.ModuleType, asked: frozenset[str], learn: Learn) -> Any:
    """A file of a person's numbers: ``import parameters as p``."""
    known = {n: v for n, v in vars(value).items() if n in asked and is_number(v)}
    if not known or library(value.__name__):
        return value
    other = types.ModuleType(value.__name__)
    other.__dict__.update(vars(value))
    for name, number in known.items():
        learn(name, number, partial(other.__dict__.__setitem__, name))
    return other


def _another(value: Any) -> Any:
    if not isinstance(value, type):
        parts = of_classes(type(value))
        # What is computed once is computed again: from other numbers.
        once = {n: p.func for n, p in parts.items() if isinstance(p, cached_property)}
        return with_methods(value, once)
    make: Callable[..., type] = type(value)
    try:
        return make(value.__name__, (value,), {})
    except (TypeError, AttributeError, ValueError):
        return value  # a class that nothing is derived from, or only in its own way


def words_in(code: types.CodeType) -> Iterator[str]:
    """Names and strings that code uses, functions inside it included; ``m, l = P`` uses m and l."""
    yield from code.co_names
    left = 0
    for instruction in instructions(code):
        left = int(instruction.argval) if instruction.opname == "UNPACK_SEQUENCE" else left
        if left and instruction.opname.startswith("STORE_"):
            stored = instruction.argval
            left -= 1
            yield from map(str, stored if isinstance(stored, tuple) else (stored,))
    for part in code.co_consts:
        if isinstance(part, str):
            yield part
        elif isinstance(part, types.CodeType):
            yield from words_in(part)


def is_number(value: Any) -> bool:
    """Whether a value is a number that may stand for a parameter."""
    return isinstance(value, int | float) and not isinstance(value, bool)
