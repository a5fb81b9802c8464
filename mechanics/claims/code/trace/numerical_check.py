"""A Python function called with numbers, beside the formulas that tracing has found in it.

    | f(numbers) - formulas at the numbers |  <=  2^-20 (largest of both) + what rounding explains

Code can tell a traced number from a float, or keep what it has seen: ``np.zeros(2, dtype=int)``
truncates floats only, ``type(x)`` and ``x.dtype`` differ, counters grow. Then its formulas are not
what it computes, and nothing is proved of it. This is a guard and no proof: some states are tried.
What is rounded to single precision stays within the bound.
"""

import inspect
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import inf, isfinite
from random import Random
from typing import Any

import numpy as np
from flint import arb
from sympy import Expr, Piecewise, Rational, S, Symbol
from sympy.logic.boolalg import Boolean

from mechanics.claims.code.python.closure_numbers import Held, held
from mechanics.claims.code.python.containers import words_in
from mechanics.claims.code.trace.tracing import NONE, Given, Outputs, Value, parts_of
from mechanics.claims.code.unpacking import Record
from mechanics.errors import ExpressionError
from mechanics.symbolic.decimals import Formulas
from mechanics.symbolic.decimals import formulas as formulas_of

UNCALLED = "it cannot be called with numbers"
"""How the doubt begins where no state was found at which it returns numbers."""

STATES = 6
"""That are tried whatever the code decides; each way through it that is met is tried besides."""
DRAWN = 60
MOST_COMPARED = 16
SCALES = (1, 1, 8, Fraction(1, 8), 1, 64)
BITS, ROUNDED = 64, 20
"""Of the formulas' values; of the roughest rounding that is allowed: single precision has 24."""

Numbers = Mapping[Symbol, Fraction]


@dataclass(frozen=True)
class _Program:
    """Conditions of the code, and its formulas, as programs."""

    conditions: Formulas
    values: Formulas
    decided: tuple[Boolean, ...] = ()


@dataclass(frozen=True)
class _Formulas:
    """Values of formulas at a state, and for each how far off rounding may be."""

    numbers: Numbers
    values: tuple[float, ...]
    slack: tuple[float, ...]

    @property
    def where(self) -> str:
        """The state, for people."""
        return ", ".join(f"{s} = {float(x):.6g}" for s, x in self.numbers.items())


def doubt_when_called(
    function: Callable[..., Any], given: Given, outputs: Outputs,
    standing: Mapping[str, Expr] = NONE,
) -> str:  # fmt: skip
    """Why the formulas of a function are not what it computes, one line; empty where they are.

    Parameters
    ----------
    function : callable
        It is called twice at each state, scalars being floats of Python and of NumPy.
    given : mapping of str to Symbol or sequence of Symbol
        What its arguments stand for.
    outputs : Outputs
        As it was traced.
    standing : mapping of str to Expr
        What numbers that it holds stand for.
    """
    own = held(function, standing)
    # What it computes from others beforehand has no number of its own.
    plain = {name: s for name, s in standing.items() if isinstance(s, Symbol)}
    symbols = (*given.values(), *plain.values(), *symbols_in(standing.values()))
    kept = _kept(function, given) | {s: own.numbers[name] for name, s in plain.items()}
    whole, compared, failure = function, False, "its formulas have no value at random states"
    by_kind = any(not isinstance(v, Expr | Record) for v in given.values()) and _asks_kinds(
        function
    )
    try:
        program = program_of(outputs)
        for formulas in at_states(symbols, program):
            values = {name: value_of(s, formulas.numbers) for name, s in standing.items()}
            function = own.with_values(values)
            results = [_attempt(function, given, formulas, kind) for kind in (float, np.float64)]
            failed = [r for r in results if isinstance(r, _Failed)]
            if len(failed) == len(results):
                failure = str(failed[0])
                if failed[0].excused:
                    continue  # it has no value there, and others are drawn
                return f"called with numbers it fails: {failure}"
            for result in results:
                if not isinstance(result, _Failed) and (words := _differs(result, formulas)):
                    return words
            for sequence in (list, tuple) if by_kind else ():
                given_so = _attempt(function, given, formulas, float, sequence=sequence)
                if isinstance(given_so, _Failed) or len(given_so) != len(formulas.values):
                    continue  # code that is for arrays only
                if words := _differs(given_so, formulas):
                    return f"given a {sequence.__name__}, {words}"
            compared = True
        if kept and (there := _at_kept(symbols, program, kept)) is not None:
            values = {name: value_of(s, there.numbers) for name, s in standing.items()}
            function = own.with_values({**values, **{n: own.numbers[n] for n in plain}})
            result = _attempt(function, given, there, float, kept)
            if not isinstance(result, _Failed) and (words := _differs(result, there)):
                return words
        # What a call changes stays as it is; what nothing keeps has no number.
        settled = not outputs.changed and {*symbols_in(standing.values())} <= {*plain.values()}
        if (
            compared
            and settled
            and (words := _differs_as_it_stands(whole, given, symbols, program, own, plain))
        ):
            return words
    except ExpressionError as error:
        failure = str(error)
    except RecursionError:
        failure = "its expressions are nested too deeply"
    return "" if compared else f"{UNCALLED}: {failure}"


