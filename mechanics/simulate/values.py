"""What a person sets, by name: initial values, parameters and inputs, read into arrays.

Every mistake is an `InputError` that says what was found and which names there are.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Rational, Symbol, sympify

from mechanics.compiled.quantities import Quantity, typical_value
from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS, name_of
from mechanics.scene.validity import condition_parameters
from mechanics.simulate.consistent import Suggestion
from mechanics.simulate.feedback import Feedback

Array = NDArray[np.float64]
Signal = Callable[[float, Array | None], float]
"""Of time, and of the state where it is known."""
Given = Mapping[str, float]


def read_initial(scene: Scene, given: Given) -> tuple[Suggestion, Suggestion]:
    """Coordinates and speeds: as given, else as the scene's example has them, else zero.

    A quaternion is given as a whole, what is left out zero, and is divided by its norm.
    """
    q, u = (tuple(s.name for s in group) for group in (scene.q, scene.u))
    _known("initial value", given, (*q, *u), "coordinates and speeds")
    numbers = {name: _number(f"initial value {name}", value) for name, value in given.items()}

    values = {name: float(value) for name, value in scene.example.items()} | numbers
    asked, kept = {*numbers}, {*numbers, *(s.name for s in scene.quaternions)}
    # A wheel whose example rolls does not stand still because its road is named before its turn.
    kept |= {*u} & {*scene.example}
    for rotation in scene.rotations:
        own = [name_of(coordinate) for coordinate in rotation.coordinates]
        told = numbers if numbers.keys() & set(own) else values
        parts = [told.get(name, 0.0) for name in own]
        norm = math.hypot(*parts)
        if not norm > 0:
            raise InputError(
                f"initial values {rotation.name}: a quaternion of norm {norm:g} is no orientation:"
                f" give numbers that are not all zero, as in {own[0]}=1"
            )
        values |= {name: part / norm for name, part in zip(own, parts, strict=True)}
        if told is numbers:
            asked |= {*own}

    def suggested(names: tuple[str, ...]) -> Suggestion:
        found = np.array([values.get(name, 0.0) for name in names])
        flags = (tuple(name in group for name in names) for group in (asked, kept))
        return Suggestion(names, found, *flags)

    return suggested(q), suggested(u)


def read_parameters(
    entries: Sequence[Quantity], definitions: Mapping[Symbol, Expr], given: Given
) -> Array:
    """Parameters in the model's order: as given, else defined by others, else typical.

    Raises
    ------
    ValueMissingError
        For a parameter that has none of these.
    """
    free = {s for e in definitions.values() for s in sympify(e).free_symbols}
    names = {entry.name for entry in entries} | {s.name for s in (*definitions, *free)}
    _known("parameter", given, sorted(names), "parameters")
    numbers = {name: _number(f"parameter {name}", value) for name, value in given.items()}
    symbols = {s.name: s for s in (*(e.symbol for e in entries), *definitions, *free)}
    for name, value in numbers.items():
        if symbols[name].is_positive and value < 0:
            raise InputError(f"parameter {name}: {value:g} is negative: it is declared positive")
    # A given value overrules a definition, and counts in the definitions that use it.
    table = {**definitions, **{symbols[n]: Rational(v) for n, v in numbers.items()}}
    return np.array([typical_value(entry.symbol, table) for entry in entries])


def for_equations(scene: Scene, given: Given) -> dict[str, float]:
    """Values for parameters of the equations, without those that only conditions use."""
    own = {symbol.name for symbol in condition_parameters(scene)}
    return {name: value for name, value in given.items() if name not in own}


@dataclass(frozen=True)
class Signals:
    """Inputs as functions of time and state, for the symbols of them and of their rates."""

    functions: tuple[Signal, ...]

    def __call__(self, t: float, state: Array | None = None) -> Array:
        """Their values at a time, and at a state (q, u), which feedback needs."""
        return np.array([function(t, state) for function in self.functions], dtype=float)


def read_inputs(scene: Scene, symbols: Sequence[Symbol], given: Mapping[str, Any]) -> Signals:
    """Signals for `symbols`, which are inputs, their rates, and time.

    An input that is not given is zero. The rates of an input that is given as a function of time
    have to be given too, where they are needed: ``{"f": sin, "f_dot": cos}``. An input that is a
    `Feedback` is a function of the state, too.
    """
    bases = [symbol.name for symbol in scene.input_symbols]
    orders = {base + dots: (base, i) for base in bases for i, dots in enumerate(DOTS)}
    _known("input", given, list(orders), "inputs and their rates")
    n = len(scene.q)
    signals = {name: _signal(name, value, n) for name, value in given.items()}

    def signal(symbol: Symbol) -> Signal:
        if symbol == TIME:
            return _time
        if symbol.name in signals:
            return signals[symbol.name]
        base, order = orders[symbol.name]
        if order and callable(given.get(base)):
            raise InputError(
                f"input {base} is given as a function and its rate {symbol.name} is needed:"
                " give that function too"
            )
        return _zero

    return Signals(tuple(signal(symbol) for symbol in symbols))


def _zero(t: float, state: Array | None) -> float:
    return 0.0


def _time(t: float, state: Array | None) -> float:
    return t


def _signal(name: str, value: Any, n: int) -> Signal:
    if isinstance(value, Feedback):
        return partial(_fed_back, name, value, n)
    if callable(value):
        return lambda t, state: float(value(t))
    constant = _number(f"input {name}", value)
    return lambda t, state: constant


def _fed_back(name: str, law: Feedback, n: int, t: float, state: Array | None) -> float:
    if state is None:
        raise InputError(
            f"input {name}: it is fed back from the state, and a function of time is needed here:"
            " a constraint that it moves, or the error of a choice of integrators"
        )
    return law(t, state[:n], state[n:])


def _known(kind: str, given: Mapping[str, Any], names: Sequence[str], group: str) -> None:
    for name in given:
        if name not in names:
            there = instead(name, names, group)
            raise InputError(f"{kind} {name!r}: the scene has no such name: {there}")


def _number(what: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{what}: {value!r} is no number") from None
    if not math.isfinite(number):
        raise InputError(f"{what}: {value!r} is not finite")
    return number
