"""A fraction over a ring of polynomials: numerator / product of factors**powers.

The denominator stays factored: two fractions are added over the least common multiple of factors
that are recognised, so no greatest common divisor is ever computed. The ring has no zero divisors
as long as no radicand is a square, so a fraction is zero exactly when its reduced numerator is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from flint import fmpq_mpoly

from mechanics.exact.signals import DivisionHere

if TYPE_CHECKING:
    from mechanics.exact.normal import NormalArithmetic

Powers = dict[int, int]
"""Power of each denominator factor, by its number."""


class Quotient:
    """A fraction of polynomials."""

    __slots__ = ("field", "numerator", "powers")

    def __init__(self, field: NormalArithmetic, numerator: fmpq_mpoly, powers: Powers) -> None:
        self.field = field
        self.numerator = numerator
        self.powers = powers

    def __repr__(self) -> str:
        return f"Quotient(({self.numerator}) / {self.powers})"

    def _lift(self, other: Any) -> Quotient:
        return other if isinstance(other, Quotient) else self.field.rational(other)

    def __add__(self, other: Any) -> Quotient:
        other = self._lift(other)
        if self.powers == other.powers:
            return Quotient(self.field, self.numerator + other.numerator, self.powers)
        common = dict(self.powers)
        for factor, power in other.powers.items():
            common[factor] = max(common.get(factor, 0), power)
        left, right = (self.field.over(x, common) for x in (self, other))
        return Quotient(self.field, left + right, common)

    __radd__ = __add__

    def __neg__(self) -> Quotient:
        return Quotient(self.field, -self.numerator, self.powers)

    def __sub__(self, other: Any) -> Quotient:
        return self + -self._lift(other)

    def __rsub__(self, other: Any) -> Quotient:
        return -self + other

    def __mul__(self, other: Any) -> Quotient:
        other = self._lift(other)
        numerator = self.field.ring.product(self.numerator, other.numerator)
        if not (self.powers or other.powers):
            return Quotient(self.field, numerator, self.powers)
        powers = dict(self.powers)
        for factor, power in other.powers.items():
            powers[factor] = powers.get(factor, 0) + power
        return self.field.cancelled(numerator, powers)

    __rmul__ = __mul__

    def inverse(self) -> Quotient:
        """Return 1 / x.

        Raises
        ------
        DivisionHere
            If the numerator is identically zero.
        """
        field = self.field
        if field.is_zero(self):
            raise DivisionHere("division by zero")
        unit, powers = field.factored(field.ring.reduced(self.numerator))
        return field.cancelled(field.denominator(self.powers) / unit, powers)

    def __truediv__(self, other: Any) -> Quotient:
        return self * self._lift(other).inverse()

    def __rtruediv__(self, other: Any) -> Quotient:
        return self.inverse() * other

    def __pow__(self, exponent: int) -> Quotient:
        if exponent < 0:
            return self.inverse() ** -exponent
        numerator = self.field.ring.power(self.numerator, exponent)
        powers = {factor: power * exponent for factor, power in self.powers.items() if exponent}
        return self.field.cancelled(numerator, powers)