def _differs_as_it_stands(
    function: Callable[..., Any], given: Given, symbols: Sequence[Value], program: _Program,
    own: Held, plain: Mapping[str, Symbol],
) -> str:  # fmt: skip
    """How the function itself, with its own numbers, differs from its formulas.

    It may keep what it computed before these numbers changed, which its copies compute anew.
    """
    numbers = {s: own.numbers[name] for name, s in plain.items() if isfinite(own.numbers[name])}
    there = _at_kept(symbols, program, numbers) if len(numbers) == len(plain) else None
    result = _attempt(function, given, there, float) if there is not None else _Failed(ValueError())
    if there is None or isinstance(result, _Failed) or not (words := _differs(result, there)):
        return ""
    return f"as it stands, with values that it computed before, {words}"


def at_states(
    symbols: Sequence[Value], program: _Program, rounded: int = ROUNDED
) -> Iterator[_Formulas]:
    """Formulas at random states, and at those that take another way through the code.

    Random states come first, then those next to the numbers that the code compares with.

    `rounded` is the number of binary digits of the roughest rounding that is allowed.
    """
    source, tried, ways = Random(0), 0, set()
    for k in range(DRAWN):
        numbers = _drawn(symbols, source, Fraction(SCALES[k % len(SCALES)]))
        way = tuple(_holds(ball) for ball in program.conditions.at(numbers, BITS))
        if tried >= STATES and way in ways:
            continue
        formulas = _formulas(program, numbers, rounded)
        if formulas is not None:
            tried += 1
            ways.add(way)
            yield formulas
        if tried >= STATES and not way:
            return
    for numbers in _beyond(symbols, program.decided):
        way = tuple(_holds(ball) for ball in program.conditions.at(numbers, BITS))
        if way not in ways and (formulas := _formulas(program, numbers, rounded)) is not None:
            ways.add(way)
            yield formulas


def _beyond(symbols: Sequence[Value], decided: Iterable[Boolean]) -> Iterator[Numbers]:
    """States at, below and above the numbers that code compares with: ``if theta > 1e6``."""
    drawn = _drawn(symbols, Random(0), Fraction(1))
    pairs = [(s, c) for c in decided for s in sorted(c.free_symbols, key=str) if s in drawn]
    for symbol, condition in pairs[:MOST_COMPARED]:
        limits = {abs(Fraction(str(n))) for n in condition.atoms(Rational)} - {0}
        sizes = [Fraction(0), *(n * k for n in sorted(limits) for k in (1, 2, Fraction(1, 2)))]
        signs = (1,) if symbol.is_nonnegative else (-1,) if symbol.is_negative else (1, -1)
        for sign, size in product(signs, sizes[:MOST_COMPARED]):
            if size or not (symbol.is_positive or symbol.is_negative):
                yield {**drawn, symbol: Fraction(float(sign * size))}


def _kept(function: Callable[..., Any], given: Given) -> dict[Expr, Any]:
    """Defaults of arguments, as they are: integers make arrays of integers."""
    parameters = inspect.signature(function).parameters
    found = {value: parameters[n].default for n, value in given.items() if isinstance(value, Expr)}
    return {s: v for s, v in found.items() if type(v) in (int, float) and isfinite(v)}


def _at_kept(
    symbols: Sequence[Value], program: _Program, kept: Mapping[Expr, Any]
) -> _Formulas | None:
    """Formulas at a state with the person's own numbers."""
    numbers = {**_drawn(symbols, Random(0), Fraction(1))}
    numbers.update((s, Fraction(v)) for s, v in kept.items() if isinstance(s, Symbol))
    return _formulas(program, numbers, ROUNDED)


def symbols_in(formulas: Iterable[Expr]) -> list[Expr]:
    """Their symbols, by name."""
    symbols = set().union(*(formula.free_symbols for formula in formulas))
    return sorted(symbols, key=str)


def value_of(formula: Expr, numbers: Numbers) -> float:
    """What a number that the code holds is at a state."""
    if isinstance(formula, Symbol):
        return float(numbers[formula])
    table = {s: Rational(n.numerator, n.denominator) for s, n in numbers.items()}
    return float(formula.xreplace(table))


def _drawn(values: Sequence[Value], source: Random, scale: Fraction) -> Numbers:
    """A state of numbers that are exact in single precision and no integers."""
    symbols: dict[Expr, None] = {}
    for value in values:
        symbols.update(dict.fromkeys([value] if isinstance(value, Expr) else value))
    found: dict[Symbol, Fraction] = {}
    for symbol in symbols:
        size = Fraction(source.randrange(301, 3001, 2), 1024)
        if symbol.is_nonnegative:
            found[symbol] = size
        else:
            sign = -1 if symbol.is_negative or source.random() < 0.5 else 1
            found[symbol] = sign * scale * size
    return found


