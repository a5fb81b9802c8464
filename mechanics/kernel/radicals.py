"""Roots and absolute values in the normal form: sqrt(c m**2 q) = sqrt(c) m sqrt(q) for positive m.

A radicand N / D is written N D**(k-1) / D**k. From its numerator are taken out: rational content,
prime by prime; positive generators, one root generator for each; and a polynomial whose square it
is. What is left is one generator w with w**k = rest.
"""

from fractions import Fraction

from flint import fmpq_mpoly, fmpz

from mechanics.kernel.quotients import Quotient, Quotients
from mechanics.kernel.ring import TooLarge, leading_powers, primitive_part, square_root
from mechanics.kernel.sizes import prime_factors

LARGEST_CONTENT = 10**18


def root(a: Quotients, x: Quotient, degree: int) -> Quotient:
    """The root of a number that is not negative, prime degree by prime degree."""
    for k in prime_factors(degree):
        x = _prime_root(a, x, k)
    return x


def _prime_root(a: Quotients, x: Quotient, k: int) -> Quotient:
    ring = a.ring
    below = a.denominator(x.powers)
    radicand = ring.product(ring.reduced(x.numerator), ring.power(below, k - 1))
    if radicand == 0:
        return a.constant(Fraction(0))
    if k == 2:
        return _divided(a, _of_polynomial(a, radicand, k, True), _size(a, below))
    # N and D may both be negative: the odd root of N D**(k-1) is so too then.
    return _divided(a, _of_polynomial(a, radicand, k, not x.powers), below)


def _divided(a: Quotients, above: fmpq_mpoly, below: fmpq_mpoly) -> Quotient:
    return a.divide(Quotient(above, {}), Quotient(below, {}))


def _of_polynomial(a: Quotients, radicand: fmpq_mpoly, k: int, positive: bool) -> fmpq_mpoly:
    ring = a.ring
    unit, rest = primitive_part(radicand)
    result = _of_rational(a, unit, k)
    powers = rest.term_content().degrees()
    for place in sorted(ring.positive):
        if powers[place] > 0:
            whole, part = divmod(int(powers[place]), k)
            rest = rest / ring.gen(place) ** int(powers[place])
            below = _generator(a, ring.gen(place), k) if part else ring.constant(1)
            result = ring.product(result, ring.gen(place) ** whole * below**part)
    return ring.product(result, _of_rest(a, rest, k, positive))


def _of_rational(a: Quotients, unit: Fraction, k: int) -> fmpq_mpoly:
    """The root of a positive rational, prime by prime."""
    whole = unit.numerator * unit.denominator ** (k - 1)
    if whole > LARGEST_CONTENT:
        raise TooLarge(f"radicand {unit} is not factored")
    result = a.ring.constant(Fraction(1, unit.denominator))
    for prime, times in fmpz(whole).factor():
        result = result * int(prime) ** (int(times) // k)
        if times % k:
            surd = _generator(a, a.ring.constant(int(prime)), k)
            result = a.ring.product(result, surd ** (int(times) % k))
    return result


def _of_rest(a: Quotients, rest: fmpq_mpoly, k: int, positive: bool) -> fmpq_mpoly:
    if rest == 1:
        return rest
    if k == 2 and (whole := square_root(rest)) is not None:
        return _size(a, whole)
    return _generator(a, rest, k, positive)


def _generator(a: Quotients, radicand: fmpq_mpoly, k: int, positive: bool = True) -> fmpq_mpoly:
    """The generator w with w**k = radicand, not negative unless it is said to be free."""
    return a.ring.root(("root", k, positive, str(radicand)), k, radicand, positive)


def absolute(a: Quotients, x: Quotient) -> Quotient:
    """|N| / |D|."""
    below = a.denominator(x.powers)
    return _divided(a, _size(a, a.ring.reduced(x.numerator)), _size(a, below))


def sign(a: Quotients, x: Quotient) -> Quotient:
    """sign(N) sign(D), where D is not zero."""
    below = a.denominator(x.powers)
    over = Quotient(a.ring.product(_sign(a, a.ring.reduced(x.numerator)), below), {})
    return a.divide(over, Quotient(_size(a, below), {}))


def _sign(a: Quotients, x: fmpq_mpoly) -> fmpq_mpoly:
    """The generator g with g**3 = g, g x = |x| and g |x| = x; it is 0 where x is."""
    if x == 0:
        return x
    side = -1 if x.leading_coefficient() < 0 else 1
    if x.is_constant():
        return a.ring.constant(side)
    _, x = primitive_part(side * x)
    size = _size(a, x)
    key = ("sign", str(x))
    g = a.ring.root(key, 3, a.ring.generator(key))
    for one, other in ((x, size), (size, x)):
        a.ring.relate(((a.ring.place(key), 1), *leading_powers(one)), g * one - other)
    return side * g


def _size(a: Quotients, x: fmpq_mpoly) -> fmpq_mpoly:
    """|x|: x or -x where the signs of all terms tell, else factor by factor."""
    if x == 0:
        return x
    for side in (x, -x):
        if _nonnegative(a, side):
            return side
    ring = a.ring
    monomial = x.term_content()
    unit = (x / monomial).leading_coefficient()
    rest = x / monomial / unit
    result = ring.constant(1) * abs(unit)
    for place, times in enumerate(monomial.degrees()):
        if times > 0:
            part = ring.gen(place)
            size = part if place in ring.positive else _modulus(a, part)
            result = ring.product(result, ring.power(size, int(times)))
    return result if rest == 1 else ring.product(result, _modulus(a, rest))


def _modulus(a: Quotients, x: fmpq_mpoly) -> fmpq_mpoly:
    """The generator w >= 0 with w**2 = x**2."""
    return a.ring.root(("modulus", str(x)), 2, a.ring.product(x, x), positive=True)


def _nonnegative(a: Quotients, x: fmpq_mpoly) -> bool:
    """Whether all terms are plainly not negative."""
    free = [place for place in range(a.ring.capacity) if place not in a.ring.positive]
    return all(
        value > 0 and not any(powers[place] % 2 for place in free) for powers, value in x.terms()
    )
