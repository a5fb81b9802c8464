"""Fractions of polynomials: numerator / product of factors**powers.

The denominator stays factored: two fractions are added over the least common multiple of factors
that are recognised, so no greatest common divisor is ever computed. The ring need not be without
zero divisors: a fraction whose reduced numerator is zero is zero wherever it has a value.
"""

from collections.abc import Hashable
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq, fmpq_mpoly

from mechanics.kernel.ring import Ring

Powers = dict[int, int]
"""Power of each factor of a denominator, by its number."""


class NoValue(ArithmeticError):
    """A divisor or determinant is zero everywhere."""


@dataclass(frozen=True)
class Quotient:
    """A fraction: numerator, and the powers of the factors of its denominator."""

    numerator: fmpq_mpoly
    powers: Powers


class Quotients:
    """Arithmetic of fractions over a ring.

    Parameters
    ----------
    capacity : int
        Number of generators of the ring.
    """

    def __init__(self, capacity: int) -> None:
        self.ring = Ring(capacity)
        self._factors: list[fmpq_mpoly] = []

    def constant(self, value: Fraction) -> Quotient:
        """A rational."""
        return Quotient(self.ring.constant(value), {})

    def generator(self, key: Hashable, positive: bool = False) -> Quotient:
        """The generator of a key."""
        return Quotient(self.ring.generator(key, positive), {})

    def add(self, x: Quotient, y: Quotient) -> Quotient:
        """x + y, over the least common multiple of the factors that are recognised."""
        if x.powers == y.powers:
            return Quotient(x.numerator + y.numerator, x.powers)
        common = dict(x.powers)
        for factor, power in y.powers.items():
            common[factor] = max(common.get(factor, 0), power)
        return Quotient(self._over(x, common) + self._over(y, common), common)

    def negate(self, x: Quotient) -> Quotient:
        """-x."""
        return Quotient(-x.numerator, x.powers)

    def multiply(self, x: Quotient, y: Quotient) -> Quotient:
        """x y."""
        numerator = self.ring.product(x.numerator, y.numerator)
        if not (x.powers or y.powers):
            return Quotient(numerator, {})
        powers = dict(x.powers)
        for factor, power in y.powers.items():
            powers[factor] = powers.get(factor, 0) + power
        return self.cancelled(numerator, powers)

    def inverse(self, x: Quotient) -> Quotient:
        """1 / x.

        Raises
        ------
        NoValue
            If x is zero everywhere.
        """
        numerator = self.ring.reduced(x.numerator)
        if numerator == 0:
            raise NoValue("division by zero")
        unit, powers = self._factored(numerator)
        return self.cancelled(self.denominator(x.powers) / unit, powers)

    def is_zero(self, x: Quotient) -> bool:
        """Whether it is zero wherever it has a value."""
        return bool(self.ring.reduced(x.numerator) == 0)

    def denominator(self, powers: Powers) -> fmpq_mpoly:
        """A denominator multiplied out."""
        result = self.ring.constant(1)
        for factor, power in powers.items():
            result = self.ring.product(result, self.ring.power(self._factors[factor], power))
        return result

    def divide(self, x: Quotient, y: Quotient) -> Quotient:
        """x / y."""
        return self.multiply(x, self.inverse(y))

    def subtract(self, x: Quotient, y: Quotient) -> Quotient:
        """x - y."""
        return self.add(x, self.negate(y))

    def _over(self, x: Quotient, common: Powers) -> fmpq_mpoly:
        """The numerator of x over a common denominator."""
        missing = {f: n - x.powers.get(f, 0) for f, n in common.items() if n > x.powers.get(f, 0)}
        return self.ring.product(x.numerator, self.denominator(missing)) if missing else x.numerator

    def _factored(self, x: fmpq_mpoly) -> tuple[fmpq, Powers]:
        """A polynomial as constant times known factors: generators and one remainder."""
        powers: Powers = {}
        monomial = x.term_content()
        for place, power in enumerate(monomial.degrees()):
            if power > 0:
                powers[self._factor(self.ring.gen(place))] = int(power)
        rest = x / (monomial / monomial.leading_coefficient())
        unit = rest.leading_coefficient()
        if not rest.is_constant():
            powers[self._factor(rest / unit)] = 1
        return unit, powers

    def _factor(self, polynomial: fmpq_mpoly) -> int:
        for number, known in enumerate(self._factors):
            if known == polynomial:
                return number
        self._factors.append(polynomial)
        return len(self._factors) - 1

    def cancelled(self, numerator: fmpq_mpoly, powers: Powers) -> Quotient:
        """A fraction without the factors that divide the numerator as it stands."""
        left = {}
        for factor, power in powers.items():
            divisor = self._factors[factor]
            self.ring.spend(len(numerator))
            while power:
                quotient, remainder = divmod(numerator, divisor)
                if remainder != 0:
                    break
                numerator, power = quotient, power - 1
            if power:
                left[factor] = power
        return Quotient(numerator, left)
