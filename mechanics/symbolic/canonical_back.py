"""A polynomial back into SymPy: a sum of products, built in SymPy's own order.

Of s**2 + c**2 = 1 every angle uses the side that leaves fewer terms.
"""

from collections.abc import Container, Iterable
from functools import cmp_to_key
from itertools import compress

import sympy
from flint import fmpq_mpoly

from mechanics.kernel.ring import Ring

Factor = tuple[int, int]
"""Place of a generator and its power."""


def expression(ring: Ring, polynomial: fmpq_mpoly) -> sympy.Expr:
    """Return a reduced polynomial as a SymPy expression in expanded form."""
    return Writer(ring).write(shortest(ring, polynomial))


def generator_expression(ring: Ring, place: int) -> sympy.Expr:
    """Return what the generator at a place stands for."""
    key = ring.keys[place]
    if isinstance(key, tuple):
        return (sympy.cos if key[0] == "cos" else sympy.sin)(key[1])
    return key


def shortest(ring: Ring, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """Return the polynomial with c**2 replaced by 1 - s**2 where that leaves fewer terms."""
    degrees = polynomial.degrees()
    for c, s in circles(ring, [place for place, degree in enumerate(degrees) if degree > 1]):
        if polynomial.degrees()[c] < 2:
            continue
        sin, cos = ring.gen(s), ring.gen(c)
        swapped = polynomial.compose(*(
            sin if i == c else cos if i == s else ring.gen(i) for i in range(ring.capacity)
        )) % (sin**2 + cos**2 - 1)  # fmt: skip
        if len(swapped) < len(polynomial):
            polynomial = swapped.compose(*(
                sin if i == c else cos if i == s else ring.gen(i) for i in range(ring.capacity)
            ))  # fmt: skip
    return polynomial


def circles(ring: Ring, cosines: Container[int] | None = None) -> list[Factor]:
    """Return the places (c, s) of angles, all or those with these c, in the order of their names.

    Names of angles that are sines of sines are long: only those that are wanted are put in order.
    """
    places = {key: place for place, key in ring.keys.items()}
    angles = [key[1] for key in places if isinstance(key, tuple) and key[0] == "sin"]
    if cosines is not None:
        angles = [angle for angle in angles if places["cos", angle] in cosines]
    return [(places["cos", a], places["sin", a]) for a in sorted(angles, key=str)]


class Writer:
    """Writes polynomials of one ring; every power of a generator is built once."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring
        self._factors: dict[Factor, sympy.Expr] = {}

    def write(self, polynomial: fmpq_mpoly) -> sympy.Expr:
        """Return a polynomial as a SymPy sum."""
        products = [self._arguments(powers, value) for powers, value in terms(polynomial)]
        rank = ranks({part for parts, _ in products for part in parts})
        if not all(plain and len(parts) > 1 for parts, plain in products) or len(products) < 2:
            return sympy.Add(*(product(parts, plain, rank) for parts, plain in products))
        # Products of different powers of symbols never combine: SymPy would only sort them, by
        # the number of their factors and then factor by factor, which costs it most of the time.
        sums = [ordered(parts, rank) for parts, _ in products]
        sums.sort(key=lambda parts: (len(parts), [rank[part] for part in parts]))
        return sympy.Add._from_args([_product(parts) for parts in sums], is_commutative=True)

    def _arguments(
        self, factors: tuple[Factor, ...], value: sympy.Rational
    ) -> tuple[list[sympy.Expr], bool]:
        """Return the factors of a term, its number included, and whether none can combine."""
        parts = [self._factor(factor) for factor in factors]
        if value != 1 or not parts:
            parts.insert(0, value)
        return parts, all(self._plain(place) for place, _ in factors)

    def _factor(self, factor: Factor) -> sympy.Expr:
        if factor not in self._factors:
            place, power = factor
            self._factors[factor] = sympy.Pow(generator_expression(self._ring, place), power)
        return self._factors[factor]

    def _plain(self, place: int) -> bool:
        """Tell whether powers of a generator cannot combine with others: a symbol or a circle's."""
        return isinstance(self._ring.keys[place], sympy.Symbol | tuple)


def ranks(parts: Iterable[sympy.Expr]) -> dict[sympy.Expr, int]:
    """Return the order in which SymPy keeps the parts of a product or sum."""
    order = sorted(parts, key=cmp_to_key(sympy.Basic.compare))
    return {part: rank for rank, part in enumerate(order)}


def ordered(parts: list[sympy.Expr], rank: dict[sympy.Expr, int]) -> list[sympy.Expr]:
    """Return the factors of a product as SymPy orders them: a number first."""
    return sorted(parts, key=lambda part: (not part.is_Number, rank[part]))


def product(parts: list[sympy.Expr], plain: bool, rank: dict[sympy.Expr, int]) -> sympy.Expr:
    """Return a product; what may combine (roots, inverses, moduli) is left to SymPy."""
    return _product(ordered(parts, rank)) if plain else sympy.Mul(*parts)


def _product(parts: list[sympy.Expr]) -> sympy.Expr:
    return parts[0] if len(parts) == 1 else sympy.Mul._from_args(parts, is_commutative=True)


def terms(polynomial: fmpq_mpoly) -> list[tuple[tuple[Factor, ...], sympy.Rational]]:
    """Return the terms with only the generators that occur in each."""
    return [
        (
            tuple((place, int(powers[place])) for place in compress(range(len(powers)), powers)),
            sympy.Rational(int(value.p), int(value.q)),
        )
        for powers, value in polynomial.terms()
    ]
