"""What the arguments of code are: a name of the scene, or a vector of them.

f(x, theta, x_dot, theta_dot, F)        f(q, qd, u)        f(t, state, params)        p["m"]
"""

import re
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from mechanics.claims.code.integrators import ELSE_NAMES, STEP
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.unpacking import Apart, Diagonal, Record
from mechanics.claims.kinds import angular
from mechanics.claims.names import Match, Naming
from mechanics.claims.scaled_names import another_quantity
from mechanics.claims.spelled_rates import bases, key
from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.rates import TIME, rate_table
from mechanics.scene.symbols import DOTS

STATES = ("state", "states", "y", "z", "s", "x", "X", "Y", "xs")
POSITIONS = ("q", "qs", "pos", "positions", "coordinates")
SPEEDS = ("u", "v", "qd", "dq", "qdot", "q_dot", "vel", "velocities", "velocity", "speeds", "w")
ACCELERATIONS = ("a", "ud", "qdd", "ddq", "qddot", "q_ddot", "acc", "accelerations", "udot")
INPUTS = ("u", "f", "F", "force", "tau", "torque", "action", "control", "inputs", "r")
OF_TIME = "_of_time"
"""Ends the name of a function that is called with the time: an input."""
PARAMETERS = ("p", "params", "parameters", "args", "constants")

SPEED = re.compile(r"(?:omega|Omega|w|om)_?(?P<number>\d*)")
"""What an angular speed is called."""

NUMBER = re.compile(r"\d+$")
BY_NAMES = "the names that the code gives its entries"
SAID = ("as given", BY_NAMES)
MOST = 6
"""Names that a message tells."""
TENSORS = ("I", "J", "Inertia", "inertia")
AXES = 3
"""Principal ones."""


class UnexplainedError(InputError):
    """An argument is none of the scene's."""


Value = Any
"""A symbol, or a tuple of them."""


Groups = tuple[tuple[Sequence[str], Sequence[Expr]], ...]
"""Usual names of a vector, and its entries."""


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


USUAL = "the usual name of such a vector"
GUESSED_ORDER = "its order a guess"
"""Of the entries of an argument, where nothing but the scene says it."""


