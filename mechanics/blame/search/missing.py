"""The term that a sum lacks, told by how it grows.

    d = needed - has            d(2 s) / d(s) = 2**e        ->  s**e divides d
    what is left is a number, or a number times sines and cosines of the coordinates

Every quantity is doubled in turn, the motion solved anew. Of a sum in it (M + m) the parts are
d(2 s) - d(s), and they have to make up the whole.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import combinations

from sympy import Symbol

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import ADDED, HINT, Change, plus, raised, size_of
from mechanics.blame.search.circular import Circular, circular
from mechanics.blame.search.growth import Growth
from mechanics.blame.search.inside import worth
from mechanics.blame.search.judge import Problem
from mechanics.blame.search.solved import rational
from mechanics.blame.search.words import Word, Words
from mechanics.reading.tree import Name, Node, Number, Power, Product, Sum

PARTS = (2, 3)
"""How many parts a sum in a missing term may have."""

Series = dict[Symbol | None, int]
"""A residue at the point, by None, and where each symbol is doubled."""


@dataclass(frozen=True, eq=False)
class Missing:
    """Looks for the missing term of a sum.

    Attributes
    ----------
    growth : Growth
        The problem, and how it is where quantities are doubled.
    """

    growth: Growth

    @property
    def problem(self) -> Problem:
        """The equality that does not hold."""
        return self.growth.problem

    @property
    def words(self) -> Words:
        """The words of the scene."""
        return self.growth.words

    @property
    def _p(self) -> int:
        return self.problem.prime

    def changes(self) -> list[Change]:
        """A term added to each sum or side that lacks one product."""
        if not self.growth.problems:
            return []
        found = [self._at(index) for index in range(len(self.problem.forest.nodes))]
        return [change for change in found if change is not None]

    def _lacks(self, problem: Problem, index: int) -> list[int]:
        """What a node lacks, at two states the difference of it; one of two below a square."""
        if not problem.plain:
            slopes = problem.slopes(index)
            if slopes is None or not slopes[0] or slopes[0] != slopes[1]:
                return []
            return [-problem.residual * pow(slopes[0], -1, self._p) % self._p]
        (sheet,) = problem.sheets
        need = sheet.needs[index]
        if need is not None:
            return [(need - sheet.has[index]) % self._p]
        square = sheet.squares.get(index)
        if square is None:
            return []
        root = pow(square, (self._p + 1) // 4, self._p)
        if root * root % self._p != square:
            return []
        return [(sign * root - sheet.has[index]) % self._p for sign in (1, -1)]

    def _series(self, index: int) -> Iterator[Series]:
        """What a node lacks at every point; of two roots the one that tells an exponent."""
        options = {
            symbol: self._lacks(problem, index) for symbol, problem in self.growth.problems.items()
        }
        if not all(options.values()):
            return
        for first in options[None]:
            found: Series = {None: first}
            inverse = pow(first, -1, self._p) if first else 0
            for symbol, values in options.items():
                if symbol is not None:
                    known = [v for v in values if v * inverse % self._p in self.growth.doubling]
                    found[symbol] = (known or values)[0]
            if first:
                yield found

    def _at(self, index: int) -> Change | None:
        forest = self.problem.forest
        node, above = forest.nodes[index], forest.parent[index]
        side = forest.term(index) and not forest.place[index][1]
        around = forest.nodes[above] if above >= 0 else None
        inner = isinstance(node, Product) and isinstance(around, Product)
        below = inner or isinstance(around, Power)
        if not forest.written(index) or not (isinstance(node, Sum) or side or below):
            return None
        if not forest.single(index):
            return None
        found = [term for lacks in self._series(index) for term in self.products(lacks)]
        term = min(found, key=lambda entry: entry[1], default=None)
        worths = None if term is None else worth(self.problem.sheets, term[0])
        if term is None or worths is None:
            return None
        added, cost = term[0], ADDED + term[1]
        has = [sheet.has[index] for sheet in self.problem.sheets]
        values = tuple((a + b) % self._p for a, b in zip(has, worths, strict=True))
        if isinstance(node, Number) and node.value == 0:
            return Change(index, added, Mistake.TERM, cost, index, values)
        wrap = partial(plus, added)
        return Change(index, wrap(node), Mistake.MISSING, cost, index, values, wrap)

    def products(self, lacks: Series) -> Iterator[tuple[Node, float]]:
        """Products that a series is, with what each costs more."""
        for count in (0, 1, 2):
            for chosen in combinations(self.growth.dependent, count):
                series = lacks
                for word in chosen:
                    series = self._over(series, word)
                yield from self._product(series, [word.name for word in chosen])
        for divisor, values in self.growth.divisors:
            series = {s: value * values[s] % self._p for s, value in lacks.items()}
            yield from self._product(series, [divisor])

    def _over(self, lacks: Series, word: Word) -> Series:
        """A series divided by an acceleration, which is another one at each point."""
        found: Series = {}
        for symbol, value in lacks.items():
            point = self.growth.problems[symbol].sheets[0].point
            found[symbol] = value * pow(point.value(word.symbol), -1, self._p) % self._p
        return found

    def _product(self, series: Series, factors: Sequence[Node]) -> Iterator[tuple[Node, float]]:
        exponents: dict[Symbol, int] = {}
        unknown: list[Symbol] = []
        rest = series[None]
        inverse = pow(rest, -1, self._p)
        for symbol in self.growth.problems:
            if symbol is None:
                continue
            exponent = self.growth.doubling.get(series[symbol] * inverse % self._p)
            if exponent is None:
                unknown.append(symbol)
            elif exponent:
                exponents[symbol] = exponent
        if not unknown:
            yield from self._told(rest, exponents, factors, ())
            return
        parts = {s: (series[s] - series[None]) % self._p for s in unknown}
        for count in PARTS:
            for chosen in combinations(unknown, count):
                if sum(parts[s] for s in chosen) % self._p == series[None]:
                    yield from self._with_sum(parts, chosen, unknown, exponents, factors)

    def _divided(self, value: int, exponents: Mapping[Symbol, int]) -> int:
        for symbol, exponent in exponents.items():
            value = value * pow(self.words.by_symbol[symbol].values[0], -exponent, self._p)
        return value % self._p

    def _state(self, exponents: Mapping[Symbol, int], k: int) -> int:
        """The part of a product that is another one at each state, at one of them."""
        value = 1
        for symbol, exponent in exponents.items():
            value = value * pow(self.words.by_symbol[symbol].values[k], exponent, self._p)
        return value % self._p

    def _with_sum(
        self, parts: Mapping[Symbol, int], chosen: Sequence[Symbol], unknown: Sequence[Symbol],
        exponents: Mapping[Symbol, int], factors: Sequence[Node],
    ) -> Iterator[tuple[Node, float]]:  # fmt: skip
        """A product one factor of which is a sum of chosen symbols, times powers of the others."""
        first, *others = chosen
        lead = self._divided(parts[first], {first: 1})
        terms: list[Node] = [self.words.by_symbol[first].name]
        for symbol in others:
            ratio = self._divided(parts[symbol], {symbol: 1}) * pow(lead, -1, self._p) % self._p
            term = self._told_ratio(ratio, symbol, [s for s in unknown if s not in chosen])
            if term is None:
                return
            terms.append(term)
        inner = Sum(0, tuple(terms))
        yield from self._told(lead, exponents, factors, (inner,))

    def _told_ratio(self, ratio: int, symbol: Symbol, others: Sequence[Symbol]) -> Node | None:
        """A number times a symbol times a power of another one."""
        powers = [(s, e) for s in others for e in (2, 1, -1, -2)]
        for power in (None, *powers):
            value = ratio if power is None else self._divided(ratio, {power[0]: power[1]})
            number = rational(value, self._p)
            if number:
                exponents = {symbol: 1} | ({} if power is None else {power[0]: power[1]})
                return self._node(number, exponents, ())
        return None

    def _told(
        self, rest: int, exponents: Mapping[Symbol, int], factors: Sequence[Node],
        sums: Sequence[Node],
    ) -> Iterator[tuple[Node, float]]:  # fmt: skip
        states = [self._state(exponents, k) for k in range(len(self.problem.sheets))]
        for round_ in self._circular:
            first, *other = (a * b for a, b in zip(states, round_.values, strict=True))
            whole = (first - sum(other)) % self._p
            number = rational(rest * pow(whole, -1, self._p), self._p) if whole else None
            if number:
                size = sum(abs(e) for e in exponents.values()) + sum(
                    2 for e in exponents.values() if e < 0
                )
                extra = HINT * (
                    size + 2 * len(round_.factors) + len(sums) + 4 * len(factors)
                ) + size_of(number)
                node = self._node(number, exponents, (*sums, *factors, *round_.factors))
                yield node, extra
                return

    @cached_property
    def _circular(self) -> tuple[Circular, ...]:
        return circular(self.problem.forest, self.problem.sheets, self.words)

    def _node(
        self, number: Fraction, exponents: Mapping[Symbol, int], factors: Sequence[Node]
    ) -> Node:
        """number * product of powers * factors."""
        nodes: list[Node] = []
        if number < 0:
            nodes.append(Number(0, Fraction(-1)))
        if abs(number.numerator) != 1:
            nodes.append(Number(0, Fraction(abs(number.numerator))))
        for symbol, exponent in exponents.items():
            name: Name = self.words.by_symbol[symbol].name
            if exponent > 0:
                nodes.append(raised(name, exponent))
            else:
                nodes.append(Power(0, raised(name, -exponent), Number(0, Fraction(-1))))
        nodes += factors
        if number.denominator != 1:
            nodes.append(Power(0, Number(0, Fraction(number.denominator)), Number(0, Fraction(-1))))
        if not nodes:
            return Number(0, Fraction(1))
        return nodes[0] if len(nodes) == 1 else Product(0, tuple(nodes))
