"""Roots in the normal form: sqrt(c m**2 q) = sqrt(c) m sqrt(q) for positive m.

A radicand N / D is written N D**(k-1) / D**k. From its numerator are taken out: rational content,
prime by prime; positive generators, one root generator for each; and a polynomial whose k-th power
it is. What is left is one generator w with w**k = rest.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import sympy
from flint import fmpq, fmpq_mpoly
from flint.utils.flint_exceptions import DomainError

from mechanics.exact.normal_number import Quotient
from mechanics.exact.ring import content
from mechanics.exact.signals import TooLarge

if TYPE_CHECKING:
    from mechanics.exact.normal import NormalArithmetic

LARGEST_CONTENT = 10**18


def power(a: NormalArithmetic, number: Quotient, exponent: Fraction) -> Quotient:
    """Return number**exponent, root by prime root."""
    root = number
    for k, times in sympy.factorint(exponent.denominator).items():
        for _ in range(times):
            root = _root(a, root, int(k))
    return root**exponent.numerator


def _root(a: NormalArithmetic, number: Quotient, k: int) -> Quotient:
    ring = a.ring
    below = a.denominator(number.powers)
    radicand = ring.product(ring.reduced(number.numerator), ring.power(below, k - 1))
    if radicand == 0:
        return a.rational(0)
    return Quotient(a, _of_polynomial(a, radicand, k), {}) * Quotient(a, below, {}).inverse()


def _of_polynomial(a: NormalArithmetic, radicand: fmpq_mpoly, k: int) -> fmpq_mpoly:
    ring = a.ring
    unit = content(radicand)
    rest = radicand / fmpq(unit.numerator, unit.denominator)
    result = _of_rational(a, unit, k)
    powers = rest.term_content().degrees()
    for place in sorted(ring.positive):
        if powers[place] > 0:
            whole, part = divmod(int(powers[place]), k)
            rest = rest / ring.gen(place) ** int(powers[place])
            root = _generator(a, ring.gen(place), k) if part else ring.constant(1)
            result = ring.product(result, ring.gen(place) ** whole * root**part)
    return ring.product(result, _of_rest(a, rest, k))


def _of_rational(a: NormalArithmetic, unit: Fraction, k: int) -> fmpq_mpoly:
    """Return the root of a positive rational, prime by prime."""
    whole = unit.numerator * unit.denominator ** (k - 1)
    if whole > LARGEST_CONTENT:
        raise TooLarge(f"radicand {unit} is not factored")
    result = a.ring.constant(Fraction(1, unit.denominator))
    for prime, times in sympy.factorint(whole).items():
        result = result * int(prime) ** (int(times) // k)
        if times % k:
            root = _generator(a, a.ring.constant(int(prime)), k)
            result = a.ring.product(result, root ** (int(times) % k))
    return result


def _of_rest(a: NormalArithmetic, rest: fmpq_mpoly, k: int) -> fmpq_mpoly:
    if rest == 1:
        return rest
    if k == 2:
        try:
            return _size(a, rest.sqrt())
        except DomainError:
            pass  # no square: a generator of its own, below
    return _generator(a, rest, k)


def _generator(a: NormalArithmetic, radicand: fmpq_mpoly, k: int) -> fmpq_mpoly:
    """Return the positive generator w with w**k = radicand."""
    place, new = a.ring.place(("root", k, str(radicand)), positive=True)
    w = a.ring.gen(place)
    if new:
        a.ring.relate(((place, k),), w**k - radicand)
    return w


def absolute(a: NormalArithmetic, number: Quotient) -> Quotient:
    """Return |N| / |D|."""
    below = a.denominator(number.powers)
    above = _size(a, a.ring.reduced(number.numerator))
    return Quotient(a, above, {}) * Quotient(a, _size(a, below), {}).inverse()


def _size(a: NormalArithmetic, x: fmpq_mpoly) -> fmpq_mpoly:
    """Return |x|: x or -x where the signs of all terms tell, else factor by factor."""
    for side in (x, -x):
        if _nonnegative(a, side):
            return side
    ring = a.ring
    monomial = x.term_content()
    rest = x / monomial / (x / monomial).leading_coefficient()
    result = ring.constant(1) * abs((x / monomial).leading_coefficient())
    for place, times in enumerate(monomial.degrees()):
        if times > 0:
            part = ring.gen(place)
            size = part if place in ring.positive else _modulus(a, part)
            result = ring.product(result, ring.power(size, int(times)))
    return result if rest == 1 else ring.product(result, _modulus(a, rest))


def _modulus(a: NormalArithmetic, x: fmpq_mpoly) -> fmpq_mpoly:
    """Return the positive generator w with w**2 = x**2."""
    place, new = a.ring.place(("modulus", str(x)), positive=True)
    w = a.ring.gen(place)
    if new:
        a.ring.relate(((place, 2),), w**2 - a.ring.product(x, x))
    return w


def _nonnegative(a: NormalArithmetic, x: fmpq_mpoly) -> bool:
    """Tell whether all terms are plainly nonnegative."""
    free = [place for place in range(a.ring.capacity) if place not in a.ring.positive]
    return all(
        value > 0 and not any(powers[place] % 2 for place in free) for powers, value in x.terms()
    )