def arguments_of(
    naming: Naming,
    names: Sequence[str],
    sizes: Mapping[str, int | None],
    given: Mapping[str, str],
    interleaved: bool = False,
    apart: Mapping[str, Apart] | None = None,
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
    apart : mapping of str to Apart, optional
        How the code takes them apart.

    Raises
    ------
    UnexplainedError
        For an argument that nothing explains.
    """
    scene = naming.vocabulary.scene
    told = {n: m for n, m in given.items() if naming.vocabulary.target(m) is not None}
    aware = replace(naming, given={**naming.given, **told})
    # x[2] is no coordinate x, whatever the scene calls x.
    parted = {n for n, known in (apart or {}).items() if known.vector or (known.size or 0) > 1}
    vectors = [n for n in names if n not in given and (n in parted or not naming.knows(n))]
    groups = _groups(scene, names, vectors, sizes, interleaved)
    values: dict[str, Value] = {}
    matches: list[Match] = []
    state: tuple[Expr, ...] = ()
    own = {naming.symbol(n, 0) for n in names if n not in parted and naming.knows(n)}
    own |= {
        TIME if w == "t" else naming.symbol(w, 0) for n in names for w in _words(given.get(n, ""))
    }
    used = {k for k, (_, symbols) in enumerate(groups) if symbols and own.issuperset(symbols)}
    unexplained: list[str] = []
    for name in names:
        if name in given:
            values[name] = _given(naming, name, given[name], sizes.get(name))
            why = "as given"
        elif name in ("t", "time") and not naming.knows(name):
            values[name], why = TIME, "the time"
        elif name in STEPS and not naming.knows(name) and name not in parted:
            values[name], why = STEP, "the time of a step"
        elif known := named_entries(aware, name, (apart or {}).get(name)):
            values[name], why = known, BY_NAMES
        elif tensor := _inertia(naming, name, (apart or {}).get(name)):
            values[name], why = tensor, f"the inertia about principal axes, {GUESSED_ORDER}"
        elif naming.knows(name) and sizes.get(name) in (None, 1) and name not in parted:
            symbol = naming.symbol(name, 0)
            values[name], why = symbol, naming.matches([name])[0].why
        else:
            group = _group(name, sizes.get(name), groups, used)
            if group is None and name in ELSE_NAMES:
                group = STEP, "the time of a step: no input of this name is left", -1
            if group is None and (speed := _speed(naming, name, own)) is not None:
                group = (
                    speed,
                    f"the rate of {speed.name.removesuffix(DOTS[1])}, of the same number",
                    -1,
                )
            rates = _rates(scene, name, values, state)
            if group is None and rates and sizes.get(name) in (None, len(rates)):
                group = rates, "the rates of a state, by its name", -1
            if group is None and len(scene.q) == 1 and name in parted and naming.knows(name):
                # Of one coordinate all that a vector of its name can begin with.
                group = naming.symbol(name, 0), "a vector of one entry", -1
            if group is None:
                unexplained.append(name)
                continue
            values[name], why, k = group
            used.add(k)
            if name in parted and isinstance(values[name], Expr):
                values[name] = (values[name],)
        found = values[name]
        entries = (found,) if isinstance(found, Expr) else tuple(found)
        if {*entries} & {*scene.q} and {*entries} & {*scene.u}:
            state = entries
        if {*scene.u} < {*entries} <= {*scene.u, *scene.parameters}:
            state = entries  # speeds, and what is held
        if name in parted and why not in SAID and contradicted(naming, apart, name, entries):
            unexplained.append(name)
            continue
        matches.append(Match(name, " ".join(str(entry) for entry in entries), why))
    if unexplained:
        raise UnexplainedError(_unexplained(naming, unexplained, apart or {}))
    own_values = {n: v for n, v in values.items() if not {*entries_of(v)} & {*scene.ud}}
    _refuse_twice(own_values, given)  # rates of a state have its speeds
    _refuse_orders(scene, values, given)
    return Arguments(values, state, tuple(matches))


def places_of_vectors(scene: Scene, arguments: Arguments) -> tuple[int, ...]:
    """Where the scene has the coordinates that one argument holds; empty for its own order.

    Parameters
    ----------
    scene : Scene
    arguments : Arguments
    """
    own = list(scene.q)
    held = (entries_of(value) for value in arguments.values.values())
    found = next((e for e in held if len(e) > 1 and {*e} == {*own}), tuple(own))
    places = tuple(own.index(entry) for entry in found)
    aligned = len(own) == len(scene.u) and {rate_table(scene)[q] for q in own} == {*scene.u}
    return places if aligned and places != tuple(range(len(own))) else ()


def entries_of(value: Value) -> tuple[Expr, ...]:
    """The symbols of an argument, one or several."""
    return (value,) if isinstance(value, Expr) else tuple(value)


def state_is_stated(arguments: Arguments) -> bool:
    """Whether somebody says what the entries of the state are."""
    words = " ".join(map(str, arguments.state))
    return any(m.meaning == words and m.why in SAID for m in arguments.matches)


def _refuse_twice(values: Mapping[str, Value], given: Container[str]) -> None:
    """Refuse two arguments that are taken for one number: accel(s, r) of two states.

    Raises
    ------
    InputError
    """
    owner: dict[Expr, str] = {}
    for name, value in values.items():
        for entry in entries_of(value):
            other = owner.setdefault(entry, name)
            if (
                other != name
                and entry not in (TIME, STEP)
                and not (name in given and other in given)
            ):
                raise InputError(
                    f"the arguments {other} and {name} are both read as {entry}: say what they"
                    f" are, --name '{name}=...' (names={{'{name}': ...}})"
                )


def _refuse_orders(scene: Scene, values: Mapping[str, Value], given: Container[str]) -> None:
    """Refuse coordinates in one order and their rates in another: th2, th1 = q; w1, w2 = qd.

    Raises
    ------
    InputError
    """
    place = {s: k for group in (scene.q, scene.u, scene.ud) for k, s in enumerate(group)}
    orders: dict[tuple[int, ...], str] = {}
    for name, value in values.items():
        entries = entries_of(value)
        order = tuple(place.get(entry, -1) for entry in entries)
        if sorted(order) != [*range(len(scene.q))] or len(order) < 2 or name in given:
            continue
        other = orders.setdefault(order, name)
        if len(orders) > 1 and other == name:
            first = next(iter(orders.values()))
            held = " ".join(map(str, entries_of(values[first])))
            raise InputError(
                f"the argument {first} is {held} and {name} is {' '.join(map(str, entries))}: say"
                f" in which order they are, --name '{name}=...' (names={{'{name}': ...}})"
            )


RATE = re.compile(r"(?P<of>\w+?)(?:_?dot|p|_?prime)|d(?P<after>[A-Za-z]+?)(?:_?dt)?")
"""What the rates of a vector are called: zdot, yp, dx, dxdt."""


def _rates(
    scene: Scene, name: str, values: Mapping[str, Value], state: tuple[Expr, ...]
) -> tuple[Symbol, ...]:
    """The rates of a state that is an argument, too: ``f(t, y, yp)``; empty for other names."""
    found = RATE.fullmatch(name)
    of = values.get(found["of"] or found["after"]) if found else None
    table = rate_table(scene)
    if not state or of is None or isinstance(of, Expr) or tuple(of) != state:
        return ()
    rates = tuple(one for s in state if isinstance(one := table.get(s), Symbol))
    return rates if len(rates) == len(state) else ()


def _inertia(naming: Naming, name: str, apart: Apart | None) -> Diagonal | None:
    """A matrix I of three entries, where the scene has three moments of inertia."""
    if apart is None or not apart.matrix or name not in TENSORS or naming.knows(name):
        return None
    own = [p for p in naming.vocabulary.scene.parameters if getattr(p, "unit", "") == "kg*m^2"]
    return Diagonal((), tuple(own), False) if len(own) == AXES else None


def vectors_of_motion(naming: Naming, names: Sequence[str]) -> frozenset[str]:
    """Arguments that are all coordinates, all speeds or all accelerations: ``f(q, qd, qdd)``.

    None where a coordinate is an argument by its own name, or there is only one.
    """
    scene = naming.vocabulary.scene
    own = {str(q) for q in scene.q}
    if len(scene.q) < 2 or any((found := naming.lookup(n)) and found[0] in own for n in names):
        return frozenset()
    usual = {*POSITIONS, *SPEEDS, *ACCELERATIONS}
    return frozenset(n for n in names if n in usual) if {*names} & {*POSITIONS} else frozenset()


def _groups(
    scene: Scene, names: Sequence[str], vectors: Sequence[str], sizes: Mapping[str, int | None],
    interleaved: bool,
) -> Groups:  # fmt: skip
    """What vectors of these usual names are."""
    both: list[Expr] = [*scene.q, *scene.u]
    if interleaved:
        both = [symbol for pair in zip(scene.q, scene.u, strict=True) for symbol in pair]
    groups: Groups = (
        (POSITIONS, scene.q), (SPEEDS, scene.u), (STATES, both), (ACCELERATIONS, scene.ud),
        (INPUTS, scene.input_symbols), (PARAMETERS, scene.parameters),
    )  # fmt: skip
    whole = [n for n in vectors if n in STATES and sizes.get(n) in (None, len(both))]
    if whole and not any(n in POSITIONS for n in names):
        # Beside a whole state, u is no vector of speeds.
        groups = tuple(group for group in groups if group[0] is not SPEEDS)
    return groups


def _words(meaning: str) -> list[str]:
    """Names that are given for one argument."""
    return meaning.replace(",", " ").split()


def _given(naming: Naming, name: str, meaning: str, size: int | None) -> Value:
    found: list[Expr] = []
    for word in _words(meaning):
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


def named_entries(naming: Naming, name: str, apart: Apart | None) -> Value:
    """What the entries of an argument are by the names that code has for them; () if not plain.

    Raises
    ------
    InputError
        For a key or an attribute that the scene does not have.
    """
    if apart is None:
        return ()
    attributes = {a: line for a, line in apart.attributes.items() if not hasattr(np.ndarray, a)}
    known = [a for a in attributes if naming.knows(a)]
    if asked := apart.keys or (apart.attributes if known and not apart.places else {}):
        symbols = [naming.symbol(e, 0) if naming.knows(e) else None for e in asked]
        strange = [e for e, symbol in zip(asked, symbols, strict=True) if symbol is None]
        if strange:
            places = (f'{name}["{e}"]' if apart.keys else f"{name}.{e}" for e in strange)
            where = (f"{p} in line {asked[e]}" for p, e in zip(places, strange, strict=True))
            raise InputError(
                f"{', '.join(where)}: the scene has no {', '.join(map(repr, strange))}: say what"
                f" {'it is' if len(strange) == 1 else 'they are'}: {_options(naming, strange)}"
            )
        return Record(tuple(asked), tuple(symbols), not apart.keys)
    found = _with_rates([naming.lookup(entry) for entry in apart.order])
    if None in found:
        found = _by_spelling(naming, apart.order)
    if len(found) < 2 or None in found or len(set(found)) < len(found):
        return ()
    bases = {target[0] for target in found if target is not None}
    inputs = {symbol.name for symbol in naming.vocabulary.scene.input_symbols}
    constants = naming.vocabulary.constants
    moving = naming.vocabulary.functions.keys() - inputs
    known_entries = tuple(
        constants[target[0]] if target[0] in constants
        else Symbol(target[0] + DOTS[target[1]], real=True)
        for target in found if target is not None
    )  # fmt: skip
    scene = naming.vocabulary.scene
    whole = set(known_entries) >= {*scene.q, *scene.u}
    alike = bases <= inputs | constants.keys() or bases <= moving
    if not (apart.fields or whole or alike):
        return ()  # q, u = z takes a state apart, whatever the scene calls q and u
    return known_entries


def _with_rates(found: Sequence[tuple[str, int] | None]) -> list[tuple[str, int] | None]:
    """``theta, theta_, x, x_ = y``: where each name is there twice, the second one is the rate."""
    if None in found or any(found.count(target) != 2 for target in found):
        return list(found)
    return [
        target if target is None or k == found.index(target) else (target[0], target[1] + 1)
        for k, target in enumerate(found)
    ]


def _by_spelling(naming: Naming, order: Sequence[str]) -> list[tuple[str, int] | None]:
    """``th1, th1d, th2, th2d = y``: names of a state of which some are the rates of others.

    Those that are no name of the scene are its coordinates of the same number, or the one left.
    """
    keys = {key(name): name for name in order}
    rate_of = {
        name: keys[base]
        for name in order
        for base, dots in bases(name) if dots == 1 and base in keys and keys[base] != name
    }  # fmt: skip
    numbers = {
        n[0]: name for name in order if not SPEED.fullmatch(name) and (n := NUMBER.search(name))
    }
    for name in order:
        speed = SPEED.fullmatch(name)
        if speed and name not in rate_of and speed["number"] in numbers:
            rate_of[name] = numbers[speed["number"]]
    first = [name for name in order if name not in rate_of]
    coordinates = [q.name for q in naming.vocabulary.scene.q]
    if len(first) != len(coordinates) or {*rate_of.values()} != {*first}:
        return []
    meant: dict[str, str] = {}
    for name in first:
        target = naming.lookup(name)
        number = NUMBER.search(name)
        fits = [q for q in coordinates if number and q.endswith(number[0])]
        if target is not None and target[1] == 0 and target[0] in coordinates:
            meant[name] = target[0]
        elif target is None and len(fits) == 1:
            meant[name] = fits[0]
    left = [name for name in first if name not in meant]
    free = [q for q in coordinates if q not in meant.values()]
    if len(left) == len(free) == 1:
        meant[left[0]] = free[0]
    return [
        (meant[name], 0) if name in meant else (meant[rate_of[name]], 1)
        if rate_of.get(name) in meant else None
        for name in order
    ]  # fmt: skip


def contradicted(
    naming: Naming, apart: Mapping[str, Apart] | None, name: str, entries: Sequence[Expr]
) -> bool:
    """Whether the code calls an entry by the name of another coordinate or input, or a momentum."""
    momenta = {symbol.name for symbol in momentum_symbols(naming.vocabulary.scene)}
    moving = {*naming.vocabulary.scene.q, *naming.vocabulary.scene.input_symbols}
    known = (apart or {}).get(name)
    for place, names in known.places.items() if known else ():
        meant = {naming.symbol(n, 0) for n in names if naming.knows(n)} & moving
        if meant and place < len(entries) and entries[place] not in meant:
            return True
        impulses = [n for n in names if not naming.knows(n) and naming.vocabulary.momentum(n)]
        if impulses and not momenta & {str(entry) for entry in entries[place : place + 1]}:
            return True
    return False


def _group(
    name: str, size: int | None, groups: Groups, used: set[int]
) -> tuple[Value, str, int] | None:
    """The vector that an argument's name stands for, if that group is not taken already."""
    for k, (words, symbols) in enumerate(groups):
        fits = size is None or size == len(symbols)
        usual = name in words or (words is INPUTS and name.endswith(OF_TIME))
        if usual and symbols and fits and k not in used:
            scalar = words is INPUTS and len(symbols) == 1 and size in (None, 1)
            value: Value = symbols[0] if scalar else tuple(symbols)
            why = USUAL
            if words in (INPUTS, PARAMETERS) and not scalar and not _numbered(symbols):
                order = " ".join(str(symbol) for symbol in symbols)
                why = f"{why}, {GUESSED_ORDER}: --name '{name}={order}' gives it"
            return value, why, k
    return None


def _numbered(symbols: Sequence[Expr]) -> bool:
    """Whether names say their order: tau1, tau2, or one alone."""
    ends = [NUMBER.search(str(symbol)) for symbol in symbols]
    return len(ends) == 1 or [int(e[0]) for e in ends if e] == [*range(1, len(ends) + 1)]


def _speed(naming: Naming, name: str, own: Container[Expr | None]) -> Symbol | None:
    """The rate of an angle of the same number, which is an argument, too: omega1 beside theta1."""
    part = SPEED.fullmatch(name)
    scene = naming.vocabulary.scene
    turning = angular(scene) if part else set()
    found = [q for q in scene.q if q in turning and q in own]
    if part and part["number"]:
        found = [q for q in found if key(q.name).endswith(part["number"])]
    rates = [Symbol(q.name + DOTS[1], real=True) for q in found]
    return rates[0] if len(rates) == 1 and rates[0] not in own else None


def _unexplained(naming: Naming, names: Sequence[str], apart: Mapping[str, Apart]) -> str:
    """What to say of arguments that nothing explains: all of them, and the options that do."""
    asked: list[str] = []
    wanted: list[str] = []
    for name in names:
        attributes = list(apart[name].attributes)[:MOST] if name in apart else []
        asked += [f"{name}.{entry}" for entry in attributes] or [name]
        wanted += attributes or [name]
    said = [f"{n} says '{word}'" for n in wanted if (word := another_quantity(n))]
    if said:
        return (
            f"argument{'s' * (len(said) > 1)} {', '.join(said)}, which no name of the scene does:"
            f" it is not guessed: {_options(naming, wanted)}"
        )
    many, are = ("", "it is") if len(asked) == 1 else ("s", "they are")
    return (
        f"argument{many} {', '.join(asked)}: nothing says what {are}: give, several names for a"
        f" vector, {_options(naming, wanted)}"
    )


def _options(naming: Naming, names: Sequence[str]) -> str:
    """What says what names are, and which names the scene has."""
    known = ", ".join([*naming.vocabulary.functions, *naming.vocabulary.constants])
    options = " ".join(f"--name '{name}=...'" for name in names)
    table = ", ".join(f"{name!r}: ..." for name in names)
    return f"{options} (names={{{table}}}); the scene has {known}"
