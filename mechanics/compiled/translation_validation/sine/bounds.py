"""Largest error of the computed sine and cosine, in units in the last place (ulp).

    |s - sin t| <= |s - S(r, low)| + |S(r, low) - sin(r - low)| + |r - low - t|

S is the polynomial of the text. The first term is a running error analysis, the second one the
difference of S and Taylor's polynomial with its remainder, the third one comes from the reduction.
All three are enclosed by Arb for r in each of many short intervals that cover what r can be; signs
are taken care of by symmetry, so r > 0 here. The unit is that of the true or the computed value,
whichever is larger: they differ where a power of 2 lies between the two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import factorial, isfinite

from flint import arb, arb_poly, fmpq

from mechanics.compiled.translation_validation.sine.affine import BITS, SMALLEST, half_unit
from mechanics.compiled.translation_validation.sine.reduction import Reduced
from mechanics.compiled.translation_validation.sine.rounding import (
    Poly,
    Polynomials,
    Rounded,
    Roundings,
    unit,
)
from mechanics.compiled.translation_validation.sine.tape import Recorded, record
from mechanics.errors import ExpressionError
from mechanics.kernel.balls import precision
from mechanics.program.c.parse import Source

DIGITS = 160
"""Bits of the balls."""
TERMS = 30
"""Degree of Taylor's polynomials: the remainder for |r| < 1 is below 2^-100."""


@dataclass(frozen=True)
class Largest:
    """Largest errors: of sine and cosine in ulp of the true values, of s^2 + c^2."""

    sine: float
    cosine: float
    square: float

    def joined(self, other: Largest) -> Largest:
        """The larger ones of both."""
        return Largest(
            max(self.sine, other.sine),
            max(self.cosine, other.cosine),
            max(self.square, other.square),
        )


def largest_errors(
    source: Source, name: str, kind: str, known: Sequence[Reduced], small: Fraction
) -> Largest:
    """Over all numbers.

    Parameters
    ----------
    known : sequence of Reduced
        What is known where n is not zero.
    small : Fraction
        Largest |r| where n is zero, where r is exact.
    """
    with precision(DIGITS):
        return _largest(source, name, kind, known, small)


def _largest(
    source: Source, name: str, kind: str, known: Sequence[Reduced], small: Fraction
) -> Largest:
    text = record(source, name, ("r", "low"), ("s", "c"))
    sine, cosine = text.play(Polynomials(), {"r": {(1, 0): Fraction(1)}, "low": _LOW})
    differences = _Difference(sine, 0), _Difference(cosine, 1)
    cases = [Reduced(0, Fraction(0), small, Fraction(0), Fraction(0)), *known]
    found = Largest(0.0, 0.0, 0.0)
    for a, b in _intervals(kind, max(one.farthest + 2 * one.low for one in cases)):
        near = [one for one in cases if _least(one) <= b and a <= one.farthest + 2 * one.low]
        if a > _TINY:
            near = [*(one for one in near if not one.turns), *_joined([o for o in near if o.turns])]
        for one in near:
            found = found.joined(_errors(text, kind, differences, (a, b), one))
    return found


def _joined(cases: Sequence[Reduced]) -> list[Reduced]:
    """One case that holds all of them."""
    if not cases:
        return []
    return [
        Reduced(
            max(one.turns for one in cases),
            min(one.nearest for one in cases),
            max(one.farthest for one in cases),
            max(one.low for one in cases),
            max(one.error for one in cases),
        )
    ]


_MINUTE, _WIDE = 64, 16
"""Exponents from which on, and by which, intervals span several powers of 2."""
_TINY = Fraction(1, 2**12)
"""Below, low matters beside r, and how large it is depends on n."""


def _least(one: Reduced) -> Fraction:
    """Lower bound of |r|; a relative rounding error is less than 2^-20."""
    return (one.nearest - one.low - one.error) * (1 - Fraction(1, 2**20))


_LOW: Poly = {(0, 1): Fraction(1)}


def _intervals(kind: str, top: Fraction) -> Iterator[tuple[Fraction, Fraction]]:
    """Intervals from the smallest number to `top`, shorter where errors are larger."""
    if top > 1:
        raise ExpressionError(f"the reduced angle may be {float(top):.3g}")
    for e in range(-1, -_MINUTE - 1, -1):
        parts = 128 if e > -3 else (16 if e > -12 else 1)
        start = Fraction(2) ** e
        for k in range(parts):
            a, b = start * (1 + Fraction(k, parts)), start * (1 + Fraction(k + 1, parts))
            if a < top:
                yield a, min(b, top)
    # There the sine is r: r^3 is small beside a unit in the last place of much smaller numbers.
    for e in range(-_MINUTE, SMALLEST[kind], -_WIDE):
        yield Fraction(2) ** max(e - _WIDE, SMALLEST[kind]), Fraction(2) ** e


