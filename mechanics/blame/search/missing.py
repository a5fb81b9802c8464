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
from mechanics.blame.search.claim import ALONG, Claim
from mechanics.blame.search.judge import Problem
from mechanics.blame.search.point import Family, points_like
from mechanics.blame.search.sheet import Sheet, sheet_of
from mechanics.blame.search.solved import rational
from mechanics.blame.search.words import Word, Words
from mechanics.exact.signals import Inadmissible, Restart
from mechanics.reading.guess import angular
from mechanics.reading.tree import Name, Node, Number, Power, Product, Sum

MOST_EXPONENT = 4
PARTS = (2, 3)
"""How many parts a sum in a missing term may have."""

Series = dict[Symbol | None, int]
"""A residue at the point, by None, and where each symbol is doubled."""


@dataclass(frozen=True, eq=False)
class Missing:
    """Looks for the missing term of a sum.

    Attributes
    ----------
    claim : Claim
    problem : Problem
    words : Words
    """

    claim: Claim
    problem: Problem
    words: Words

    @property
    def _p(self) -> int:
        return self.problem.prime

    def changes(self) -> list[Change]:
        """A term added to each sum or side that lacks one product."""
        if not self.problem.plain or self.claim.truth.scene.constraints or not self._grown:
            return []
        found = [self._at(index) for index in range(len(self.problem.forest.nodes))]
        return [change for change in found if change is not None]

    @cached_property
    def _grown(self) -> dict[Symbol, Sheet]:
        """The problem at the points where one quantity is doubled."""
        scene, sheet = self.claim.truth.scene, self.problem.sheets[0]
        moving = isinstance(self.claim.row.quantity, ALONG)
        fixed = {*angular(scene), *scene.definitions, *(scene.ud if moving else ())}
        doubled = [word.symbol for word in self.words.symbols if word.symbol not in fixed]
        families = [Family(moving, symbol) for symbol in doubled]
        target = self.problem.target
        try:
            points = points_like(self.claim.truth, sheet.point, families)
            wanted = [0 if target is None else point.value(target) for point in points]
            sheets = [
                sheet_of(self.problem.forest, point, sheet.builder, value)
                for point, value in zip(points, wanted, strict=True)
            ]
        except (Inadmissible, Restart):
            return {}
        return dict(zip(doubled, sheets, strict=True))

    def _at(self, index: int) -> Change | None:
        forest, (sheet,) = self.problem.forest, self.problem.sheets
        node = forest.nodes[index]
        side = forest.term(index) and not forest.place[index][1]
        if not forest.written(index) or not (isinstance(node, Sum) or side):
            return None
        lacks: Series = {}
        for symbol, here in ((None, sheet), *self._grown.items()):
            need = here.needs[index]
            if need is None:
                return None
            lacks[symbol] = (need - here.has[index]) % self._p
        if not lacks[None]:
            return None
        term = min(self._products(lacks), key=lambda found: found[1], default=None)
        if term is None:
            return None
        added, extra = term
        value = (sheet.has[index] + lacks[None]) % self._p
        if isinstance(node, Number) and node.value == 0:
            return Change(index, added, Mistake.TERM, ADDED + extra, index, (value,))
        wrap = partial(plus, added)
        cost = ADDED + extra
        return Change(index, wrap(node), Mistake.MISSING, cost, index, (value,), wrap)

    def _products(self, lacks: Series) -> Iterator[tuple[Node, float]]:
        """Products that a series is, with what each costs more."""
        yield from self._product(lacks, ())
        if isinstance(self.claim.row.quantity, ALONG):
            for word in self.words.symbols:
                if word.symbol in self.claim.truth.scene.ud:
                    yield from self._product(self._over(lacks, word), (word.name,))

    def _over(self, lacks: Series, word: Word) -> Series:
        """A series divided by an acceleration, which is another one at each point."""
        (sheet,) = self.problem.sheets
        found: Series = {}
        for symbol, value in lacks.items():
            point = sheet.point if symbol is None else self._grown[symbol].point
            found[symbol] = value * pow(point.value(word.symbol), -1, self._p) % self._p
        return found

    def _product(self, series: Series, factors: Sequence[Node]) -> Iterator[tuple[Node, float]]:
        exponents: dict[Symbol, int] = {}
        unknown: list[Symbol] = []
        rest = series[None]
        inverse = pow(rest, -1, self._p)
        for symbol in self._grown:
            exponent = self._doubling.get(series[symbol] * inverse % self._p)
            if exponent is None:
                unknown.append(symbol)
            elif exponent:
                exponents[symbol] = exponent
        rest = self._divided(rest, exponents)
        if not unknown:
            yield from self._told(rest, exponents, factors, ())
            return
        parts = {s: (series[s] - series[None]) % self._p for s in unknown}
        for count in PARTS:
            for chosen in combinations(unknown, count):
                if sum(parts[s] for s in chosen) % self._p == series[None]:
                    yield from self._with_sum(parts, chosen, unknown, exponents, factors)

    @cached_property
    def _doubling(self) -> dict[int, int]:
        return {pow(2, e, self._p): e for e in range(-MOST_EXPONENT, MOST_EXPONENT + 1)}

    def _divided(self, value: int, exponents: Mapping[Symbol, int]) -> int:
        for symbol, exponent in exponents.items():
            value = value * pow(self.words.by_symbol[symbol].values[0], -exponent, self._p)
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
        yield from self._told(self._divided(lead, exponents), exponents, factors, (inner,))

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
        for round_ in self._circular:
            number = rational(rest * round_.inverse % self._p, self._p)
            if number:
                size = sum(abs(e) for e in exponents.values()) + sum(
                    2 for e in exponents.values() if e < 0
                )
                extra = HINT * (size + 2 * len(round_.factors) + len(sums)) + size_of(number)
                node = self._node(number, exponents, (*sums, *factors, *round_.factors))
                yield node, extra
                return

    @cached_property
    def _circular(self) -> tuple[Circular, ...]:
        return circular(self.problem, self.words)

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
