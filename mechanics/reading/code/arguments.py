"""What the arguments of code are: a name of the scene, or a vector of them.

f(x, theta, x_dot, theta_dot, F)        f(q, qd, u)        f(t, state, params)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Symbol

from mechanics.errors import InputError
from mechanics.reading.names import Match, Naming
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS

STATES = ("state", "states", "y", "z", "s", "x", "X", "Y", "xs")
POSITIONS = ("q", "qs", "pos", "positions", "coordinates")
SPEEDS = ("u", "v", "qd", "dq", "qdot", "q_dot", "vel", "velocities", "speeds", "w")
ACCELERATIONS = ("a", "ud", "qdd", "ddq", "qddot", "q_ddot", "acc", "accelerations", "udot")
INPUTS = ("u", "f", "F", "force", "tau", "torque", "action", "control", "inputs", "r")
PARAMETERS = ("p", "params", "parameters", "args", "theta", "constants")

Value = Any
"""A symbol, or a tuple of them."""


@dataclass(frozen=True)
class Arguments:
    """What every argument is.

    Attributes
    ----------
    values : dict of str to symbol or symbols
    state : tuple of Symbol
        Entries of the argument that holds q and u together; empty where there is none.
    matches : tuple of Match
    """

    values: dict[str, Value]
    state: tuple[Expr, ...]
    matches: tuple[Match, ...]


def arguments_of(
    naming: Naming,
    names: Sequence[str],
    sizes: Mapping[str, int | None],
    given: Mapping[str, str],
    interleaved: bool = False,
) -> Arguments:
    """Match arguments.

    Parameters
    ----------
    naming : Naming
    names : sequence of str
    sizes : mapping of str to int or None
        Number of entries where that is known; None where it is not.
    given : mapping of str to str
        By the person; several names of the scene are separated by blanks.
    interleaved : bool
        Whether a state is x, x_dot, theta, theta_dot, ...

    Raises
    ------
    InputError
        For an argument that nothing explains.
    """
    scene = naming.vocabulary.scene
    both: list[Expr] = [*scene.q, *scene.u]
    if interleaved:
        both = [symbol for pair in zip(scene.q, scene.u, strict=True) for symbol in pair]
    groups: tuple[tuple[Sequence[str], Sequence[Expr]], ...] = (
        (POSITIONS, scene.q), (SPEEDS, scene.u), (STATES, both), (ACCELERATIONS, scene.ud),
        (INPUTS, scene.input_symbols), (PARAMETERS, scene.parameters),
    )  # fmt: skip
    values: dict[str, Value] = {}
    matches: list[Match] = []
    state: tuple[Expr, ...] = ()
    used: set[int] = set()
    for name in names:
        if name in given:
            values[name] = _given(naming, name, given[name], sizes.get(name))
            why = "as given"
        elif name in ("t", "time") and not naming.knows(name):
            values[name], why = TIME, "the time"
        elif naming.knows(name) and sizes.get(name) in (None, 1):
            symbol = naming.symbol(name, 0)
            values[name], why = symbol, naming.matches([name])[0].why
        else:
            values[name], why, k = _group(naming, name, sizes.get(name), groups, used)
            used.add(k)
        found = values[name]
        entries = found if isinstance(found, tuple) else (found,)
        if set(entries) == {*scene.q, *scene.u} and len(entries) > 1:
            state = entries
        matches.append(Match(name, " ".join(str(entry) for entry in entries), why))
    return Arguments(values, state, tuple(matches))


def _given(naming: Naming, name: str, meaning: str, size: int | None) -> Value:
    words = meaning.replace(",", " ").split()
    found: list[Expr] = []
    for word in words:
        target = naming.vocabulary.lookup(word)
        if target is None and word != "t":
            raise InputError(f"argument {name}={meaning}: the scene has no {word!r}")
        base, order = target or ("t", 0)
        constants = naming.vocabulary.constants
        symbol = Symbol(base + DOTS[order], real=True)
        found.append(TIME if word == "t" else constants.get(base, symbol))
    if size is not None and size != len(found):
        raise InputError(f"argument {name} has {size} entries, {len(found)} names are given")
    return tuple(found) if len(found) > 1 or (size or 0) > 1 else found[0]


def _group(
    naming: Naming, name: str, size: int | None,
    groups: Sequence[tuple[Sequence[str], Sequence[Expr]]], used: set[int],
) -> tuple[Value, str, int]:  # fmt: skip
    """The vector that an argument's name stands for, if that group is not taken already."""
    for k, (words, symbols) in enumerate(groups):
        fits = size is None or size == len(symbols)
        if name in words and symbols and fits and k not in used:
            scalar = words is INPUTS and len(symbols) == 1 and size in (None, 1)
            value: Value = symbols[0] if scalar else tuple(symbols)
            return value, "the usual name of such a vector", k
    known = ", ".join([*naming.vocabulary.functions, *naming.vocabulary.constants])
    raise InputError(
        f"argument {name}: nothing says what it is: give names={{{name!r}: ...}}; the scene has"
        f" {known}"
    )
