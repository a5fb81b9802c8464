"""Exact numbers that are multiplied and divided a lot: a rational times powers of others.

27/25 + 27 pi/50   =   27/50 * (2 + pi)^1
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

import sympy
from sympy import Expr

Powers = tuple[tuple[Expr, int], ...]


@dataclass(frozen=True)
class Coefficient:
    """``ratio * prod(base**power)``; bases are positive and not rational, in a fixed order."""

    ratio: Fraction
    powers: Powers = ()

    def __mul__(self, other: "Coefficient") -> "Coefficient":
        """The product."""
        if not other.powers:
            return Coefficient(self.ratio * other.ratio, self.powers)
        powers = dict(self.powers)
        for base, power in other.powers:
            powers[base] = powers.get(base, 0) + power
        kept = sorted(((b, p) for b, p in powers.items() if p), key=lambda entry: str(entry[0]))
        return Coefficient(self.ratio * other.ratio, tuple(kept))

    def __truediv__(self, other: "Coefficient") -> "Coefficient":
        """The quotient."""
        return self * Coefficient(1 / other.ratio, tuple((b, -p) for b, p in other.powers))

    def __neg__(self) -> "Coefficient":
        """The negative."""
        return Coefficient(-self.ratio, self.powers)

    def __abs__(self) -> "Coefficient":
        """The magnitude."""
        return Coefficient(abs(self.ratio), self.powers)

    @property
    def positive(self) -> bool:
        """Whether it is more than zero."""
        return self.ratio > 0

    @property
    def awkward(self) -> int:
        """2 for a number that no double holds, and 1 for a sign."""
        q = self.ratio.denominator
        return (2 if self.powers or q & (q - 1) else 0) + (self.ratio < 0)

    @property
    def expr(self) -> Expr:
        """As an expression."""
        ratio = sympy.Rational(self.ratio.numerator, self.ratio.denominator)
        return sympy.Mul(ratio, *(base**power for base, power in self.powers))


@lru_cache(maxsize=1024)
def coefficient(number: Expr) -> Coefficient:
    """A number as a coefficient."""
    ratio, powers = Fraction(1), []
    for factor in sympy.Mul.make_args(sympy.factor(number)):
        base, power = factor.as_base_exp()
        if not power.is_Integer:
            base, power = factor, sympy.S.One
        if isinstance(base, sympy.Rational):
            ratio *= Fraction(int(base.p), int(base.q)) ** int(power)
            continue
        content, rest = base.as_content_primitive()
        ratio *= Fraction(int(content.p), int(content.q)) ** int(power)
        if rest.evalf() < 0:
            ratio, rest = ratio * (-1) ** int(power), -rest
        powers.append((rest, int(power)))
    return Coefficient(ratio, tuple(sorted(powers, key=lambda entry: str(entry[0]))))
