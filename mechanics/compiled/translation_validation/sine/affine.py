"""Which multiple of pi/2 is taken off, and how exactly: forms a x + b n + c with rounding errors.

A value that is a multiple of 2^g and at most 2^(g + bits) is a floating number: it is not rounded.
That makes all but one step of the reduction exact. Its magnitude is bounded through

    x = t + n pi/2      hence      a x + b n = a t + (a pi/2 + b) n
"""

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from flint import arb

from mechanics.compiled.translation_validation.sine.walk import Domain
from mechanics.errors import ExpressionError
from mechanics.kernel.balls import precision

BITS = {"double": 53, "float": 24}
SMALLEST = {"double": -1074, "float": -149}
"""Exponent of the smallest positive number."""
DIGITS = 400
"""Bits of pi: more than any error that matters is small."""


@cache
def half_pi() -> tuple[Fraction, Fraction]:
    """Bounds of pi/2 that are 2^-DIGITS apart, about."""
    with precision(DIGITS):
        pi = arb.pi() / 2
        mid, exponent = (int(part) for part in pi.mid().man_exp())
        radius = Fraction(2) ** (2 - DIGITS)
    middle = mid * Fraction(2) ** exponent
    return middle - radius, middle + radius


def exponent(number: Fraction) -> int:
    """The smallest e with |number| <= 2^e; number is not zero."""
    number = abs(number)
    e = number.numerator.bit_length() - number.denominator.bit_length() + 1
    while number <= Fraction(2) ** (e - 1):
        e -= 1
    return e


def half_unit(kind: str, bound: Fraction) -> Fraction:
    """What rounding a number of at most this magnitude may change."""
    if not bound:
        return Fraction(0)
    unit = max(exponent(bound) - BITS[kind], SMALLEST[kind])
    return Fraction(2) ** (unit - 1)


def grid(number: Fraction) -> int:
    """The largest g for which a number, not zero and dyadic, is a multiple of 2^g."""
    ones = number.numerator & -number.numerator
    return ones.bit_length() - number.denominator.bit_length()


@dataclass(frozen=True)
class Affine:
    """a x + b n + c, in error by at most `error`, and by the last rounding on top if `inexact`.

    Attributes
    ----------
    kind : str
        The smallest type that it is known to be a number of, by the last rounding.
    grid : int or None
        The value is a multiple of 2^grid; None where that is not known, or it is zero.
    """

    kind: str
    a: Fraction = Fraction(0)
    b: Fraction = Fraction(0)
    c: Fraction = Fraction(0)
    error: Fraction = Fraction(0)
    inexact: bool = False
    grid: int | None = None

    @property
    def is_number(self) -> bool:
        """Whether neither x nor n is in it."""
        return not self.a and not self.b


class AffineForms(Domain):
    """Affine forms of x and n.

    Parameters
    ----------
    turns : Fraction
        Bound of |n|.
    rest : Fraction
        Bound of |t| = |x - n pi/2|.
    """

    def __init__(self, turns: Fraction, rest: Fraction) -> None:
        self._turns, self._rest = turns, rest

    def bound(self, x: Affine) -> Fraction:
        """Bound of the magnitude of the exact form."""
        low, high = half_pi()
        slope = max(abs(x.a * low + x.b), abs(x.a * high + x.b))
        return abs(x.a) * self._rest + slope * self._turns + abs(x.c)

    def settled(self, x: Affine) -> Affine:
        """With the last rounding among the errors."""
        if not x.inexact:
            return x
        size = self.bound(x) + x.error
        return replace(x, error=x.error + half_unit(x.kind, size), inexact=False)

    def _rounded(self, kind: str, x: Affine) -> Affine:
        size = self.bound(x) + x.error
        if not size or (x.grid is not None and size <= Fraction(2) ** (x.grid + BITS[kind])):
            return replace(x, kind=kind)
        smallest = abs(x.c) - (size - abs(x.c))
        # A number of at least 2^e is a multiple of 2^(e + 1 - bits).
        least = exponent(smallest) - 1 + 1 - BITS[kind] if smallest > 0 else None
        return replace(x, kind=kind, inexact=True, grid=least)

    def number(self, kind: str, value: Fraction) -> Affine:
        """A literal."""
        return Affine(kind, c=value, grid=grid(value) if value else None)

    def negative(self, kind: str, x: Affine) -> Affine:
        """-x."""
        return replace(x, a=-x.a, b=-x.b, c=-x.c)

    def _is_zero(self, x: Affine) -> bool:
        return not self.bound(x) and not x.error

    def _added(self, kind: str, x: Affine, y: Affine) -> Affine:
        """x + y, rounded: nothing changes where one of them is zero and the other a number."""
        for zero, other in ((x, y), (y, x)):
            if self._is_zero(zero) and BITS[other.kind] <= BITS[kind]:
                return other
        x, y = self.settled(x), self.settled(y)
        least = None if x.grid is None or y.grid is None else min(x.grid, y.grid)
        exact = Affine(kind, x.a + y.a, x.b + y.b, x.c + y.c, x.error + y.error, grid=least)
        return self._rounded(kind, exact)

    def _product(self, kind: str, x: Affine, y: Affine) -> Affine:
        if not y.is_number or y.error:
            x, y = y, x
        if not y.is_number or y.error:
            raise ExpressionError("the reduction multiplies two values that are no numbers")
        x, c = self.settled(x), y.c
        least = None if x.grid is None or not c else x.grid + grid(c)
        return Affine(kind, x.a * c, x.b * c, x.c * c, x.error * abs(c), grid=least)

    def sum(self, kind: str, x: Affine, y: Affine) -> Affine:
        """x + y, rounded."""
        return self._added(kind, x, y)

    def product(self, kind: str, x: Affine, y: Affine) -> Affine:
        """x y, rounded; one of them is a number."""
        return self._rounded(kind, self._product(kind, x, y))

    def fused(self, kind: str, x: Affine, y: Affine, z: Affine) -> Affine:
        """x y + z, rounded once."""
        return self._added(kind, self._product(kind, x, y), z)

    def cast(self, kind: str, old: str, x: Affine) -> Affine:
        """x in another type: exact where it is one of its numbers already."""
        return x if BITS[kind] >= BITS[x.kind] else self._rounded(kind, self.settled(x))
