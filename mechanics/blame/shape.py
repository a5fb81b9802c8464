"""Terms in the shape that is shortest to read.

cos a cos b + sin a sin b  ->  cos(a - b)        1 - cos^2 a  ->  sin^2 a
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import product as choices
from math import comb

from sympy import Add, Expr, Symbol, cos, sin

from mechanics.blame.terms import Monomial, Terms, written

Shape = Callable[[Terms], Expr]

MOST_TERMS = 60
"""Beyond, shapes are not tried: nobody reads them."""

Wave = tuple[tuple[Symbol, int], ...]
Waves = dict[Wave, tuple[Fraction, Fraction]]
"""Coefficients (real, imaginary) of exp(i sum n a), by the n that are not zero."""


def shortest(one: Terms, two: Terms) -> tuple[Expr, Expr]:
    """Two sides as expressions, in the same shape: the one with the fewest terms in all."""
    best = written(one), written(two)
    if len(one) + len(two) > MOST_TERMS:
        return best
    for shape in _shapes(one, two):
        found = shape(one), shape(two)
        if _length(found) < _length(best):
            best = found
    return best


def _length(sides: tuple[Expr, Expr]) -> int:
    return sum(len(Add.make_args(side)) for side in sides if side != 0)


def _shapes(one: Terms, two: Terms) -> Iterator[Shape]:
    powers: dict[Expr, int] = {}
    for monomial in (*one, *two):
        for atom, power in monomial:
            if isinstance(atom, sin | cos):
                powers[atom] = max(powers.get(atom, 0), power)
    for atom, power in powers.items():
        if isinstance(atom, cos) and power >= 2:
            yield partial(_written_in_sines, atom)
    if len({atom.args[0] for atom in powers}) > 1:
        yield in_sums


def _written_in_sines(turned: Expr, terms: Terms) -> Expr:
    return written(_in_sines(terms, turned))


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
