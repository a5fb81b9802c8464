"""A Python function followed along all its ways: ``trace(function, arguments) -> formulas``.

    call with (True, True, ...), then with each decision turned, the last one first

The ways are put together as cases of the conditions they were taken under.
"""

import inspect
import re
import traceback
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from dis import opmap
from typing import Any, TypeAlias

import numpy as np
from sympy import Expr, Matrix, Piecewise
from sympy.logic.boolalg import Boolean

from mechanics.claims.code import array_language
from mechanics.claims.code.python.closure_numbers import held
from mechanics.claims.code.trace.assignments import recorded
from mechanics.claims.code.trace.explorer import MOST_PATHS, Explorer
from mechanics.claims.code.trace.formulas import Authored, Formulas, leaf
from mechanics.claims.code.trace.side_effects import changed, seen
from mechanics.claims.code.trace.tracer import Traced, asked_of, expression_of
from mechanics.claims.code.trace.tracing_modules import SINGLE_NOTE, copy_of, names_single
from mechanics.claims.code.unpacking import Record
from mechanics.claims.demands import ERROR, RAISED, Demand, gathered
from mechanics.errors import InputError, MechanicsError

Value: TypeAlias = Expr | Sequence[Expr] | Record
Given = Mapping[str, Value]
NONE: Mapping[str, Expr] = {}


@dataclass(frozen=True)
class Outputs:
    """What code computes.

    Attributes
    ----------
    values : tuple of Matrix
        One for each thing that it returns; numbers are 1 x 1.
    notes : tuple of str
        Constants that were computed before the code was read, and ways that end in an error.
    conditions : tuple of Boolean
        What it decides upon.
    doubt : str
        Why the formulas are not what it computes, one line; empty where nothing says so.
    formulas : mapping of Expr to Authored
        Values as the code has them, before SymPy puts terms together; those that are known, of
        each way through the code.
    names : tuple of str
        What the code calls its outputs, entry by entry; empty where that is not plain.
    changed : tuple of str
        What a call changes that outlives it.
    demands : mapping of Expr to tuple of Demand
        What values ask of the operations that they were made by.
    """

    values: tuple[Matrix, ...]
    notes: tuple[str, ...]
    conditions: tuple[Boolean, ...] = ()
    doubt: str = ""
    formulas: Formulas = field(default_factory=dict)
    names: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()
    demands: Mapping[Expr, tuple[Demand, ...]] = field(default_factory=dict)

    @property
    def entries(self) -> list[Expr]:
        """All numbers, row by row."""
        return [entry for value in self.values for entry in value]


@dataclass(frozen=True)
class _Way:
    conditions: tuple[tuple[Boolean, bool], ...]
    values: tuple[Matrix, ...] | None
    formulas: Formulas
    names: tuple[str, ...]
    decided: tuple[tuple[Demand, ...], ...] = ()
    asked: tuple[tuple[Demand, ...], ...] = ()
    failure: str = ""


class OtherKindError(InputError):
    """A function returns neither numbers nor arrays."""


def trace(
    function: Callable[..., Any], given: Given, standing: Mapping[str, Expr] = NONE
) -> Outputs:
    """The formulas of a Python function.

    Parameters
    ----------
    function : callable
        On numbers and NumPy arrays. A copy of it is called.
    given : mapping of str to Expr or sequence of Expr
        For each argument its symbol, or those of its entries.
    standing : mapping of str to Expr
        What numbers that the function holds stand for, by their names.

    Raises
    ------
    InputError
        When its code hides a formula: by ``float()``, by what is compiled, by too many decisions.
    """
    title, ways = _title(function), _Ways()
    try:
        _follow(function, given, standing, ways)
    except MechanicsError:
        raise
    except (TypeError, ValueError, AttributeError) as error:
        # What it holds refuses traced numbers: an array of floats, a property that is kept.
        raise InputError(f"{title} cannot be traced: {_words(error)}") from None
    defined = [way for way in ways.found if way.values is not None]
    if not defined:
        raise InputError(f"{title} raises an error for all arguments")
    if len(defined) < len(ways.found):
        ways.notes.append("branches that raise an error have no value")
    shapes = {tuple(value.shape for value in way.values or ()) for way in defined}
    if len(shapes) > 1:
        raise InputError(f"{title} returns arrays of different shapes")
    conditions = dict.fromkeys(condition for way in ways.found for condition, _ in way.conditions)
    names = {way.names for way in ways.found}
    values = _joined(defined, 0)
    entries = [entry for value in values for entry in value]
    failing = [
        Demand(way.failure, conditions=way.conditions) for way in ways.found if way.values is None
    ]
    demands = {entry: (*_demanded(defined, 0, k), *failing) for k, entry in enumerate(entries)}
    return Outputs(
        values, tuple(ways.notes), tuple(conditions), demands=demands,
        formulas={e: f for way in reversed(defined) for e, f in way.formulas.items()},
        names=ways.found[0].names if len(names) == 1 else (), changed=tuple(ways.lasting),
    )  # fmt: skip


