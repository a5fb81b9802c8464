"""Names that code gives to what it computes, with their places: the definitions of a claim.

    temp = (force + polemass_length*theta_dot**2*sintheta)/total_mass        cart.py, line 12

A name that is given twice to different formulas stands for the first; the other is written out.
"""

import inspect
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

import numpy as np
from sympy import Symbol

from mechanics.claims.claim import Written
from mechanics.claims.code.trace.formulas import (
    LOCAL,
    Assignment,
    Assignments,
    Authored,
    Formulas,
    given_a_name,
    renamed,
)
from mechanics.claims.code.trace.tracer import Traced, of_libraries
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    names,
)
from mechanics.errors import InputError, MechanicsError
from mechanics.scene.symbols import DOTS

LARGEST_ARRAY = 36
"""Entries that get names of their own."""
MOST_LINES = 60_000
"""That a call may run through, loops in loops included."""
ENTRIES = {".m": ("(", 1, ")"), ".jl": ("[", 1, "]")}
"""How languages write an entry of an array, and from where they count; others as Python."""
PYTHON = (".py", ".ipynb", ".md", "")
"""What files end with whose rows of a matrix need two indices."""
NO_NUMBER = re.compile(r"has no len\(\)|not (?:iterable|subscriptable|callable)")
"""What fails for every number."""


@contextmanager
def recorded(
    function: Callable[..., Any], found: dict[str, Assignment], failed: list[str]
) -> Iterator[None]:
    """Learn what the lines of a function's file assign while it runs; traced numbers get names.

    Parameters
    ----------
    function : callable
    found : dict of str to Assignment
    failed : list of str
        What could not be done with traced numbers, though the code may go on: ``except: pass``.
    """
    inner = inspect.unwrap(function)
    inner = getattr(inner, "__func__", inner)
    code = getattr(inner, "__code__", getattr(type(inner).__call__, "__code__", None))
    if not isinstance(code, CodeType):
        yield
        return
    lines: dict[int, int] = {}
    left = iter(range(MOST_LINES))
    file = code.co_filename
    suffix = Path(file).suffix
    words = f"{Path(file).name}, line" if suffix == ".py" else "line"
    entry = (*ENTRIES.get(suffix, ("[", 0, "]")), suffix in PYTHON)

    def called(frame: FrameType, event: str, _: Any) -> Any:
        if event != "call" or frame.f_code.co_filename != file:
            return None
        module = str(frame.f_globals.get("__name__", ""))
        if frame.f_builtins.get("isinstance") is isinstance and not of_libraries(module):
            failed.append(f"line {frame.f_lineno}: {frame.f_code.co_name} is not followed")
        return line

    def line(frame: FrameType, event: str, what: Any) -> Any:
        if event == "exception" and _of_tracing(what[1]):
            failed.append(f"line {frame.f_lineno}: {what[0].__name__}: {what[1]}")
        if next(left, None) is None:
            failed.append(f"it runs through more than {MOST_LINES} lines")
            raise InputError(failed[-1])
        if id(frame) in lines:
            for name, value in frame.f_locals.items():
                place = f"{words} {lines[id(frame)]}"
                for own, number in _numbers(name, value, *entry):
                    if number.formula is not None:
                        number.formula = given_a_name(number.formula, own, place, found)
        lines[id(frame)] = frame.f_lineno
        if event == "return":
            del lines[id(frame)]
        return line

    before = sys.gettrace()
    sys.settrace(called)
    try:
        yield
    finally:
        sys.settrace(before)


def _of_tracing(error: BaseException | None) -> bool:
    """Whether an operation fails for a traced number, and would not for a float."""
    if isinstance(error, TypeError):
        return NO_NUMBER.search(str(error)) is None
    return isinstance(error, MechanicsError)


def _numbers(
    name: str, value: Any, opening: str, first: int, closing: str, both: bool
) -> Iterator[tuple[str, Traced]]:
    """Traced numbers that are assigned to a name, with what the language calls each.

    Parameters
    ----------
    name : str
    value : object
    opening, closing : str
        Around indices.
    first : int
        Index of the first entry.
    both : bool
        Whether an entry of a matrix of one row needs two indices.
    """
    if isinstance(value, np.ndarray) and value.dtype == object and value.size <= LARGEST_ARRAY:
        row = not both and value.shape[:-1] == (1,)
        for index, entry in np.ndenumerate(value):
            places = ", ".join(str(first + k) for k in (index[1:] if row else index))
            own = f"{name}{opening}{places}{closing}"
            yield from _numbers(own, entry, opening, first, closing, both)
    if isinstance(value, Traced):
        yield name, value


