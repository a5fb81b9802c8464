"""Polynomials over the rationals modulo relations with one leading power product each:

    s**2 = 1 - c**2,      w**k = radicand,      h**2 = h,      sign(x) x = |x|.

Generators are handed out from the last place of a lexicographic order to the first, so a generator
leads everything that was known when it was made, and dividing by a relation (python-flint's
multivariate division) replaces its leading power wherever it stands. Work is counted in products of
terms, never in time.
"""

from collections.abc import Hashable
from fractions import Fraction
from math import gcd, lcm

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from flint.utils.flint_exceptions import DomainError

from mechanics.errors import MechanicsError

MOST_TERMS = 40_000
MOST_WORK = 4_000_000
MOST_GENERATORS = 600


Lead = tuple[tuple[int, int], ...]
"""Places of generators and their powers."""


class TooLarge(MechanicsError, OverflowError):
    """The normal form outgrew its budget."""


class Full(TooLarge):
    """More generators are asked for than the ring has."""


class Ring:
    """A polynomial ring whose generators are named one by one, up to a capacity.

    Parameters
    ----------
    capacity : int
        Number of generators.
    limited : bool
        False for a user who has limits of generators, terms and work of its own.

    Attributes
    ----------
    keys : dict of int to hashable
        What the generators stand for, by their places.

    Raises
    ------
    TooLarge
        If there are more than MOST_GENERATORS.
    """

    def __init__(self, capacity: int, limited: bool = True) -> None:
        if limited and capacity > MOST_GENERATORS:
            raise TooLarge(f"{capacity} generators")
        self.capacity, self.limited = capacity, limited
        self._context = fmpq_mpoly_ctx.get([f"g{i}" for i in range(capacity)], "lex")
        self._gens = self._context.gens()
        self._places: dict[Hashable, int] = {}
        self.keys: dict[int, Hashable] = {}
        self._relations: dict[Lead, fmpq_mpoly] = {}
        self.positive: set[int] = set()
        self._work = 0

    def constant(self, number: int | Fraction) -> fmpq_mpoly:
        """A rational constant."""
        ratio = Fraction(number)
        return self._context.constant(fmpq(ratio.numerator, ratio.denominator))

    def place(self, key: Hashable, positive: bool = False) -> int:
        """The place of a generator, which is made when it is first asked for.

        Raises
        ------
        Full
            If the ring is.
        """
        if key in self._places:
            return self._places[key]
        place = self.capacity - 1 - len(self._places)
        if place < 0:
            raise Full(f"ring of {self.capacity} generators is full")
        self._places[key] = place
        self.keys[place] = key
        if positive:
            self.positive.add(place)
        return place

    def gen(self, place: int) -> fmpq_mpoly:
        """The generator at a place."""
        return self._gens[place]

    def generator(self, key: Hashable, positive: bool = False) -> fmpq_mpoly:
        """The generator of a key."""
        return self._gens[self.place(key, positive)]

    def root(
        self, key: Hashable, degree: int, radicand: fmpq_mpoly, positive: bool = False
    ) -> fmpq_mpoly:
        """The generator w of a key, with w**degree = radicand."""
        place = self.place(key, positive)
        w = self._gens[place]
        self.relate(((place, degree),), w**degree - radicand)
        return w

    def circle(self, key: Hashable) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Cosine and sine of an angle."""
        cos = self.generator(("cos", key))
        return cos, self.root(("sin", key), 2, 1 - cos**2)

    def relate(self, lead: Lead, polynomial: fmpq_mpoly) -> None:
        """Let ``polynomial = 0``; `lead` must be the power product that leads it."""
        self._relations[lead] = polynomial

    def product(self, x: fmpq_mpoly, y: fmpq_mpoly) -> fmpq_mpoly:
        """x y, reduced.

        Raises
        ------
        TooLarge
            If it, or all products so far, are beyond the budget.
        """
        self.spend(len(x) * len(y))
        return self.reduced(x * y)

    def power(self, x: fmpq_mpoly, exponent: int) -> fmpq_mpoly:
        """x**exponent for a natural exponent, reduced."""
        if len(x) <= 1:
            return self.reduced(x**exponent)
        result = self.constant(1)
        for _ in range(exponent):
            result = self.product(result, x)
        return result

    def put(self, x: fmpq_mpoly, place: int, value: fmpq_mpoly) -> fmpq_mpoly:
        """x with a polynomial in the place of a generator."""
        values = [*self._gens]
        values[place] = value
        return x.compose(*values)

    def spend(self, work: int) -> None:
        """Count products of terms.

        Raises
        ------
        TooLarge
            If the budget is used up.
        """
        self._work += work
        if self.limited and self._work > MOST_WORK:
            raise TooLarge(f"more than {MOST_WORK} products of terms")

    def reduced(self, x: fmpq_mpoly) -> fmpq_mpoly:
        """The remainder by all relations, the latest first.

        Raises
        ------
        TooLarge
            If it has too many terms.
        """
        changed = bool(self._relations)
        while changed:
            changed = False
            degrees = x.degrees()
            for lead, polynomial in reversed(self._relations.items()):
                if all(degrees[place] >= power for place, power in lead):
                    left = x % polynomial
                    self.spend(len(x) + len(left))
                    if left != x:
                        x, changed = left, True
                        degrees = x.degrees()
        if self.limited and len(x) > MOST_TERMS:
            raise TooLarge(f"{len(x)} terms")
        return x


def leading_powers(x: fmpq_mpoly) -> Lead:
    """The power product that leads a polynomial."""
    powers = x.monomial(0)
    return tuple((place, int(power)) for place, power in enumerate(powers) if power)


def square_root(x: fmpq_mpoly) -> fmpq_mpoly | None:
    """One of the two polynomials whose square it is, or None where there is none."""
    try:
        return x.sqrt()
    except DomainError:
        return None


def primitive_part(x: fmpq_mpoly) -> tuple[Fraction, fmpq_mpoly]:
    """The positive rational c such that x / c has coprime integer coefficients, and x / c."""
    top, bottom = 0, 1
    for coefficient in x.coeffs():
        top, bottom = gcd(top, int(coefficient.p)), lcm(bottom, int(coefficient.q))
    return Fraction(top, bottom), x / fmpq(top, bottom)
