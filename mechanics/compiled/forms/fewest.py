"""Unknowns of a small linear system with the fewest operations that a search finds.

    x'' = (M s (l w^2 + g c) - 8/3 k x) / (4/3 (M + m) - M c^2),   theta'' = (g s + c x'') / -l

Quotients of polynomials (`.closed`) are nested (`.nested`); the
search decides what is multiplied first, by which numbers both sides of a quotient are multiplied,
and which order the unknowns have.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

from sympy import Matrix, Symbol

from mechanics.compiled.forms.closed import Polynomial, Quotient, quotients
from mechanics.compiled.forms.coefficient import Coefficient
from mechanics.compiled.forms.graph import Decide, Written, search, written
from mechanics.compiled.forms.horner import UNIT, Choice, Nest, Table, Term

PATIENCE, MOST = 80, 2000
"""Trials without success after which a search ends, and trials after which it ends anyway."""

STARTS = 3
"""Searches, each from a start of its own."""

NEGATIVE, APART, EARLY = 0.3, 0.4, 0.5
"""How often, at first, a number is negative, sides have scales of their own, parts are divided."""


def nested_quotients(
    left: Matrix, right: Matrix, unknowns: Sequence[Symbol], definite: bool
) -> list[Written]:
    """Ways to write the solution of K x = k, the cheapest first.

    Raises
    ------
    TooLarge
        If the system is not small.
    """
    orders = quotients(left, right, unknowns, definite)
    found = (_searched(solved, seed) for solved in orders for seed in range(STARTS))
    return sorted(found, key=lambda way: way.cost)


@lru_cache(maxsize=256)
def _searched(solved: tuple[Quotient, ...], seed: int) -> Written:
    table = Table()
    scaled = [_scaled(quotient, table) for quotient in solved]
    return search(partial(_write, scaled, table), seed, PATIENCE, MOST)


@dataclass(frozen=True)
class Scaled:
    """A quotient whose sides are multiplied by numbers: ``scales[i] * polynomial``."""

    unknown: Symbol
    scales: tuple[Coefficient, ...]
    above: tuple[tuple[Term, ...], ...]
    below: tuple[tuple[Term, ...], ...]
    between: dict[tuple[int, int], int]


def _scaled(quotient: Quotient, table: Table) -> Scaled:
    """Numerator and denominator times every number that makes a coefficient one."""
    inverses = [UNIT / value for _, value in (*quotient.above, *quotient.below)]
    scales = tuple(dict.fromkeys(scale for value in inverses for scale in (value, -value)))
    return Scaled(
        quotient.unknown,
        scales,
        tuple(table.terms(_times(quotient.above, scale)) for scale in scales),
        tuple(table.terms(_times(quotient.below, scale)) for scale in scales),
        {(i, j): table.place(below / above)
         for i, above in enumerate(scales) for j, below in enumerate(scales)},
    )  # fmt: skip


def _times(polynomial: Polynomial, scale: Coefficient) -> Polynomial:
    return tuple((parts, scale * value) for parts, value in polynomial)


def _write(scaled: Sequence[Scaled], table: Table, decide: Decide) -> Written:
    """One way to write the quotients, as it is decided."""
    choice = Choice(
        rank=lambda factor: decide("rank", factor),
        negative=lambda number: decide("negative", number) < NEGATIVE,
    )
    nest = Nest(table, choice)
    roots = {}
    for j in sorted(range(len(scaled)), key=lambda j: decide("order", j)):
        quotient = scaled[j]
        count = len(quotient.scales)
        above = below = int(decide("above", j) * count)
        if decide("apart", j) < APART:
            below = int(decide("below", j) * count)
        roots[quotient.unknown] = nest.quotient(
            quotient.above[above],
            quotient.below[below],
            quotient.between[above, below],
            decide("early", j) < EARLY,
        )
    return written(nest, roots)
