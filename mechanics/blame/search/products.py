"""Products that a value is, told by how it grows.

    d(2 s) / d(s) = 2**e        ->  s**e divides d
    what is left is a number, or a number times sines and cosines of the coordinates

Every quantity is doubled in turn, the motion solved anew. Of a sum in it (M + m) the parts are
d(2 s) - d(s), and they have to make up the whole.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations, product

from sympy import Symbol

from mechanics.blame.search.change import HINT, RATIOS, raised, size_of
from mechanics.blame.search.circular import Circular, circular
from mechanics.blame.search.factors import Series
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.residues import inverses, rational
from mechanics.blame.search.words import Words
from mechanics.claims.tree import Name, Node, Number, Power, Product, Sum, constant

MOST_TWICE = 100
"""Products of sines and cosines, the simplest of them, that are multiplied by each other."""

MOTION = ("coordinate", "speed", "acceleration")
"""Kinds of words that stand behind parameters: m l theta_dot**2."""


@dataclass(frozen=True, eq=False)
class Products:
    """Tells products.

    Attributes
    ----------
    homogeneity : Homogeneity
        A problem, and how it is where quantities are doubled.
    """

    homogeneity: Homogeneity

    @property
    def _words(self) -> Words:
        return self.homogeneity.words

    @property
    def _p(self) -> int:
        return self.homogeneity.problem.prime

    def of(self, series: Series) -> Iterator[tuple[Node, float]]:
        """Products that a series is, with what each costs more."""
        for factor in self.homogeneity.factors:
            yield from self._product(factor.out_of(series, self._p), factor.nodes)

    def _product(self, series: Series, factors: Sequence[Node]) -> Iterator[tuple[Node, float]]:
        exponents: dict[Symbol, int] = {}
        unknown: list[Symbol] = []
        rest = series[None]
        inverse = pow(rest, -1, self._p)
        for symbol in self.homogeneity.problems:
            if symbol is None:
                continue
            exponent = self.homogeneity.doubling.get(series[symbol] * inverse % self._p)
            if exponent is None:
                unknown.append(symbol)
            elif exponent:
                exponents[symbol] = exponent
        if not unknown:
            yield from self._told(rest, exponents, factors, ())
            return
        parts = {s: (series[s] - series[None]) % self._p for s in unknown}
        for chosen in self._adding_up(parts, series[None]):
            yield from self._with_sum(parts, chosen, unknown, exponents, factors)

    def _adding_up(self, parts: Mapping[Symbol, int], whole: int) -> Iterator[tuple[Symbol, ...]]:
        """Two symbols, or three, whose parts make up the whole; the last one is looked up."""
        last = {part: symbol for symbol, part in parts.items()}
        order = {symbol: i for i, symbol in enumerate(parts)}
        for count in (1, 2):
            for chosen in combinations(parts, count):
                other = last.get((whole - sum(parts[s] for s in chosen)) % self._p)
                if other is not None and order[other] > order[chosen[-1]]:
                    yield (*chosen, other)

    def _divided(self, value: int, exponents: Mapping[Symbol, int]) -> int:
        for symbol, exponent in exponents.items():
            value = value * pow(self._words.by_symbol[symbol].values[0], -exponent, self._p)
        return value % self._p

    def _state(self, exponents: Mapping[Symbol, int], k: int) -> int:
        """The part of a product that is another one at each state, at one of them."""
        value = 1
        for symbol, exponent in exponents.items():
            value = value * pow(self._words.by_symbol[symbol].values[k], exponent, self._p)
        return value % self._p

    def _with_sum(
        self, parts: Mapping[Symbol, int], chosen: Sequence[Symbol], unknown: Sequence[Symbol],
        exponents: Mapping[Symbol, int], factors: Sequence[Node],
    ) -> Iterator[tuple[Node, float]]:  # fmt: skip
        """A product one factor of which is a sum of chosen symbols, times powers of the others."""
        first, *others = chosen
        lead = self._divided(parts[first], {first: 1})
        terms: list[Node] = [self._words.by_symbol[first].name]
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
        """The simplest sines and cosines that leave a number.

        Nobody leaves out a term that is divided by a speed: a product around it would cancel that.
        """
        if any(e < 0 and self._words.by_symbol[s].kind in MOTION for s, e in exponents.items()):
            return
        size = sum(abs(e) + (2 if e < 0 else 0) for e in exponents.values())
        for number, angles in self._left(rest, exponents):
            below = sum(isinstance(angle, Power) for angle in angles)
            far = size + 2 * len(angles) + 8 * below + len(sums) + 4 * len(factors)
            node = self._node(number, exponents, (*sums, *factors, *angles))
            yield node, HINT * far + size_of(number)
            return

    def _left(
        self, rest: int, exponents: Mapping[Symbol, int]
    ) -> Iterator[tuple[Fraction, tuple[Node, ...]]]:
        """A number, and the sines and cosines beside it."""
        states = [self._state(exponents, k) for k in range(len(self.homogeneity.problem.sheets))]
        for round_ in self._circular:
            first, *other = (a * b for a, b in zip(states, round_.values, strict=True))
            whole = (first - sum(other)) % self._p
            number = rational(rest * pow(whole, -1, self._p), self._p) if whole else None
            if number:
                yield number, round_.factors
        if len(states) == 1 and len(self._circular) > 1:
            yield from self._of_four(rest * pow(states[0], -1, self._p) % self._p)

    def _of_four(self, rest: int) -> Iterator[tuple[Fraction, tuple[Node, ...]]]:
        """More than two of them, or one over some: products of two are looked up."""
        p = self._p
        for ratio in (Fraction(1), *RATIOS):
            left = rest * ratio.denominator * pow(ratio.numerator, -1, p) % p
            for number, value in ((ratio, left), (-ratio, p - left)):
                if value in self._twice:
                    one, other, above = self._twice[value]
                    yield number, (*other, *(one if above else map(_over, one)))

    @cached_property
    def _twice(self) -> dict[int, tuple[tuple[Node, ...], tuple[Node, ...], bool]]:
        """Products and quotients of two products of sines and cosines, by what they are worth."""
        p = self._p
        known = [(round_.factors, round_.values[0]) for round_ in self._circular[:MOST_TWICE]]
        below = inverses([value for _, value in known], p)
        pairs = list(product(known, known))
        found = {a * b % p: (one, other, True) for (one, a), (other, b) in reversed(pairs)}
        for (one, _), inverse in zip(known, below, strict=True):
            for other, b in known:
                found.setdefault(b * inverse % p, (one, other, False))
        return found

    @cached_property
    def _circular(self) -> tuple[Circular, ...]:
        return circular(self.homogeneity.problem.tree, self.homogeneity.problem.sheets, self._words)

    def _node(
        self, number: Fraction, exponents: Mapping[Symbol, int], factors: Sequence[Node]
    ) -> Node:
        """number * product of powers * factors, parameters before what moves."""
        nodes: list[Node] = []
        if abs(number.numerator) != 1:
            nodes.append(Number(0, Fraction(abs(number.numerator))))
        counts: Counter[Node] = Counter()
        for factor in factors:
            if isinstance(factor, Power) and constant(factor.exponent) == -1:
                counts[factor.base] -= 1
            else:
                counts[factor] += 1
        counts.update({self._words.by_symbol[symbol].name: e for symbol, e in exponents.items()})
        for node, count in sorted(counts.items(), key=self._rank):
            if count:
                nodes.append(raised(node, count) if count > 0 else _over(raised(node, -count)))
        if number.denominator != 1:
            nodes.append(_over(Number(0, Fraction(number.denominator))))
        if number < 0:
            nodes.insert(0, Number(0, Fraction(-1)))
        if not nodes:
            return Number(0, Fraction(1))
        return nodes[0] if len(nodes) == 1 else Product(0, tuple(nodes))

    def _rank(self, entry: tuple[Node, int]) -> int:
        """Parameters, sums of them, what moves, functions."""
        node = entry[0].base if isinstance(entry[0], Power) else entry[0]
        if isinstance(node, Name):
            word = self._words.word(node)
            return 2 if word is not None and word.kind in MOTION else 0
        return 1 if isinstance(node, Sum) else 3


def _over(node: Node) -> Node:
    return Power(0, node, Number(0, Fraction(-1)))
