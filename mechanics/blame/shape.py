"""Terms in the shape that is shortest to read.

cos a cos b + sin a sin b  ->  cos(a - b)        1 - cos^2 a  ->  sin^2 a
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import product as choices
from math import comb

from sympy import Add, Expr, Symbol, cos, factor, factor_terms, sin

from mechanics.blame.terms import Monomial, Terms, written
from mechanics.symbolic import operations

MOST_TERMS = 60
"""Beyond, shapes are not tried: nobody reads them."""

MOST_FACTORED = 12
"""Beyond, only common factors are taken out: all others take seconds to find."""

Wave = tuple[tuple[Symbol, int], ...]
Waves = dict[Wave, tuple[Fraction, Fraction]]
"""Coefficients (real, imaginary) of exp(i sum n a), by the n that are not zero."""


def shortest(one: Terms, two: Terms, *, summed: bool = False) -> tuple[Expr, Expr]:
    """What one has and two has not, and the other way round, in the same shape.

    Parameters
    ----------
    summed : bool
        Whether sines and cosines of sums are liked as well as those of single angles.

    Returns
    -------
    tuple of Expr
        In the shape with the fewest terms; common factors are taken out.
    """
    left, right = apart(one, two), apart(two, one)
    best = written(left), written(right)
    if len(left) + len(right) <= MOST_TERMS:
        for found in _shapes(one, two, left, right):
            gain = _length(best) - _length(found)
            if gain > 0 or (summed and gain == 0):
                best = found
    return _factored(best[0]), _factored(best[1])


def apart(one: Terms, two: Terms) -> Terms:
    """The terms of one that two has not, or with another factor."""
    return {monomial: value for monomial, value in one.items() if two.get(monomial) != value}


def _factored(side: Expr) -> Expr:
    """A sum as a product, where that is shorter."""
    count = len(Add.make_args(side))
    if not 1 < count <= MOST_TERMS:
        return side
    product = factor(side) if 2 < count <= MOST_FACTORED else factor_terms(side)
    return product if operations(product) < operations(side) else side


def _length(sides: tuple[Expr, Expr]) -> int:
    return sum(len(Add.make_args(side)) for side in sides if side != 0)


def _shapes(one: Terms, two: Terms, left: Terms, right: Terms) -> Iterator[tuple[Expr, Expr]]:
    """Both sides in each other shape."""
    powers: dict[Expr, int] = {}
    for monomial in (*left, *right):
        for atom, power in monomial:
            if isinstance(atom, sin | cos):
                powers[atom] = max(powers.get(atom, 0), power)
    for atom, power in powers.items():
        if isinstance(atom, cos) and power >= 2:
            yield written(_in_sines(left, atom)), written(_in_sines(right, atom))
    if len({atom.args[0] for atom in powers}) > 1 and len(one) + len(two) <= MOST_TERMS:
        sums = [set(Add.make_args(in_sums(side))) for side in (one, two)]
        yield Add(*(sums[0] - sums[1])), Add(*(sums[1] - sums[0]))


def _in_sines(terms: Terms, turned: Expr) -> Terms:
    """cos^2 a replaced by 1 - sin^2 a."""
    found = Terms()
    base = sin(turned.args[0])
    for monomial, value in terms.items():
        powers = dict(monomial)
        half, odd = divmod(max(powers.get(turned, 0), 0), 2)
        if half:
            powers[turned] = odd
        for k in range(half + 1):
            more = {**powers, base: powers.get(base, 0) + 2 * k}
            key = frozenset((atom, power) for atom, power in more.items() if power)
            found[key] = found.get(key, Fraction(0)) + value * comb(half, k) * (-1) ** k
    return {key: value for key, value in found.items() if value}


def in_sums(terms: Terms) -> Expr:
    """Products of sines and cosines as those of sums of angles."""
    parts: dict[Monomial, Waves] = {}
    for monomial, value in terms.items():
        angular = {(a, n) for a, n in monomial if isinstance(a, sin | cos) and n > 0}
        rest = frozenset(monomial - angular)
        waves = parts.setdefault(rest, {})
        for wave, (real, imaginary) in _waves(sorted(angular, key=str)).items():
            old = waves.get(wave, (Fraction(0), Fraction(0)))
            waves[wave] = old[0] + value * real, old[1] + value * imaginary
    sums = []
    for rest, waves in parts.items():
        factor = written({rest: Fraction(1)})
        sums += [factor * term for term in _back(waves)]
    return Add(*sums)


def _waves(factors: list[tuple[Expr, int]]) -> Waves:
    """A product of powers of sines and cosines as a sum of exponentials."""
    half = Fraction(1, 2)
    singles = [atom for atom, power in factors for _ in range(power)]
    found: Waves = {}
    for signs in choices((1, -1), repeat=len(singles)):
        real, imaginary = Fraction(1), Fraction(0)
        angles: dict[Symbol, int] = {}
        for atom, sign in zip(singles, signs, strict=True):
            angles[atom.args[0]] = angles.get(atom.args[0], 0) + sign
            if isinstance(atom, cos):
                real, imaginary = real * half, imaginary * half
            else:  # sin a = (e - 1/e) / 2i: times -i/2 or i/2
                real, imaginary = imaginary * half * sign, -real * half * sign
        wave = tuple(sorted(((a, n) for a, n in angles.items() if n), key=str))
        old = found.get(wave, (Fraction(0), Fraction(0)))
        found[wave] = old[0] + real, old[1] + imaginary
    return found


def _back(waves: Waves) -> Iterator[Expr]:
    """A real sum of exponentials as sines and cosines."""
    done: set[Wave] = set()
    for wave, (real, imaginary) in waves.items():
        if wave in done:
            continue
        done |= {wave, tuple((a, -n) for a, n in wave)}
        angle = Add(*(n * a for a, n in wave))
        twice = 2 if wave else 1
        if real:
            yield written({frozenset(): real * twice}) * cos(angle)
        if imaginary and wave:
            yield written({frozenset(): -imaginary * twice}) * sin(angle)
