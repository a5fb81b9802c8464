"""The sign of a polynomial in numbers that are no rationals: pi, roots and sines of numbers.

A ball of enough digits tells the sign of what is not zero. What is made of roots of numbers alone
is zero if it is smaller than a bound: where l E is an algebraic integer of degree D at most, and u
bounds the absolute values of all its conjugates, their product is a whole number, so that

    E = 0   or   |E| >= 1 / (u^(D - 1) l).                                                   (1)

Burnikel, Fleischer, Mehlhorn, Schirra, "A strong and easily computable separation bound for
arithmetic expressions involving radicals", Algorithmica 27 (2000) 87-99.
"""

from collections.abc import Callable, Mapping
from math import inf, lcm, log2, prod

from flint import arb, fmpq, fmpq_mpoly

from mechanics.kernel.balls import precision

PRECISIONS = (64, 256, 1024)
MOST_BITS = 16384
"""Digits that are worth a try for (1)."""

Terms = Mapping[tuple[int, ...], fmpq]
"""Coefficients by the powers of all unknowns."""


class Numbers:
    """Which unknowns of polynomials are numbers, and what they are, each made of earlier ones."""

    def __init__(self) -> None:
        self._values: dict[int, Callable[[Mapping[int, arb]], arb]] = {}
        self._bounds: dict[int, tuple[float, float]] = {}
        self._below: dict[int, frozenset[int]] = {}

    def __contains__(self, place: int) -> bool:
        return place in self._values

    def __bool__(self) -> bool:
        return bool(self._values)

    def holds(self, polynomial: fmpq_mpoly) -> bool:
        """Whether a polynomial has no other unknowns."""
        return all(k in self._values for k, power in enumerate(polynomial.degrees()) if power)

    def pi(self, place: int) -> None:
        """Tell that an unknown is pi."""
        self._values.setdefault(place, lambda values: arb.pi())

    def root(self, place: int, radicand: fmpq_mpoly) -> None:
        """Tell that an unknown is the square root of a polynomial in numbers."""
        terms = radicand.to_dict()
        self._values.setdefault(place, lambda values: _at(terms, values).sqrt())
        bound = self.bound(terms)
        if bound is not None:
            u, l = bound
            # sqrt(U / l) = sqrt(U l) / l
            self._bounds[place] = (u + l) / 2, l
            self._below[place] = self._roots(terms) | {place}

    def circular(self, sine: int, cosine: int, above: fmpq_mpoly, below: fmpq_mpoly) -> None:
        """Tell that two unknowns are the sine and the cosine of a quotient of numbers."""
        over, under = above.to_dict(), below.to_dict()

        def angle(values: Mapping[int, arb]) -> arb:
            return _at(over, values) / _at(under, values)

        self._values.setdefault(sine, lambda values: angle(values).sin())
        self._values.setdefault(cosine, lambda values: angle(values).cos())

    def sign(self, terms: Terms) -> int | None:
        """-1, 0 or 1; None where it is not known."""
        digits = list(PRECISIONS)
        bound = self.bound(terms)
        smallest = inf
        if bound is not None:
            u, l = bound
            smallest = (2.0 ** len(self._roots(terms)) - 1) * u + l
            if smallest < MOST_BITS:
                # As many as (1) asks for, and some for rounding.
                enough = int(smallest + 2 * u) + 128
                digits = [bits for bits in PRECISIONS if bits < enough] + [enough]
        for bits in digits:
            with precision(bits):
                values: dict[int, arb] = {}
                for place, value in self._values.items():
                    values[place] = value(values)
                total = _at(terms, values)
                if total > 0 or total < 0:
                    return 1 if total > 0 else -1
                if smallest < MOST_BITS and abs(total) < arb(2) ** -int(smallest + 1):
                    return 0
        return None

    def _roots(self, terms: Terms) -> frozenset[int]:
        """Roots that something is made of."""
        places = {k for monomial in terms for k, power in enumerate(monomial) if power}
        return frozenset().union(*(self._below[k] for k in places))

    def bound(self, terms: Terms) -> tuple[float, float] | None:
        """log2 of u and l of (1), or None where something is no root."""
        powers = zip(*terms, strict=True)
        most = {k: int(max(column)) for k, column in enumerate(powers) if any(column)}
        if not most.keys() <= self._bounds.keys():
            return None
        whole = lcm(*(int(value.q) for value in terms.values()))
        l = log2(whole) + sum(self._bounds[k][1] * n for k, n in most.items())
        sizes = []
        for monomial, value in terms.items():
            size = log2(abs(int(value.p)) * (whole // int(value.q)))
            for k, n in most.items():
                u, own = self._bounds[k]
                size += u * int(monomial[k]) + own * (n - int(monomial[k]))
            sizes.append(size)
        # Logarithms are rounded: stay above.
        return max(sizes) + log2(len(sizes)) + 1e-6, l + 1e-6


def _at(terms: Terms, values: Mapping[int, arb]) -> arb:
    """The ball of a polynomial."""

    def term(monomial: tuple[int, ...]) -> arb:
        return prod((values[k] ** n for k, n in enumerate(monomial) if n), start=arb(1))

    return sum((value * term(monomial) for monomial, value in terms.items()), arb(0))