class _Difference:
    """S(r, low) - sin(r - low), or with the cosine.

    Parameters
    ----------
    poly : polynomial in r and low
    shift : 0 for the sine, 1 for the cosine
    """

    def __init__(self, poly: Poly, shift: int) -> None:
        degree = max([TERMS, *(i for i, _ in poly)])
        # cos r for shift 1; the derivative of the sine by low is -cos r, of the cosine sin r.
        self._value = arb_poly(_coefficients(poly, 0, degree, shift, 1))
        self._slope = arb_poly(_coefficients(poly, 1, degree, shift + 1, -1))
        self._more = [(i, j, _arb(c)) for (i, j), c in poly.items() if j > 1]
        self._remainder = _arb(Fraction(1, factorial(degree + 1)))
        self._degree = degree

    def __call__(self, r: arb, low: arb) -> arb:
        """Bound of the absolute value for r and low in balls."""
        rest = abs(r) ** (self._degree + 1) * self._remainder
        value = abs(_centred(self._value, r)) + rest
        slope = abs(_centred(self._slope, r)) + rest + abs(low) / 2
        more = (abs(c) * abs(r) ** i * abs(low) ** j for i, j, c in self._more)
        return value + abs(low) * slope + sum(more, arb(0))


def _centred(poly: arb_poly, r: arb) -> arb:
    """Values of a polynomial on a ball, about its midpoint: large terms that cancel do so there."""
    return poly(arb_poly([r.mid(), 1]))(r - r.mid())


def _coefficients(poly: Poly, power: int, degree: int, shift: int, sign: int) -> list[arb]:
    """Of low^power in the polynomial, less Taylor's of sign * the shift-th derivative of sin r."""
    return [
        _arb(
            poly.get((i, power), Fraction(0))
            - sign * _taylor(i + shift) * Fraction(1, factorial(i))
        )
        for i in range(degree + 1)
    ]


@cache
def _taylor(order: int) -> int:
    """The derivative of the sine of this order, at zero."""
    return (0, 1, 0, -1)[order % 4]


def _arb(number: Fraction) -> arb:
    return arb(fmpq(number.numerator, number.denominator))


def _errors(
    text: Recorded,
    kind: str,
    differences: tuple[_Difference, _Difference],
    interval: tuple[Fraction, Fraction],
    known: Reduced,
) -> Largest:
    a, b = (_arb(end) for end in interval)
    r, low = arb((a + b) / 2, (b - a) / 2), arb(0, _arb(known.low))
    given = {"r": Rounded(r, arb(0), arb(0)), "low": Rounded(low, arb(0), arb(0))}
    values = text.play(Roundings(), given)
    # Where n is zero, r is x itself.
    shift = _arb(known.error + (half_unit(kind, interval[1]) if known.turns else 0))
    t = _between(_arb(known.nearest), r - low + arb(0, shift))
    sine, cosine = t.sin(), t.cos()
    ulps, errors = [], []
    for value, difference, true, slope in zip(
        values, differences, (sine, cosine), (cosine, sine), strict=True
    ):
        before = (value.error + difference(r, low) + shift * abs(slope)).abs_upper()
        ulps.append(_ulps(kind, true, before, value))
        errors.append(before + value.last)
    square = sum(
        (2 * abs(true) * error + error**2
         for error, true in zip(errors, (sine, cosine), strict=True)), arb(0),
    )  # fmt: skip
    return Largest(*(_upper(value) for value in (*ulps, square)))


def _between(lowest: arb, ball: arb) -> arb:
    """What of the ball is not below a number."""
    lower, upper = ball.lower(), ball.upper()
    if not lower < lowest:
        return ball
    return lowest.union(upper) if lowest < upper else lowest


def _ulps(kind: str, true: arb, before: arb, value: Rounded) -> arb:
    """The error in units of the larger of both values, for every binade that the true one is in.

    `before` bounds the error before the last rounding. If the true value is in a binade, so is the
    computed one, or it is below, and the last rounding is at most half a unit there; or it is in
    the next one, where units are twice as large.
    """
    found, step = arb(0), unit(kind, true)
    top = true.abs_upper()
    while True:
        inside = (before + _smaller(value.last, step / 2)) / step
        above = (before + _smaller(value.last, step)) / (2 * step)
        found = max(found, inside, above, key=float)
        if top < step * arb(2) ** BITS[kind]:
            return found
        step = 2 * step


def _smaller(a: arb, b: arb) -> arb:
    return min(a, b, key=float)


def _upper(number: arb) -> float:
    """A double that is not smaller."""
    upper = float(number.abs_upper())
    if not isfinite(upper):
        raise ExpressionError("an enclosure is not finite")
    return upper * (1 + 2.0**-50)