def written_out(tree: Node, table: Mapping[str, Node]) -> Node:
    """A tree with others in place of names."""

    def put(part: Node) -> Node:
        return written_out(part, table)

    match tree:
        case Name(name=name):
            return table.get(name, tree)
        case Sum(terms=inner):
            return Sum(tree.at, tuple(map(put, inner)))
        case Product(factors=inner):
            return type(tree)(tree.at, tuple(map(put, inner)))
        case Power(base=base, exponent=exponent):
            return Power(tree.at, put(base), put(exponent))
        case Call(function=function, arguments=inner):
            return Call(tree.at, function, tuple(map(put, inner)))
        case Rate(of=of, order=order):
            return Rate(tree.at, put(of), order)
        case Table(rows=rows):
            return Table(tree.at, tuple(tuple(map(put, row)) for row in rows))
    return tree


def written_of(formulas: Sequence[Authored], naming: Naming) -> Written:
    """Formulas of one call under the names of the scene, the code's own names as definitions.

    Parameters
    ----------
    formulas : sequence of Authored
    naming : Naming
    """
    vocabulary, empty = naming.vocabulary, Written((), (), naming, "code", "")

    aliases = _aliases(formulas[0].assigned, naming)

    def name_of(symbol: Symbol) -> Name:
        if symbol.name in aliases:
            return Name(0, aliases[symbol.name])
        return empty.name_of(vocabulary.constants.get(symbol.name, symbol))

    taken = {name_of(symbol).name for symbol in _symbols(vocabulary)}
    taken |= {base + dots for base in tuple(taken) for dots in DOTS}
    trees = [formula.tree for formula in formulas]
    used = _used(trees, formulas[0].assigned)
    table: dict[str, Node] = {}
    definitions: list[tuple[str, Node]] = []
    places: dict[str, str] = {}
    for key, assignment in formulas[0].assigned.items():
        if key not in used:
            continue
        name = key.removeprefix(LOCAL)
        tree = written_out(renamed(assignment.tree, name_of), table)
        table[key] = tree if name in taken else Name(0, name)
        if name not in taken:
            definitions.append((name, tree))
            places[name] = assignment.place
    sides = tuple(written_out(renamed(tree, name_of), table) for tree in trees)
    own = (Match(alias, meaning, "a name in the code") for meaning, alias in aliases.items())
    naming = replace(naming, guessed=(*naming.guessed, *own))
    return Written(sides, tuple(definitions), naming, "code", "", places=places)


def names_used(formulas: Formulas) -> frozenset[str]:
    """The names that code gives to what it computes its outputs with."""
    found: set[str] = set()
    for formula in formulas.values():
        used = _used([formula.tree], formula.assigned)
        found |= {key for key, one in formula.assigned.items()
                  if key in used or isinstance(one.tree, Name)}  # fmt: skip
    return frozenset(name.removeprefix(LOCAL) for name in found)


def _aliases(assigned: Assignments, naming: Naming) -> dict[str, str]:
    """What code calls symbols of the scene, by their names there: dtheta1 = s[2]."""
    found: dict[str, str] = {}
    for key, assignment in assigned.items():
        alias, tree = key.removeprefix(LOCAL), assignment.tree
        if isinstance(tree, Name):
            symbol = naming.symbol(alias, 0)
            if symbol is None or symbol.name == tree.name:
                found.setdefault(tree.name, alias)
    return found


def _symbols(vocabulary: Vocabulary) -> list[Symbol]:
    return [*vocabulary.functions.values(), *vocabulary.constants.values()]


def _used(trees: Sequence[Node], assigned: Assignments) -> set[str]:
    """Names that formulas are made with."""
    found: set[str] = set()
    todo = list(trees)
    while todo:
        for name in names(todo.pop()):
            if name.name in assigned and name.name not in found:
                found.add(name.name)
                todo.append(assigned[name.name].tree)
    return found
