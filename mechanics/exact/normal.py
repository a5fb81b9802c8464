"""The normal form: fractions of polynomials, where zero is a proof.

Generators are symbols, cosine and sine of base angles (s**2 = 1 - c**2), exponentials, roots
(w**k = radicand) and values of opaque functions. A difference whose reduced numerator is the zero
polynomial is zero wherever it is defined, with no chance of error. The converse is not used: what
is not zero here may still be zero for a reason that the relations do not know.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

import sympy
from flint import fmpq, fmpq_mpoly

from mechanics.errors import ExpressionError
from mechanics.exact import normal_linear, normal_roots
from mechanics.exact.arithmetic import Arithmetic, Term, as_fraction
from mechanics.exact.normal_number import Powers, Quotient
from mechanics.exact.ring import MOST_GENERATORS, Ring
from mechanics.exact.signals import Inadmissible, Restart, TooLarge

Denominators = dict[Hashable, int]
"""For every angle or exponent atom, in order: the common denominator of its factors."""


class NormalArithmetic(Arithmetic):
    """Arithmetic over all states at once.

    Parameters
    ----------
    capacity : int
        Number of generators; Restart is raised when they run out.
    denominators : dict
        Learnt by earlier runs, extended by this one.
    expand_angles : bool
        True to write cos(a + b) in cosines and sines of a and b; False to keep every angle whole,
        which is shorter and enough where both sides were built on the same angles.
    """

    def __init__(self, capacity: int, denominators: Denominators, expand_angles: bool) -> None:
        super().__init__()
        self.ring = Ring(capacity)
        self.factors: list[fmpq_mpoly] = []
        self._denominators, self._expand = denominators, expand_angles
        self._atoms: dict[tuple[str, str], int] = {}
        self.compound = False

    def rational(self, number: int | Fraction) -> Quotient:
        """Return a constant."""
        return Quotient(self, self.ring.constant(as_fraction(number)), {})

    def _generator(self, key: Hashable, positive: bool = False) -> Quotient:
        return Quotient(self, self.ring.generator(key, positive), {})

    def symbol(self, symbol: sympy.Symbol) -> Quotient:
        """Return a generator."""
        return self._generator(symbol, bool(symbol.is_nonnegative))

    def constant(self, constant: sympy.Expr) -> Quotient:
        """Return a generator."""
        return self._generator(constant, positive=True)

    # ------------------------------------------------------------------ denominators

    def denominator(self, powers: Powers) -> fmpq_mpoly:
        """Return a denominator multiplied out."""
        result = self.ring.constant(1)
        for factor, power in powers.items():
            result = self.ring.product(result, self.ring.power(self.factors[factor], power))
        return result

    def over(self, x: Quotient, common: Powers) -> fmpq_mpoly:
        """Return the numerator of `x` over a common denominator."""
        missing = {f: n - x.powers.get(f, 0) for f, n in common.items() if n > x.powers.get(f, 0)}
        return self.ring.product(x.numerator, self.denominator(missing)) if missing else x.numerator

    def factored(self, x: fmpq_mpoly) -> tuple[fmpq, Powers]:
        """Return a polynomial as constant times known factors: generators and one remainder."""
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
        for number, known in enumerate(self.factors):
            if known == polynomial:
                return number
        self.factors.append(polynomial)
        return len(self.factors) - 1

    def cancelled(self, numerator: fmpq_mpoly, powers: Powers) -> Quotient:
        """Return a fraction without the factors that divide the numerator as it stands."""
        left = {}
        for factor, power in powers.items():
            divisor = self.factors[factor]
            self.ring.spend(len(numerator))
            while power:
                quotient, remainder = divmod(numerator, divisor)
                if remainder != 0:
                    break
                numerator, power = quotient, power - 1
            if power:
                left[factor] = power
        return Quotient(self, numerator, left)

    # ------------------------------------------------------------------ angles and exponents

    def _multiples(self, kind: str, terms: Sequence[Term]) -> list[tuple[str, int]]:
        """Return (atom, integer multiple of its base) for the sum of the terms."""
        total = sum((self.rational(factor) * number for factor, number in terms), self.rational(0))
        numerator = self.ring.reduced(total.numerator)
        if total.powers or not self._expand:
            return self._whole(kind, numerator, total.powers)
        return [
            self._multiple(kind, str(self.ring.reduced(monomial / value)), _ratio(value))
            for monomial, value in _monomials(numerator)
        ]

    def _whole(self, kind: str, numerator: fmpq_mpoly, powers: Powers) -> list[tuple[str, int]]:
        """Return the whole argument as one atom: up to a factor, so that 2 a is twice a."""
        if numerator == 0:
            return []
        self.compound = self.compound or len(numerator) > 1
        unit = numerator.leading_coefficient()
        atom = f"({numerator / unit}) / {sorted(powers.items())}"
        return [self._multiple(kind, atom, _ratio(unit))]

    def _multiple(self, kind: str, atom: str, factor: Fraction) -> tuple[str, int]:
        number = self._atoms.setdefault((kind, atom), len(self._atoms))
        common = self._denominators.setdefault((kind, number), 1)
        if common % factor.denominator:
            self._denominators[kind, number] = lcm(common, factor.denominator)
            raise Restart(f"base angle over {factor.denominator}")
        return atom, int(factor * common)

    def circle(self, terms: Sequence[Term]) -> tuple[Quotient, Quotient]:
        """Return cos and sin by the group law."""
        c, s = self.rational(1), self.rational(0)
        for atom, multiple in self._multiples("circle", terms):
            x, y = (Quotient(self, part, {}) for part in self.ring.circle(atom))
            if multiple < 0:
                y = -y
            for _ in range(abs(multiple)):
                c, s = c * x - s * y, s * x + c * y
        return c, s

    def exponential(self, terms: Sequence[Term]) -> Quotient:
        """Return a product of powers."""
        result = self.rational(1)
        for atom, multiple in self._multiples("exp", terms):
            result = result * self._generator(("exp", atom), positive=True) ** multiple
        return result

    # ------------------------------------------------------------------ roots and opaque functions

    def root_power(self, number: Quotient, exponent: Fraction) -> Quotient:
        """Return a rational power; squares and known positive factors are taken out."""
        return normal_roots.power(self, number, exponent)

    def absolute(self, number: Quotient) -> Quotient:
        """Return |N| / |D|."""
        return normal_roots.absolute(self, number)

    def sign(self, number: Quotient) -> Quotient:
        """Return |x| / x."""
        return self.absolute(number) / number

    def _key(self, number: Quotient) -> tuple[str, str]:
        numerator = self.ring.reduced(number.numerator)
        return str(numerator), str(sorted(number.powers.items()))

    def indicator(self, relation: str, difference: Quotient) -> Quotient:
        """Return a generator; ``x < 0`` is the complement of ``-x <= 0``."""
        if relation == "<=":
            return 1 - self._generator(("<", self._key(-difference)))
        return self._generator((relation, self._key(difference)))

    def select(self, condition: Quotient, yes: Quotient, no: Quotient) -> Quotient:
        """Return h yes + (1 - h) no."""
        return condition * yes + (1 - condition) * no

    def function(self, name: str, arguments: Sequence[Quotient]) -> Quotient:
        """Return a generator for each name and normal form of the arguments."""
        return self._generator((name, *(self._key(argument) for argument in arguments)))

    # ------------------------------------------------------------------ linear algebra

    def solve(self, rows: Sequence[Sequence[Quotient]], rhs: Sequence[Quotient]) -> list[Quotient]:
        """Solve by Cramer's rule, for few unknowns."""
        return normal_linear.solve(self, rows, rhs)

    def rank(self, rows: Sequence[Sequence[Quotient]]) -> int:
        """Return the rank over the field of fractions."""
        return normal_linear.rank(self, rows)

    def is_zero(self, number: Quotient) -> bool:
        """Tell whether a fraction is zero everywhere."""
        return bool(self.ring.reduced((self.rational(0) + number).numerator) == 0)

    def require_positive(self, number: Quotient) -> None:
        """Ask for nothing: all admissible states are looked at together."""


