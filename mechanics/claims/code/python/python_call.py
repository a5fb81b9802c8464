"""Which arguments of a Python function are symbols, and which numbers that it holds are.

def f(t, z, m=2.0, g=9.81, tol=1e-9)    ->    t, z, m, g        m and g are names of the scene
"""

import inspect
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from math import isfinite
from types import CodeType
from typing import Any

import numpy as np
from sympy import Expr, Rational

from mechanics.claims.code.arguments import named_entries
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.python.changed_numbers import changed
from mechanics.claims.code.python.closure_numbers import called_by, held, owner_of
from mechanics.claims.code.python.computed_numbers import derived
from mechanics.claims.code.python.containers import is_number
from mechanics.claims.code.python.objects import attributes
from mechanics.claims.code.python.wrappers import filled
from mechanics.claims.code.unpacking import Apart, in_python
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import key
from mechanics.errors import InputError

MOST = 8
"""Numbers that are told."""


class Unsaid(float):
    """A number that an object is made with because it wants one: a parameter stands for it.

    `name` is that of the argument; what is computed from such numbers has none.
    """

    name = ""


def _computed(operator: str) -> Callable[..., Any]:
    def apply(self: Unsaid, *others: Any) -> Any:
        found = getattr(float, operator)(self, *others)
        return Unsaid(found) if isinstance(found, float) else found

    return apply


for _operator in ("add", "sub", "mul", "truediv", "pow"):
    for _name in (f"__{_operator}__", f"__r{_operator}__"):
        setattr(Unsaid, _name, _computed(_name))


@dataclass(frozen=True)
class Signature:
    """How a function is called.

    Attributes
    ----------
    wanted : tuple of str
        Arguments that are symbols.
    apart : dict of str to Apart
    returned : tuple of str
        Names of what it returns, where it has some.
    standing : dict of str to Expr
        What numbers stand for that it holds besides.
    steps : dict of str to Expr
        Numbers that may be the time of a step, ``dt = 0.01``.
    remarks : tuple of str
    text : str
        Of the function, where it is at hand.
    own : dict of Expr to Rational
        Its numbers for parameters, where others of its names stay numbers: these may be made of
        them.
    """

    wanted: tuple[str, ...]
    apart: dict[str, Apart]
    returned: tuple[str, ...]
    standing: dict[str, Expr]
    steps: dict[str, Expr]
    remarks: tuple[str, ...]
    text: str
    own: dict[Expr, Rational] = field(default_factory=dict)


def signature_of(
    function: Callable[..., Any], naming: Naming, names: Mapping[str, str], title: str
) -> Signature:
    """What a function is called with.

    Raises
    ------
    InputError
        When its arguments are not known.
    """
    try:
        parameters = inspect.signature(function).parameters
    except (TypeError, ValueError):
        raise InputError(f"function {title}: its arguments are not known") from None
    apart, returned, text = in_python(function)
    wanted: list[str] = []
    freed: list[str] = []
    kept: list[str] = []
    starred: list[str] = []
    if moving := sorted(n for n in filled(function) if naming.is_function(n) and n not in names):
        raise InputError(
            f"function {title}: {', '.join(moving)} has one value in a partial: pass the function"
            " of all coordinates, speeds and inputs"
        )
    for name, parameter in parameters.items():
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            starred.append(f"*{name}")
            continue
        if parameter.kind is parameter.POSITIONAL_ONLY:
            raise InputError(f"function {title}: argument {name} has no name")
        default = parameter.default
        if default is parameter.empty or name in names:
            wanted.append(name)
        elif _of_scene(naming, name, default, apart.get(name)):
            wanted.append(name)
            freed.append(name if name in ("t", "time") else f"{name} = {default}")
        elif is_number(default) or isinstance(default, str | bool):
            kept.append(f"{name} = {default!r}")
    standing, numbers, others, values = _standing(function, naming, names)
    if others and any(isinstance(v, Unsaid) for v in attributes(owner_of(function)[1]).values()):
        asked = [other.split(" = ")[0] for other in others]
        options = " ".join(f"--name '{name}=...'" for name in asked)
        raise InputError(
            f"{title}: nothing says what {', '.join(asked)} of its object are: give {options}"
            f" (names=), or make the object with numbers"
        )
    remarks = [
        *([f"{title}: {', '.join(freed)}: read as the scene's, for all values, not the default"]
          if freed else []),
        *([f"{title}: {', '.join(kept)}: the default; --name 'mine=scene' (names=) reads"
           " it as the scene's"] if kept else []),
        *([f"{title}: {', '.join(numbers)} of the code: read as the scene's, for all values"]
          if numbers else []),
        *([f"{title}: {', '.join(others)} of the code: numbers; --name 'mine=scene' (names=) reads"
           " them as the scene's"] if others else []),
        *([f"{title}: {', '.join(starred)}: read as nothing"] if starred else []),
    ]  # fmt: skip
    held_ones = [other.split(" = ")[0] for other in others]
    steps: dict[str, Expr] = {name: STEP for name in held_ones if name in STEPS}
    own = values if {*held_ones} - {*STEPS} else {}
    return Signature(tuple(wanted), apart, returned, standing, steps, tuple(remarks), text, own)


