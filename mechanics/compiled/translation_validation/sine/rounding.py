"""Running error analysis: how far the computed s and c are from polynomials in r and low.

    computed = ideal + error,      |error| <= sum of what every rounding did, carried along

r is any number of a short interval, low any number of a small one. Two domains: polynomials, which
hold the ideal values for all r at once, and balls with an error for one interval.
"""

from fractions import Fraction
from typing import NamedTuple

from flint import arb, fmpq

from mechanics.compiled.translation_validation.sine.affine import BITS, SMALLEST
from mechanics.compiled.translation_validation.sine.walk import Domain
from mechanics.errors import ExpressionError

Poly = dict[tuple[int, int], Fraction]
"""Coefficients of r^i low^j."""


class Polynomials(Domain):
    """Exact polynomials in r and low."""

    def number(self, kind: str, value: Fraction) -> Poly:
        """A literal."""
        return {(0, 0): value} if value else {}

    def negative(self, kind: str, x: Poly) -> Poly:
        """-x."""
        return {at: -c for at, c in x.items()}

    def sum(self, kind: str, x: Poly, y: Poly) -> Poly:
        """x + y."""
        total = {at: x.get(at, Fraction(0)) + y.get(at, Fraction(0)) for at in {*x, *y}}
        return {at: c for at, c in total.items() if c}

    def product(self, kind: str, x: Poly, y: Poly) -> Poly:
        """x y."""
        total: Poly = {}
        for (i, j), a in x.items():
            for (k, m), b in y.items():
                total[i + k, j + m] = total.get((i + k, j + m), Fraction(0)) + a * b
        return {at: c for at, c in total.items() if c}

    def fused(self, kind: str, x: Poly, y: Poly, z: Poly) -> Poly:
        """x y + z."""
        return self.sum(kind, self.product(kind, x, y), z)

    def cast(self, kind: str, old: str, x: Poly) -> Poly:
        """x."""
        return x


class Rounded(NamedTuple):
    """The value before its last rounding is in the ball, and at most `error` from the ideal one.

    `last` bounds what the last rounding changes.
    """

    ball: arb
    error: arb
    last: arb

    @property
    def value(self) -> arb:
        """The ball after the last rounding."""
        return self.ball + arb(0, self.last)

    @property
    def total(self) -> arb:
        """The error after the last rounding."""
        return self.error + self.last


class Roundings(Domain):
    """Balls and errors, for r and low in given ones."""

    def number(self, kind: str, value: Fraction) -> Rounded:
        """A literal: as written, it has been rounded to its type."""
        return Rounded(arb(fmpq(value.numerator, value.denominator)), arb(0), arb(0))

    def negative(self, kind: str, x: Rounded) -> Rounded:
        """-x."""
        return Rounded(-x.ball, x.error, x.last)

    def sum(self, kind: str, x: Rounded, y: Rounded) -> Rounded:
        """x + y, rounded."""
        ball, error = x.value + y.value, x.total + y.total
        return Rounded(ball, error, _least(half_unit(kind, ball), x.value, y.value))

    def product(self, kind: str, x: Rounded, y: Rounded) -> Rounded:
        """x y, rounded."""
        ball = x.value * y.value
        return Rounded(ball, _product_error(x, y), half_unit(kind, ball))

    def fused(self, kind: str, x: Rounded, y: Rounded, z: Rounded) -> Rounded:
        """x y + z, rounded once."""
        product = x.value * y.value
        ball, error = product + z.value, _product_error(x, y) + z.total
        return Rounded(ball, error, _least(half_unit(kind, ball), product))

    def cast(self, kind: str, old: str, x: Rounded) -> Rounded:
        """x in another type: exact where that has more bits."""
        if BITS[kind] > BITS[old]:
            return x
        return Rounded(x.value, x.total, half_unit(kind, x.value))


def _product_error(x: Rounded, y: Rounded) -> arb:
    # x y - (x + a)(y + b) with the ideal values x + a and y + b.
    return abs(x.value) * y.total + abs(y.value) * x.total + x.total * y.total


def _least(*bounds: arb) -> arb:
    """The smallest bound: a sum of a number and something is not farther from it than that."""
    return min((bound.abs_upper() for bound in bounds), key=float)


def exponent(number: arb) -> int:
    """The smallest e with |number| <= 2^e, for a positive upper bound of the number."""
    mantissa, power = (int(part) for part in number.abs_upper().man_exp())
    return power + (mantissa - 1).bit_length()


def half_unit(kind: str, ball: arb) -> arb:
    """What rounding a number in the ball may change at most."""
    if ball.is_zero():
        return arb(0)
    return arb(2) ** (max(exponent(ball) - BITS[kind], SMALLEST[kind]) - 1)


def unit(kind: str, smallest: arb) -> arb:
    """Unit in the last place of numbers that are at least this large, a positive ball.

    Raises
    ------
    ExpressionError
        If the ball is not positive.
    """
    if not smallest > 0:
        raise ExpressionError("a sine or cosine is not told from zero")
    mantissa, power = (int(part) for part in smallest.abs_lower().man_exp())
    return arb(2) ** max(power + mantissa.bit_length() - BITS[kind], SMALLEST[kind])
