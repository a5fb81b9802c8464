"""The form of forward dynamics with the fewest operations that a search finds.

    cost = number of operations + number of divisions, then numbers that no double holds

Quotients of polynomials (`mechanics.compiled.closed`) are nested in many ways
(`mechanics.compiled.nested`); one choice is changed at a time, and what costs no more is kept. The
search always takes the same path, so the same equations give the same code.
"""

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from operator import add, mul, sub, truediv
from random import Random

import casadi as ca
from sympy import Matrix, Symbol

from mechanics.compiled.closed import Polynomial, Quotient, quotients
from mechanics.compiled.coefficient import Coefficient
from mechanics.compiled.nested import UNIT, Choice, Nest, Table, Term
from mechanics.compiled.translate import Translator

PATIENCE = 80
STARTS = 3
"""Trials without success after which a search ends, and searches, each from a start of its own."""

NEGATIVE, APART, EARLY = 0.3, 0.4, 0.5
"""How often, at first, a number is negative, sides have scales of their own, parts are divided."""

FUNCTION = 20
"""What a sine costs, in operations."""


@dataclass(frozen=True)
class Written:
    """Unknowns as nodes of a nest, and what computing all of them costs."""

    nest: Nest
    roots: tuple[tuple[Symbol, int], ...]
    cost: tuple[int, int]


def written(
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


def solution(found: Written, unknowns: Sequence[Symbol], translate: Translator) -> ca.SX:
    """The graph of the unknowns, a column."""
    nodes, keys = found.nest.nodes, found.nest.table.keys
    roots = dict(found.roots)
    graphs: dict[int, ca.SX] = {}

    def graph(place: int) -> ca.SX:
        if place not in graphs:
            graphs[place] = build(*nodes[place])
        return graphs[place]

    def build(operation: str, one: int, two: int) -> ca.SX:
        if operation == "leaf":
            key = keys[one]
            if key in roots:
                return graph(roots[key])
            return translate.number(key.expr) if isinstance(key, Coefficient) else translate(key)
        if operation == "-" and one == two:
            return -graph(one)
        return OPERATIONS[operation](graph(one), graph(two))

    return ca.vertcat(*(graph(roots[unknown]) for unknown in unknowns))


OPERATIONS: dict[str, Callable[[ca.SX, ca.SX], ca.SX]] = {
    "+": add, "-": sub, "*": mul, "/": truediv,
}  # fmt: skip


@lru_cache(maxsize=256)
def _searched(solved: tuple[Quotient, ...], seed: int) -> Written:
    """Change one decision at a time; keep what costs no more."""
    random = Random(seed)
    table = Table()
    scaled = [_scaled(quotient, table) for quotient in solved]
    decisions: dict[Hashable, float] = {}

    def decide(*key: Hashable) -> float:
        if key not in decisions:
            decisions[key] = random.random()
        return decisions[key]

    best, idle = _write(scaled, table, decide), 0
    while idle < PATIENCE:
        key = random.choice(tuple(decisions))
        before, decisions[key] = decisions[key], random.random()
        found = _write(scaled, table, decide)
        idle = 0 if found.cost < best.cost else idle + 1
        if found.cost <= best.cost:
            best = found
        else:
            decisions[key] = before
    return best


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


def _write(scaled: Sequence[Scaled], table: Table, decide: Callable[..., float]) -> Written:
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
    return Written(nest, tuple(roots.items()), _cost(nest, roots.values()))


def _cost(nest: Nest, roots: Iterable[int]) -> tuple[int, int]:
    """Operations, a division counted twice, a function as many; and how awkward the numbers are."""
    seen: set[int] = set()
    stack, cost, awkward = list(roots), 0, 0
    while stack:
        place = stack.pop()
        if place in seen:
            continue
        seen.add(place)
        operation, one, two = nest.nodes[place]
        if operation == "leaf":
            key = nest.table.keys[one]
            if isinstance(key, Coefficient):
                awkward += key.awkward
            elif key.args:
                cost += FUNCTION
        else:
            cost += 2 if operation == "/" else 1
            stack += (one, two)
    return cost, awkward