def _of_scene(naming: Naming, name: str, default: Any, apart: Apart | None) -> bool:
    """Whether an argument with a default is one of the scene."""
    if is_number(default):
        if name in ("t", "time"):
            return True
        known = key(name) in naming.vocabulary.by_key
        return known and _may_be(naming.symbol(name, 0), default)
    if isinstance(default, dict) and not default:
        keys = apart.keys if apart is not None else {}
        return bool(keys) and all(naming.knows(entry) for entry in keys)
    if isinstance(default, tuple | list | dict | np.ndarray) and len(default):
        return bool(named_entries(naming, name, apart))
    return False


def _standing(
    function: Callable[..., Any], naming: Naming, names: Mapping[str, str]
) -> tuple[dict[str, Expr], list[str], list[str], dict[Expr, Rational]]:
    """What numbers that a function holds stand for, these in words, and those that stay numbers.

    And the numbers of parameters.
    """
    constants = naming.vocabulary.constants
    own = held(function, constants).numbers
    # Beside what is named, the file may compute from numbers that only it uses.
    whole = getattr(owner_of(function)[0], "__globals__", {})
    used = held(function, _used(function)).numbers
    values = {n: v for n, v in whole.items() if is_number(v)} | used | own
    values |= held(function, names).numbers
    named = {*values, *names}
    meant = {n: constants[m] for n in named if (m := _in_capitals(naming, n, named))}
    meant |= constants | {n: constants[m] for n, m in names.items() if m in constants}
    known: dict[str, Expr] = {
        n: s for n, s in meant.items() if n not in values or _may_be(s, values[n])
    }
    known |= derived(function, known)
    numbers = held(function, known).numbers
    for n, v in numbers.items():
        if isinstance(v, Unsaid) and n in constants and v.name in ("", *constants) and v.name != n:
            made = v.name or "something computed"
            raise InputError(f"{n} of the object is {made}, not what is passed by that name")
    for n in numbers:
        made = changed(function, n, known[n]) if known[n].is_Symbol and n not in names else ""
        if made:
            raise InputError(
                f"{n} is {made} in the code, not what is passed by that name: say --name '{n}={n}'"
                " (names=) if it is the scene's, or give it a name of its own"
            )
    told = [f"{n} = {v}" + ("" if n == str(known[n]) else f" ({known[n]})")
            for n, v in numbers.items()]  # fmt: skip
    others = [f"{n} = {v}" for n, v in used.items() if n not in known]
    values = {known[n]: Rational(str(v)) for n, v in numbers.items()
              if known[n].is_Symbol and isfinite(v) and not isinstance(v, Unsaid)}  # fmt: skip
    return {name: known[name] for name in numbers}, told, others[:MOST], values


def _in_capitals(naming: Naming, name: str, others: Collection[str]) -> str:
    """The parameter that a constant of a file is, ``G`` for g; empty where another name is it."""
    meaning = naming.vocabulary.parameter(name)
    return "" if meaning in others or meaning.lower() != name.lower() else meaning


def _used(function: Callable[..., Any]) -> list[str]:
    """Names that a function and what it calls use."""
    inner, bound = owner_of(function)
    codes = [f.__code__ for f in called_by(inner, bound)] if inner is not None else []
    for code in codes:
        codes += [part for part in code.co_consts if isinstance(part, CodeType)]
    return [name for code in codes for name in (*code.co_names, *code.co_freevars)]


def beside(
    function: Callable[..., Any], standing: Mapping[str, Expr], arguments: Iterable[Expr]
) -> tuple[dict[str, Expr], list[str]]:
    """What numbers stand for beside arguments, and in words which ones do not.

    A number of the file does not follow an argument that is passed.
    """
    passed = set(arguments)
    kept = {n: s for n, s in standing.items() if not s.free_symbols & passed}
    numbers = held(function, standing).numbers
    told = [
        f"{n} = {numbers[n]} of the code stays a number: {', '.join(sorted(map(str, both)))} of the"
        " scene is passed as an argument, which it does not follow: pass it too, or compute it"
        " inside the function"
        for n, s in standing.items() if (both := s.free_symbols & passed)
    ]  # fmt: skip
    return kept, told


def _may_be(symbol: Expr, value: float) -> bool:
    """Whether a symbol can have a value: g = -9.81 is not the g > 0 of a scene."""
    signed = symbol.is_positive or symbol.is_nonnegative
    return isfinite(value) and (value >= 0 or not signed)