def program_of(outputs: Outputs) -> _Program:
    """What code decides upon and computes, to be enclosed at states."""
    truths = [Piecewise((S.One, condition), (S.Zero, True)) for condition in outputs.conditions]
    values = [entry for matrix in outputs.values for entry in matrix]
    return _Program(formulas_of(truths), formulas_of(values), outputs.conditions)


def _holds(truth: arb) -> bool | None:
    """Whether a condition holds; None where that cannot be told."""
    return bool(truth == 1) if truth.is_finite() else None


def _formulas(program: _Program, numbers: Numbers, rounded: int) -> _Formulas | None:
    """Values of all formulas; None where one has no value, or none that a float holds.

    A ball's radius is what rounding to `BITS` digits does to the formula, hence grows by as many
    powers of two as digits are fewer.
    """
    balls = program.values.at(numbers, BITS)
    values = [float(ball.mid()) if ball.is_finite() else inf for ball in balls]
    grown = [float(ball.rad()) * 2.0 ** (BITS - rounded) for ball in balls]
    if not all(isfinite(number) for number in (*values, *grown)):
        return None
    largest = max((float(abs(number)) for number in numbers.values()), default=0.0)
    slack = [r + 2.0**-rounded * max(abs(v), largest) for v, r in zip(values, grown, strict=True)]
    return _Formulas(numbers, tuple(values), tuple(slack))


ASKED = frozenset(("isinstance", "type", "hasattr", "getattr", "__class__", "issubclass"))
"""Names by which code asks of which kind an array is."""


def _asks_kinds(function: Callable[..., Any]) -> bool:
    """Whether a function, or one of its file that it may call, asks of which kind something is."""
    inner = inspect.unwrap(getattr(function, "__func__", function))
    todo, seen = [inner], set[int]()
    while todo:
        one = todo.pop()
        code = getattr(one, "__code__", None)
        if code is None or id(code) in seen:
            continue
        seen.add(id(code))
        words = {*words_in(code)}
        if words & ASKED:
            return True
        around = getattr(one, "__globals__", {})
        known = (around[word] for word in sorted(words & around.keys()))
        todo += [f for f in known if getattr(f, "__module__", None) == inner.__module__]
    return False


class _Failed(Exception):
    """A call of the person's code ended with an error; at another state it may have a value."""

    def __init__(self, error: BaseException) -> None:
        super().__init__(f"{type(error).__name__}: {' '.join(str(error).split())}")
        self.excused = isinstance(error, ArithmeticError | ValueError | AssertionError)


def _attempt(
    function: Callable[..., Any], given: Given, formulas: _Formulas, kind: type[float],
    kept: Mapping[Expr, Any] = NONE, *, sequence: type | None = None,
) -> list[float] | _Failed:  # fmt: skip
    """What a call returns, or how it failed; `kept` numbers are passed as they are."""
    try:
        return _returned(function, given, formulas, kind, kept, sequence=sequence)
    except _Failed as failed:
        return failed


def _returned(
    function: Callable[..., Any], given: Given, formulas: _Formulas, kind: type[float],
    kept: Mapping[Expr, Any], *, sequence: type | None = None,
) -> list[float]:  # fmt: skip
    """What a call returns as one list."""

    def number(symbol: Expr) -> Any:
        return kept[symbol] if symbol in kept else kind(formulas.numbers[symbol])

    arguments = {name: _filled(value, number) for name, value in given.items()}
    if sequence is not None:
        arguments = {n: sequence(v.tolist()) if isinstance(v, np.ndarray) else v
                     for n, v in arguments.items()}  # fmt: skip
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            found = [np.asarray(part, dtype=float) for part in parts_of(function(**arguments))]
        numbers = [float(number) for part in found for number in part.flat]
    except (Exception, SystemExit, GeneratorExit) as error:
        raise _Failed(error) from error
    if not all(isfinite(number) for number in numbers):
        raise _Failed(ArithmeticError("what it returns is not finite"))
    return numbers


def _filled(value: Value, number: Callable[[Expr], float]) -> Any:
    """An argument with numbers in place of symbols."""
    if isinstance(value, Expr):
        return number(value)
    if isinstance(value, Record):
        return value.filled(number)
    return np.array([float(number(entry)) for entry in value])


def _differs(result: list[float], formulas: _Formulas) -> str:
    """How numbers are not those of the formulas; empty where they are."""
    if len(result) != len(formulas.values):
        return (
            f"called with numbers it returns {len(result)} of them, traced it returns"
            f" {len(formulas.values)}"
        )
    rows = zip(result, formulas.values, formulas.slack, strict=True)
    for place, (number, value, slack) in enumerate(rows, 1):
        if abs(number - value) > slack:
            return (
                f"called with numbers it returns other values than its formulas: output {place} is"
                f" {number:.6g}, its formula {value:.6g}, at {formulas.where}"
            )
    return ""