@dataclass
class _Ways:
    """Ways through a function that were gone, and what was learnt on them."""

    found: list[_Way] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    lasting: dict[str, None] = field(default_factory=dict)


def _follow(
    function: Callable[..., Any], given: Given, standing: Mapping[str, Expr], ways: _Ways
) -> None:
    """Go all ways through a function."""
    made: dict[int, Any] = {}
    own, copied = held(function, standing), copy_of(function, made)
    if any(names_single(one.__code__) for one in made.values() if inspect.isfunction(one)):
        ways.notes.append(SINGLE_NOTE)
    # What only fills arrays is called by what returns them: the lines are those of the first.
    origin = getattr(function, "__wrapped__", function)
    prefix: tuple[bool, ...] | None = ()
    while prefix is not None:
        if len(ways.found) == MOST_PATHS:
            raise InputError(f"{_title(function)} has more than {MOST_PATHS} branches")
        explorer = Explorer(prefix, notes=ways.notes)
        if own.places:
            traced = {n: _argument(value, explorer) for n, value in standing.items()}
            copied = copy_of(own.with_values(traced))
        arguments = {name: _argument(value, explorer) for name, value in given.items()}
        before = seen(copied, arguments)
        values = _called(copied, arguments, given, explorer, origin)
        ways.lasting |= dict.fromkeys(changed(before, seen(copied, arguments)))
        taken = tuple(explorer.taken)
        decided = tuple(map(gathered, explorer.asked))
        ways.found.append(
            _Way(
                taken,
                values,
                explorer.formulas,
                explorer.names,
                decided,
                tuple(explorer.outputs),
                explorer.failure,
            )
        )
        prefix = _next([answer for _, answer in taken])


def _title(function: Callable[..., Any]) -> str:
    return f"function {getattr(function, '__name__', type(function).__name__)}"


def _next(answers: list[bool]) -> tuple[bool, ...] | None:
    """The next way: the last decision that was yes becomes no."""
    while answers and not answers[-1]:
        answers.pop()
    return (*answers[:-1], False) if answers else None


def _called(
    function: Callable[..., Any], arguments: Mapping[str, Any], given: Given, explorer: Explorer,
    origin: Callable[..., Any],
) -> tuple[Matrix, ...] | None:  # fmt: skip
    title = _title(origin)
    try:
        with recorded(origin, explorer.assigned, explorer.hidden):
            result = function(**arguments)
    except InputError as error:
        raise InputError(f"{title}{_line(origin, error)[0]}: {error}") from None
    except MechanicsError:
        raise
    except (ValueError, ZeroDivisionError, AssertionError, FloatingPointError) as error:
        if explorer.taken:
            explorer.failure = RAISED if _raises(error) else ERROR
            return None
        raise InputError(f"{title}{_where(origin, error, given)}") from None
    except (Exception, SystemExit, GeneratorExit) as error:
        raise InputError(f"{title} cannot be traced{_where(origin, error, given)}") from None
    if explorer.hidden:
        raise InputError(f"{title} cannot be traced: {explorer.hidden[0]}")
    explorer.names = _keys(result)
    return tuple(_matrix(part, explorer, title) for part in parts_of(result))


def _raises(error: Exception) -> bool:
    """Whether the code says ``raise`` or ``assert`` there, and no operation of it failed."""
    frame = error.__traceback__
    while frame is not None and frame.tb_next is not None:
        frame = frame.tb_next
    if frame is None:
        return False
    return frame.tb_frame.f_code.co_code[frame.tb_lasti] == opmap["RAISE_VARARGS"]


def _where(function: Callable[..., Any], error: BaseException, given: Given) -> str:
    """In which line of a function something failed, how, and what its arguments were read as."""
    words = f": {_words(error)}{_unnamed(function)}"
    line, code = _line(function, error)
    if not line:
        return words
    held = [n for n, v in given.items() if not isinstance(v, Expr) and re.search(rf"\b{n}\b", code)]
    read = [f"{name} is read as {' '.join(str(entry) for entry in given[name])}" for name in held]
    more = f" ({', '.join(read)}: if it is not, give --name '{held[0]}=...')" if held else ""
    return f"{words}{line}: {code}{more}"


def _words(error: BaseException) -> str:
    """What an error says, for people."""
    words = " ".join(str(error).split())
    if isinstance(error, UnboundLocalError) and (name := re.search(r"'(\w+)'", words)):
        return (
            f"{name[1]} is set in the function and read before that: give the new one another name,"
            " or pass it as an argument"
        )
    frames = traceback.extract_tb(error.__traceback__)
    if isinstance(error, ValueError) and frames[-1].filename == array_language.__file__:
        return words
    return f"{type(error).__name__}: {words}"


