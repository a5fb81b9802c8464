"""Polynomials over the rationals modulo relations with one leading power each:

    s**2 = 1 - c**2,      w**k = radicand,      r * base = 1.

Generators are handed out from the last place of a lexicographic order to the first, so a generator
leads everything that was known when it was made, and dividing by a relation (python-flint's
multivariate division) replaces its leading power wherever it stands.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from mechanics.exact.signals import Restart, TooLarge

MOST_TERMS = 40_000
MOST_WORK = 4_000_000
MOST_GENERATORS = 600


@dataclass(frozen=True)
class Relation:
    """``polynomial = 0``; it applies where every generator of `lead` has at least that power."""

    lead: tuple[tuple[int, int], ...]
    polynomial: Any


class Ring:
    """A polynomial ring that grows generator by generator up to a capacity.

    Parameters
    ----------
    capacity : int
        Number of generators. `generator` raises Restart when they are used up.
    """

    def __init__(self, capacity: int) -> None:
        self.capacity = capacity
        self._context = fmpq_mpoly_ctx.get([f"g{i}" for i in range(capacity)], "lex")
        self._gens = self._context.gens()
        self._places: dict[Hashable, int] = {}
        self.keys: dict[int, Hashable] = {}
        self.relations: list[Relation] = []
        self.positive: set[int] = set()
        self._work = 0

    def constant(self, number: int | Fraction) -> fmpq_mpoly:
        """Return a rational constant."""
        ratio = Fraction(number)
        return self._context.constant(fmpq(ratio.numerator, ratio.denominator))

    def from_terms(self, terms: Mapping[tuple[int, ...], fmpq]) -> fmpq_mpoly:
        """Return the polynomial with these coefficients by powers of all generators."""
        return self._context.from_dict(dict(terms))

    def place(self, key: Hashable, positive: bool = False) -> tuple[int, bool]:
        """Return the place of a generator, and whether it is new.

        Raises
        ------
        Restart
            If the ring is full.
        """
        if key in self._places:
            return self._places[key], False
        place = self.capacity - 1 - len(self._places)
        if place < 0:
            raise Restart(f"ring of {self.capacity} generators is full")
        self._places[key] = place
        self.keys[place] = key
        if positive:
            self.positive.add(place)
        return place, True

    def gen(self, place: int) -> fmpq_mpoly:
        """Return the generator at a place."""
        return self._gens[place]

    def generator(self, key: Hashable, positive: bool = False) -> fmpq_mpoly:
        """Return the generator of a key."""
        return self._gens[self.place(key, positive)[0]]

    def circle(self, key: Hashable) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Return cosine and sine of an angle, bound by s**2 + c**2 - 1 = 0."""
        (c, _), (s, new) = self.place(("cos", key)), self.place(("sin", key))
        cos, sin = self._gens[c], self._gens[s]
        if new:
            self.relate(((s, 2),), sin**2 + cos**2 - 1)
        return cos, sin

    def relate(self, lead: tuple[tuple[int, int], ...], polynomial: fmpq_mpoly) -> None:
        """Add a relation; `lead` must be the power product that leads the polynomial."""
        self.relations.append(Relation(lead, polynomial))

    def product(self, x: fmpq_mpoly, y: fmpq_mpoly) -> fmpq_mpoly:
        """Return x y, reduced.

        Raises
        ------
        TooLarge
            If it, or all products so far, are beyond the limits.
        """
        self.spend(len(x) * len(y))
        return self.reduced(x * y)

    def power(self, x: fmpq_mpoly, exponent: int) -> fmpq_mpoly:
        """Return x**exponent for a natural exponent, reduced."""
        if len(x) <= 1:
            return self.reduced(x**exponent)
        result = self.constant(1)
        for _ in range(exponent):
            result = self.product(result, x)
        return result

    def spend(self, work: int) -> None:
        """Count term products, so that a normal form cannot run away.

        Raises
        ------
        TooLarge
            If the limit is reached.
        """
        self._work += work
        if self._work > MOST_WORK:
            raise TooLarge(f"more than {MOST_WORK} products of terms")

    def reduced(self, x: fmpq_mpoly) -> fmpq_mpoly:
        """Return the remainder by all relations, the latest first.

        Raises
        ------
        TooLarge
            If it has too many terms.
        """
        changed = bool(self.relations)
        while changed:
            changed = False
            degrees = x.degrees()
            for relation in reversed(self.relations):
                if all(degrees[place] >= power for place, power in relation.lead):
                    left = x % relation.polynomial
                    self.spend(len(x) + len(left))
                    if left != x:
                        x, changed = left, True
                        degrees = x.degrees()
        if len(x) > MOST_TERMS:
            raise TooLarge(f"{len(x)} terms")
        return x


def content(x: fmpq_mpoly) -> Fraction:
    """Return the positive rational c such that x / c has coprime integer coefficients."""
    top, bottom = 0, 1
    for coefficient in x.coeffs():
        top, bottom = gcd(top, int(coefficient.p)), lcm(bottom, int(coefficient.q))
    return Fraction(top, bottom)
