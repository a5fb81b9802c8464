"""The box that a reduction holds over: a range or a value for every input of a program."""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy
from sympy import Expr

from mechanics.compiled.fixed import read_fixed
from mechanics.compiled.quantities import Quantities
from mechanics.errors import InputError, RangeError, ValueMissingError
from mechanics.nearest import instead
from mechanics.program.constants import with_pi
from mechanics.reduce.proof import Box
from mechanics.scene import Scene

ENTRY = re.compile(r"\s*(\w+)\s+in\s+\[([^,\[\]]+),([^,\[\]]+)\]\s*")
PI = Fraction("3.14159265358979323846264338327950288")
"""To 35 digits: a box is rational."""
FORM = "write --over 'theta in [-1, 1]'"


def read_over(entries: Sequence[str]) -> dict[str, tuple[Fraction, Fraction]]:
    """Ranges from ``theta in [-1, 1]``; numbers, fractions or multiples of pi.

    Raises
    ------
    InputError
        For what is none, an empty range, and a name twice.
    """
    found: dict[str, tuple[Fraction, Fraction]] = {}
    for entry in entries:
        match = ENTRY.fullmatch(entry)
        if match is None:
            raise InputError(f"--over {entry!r}: it is no range: {FORM}")
        name, *ends = match.groups()
        if name in found:
            raise InputError(f"--over {entry!r}: {name} is given twice")
        found[name] = _range(name, [number(end.strip(), f"--over {entry!r}") for end in ends])
    return found


def number(text: str, where: str) -> Fraction:
    """A number, a fraction or a multiple of pi.

    Raises
    ------
    InputError
    """
    try:
        value, turn = with_pi(text)
        float(value)
        return value * PI if turn else value
    except RangeError as error:
        raise InputError(f"{where}: {error}") from None
    except OverflowError:
        raise InputError(f"{where}: {text} is beyond 1.8e308") from None
    except (ValueError, ZeroDivisionError):
        raise InputError(f"{where}: {text!r} is no number: write 0.5, 1/3 or pi/2") from None


def _range(name: str, ends: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
    low, high = ends
    if low > high:
        raise InputError(f"{name}: the range [{float(low):g}, {float(high):g}] is empty: {FORM}")
    return low, high


def given_ranges(over: Mapping[str, Any]) -> dict[str, tuple[Fraction, Fraction]]:
    """Ranges as a caller from Python gives them: pairs of numbers; one number is a value."""
    found = {}
    for name, ends in over.items():
        pair = tuple(ends) if isinstance(ends, Sequence) and not isinstance(ends, str) else (ends,)
        if not 1 <= len(pair) <= 2:
            raise InputError(f"over {name}: {ends!r} found: give (lowest, highest)")
        numbers = [number(str(end), f"over {name}") for end in pair]
        found[name] = _range(name, [numbers[0], numbers[-1]])
    return found


def fixed_parameters(
    scene: Scene, known: Quantities, box: Mapping[str, Any]
) -> dict[sympy.Symbol, Expr]:
    """Values of the parameters that have no range: what is given, typical, or defined.

    Raises
    ------
    InputError
        For a range of a parameter that others are defined by, and a value that cannot be.
    ValueMissingError
        For a parameter that has neither value nor definition.
    """
    ranged = {name for name, (low, high) in box.items() if low != high}
    for symbol, expression in scene.definitions.items():
        names = {s.name for s in sympy.sympify(expression).free_symbols} & ranged
        if names and symbol.name not in ranged and symbol in scene.parameters:
            name = min(names)
            raise InputError(
                f"{name}: {symbol.name} is defined by it: give {symbol.name} a range instead"
            )
    needed = {*scene.parameters} | {
        s for e in scene.definitions.values() for s in sympy.sympify(e).free_symbols
    }
    given: dict[str, Any] = {}
    for symbol in needed:
        if symbol.name in ranged:
            continue
        if symbol.name in box:
            value = box[symbol.name][0]
            given[symbol.name] = f"{value.numerator}/{value.denominator}"
        elif symbol not in scene.definitions and getattr(symbol, "typical", None) is not None:
            given[symbol.name] = symbol.exact if symbol.half_turns is None else symbol.typical
    table = read_fixed(scene, {name: str(value) for name, value in given.items()})
    for entry in known.p:
        if entry.symbol not in table and entry.name not in ranged:
            raise ValueMissingError(
                f"{entry.name} has no typical value: give one by --set {entry.name}=VALUE, or a"
                f" range by --over '{entry.name} in [LOWEST, HIGHEST]'"
            )
    return {s: e for s, e in table.items() if s.name not in ranged}


def complete(
    inputs: Sequence[str], known: Quantities, box: Box, of: str, off: bool
) -> dict[str, tuple[Fraction, Fraction]]:
    """The box of a program.

    Parameters
    ----------
    inputs : sequence of str
        What it depends on beside fixed parameters.
    box : mapping of str to (Fraction, Fraction)
    of : str
        The output, for messages.
    off : bool
        Whether inputs of the scene without a range are 0.

    Raises
    ------
    InputError
        Naming what has no range.
    """
    found = dict(box)
    if off:
        found = {e.name: (Fraction(0), Fraction(0)) for e in known.inputs} | found
    missing = [name for name in inputs if name not in found]
    if missing:
        raise InputError(
            f"{of} depends on {', '.join(missing)}: give each a range,"
            f" --over '{missing[0]} in [LOWEST, HIGHEST]', or a value, --set {missing[0]}=VALUE"
        )
    return {name: found[name] for name in inputs}


def check_names(scene: Scene, known: Quantities, box: Mapping[str, Any]) -> None:
    """Refuse names that there are not.

    Raises
    ------
    InputError
    """
    groups = (known.q, known.u, known.ud, known.inputs, known.p, known.multipliers)
    names = [entry.name for group in groups for entry in group]
    names += sorted(
        {s.name for e in scene.definitions.values() for s in sympy.sympify(e).free_symbols}
        - set(names)
    )
    for name in box:
        if name not in names:
            raise InputError(f"{scene.name}: there is no {name!r}: {instead(name, names, 'names')}")
