"""Numbers of model files, exactly: a decimal is the fraction that it prints.

    |x - k pi/12| <= half a unit of the last printed digit of x          (1)

An angle of which (1) holds, with two decimals at least, is read as k pi/12: 1.5708 is pi/2. With
eight decimals or more four units are allowed: many descriptions have 1.570796325.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction

from sympy import Expr, Rational, pi

from mechanics.errors import InputError
from mechanics.scene.parameters import NEAR_PI

NUMBER = re.compile(r"[+-]?(?:\d+(?:\.(\d*))?|\.(\d+))(?:[eE]([+-]?\d{1,3}))?", re.ASCII)
LONGEST = 400
"""Digits of a number: a double in full has no more."""
LARGEST = 308
RANGE = f"give a number between 1e-{LARGEST} and 1e{LARGEST}"
BITS = (10**LARGEST).bit_length()
DECIMALS = 2
"""With fewer nobody meant a multiple of pi: 0.5 is not pi/6."""
MANY, UNITS = 8, 4
FULL = 15
"""Decimals with which a double is a multiple of pi."""
STEP = NEAR_PI / 12


@dataclass(frozen=True)
class Notes:
    """What a reader tells: equal notes once, with the places in which they are true."""

    places: dict[str, list[str]] = field(default_factory=dict)

    def add(self, words: str, where: str) -> None:
        """One more place."""
        self.places.setdefault(words, []).append(where)

    def lines(self) -> tuple[str, ...]:
        """For people, at most three places each."""
        found = []
        for words, where in self.places.items():
            rest = f" and {len(where) - 3} more" if len(where) > 3 else ""
            found.append(f"{words}: {', '.join(where[:3])}{rest}")
        return tuple(found)


def exact(text: str, where: str) -> Rational:
    """The rational that a decimal is.

    Raises
    ------
    InputError
        When it is none: `where` names it.
    """
    text = text.strip()
    if len(text) > LONGEST or not (found := NUMBER.fullmatch(text)):
        raise InputError(f"{where} is {text[:40]!r}: give a finite decimal number")
    if abs(int(found[3] or 0)) > LARGEST:
        raise InputError(f"{where} is {text[:40]}: {RANGE}")
    return check_size(Rational(Fraction(text)), where)


def check_size(number: Rational, where: str) -> Rational:
    """The number, if a double can hold it.

    Raises
    ------
    InputError
        When it is none: `where` names it.
    """
    # Integers are compared by their lengths: the decimals of a long one are not to be written.
    if abs(number.p.bit_length() - number.q.bit_length()) >= BITS:
        raise InputError(
            f"{where} is a number of {max(number.p, number.q).bit_length()} bits: {RANGE}"
        )
    return number


def angle(text: str, where: str, notes: Notes, multiples: bool = True) -> Expr:
    """An angle in rad, as a multiple of pi/12 where it is one to the digits that it has.

    Parameters
    ----------
    notes : Notes
        Told of each that is read so.
    multiples : bool
        False: only of numbers that have all digits of a double.
    """
    value = exact(text, where)
    found = NUMBER.fullmatch(text.strip())
    assert found is not None
    digits = len(found[1] or found[2] or "") - int(found[3] or 0)
    count = round(Fraction(value.p, value.q) / STEP)
    units = Fraction(UNITS) if digits >= MANY else Fraction(1, 2)
    near = abs(Fraction(value.p, value.q) - count * STEP) <= units / 10**digits
    if count == 0 or digits < (DECIMALS if multiples else FULL) or not near:
        return value
    taken = Rational(count, 12) * pi
    notes.add(f"read {text.strip()} as {taken}", where)
    return taken


def several(
    text: str | None, default: str, where: str, read: Callable[[str, str], Expr] = exact
) -> tuple[Expr, ...]:
    """As many numbers as the default has, separated by blanks."""
    parts = (default if text is None else text).split()
    if len(parts) != len(default.split()):
        raise InputError(
            f"{where} has {len(parts)} numbers: give {len(default.split())}, such as {default!r}"
        )
    return tuple(read(part, where) for part in parts)