def _monomials(x: fmpq_mpoly) -> list[tuple[fmpq_mpoly, fmpq]]:
    """Return the terms of a polynomial, each with its coefficient."""
    context = x.context()
    return [(context.from_dict({powers: value}), value) for powers, value in x.terms()]


def _ratio(value: fmpq) -> Fraction:
    return Fraction(int(value.p), int(value.q))


def proves(experiment: Callable[[Arithmetic], Sequence[tuple[Any, Any]]]) -> bool:
    """Tell whether all pairs of an experiment have the same normal form.

    False says nothing: too large, an operation without normal form, or really different.
    """
    proved, compound = _attempt(experiment, expand_angles=False)
    return proved or (compound and _attempt(experiment, expand_angles=True)[0])


def _attempt(
    experiment: Callable[[Arithmetic], Sequence[tuple[Any, Any]]], expand_angles: bool
) -> tuple[bool, bool]:
    """Return whether it is proved, and whether there are sums of angles that could be expanded."""
    capacity, denominators = 24, Denominators()
    while capacity <= MOST_GENERATORS:
        a = NormalArithmetic(capacity, denominators, expand_angles)
        try:
            return all(a.is_zero(a.rational(0) + x - y) for x, y in experiment(a)), a.compound
        except Restart as reason:
            capacity *= 2 if "ring" in str(reason) else 1
        except (TooLarge, Inadmissible, ExpressionError):
            return False, a.compound  # the certificate of the field stands
    return False, False
