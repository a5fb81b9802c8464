"""Numbers that a Python function holds besides its arguments, and that stand for parameters.

    m_t = 5.0; g = 9.81            at the top of a file
    self.m = 2.0                   of an object whose method it is
    P = {"m": 2.0}; P.m            of what it finds there
    def make(l=0.3): def f(q): ... around it

Where such a number has the name of a parameter, the function is followed with the parameter itself:
what is judged then are its formulas, for all values. The person's function is not changed.
"""

import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from mechanics.claims.code.python.containers import (
    LIBRARIES,
    Learn,
    Put,
    is_number,
    with_numbers,
    words_in,
)
from mechanics.claims.code.python.instructions import instructions
from mechanics.claims.code.python.objects import (
    attributes,
    methods_used,
    of_classes,
    setter,
    with_methods,
)
from mechanics.errors import InputError

OF_MODULES = ("LOAD_GLOBAL", "LOAD_NAME")
DEEPEST = 6
"""Functions that call functions."""


@dataclass(frozen=True)
class Held:
    """A copy of a function, and how to put other numbers in place of those that it holds.

    Attributes
    ----------
    function : callable
    numbers : dict of str to number
        As the person has them.
    places : tuple of (str, callable)
        A name, and what puts a number there.
    """

    function: Callable[..., Any]
    numbers: dict[str, float]
    places: tuple[tuple[str, Put], ...]

    def with_values(self, values: Mapping[str, Any]) -> Callable[..., Any]:
        """The function, holding these from now on."""
        for name, put in self.places:
            put(values[name])
        return self.function


def held(function: Callable[..., Any], names: Iterable[str]) -> Held:
    """The numbers of these names that a function and those of its file that it calls hold.

    Raises
    ------
    InputError
        When one name has two values.
    """
    wanted = frozenset(names)
    inner, bound = owner_of(function)
    if inner is None:
        return Held(function, {}, ())
    numbers: dict[str, float] = {}
    places: list[tuple[str, Put]] = []

    def learn(name: str, value: float, put: Put) -> None:
        if numbers.setdefault(name, value) != value:
            raise InputError(
                f"function {inner.__name__}: {name} is {numbers[name]} in one place and {value} in"
                " another: name one of them otherwise"
            )
        places.append((name, put))

    copies = _copies(inner, bound, wanted, learn)
    if bound is None:
        return Held(copies[inner] if places else function, numbers, tuple(places))
    methods = {n: copies[f] for n, f in methods_used(bound, [inner]).items() if f in copies}
    asked = wanted & {word for f in copies for word in words_in(f.__code__)}
    other = _object(bound, wanted, asked, learn, methods)
    if not places:
        return Held(function, {}, ())
    return Held(types.MethodType(copies[inner], other), numbers, tuple(places))


def owner_of(function: Callable[..., Any]) -> tuple[types.FunctionType | None, Any]:
    """The plain function in what can be called, and the object whose method it is."""
    inner = function.__func__ if isinstance(function, types.MethodType) else function
    bound = getattr(function, "__self__", None)
    if not isinstance(inner, types.FunctionType):
        inner, bound = type(function).__call__, function
    if not isinstance(inner, types.FunctionType) or isinstance(bound, type | types.ModuleType):
        return None, None
    return inner, bound


def _copies(
    function: types.FunctionType, bound: Any, wanted: frozenset[str], learn: Learn
) -> dict[types.FunctionType, types.FunctionType]:
    """Functions with names of their own, which they share with the copies of those they call."""
    called = called_by(function, bound)
    asked = wanted & {word for f in called for word in words_in(f.__code__)}
    tables: dict[int, dict[str, Any]] = {}
    for f in called:
        table = tables.setdefault(id(f.__globals__), dict(f.__globals__))
        for name in named(f.__code__):
            if name not in table or table[name] is not f.__globals__[name]:
                continue  # it is a builtin, or was met before
            value = table[name]
            if name in wanted and is_number(value):
                learn(name, value, partial(table.__setitem__, name))
            else:
                table[name] = with_numbers(value, asked, learn)
    copies = {f: _over(f, tables[id(f.__globals__)], wanted, asked, learn) for f in called}
    for f, copy in copies.items():
        for name in named(f.__code__):
            value = f.__globals__.get(name)
            if isinstance(value, types.FunctionType) and value in copies:
                copy.__globals__[name] = copies[value]
        for cell in copy.__closure__ or ():
            value = content(cell)
            if isinstance(value, types.FunctionType) and value in copies:
                cell.cell_contents = copies[value]
    return copies


def called_by(function: types.FunctionType, bound: Any = None) -> list[types.FunctionType]:
    """The function and those that it calls: of its file, of its object, and around which it is."""
    found, open_ones = [function], [function]
    for _ in range(DEEPEST):
        called = [
            g for f in open_ones for name in named(f.__code__)
            if isinstance(g := f.__globals__.get(name), types.FunctionType)
            and g.__globals__ is f.__globals__
        ]  # fmt: skip
        if bound is not None:
            methods = methods_used(bound, open_ones).values()
            called += [g for g in methods if g.__globals__ is function.__globals__]
        cells = [content(cell) for f in open_ones for cell in f.__closure__ or ()]
        called += [g for g in cells if isinstance(g, types.FunctionType) and not foreign(g)]
        open_ones = [g for g in dict.fromkeys(called) if g not in found]
        found += open_ones
    return found


def foreign(function: types.FunctionType) -> bool:
    """Whether a function is one of a library of numbers."""
    return (function.__module__ or "").partition(".")[0] in LIBRARIES


def _over(
    function: types.FunctionType, table: dict[str, Any], wanted: frozenset[str],
    asked: frozenset[str], learn: Learn,
) -> types.FunctionType:  # fmt: skip
    """The function with another table of names, and cells of its own for numbers."""
    cells = []
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        value = content(cell)
        if name in wanted and is_number(value):
            cell = types.CellType(value)
            learn(name, value, partial(setattr, cell, "cell_contents"))
        elif isinstance(value, types.FunctionType):
            cell = types.CellType(value)  # a copy may come here
        elif (other := with_numbers(value, asked, learn)) is not value:
            cell = types.CellType(other)
        cells.append(cell)
    made = types.FunctionType(
        function.__code__, table, function.__name__, function.__defaults__, tuple(cells) or None
    )
    made.__kwdefaults__ = function.__kwdefaults__
    made.__module__, made.__qualname__ = function.__module__, function.__qualname__
    return made


def content(cell: types.CellType) -> Any:
    """What is in a cell; None where it is not set yet."""
    try:
        return cell.cell_contents
    except ValueError:
        return None


def _object(
    bound: Any, wanted: frozenset[str], asked: frozenset[str], learn: Learn,
    methods: Mapping[str, types.FunctionType],
) -> Any:  # fmt: skip
    """Another object of the same kind, with the same attributes but for the numbers put there."""
    other = with_methods(bound, methods)
    if other is bound:
        return bound
    for name, value in {**of_classes(type(bound)), **attributes(bound)}.items():
        if name in wanted and is_number(value):
            learn(name, value, setter(other, name))
        elif (inner := with_numbers(value, asked, learn)) is not value:
            setter(other, name)(inner)
    return other


def named(code: types.CodeType) -> Iterator[str]:
    """Names of the file that code reads, functions inside it included."""
    for instruction in instructions(code):
        if instruction.opname in OF_MODULES:
            yield str(instruction.argval)
    for inner in code.co_consts:
        if isinstance(inner, types.CodeType):
            yield from named(inner)
