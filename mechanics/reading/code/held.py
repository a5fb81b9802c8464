"""Numbers that a Python function holds besides its arguments, and that stand for parameters.

    m_t = 5.0; g = 9.81            at the top of a file
    self.m = 2.0                   of an object whose method it is
    def make(l=0.3): def f(q): ... around it

Where such a number has the name of a parameter, the function is followed with the parameter itself:
what is judged then are its formulas, for all values. The person's function is not changed.
"""

import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from dis import get_instructions
from functools import partial
from typing import Any

Put = Callable[[Any], None]
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
    """The numbers of these names that a function and those of its file that it calls hold."""
    wanted = frozenset(names)
    inner = function.__func__ if isinstance(function, types.MethodType) else function
    bound = getattr(function, "__self__", None)
    if not isinstance(inner, types.FunctionType):
        inner, bound = type(function).__call__, function
    if not isinstance(inner, types.FunctionType) or isinstance(bound, type | types.ModuleType):
        return Held(function, {}, ())
    numbers: dict[str, float] = {}
    places: list[tuple[str, Put]] = []
    copied = _copied(inner, wanted, numbers, places)
    if bound is None:
        return Held(copied if places else function, numbers, tuple(places))
    other = _object(bound, wanted, numbers, places)
    if not places:
        return Held(function, {}, ())
    return Held(types.MethodType(copied, other), numbers, tuple(places))


def _copied(
    function: types.FunctionType, wanted: frozenset[str], numbers: dict[str, float],
    places: list[tuple[str, Put]],
) -> types.FunctionType:  # fmt: skip
    """A function with names of its own, which it shares with the copies of those that it calls."""
    table = dict(function.__globals__)
    called = _called(function)
    for name in dict.fromkeys(name for f in called for name in _named(f.__code__)):
        if name in wanted and _is_number(table.get(name)):
            numbers[name] = table[name]
            places.append((name, partial(table.__setitem__, name)))
    copies = {f: _over(f, table, wanted, numbers, places) for f in called}
    for name, value in function.__globals__.items():
        if isinstance(value, types.FunctionType) and value in copies:
            table[name] = copies[value]
    return copies[function]


def _called(function: types.FunctionType) -> list[types.FunctionType]:
    """The function and those of the same file that it calls."""
    found, open_ones = [function], [function]
    for _ in range(DEEPEST):
        names = [name for f in open_ones for name in _named(f.__code__)]
        called = [function.__globals__.get(name) for name in dict.fromkeys(names)]
        open_ones = [
            f for f in called
            if isinstance(f, types.FunctionType)
            and f.__globals__ is function.__globals__
            and f not in found
        ]  # fmt: skip
        found += open_ones
    return found


def _over(
    function: types.FunctionType, table: dict[str, Any], wanted: frozenset[str],
    numbers: dict[str, float], places: list[tuple[str, Put]],
) -> types.FunctionType:  # fmt: skip
    """The function with another table of names, and cells of its own for numbers."""
    cells = []
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        value = _content(cell)
        if name in wanted and _is_number(value):
            cell = types.CellType(value)
            numbers[name] = value
            places.append((name, partial(setattr, cell, "cell_contents")))
        cells.append(cell)
    made = types.FunctionType(
        function.__code__, table, function.__name__, function.__defaults__, tuple(cells) or None
    )
    made.__kwdefaults__ = function.__kwdefaults__
    made.__module__, made.__qualname__ = function.__module__, function.__qualname__
    return made


def _content(cell: types.CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:
        return None  # it is not set yet


def _object(
    bound: Any, wanted: Iterable[str], numbers: dict[str, float], places: list[tuple[str, Put]]
) -> Any:
    """Another object of the same kind, with the same attributes but for the numbers put there."""
    own = getattr(bound, "__dict__", None)
    if not isinstance(own, dict) or isinstance(bound, types.ModuleType):
        return bound
    known = {**_of_classes(type(bound)), **own}
    found = {n: v for n, v in known.items() if n in wanted and _is_number(v)}
    if not found:
        return bound
    try:
        other = object.__new__(type(bound))
    except TypeError:
        return bound  # its kind is made in another way
    other.__dict__.update(own)
    for name, value in found.items():
        numbers[name] = value
        places.append((name, partial(other.__dict__.__setitem__, name)))
    return other


def _of_classes(kind: type) -> dict[str, Any]:
    return {name: value for base in reversed(kind.__mro__) for name, value in vars(base).items()}


def _named(code: types.CodeType) -> Iterator[str]:
    """Names of the file that code reads, functions inside it included."""
    for instruction in get_instructions(code):
        if instruction.opname in OF_MODULES:
            yield str(instruction.argval)
    for inner in code.co_consts:
        if isinstance(inner, types.CodeType):
            yield from _named(inner)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
