"""Everything that a machine may compute: balls that grow by each rounding.

    fl(x op y) = (x op y) (1 + delta) + eta,    |delta| <= u,   |eta| <= half the smallest number

with u = 2^-53 or 2^-24: what C without contraction gives, and with it too (a fused operation has
one rounding instead of two). Functions of a library are taken to be within `LIBRARY` units in the
last place; the inline sine and cosine are shown to be. A value outside is not what the text says.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from flint import arb

from mechanics.exact.arithmetic import Term
from mechanics.exact.balls import Ball, BallArithmetic, State, ball

LIBRARY = 2
"""Units in the last place."""
DIGITS = {"double": 53, "float": 24}
SMALLEST = {"double": -1074, "float": -149}


class Rounded(Ball):
    """A ball that grows with every operation."""

    __slots__ = ("_by",)

    def __init__(self, value: arb, by: RoundedArithmetic) -> None:
        super().__init__(value)
        self._by = by

    def _grown(self, value: arb) -> Rounded:
        # What is zero for certain is a factor of zero or a difference of equals, which is exact.
        return Rounded(value if value.is_zero() else self._by.grown(value, 1), self._by)

    def __add__(self, other: Any) -> Rounded:
        return self._grown(self.arb + _arb(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Rounded:
        return self._grown(self.arb - _arb(other))

    def __rsub__(self, other: Any) -> Rounded:
        return self._grown(_arb(other) - self.arb)

    def __mul__(self, other: Any) -> Rounded:
        return self._grown(self.arb * _arb(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Rounded:
        return self._grown(self.arb / _arb(other))

    def __rtruediv__(self, other: Any) -> Rounded:
        return self._grown(_arb(other) / self.arb)

    def __neg__(self) -> Rounded:
        return Rounded(-self.arb, self._by)

    def __pow__(self, exponent: int) -> Rounded:
        return Rounded(self._by.grown(self.arb**exponent, 2 * LIBRARY), self._by)


def _arb(number: Any) -> arb:
    return number.arb if isinstance(number, Ball) else ball(number)


class RoundedArithmetic(BallArithmetic):
    """Arithmetic of everything that a machine may compute.

    Parameters
    ----------
    kind : ``"double"`` or ``"float"``
    """

    def __init__(self, kind: str) -> None:
        super().__init__(State({}))
        self._unit = arb(2) ** -DIGITS[kind]
        self._smallest = arb(2) ** (SMALLEST[kind] - 1)

    def grown(self, value: arb, units: int) -> arb:
        """A ball with what `units` roundings may add."""
        slack = units * (abs(value).upper() * self._unit + self._smallest)
        return value + arb(0, slack)

    def _library(self, value: arb) -> Rounded:
        return Rounded(self.grown(value, 2 * LIBRARY), self)

    def rational(self, number: int | Fraction) -> Rounded:
        """A constant of the text, which its type holds exactly."""
        return Rounded(ball(number), self)

    def circle(self, terms: Sequence[Term]) -> tuple[Ball, Ball]:
        """Cosine and sine of a library."""
        c, s = super().circle(terms)
        return self._library(c.arb), self._library(s.arb)

    def exponential(self, terms: Sequence[Term]) -> Ball:
        """exp of a library."""
        return self._library(super().exponential(terms).arb)

    def root_power(self, number: Ball, exponent: Fraction) -> Ball:
        """A root or power of a library."""
        return self._library(super().root_power(number, exponent).arb)

    def absolute(self, number: Ball) -> Ball:
        """Exact."""
        return Rounded(abs(number.arb), self)

    def sign(self, number: Ball) -> Ball:
        """Exact."""
        return Rounded(super().sign(number).arb, self)

    def indicator(self, relation: str, difference: Ball) -> Ball:
        """Exact where the difference can be told from zero."""
        return Rounded(super().indicator(relation, difference).arb, self)

    def select(self, condition: Ball, yes: Ball, no: Ball) -> Ball:
        """The branch that is taken; not, and, or of truth values are exact, whatever was grown."""
        holds, fails = (condition.arb.overlaps(arb(truth)) for truth in (1, 0))
        if holds and fails:
            return Rounded(arb.nan(), self)
        return yes if holds else no

    def function(self, name: str, arguments: Sequence[Ball]) -> Ball:
        """Any other function of a library."""
        return self._library(super().function(name, arguments).arb)
