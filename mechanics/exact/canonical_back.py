"""A polynomial back into SymPy: a sum of products, built in SymPy's own order.

Of s**2 + c**2 = 1 every angle uses the side that leaves fewer terms.
"""

from __future__ import annotations

from functools import cmp_to_key
from typing import TYPE_CHECKING

import sympy
from flint import fmpq_mpoly

if TYPE_CHECKING:
    from mechanics.exact.ring import Ring

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
    for c, s in circles(ring):
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


def circles(ring: Ring) -> list[Factor]:
    """Return the places (c, s) of all angles, in the order of their names."""
    places = {key: place for place, key in ring.keys.items()}
    angles = [key[1] for key in places if isinstance(key, tuple) and key[0] == "sin"]
    return [(places["cos", a], places["sin", a]) for a in sorted(angles, key=str)]


class Writer:
    """Writes polynomials of one ring; every power of a generator is built once."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring
        self._factors: dict[Factor, sympy.Expr] = {}

    def write(self, polynomial: fmpq_mpoly) -> sympy.Expr:
        """Return a polynomial as a SymPy sum."""
        pairs = terms(polynomial)
        for factors, _ in pairs:
            for factor in factors:
                if factor not in self._factors:
                    place, power = factor
                    base = generator_expression(self._ring, place)
                    self._factors[factor] = sympy.Pow(base, power)
        rank = self._ranks()
        return sympy.Add(*(self._term(rank, factors, value) for factors, value in pairs))

    def _ranks(self) -> dict[Factor, int]:
        """Return the order in which SymPy keeps the factors of a product."""
        order = sorted(
            self._factors, key=lambda f: cmp_to_key(sympy.Basic.compare)(self._factors[f])
        )
        return {factor: rank for rank, factor in enumerate(order)}

    def _term(
        self, rank: dict[Factor, int], factors: tuple[Factor, ...], value: sympy.Rational
    ) -> sympy.Expr:
        parts = [self._factors[factor] for factor in sorted(factors, key=rank.__getitem__)]
        if not all(self._plain(place) for place, _ in factors):
            return sympy.Mul(value, *parts)  # roots, inverses and moduli may combine
        if value != 1 or not parts:
            parts.insert(0, value)
        return parts[0] if len(parts) == 1 else sympy.Mul._from_args(parts)

    def _plain(self, place: int) -> bool:
        """Tell whether powers of a generator cannot combine with others: a symbol or a circle's."""
        return isinstance(self._ring.keys[place], sympy.Symbol | tuple)


def terms(polynomial: fmpq_mpoly) -> list[tuple[tuple[Factor, ...], sympy.Rational]]:
    """Return the terms with only the generators that occur in each."""
    used = [place for place, power in enumerate(polynomial.degrees()) if power > 0]
    return [
        (
            tuple((place, int(powers[place])) for place in used if powers[place]),
            sympy.Rational(int(value.p), int(value.q)),
        )
        for powers, value in polynomial.terms()
    ]