def _line(function: Callable[..., Any], error: BaseException) -> tuple[str, str]:
    """In which line of a function's file something failed, in words, and what stands there."""
    code = getattr(function, "__code__", getattr(type(function).__call__, "__code__", None))
    file = getattr(code, "co_filename", None)
    entries = [e for e in traceback.extract_tb(error.__traceback__) if e.filename == file]
    return (f", in line {entries[-1].lineno}", entries[-1].line or "") if entries else ("", "")


def _unnamed(function: Callable[..., Any]) -> str:
    """What to do about ``*args``, which nothing is passed as."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return ""
    found = [p.name for p in parameters if p.kind in (p.VAR_POSITIONAL, p.VAR_KEYWORD)]
    return f" (*{found[0]} is read as nothing: give its parts names of their own)" if found else ""


def _argument(value: Value, explorer: Explorer) -> Any:
    if isinstance(value, Expr):
        return Traced(value, explorer, leaf(value))
    if isinstance(value, Record):
        return value.filled(lambda symbol: Traced(symbol, explorer, leaf(symbol)))
    found = np.empty(len(value), dtype=object)
    found[:] = [Traced(entry, explorer, leaf(entry)) for entry in value]
    return found


def _keys(result: Any) -> tuple[str, ...]:
    """Names of numbers in a dictionary, or of the fields of a tuple."""
    keys = tuple(result) if isinstance(result, dict) else getattr(result, "_fields", ())
    return keys if all(isinstance(key, str) for key in keys) else ()


def parts_of(result: Any) -> list[Any]:
    """Things that are returned; numbers side by side are one array."""
    if isinstance(result, dict):
        result = tuple(result.values())
    if isinstance(result, list) and result and all(isinstance(part, list) for part in result):
        return [result]  # rows of one matrix
    if isinstance(result, tuple | list) and any(_is_array(part) for part in result):
        return list(result)
    return [result]


def _is_array(part: Any) -> bool:
    return isinstance(part, list | tuple) or (isinstance(part, np.ndarray) and part.ndim > 0)


def _matrix(part: Any, explorer: Explorer, title: str) -> Matrix:
    array = np.asarray(part, dtype=object)
    if array.ndim > 2 or array.size == 0:
        raise InputError(f"{title} returns an array of shape {array.shape}: vectors and matrices")
    entries = [expression_of(entry, explorer) for entry in array.flat]
    if any(entry is None for entry in entries):
        raise OtherKindError(f"{title} returns {type(part).__name__}: numbers and arrays are known")
    explorer.outputs += [gathered(asked_of(entry)) for entry in array.flat]
    for entry in array.flat:
        if isinstance(entry, Traced) and entry.formula is not None:
            known = Authored(entry.formula.node, explorer.assigned)
            explorer.formulas.setdefault(entry.expr, known)
    rows = array.shape[0] if array.ndim else 1
    return Matrix(rows, len(entries) // rows, entries)


def _joined(ways: list[_Way], depth: int) -> tuple[Matrix, ...]:
    """Ways as cases of the decision at a depth."""
    first = ways[0]
    if len(ways) == 1 or len(first.conditions) <= depth:
        return first.values or ()
    condition = first.conditions[depth][0]
    yes = [way for way in ways if way.conditions[depth][1]]
    no = [way for way in ways if not way.conditions[depth][1]]
    if not (yes and no):
        return _joined(ways, depth + 1)
    pairs = zip(_joined(yes, depth + 1), _joined(no, depth + 1), strict=True)
    return tuple(
        Matrix(*a.shape, [_case(condition, x, y) for x, y in zip(a, b, strict=True)])
        for a, b in pairs
    )


def _demanded(ways: list[_Way], depth: int, place: int) -> dict[Demand, None]:
    """Demands of one output: of all ways, or under the conditions of those that have them."""
    first = ways[0]
    if len(first.conditions) <= depth:
        return dict.fromkeys(first.asked[place])
    condition = first.conditions[depth][0]
    sides = {}
    for answer in (True, False):
        there = [way for way in ways if way.conditions[depth][1] is answer]
        sides[answer] = _demanded(there, depth + 1, place) if there else {}
    always = [d for d in sides[True] if d in sides[False]]
    found = dict.fromkeys((*first.decided[depth], *always))
    for answer, demands in sides.items():
        inside = (d.under([(condition, answer)]) for d in demands if d not in found)
        found |= dict.fromkeys(inside)
    return found


def _case(condition: Boolean, yes: Expr, no: Expr) -> Expr:
    return yes if yes == no else Piecewise((yes, condition), (no, True))
