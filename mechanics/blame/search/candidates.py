"""Every small edit at every node, with what the node would be worth.

    names: other symbols, powers      numbers: ratios      powers: other exponents
    functions: sin, cos, tan, other arguments              terms: sign, factor, left out

An edit inside of a function is worth what the function is then.
"""

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    DROPPED,
    HINT,
    RATIOS,
    SECOND,
    TOKEN,
    Change,
    Wrap,
    minus,
    plus,
    raised,
    size_of,
)
from mechanics.blame.search.circular import Circular, circular
from mechanics.blame.search.forest import Forest
from mechanics.blame.search.inserted import Inserted
from mechanics.blame.search.inside import inside_of, worth
from mechanics.blame.search.sheet import Sheet, integer_exponent, power, scaled
from mechanics.blame.search.words import Words
from mechanics.exact.signals import DivisionHere
from mechanics.reading.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    constant,
)

MOST_INSIDE = 400
"""Edits inside of functions, each of which has to be evaluated anew."""


@dataclass(frozen=True, eq=False)
class Candidates:
    """Makes the edits.

    Attributes
    ----------
    forest : Forest
    sheets : tuple of Sheet
    words : Words
    """

    forest: Forest
    sheets: tuple[Sheet, ...]
    words: Words

    def all(self) -> list[Change]:
        """Every edit, once for each node that was written."""
        found: list[Change] = []
        inside = 0
        for index, node in enumerate(self.forest.nodes):
            copies = self.forest.copies[self.forest.place[index]]
            if not self.forest.written(index) or copies[0] != index or self._hidden(index):
                continue
            found += self._here(index, node)
            if isinstance(node, Call | Rate) and inside < MOST_INSIDE:
                more = list(inside_of(self.forest, self.sheets, self.words, index))
                inside += len(more)
                found += more
        return found

    def _hidden(self, index: int) -> bool:
        """Whether a node stands in a function or exponent, so that its value tells nothing."""
        way = self.forest.ways_up(index)
        for child, above in itertools.pairwise(way):
            node = self.forest.nodes[above]
            if isinstance(node, Call | Rate):
                return True
            if isinstance(node, Power) and (
                self.forest.kids[above][0] != child or integer_exponent(node) is None
            ):
                return constant(node.exponent) != Fraction(1, 2)
        return False

    def _change(
        self, index: int, node: Node | None, mistake: Mistake, cost: float, values: tuple[int, ...]
    ) -> Change:
        return Change(index, node, mistake, cost, index, values)

    def _wrapped(
        self, index: int, wrap: Wrap, mistake: Mistake, cost: float, values: tuple[int, ...]
    ) -> Change:
        node = wrap(self.forest.nodes[index])
        return Change(index, node, mistake, cost, index, values, wrap)

    def _has(self, index: int) -> tuple[int, ...]:
        return tuple(sheet.has[index] for sheet in self.sheets)

    @property
    def _p(self) -> int:
        return self.sheets[0].point.prime

    def _here(self, index: int, node: Node) -> Iterator[Change]:
        if self.forest.term(index):
            yield from self._term(index, node)
        elif isinstance(self.forest.nodes[self.forest.parent[index]], Product):
            yield from self._factor(index, node)
        if isinstance(node, Name) and not self.forest.kids[index]:
            yield from self._name(index, node)
        elif isinstance(node, Name):
            yield from self._defined(index, node)
        elif isinstance(node, Rate):
            yield from self._rate(index, node)
        elif isinstance(node, Number):
            yield from self._number(index, node)
        elif isinstance(node, Power):
            yield from self._exponent(index, node)
        elif isinstance(node, Call):
            yield from self._function(index, node)
        elif isinstance(node, Sum):
            yield from self._summand(index, node)

    @cached_property
    def _circular(self) -> tuple[Circular, ...]:
        return circular(self.forest, self.sheets, self.words)

    @cached_property
    def _inserted(self) -> Inserted:
        return Inserted(self.forest, self.sheets, self.words, self._circular)

    def _name(self, index: int, node: Name) -> Iterator[Change]:
        """Other symbols, the same kind first; squares and cubes."""
        own = self.words.word(node)
        for word in self.words.symbols:
            if own is not None and word.symbol == own.symbol:
                continue
            far = 0.0 if own is not None and word.kind == own.kind else HINT
            yield self._change(index, word.name, Mistake.SYMBOL, TOKEN + far, word.values)
            if word.kind == "speed":
                squares = tuple(value * value % self._p for value in word.values)
                square = raised(word.name, 2)
                yield self._change(index, square, Mistake.SYMBOL, TOKEN + SECOND, squares)
        above = self.forest.parent[index]
        around = self.forest.nodes[above] if above >= 0 else None
        if not isinstance(around, Sum):
            yield from self._plus(index, (node,), {own.kind if own is not None else ""})
        if not isinstance(around, Power):
            yield from self._powers(index, node, (2, 3))

    def _defined(self, index: int, node: Name) -> Iterator[Change]:
        """Another definition of the person's, or another function than the one defined."""
        inner = self.forest.nodes[self.forest.kids[index][0]]
        others: list[tuple[Node, Mistake]] = []
        if isinstance(inner, Call):
            others += [(call, Mistake.FUNCTION) for call in self.words.functions(inner)]
        for name in self.forest.definitions:
            if name != node.name:
                others.append((Name(node.at, name), Mistake.SYMBOL))
        for other, mistake in others:
            values = worth(self.sheets, other)
            if values is not None:
                yield self._change(index, other, mistake, TOKEN, values)

    def _rate(self, index: int, node: Rate) -> Iterator[Change]:
        """A derivative of another order."""
        for order in (1, 2):
            other = Rate(node.at, node.of, order)
            values = worth(self.sheets, other) if order != node.order else None
            if values is not None:
                yield self._change(index, other, Mistake.SYMBOL, TOKEN, values)

    def _powers(self, index: int, node: Node, exponents: tuple[int, ...]) -> Iterator[Change]:
        for exponent in exponents:
            values = tuple(pow(value, exponent, self._p) for value in self._has(index))
            yield self._change(
                index, raised(node, exponent), Mistake.POWER, TOKEN + HINT * (exponent - 2), values
            )

    def _number(self, index: int, node: Number) -> Iterator[Change]:
        """Other numbers; minus one is a sign, which is that of its term."""
        if node.value in (-1, 0):
            return
        for ratio in dict.fromkeys((*RATIOS, 1 / node.value**2)):
            value = node.value * ratio
            found = scaled(self.sheets, index, ratio)
            number = None if value == 1 and self._in_product(index) else Number(node.at, value)
            yield self._change(index, number, Mistake.FACTOR, TOKEN + size_of(value), found)
        above = self.forest.parent[index]
        if above >= 0 and isinstance(self.forest.nodes[above], Sum):
            for step in (1, -1, 2, -2):
                value = node.value + step
                values = tuple((v + step) % self._p for v in self._has(index))
                number = Number(node.at, value)
                yield self._change(index, number, Mistake.FACTOR, TOKEN + HINT, values)

    def _in_product(self, index: int) -> bool:
        above = self.forest.parent[index]
        return above >= 0 and isinstance(self.forest.nodes[above], Product)

    def _exponent(self, index: int, node: Power) -> Iterator[Change]:
        """Exponents one and two away, and of the other sign."""
        exponent = integer_exponent(node)
        if exponent is None:
            return
        base = self.forest.kids[index][0]
        for other in (exponent + 1, exponent - 1, exponent + 2, exponent - 2, -exponent):
            try:
                values = tuple(power(value, other, self._p) for value in self._has(base))
            except DivisionHere:
                continue
            new = raised(node.base, other) if other else Number(node.at, Fraction(1))
            far = HINT * abs(other - exponent)
            yield self._change(index, new, Mistake.POWER, TOKEN + far, values)
        yield from self._split(index, node, base, exponent)

    def _split(self, index: int, node: Power, base: int, exponent: int) -> Iterator[Change]:
        """x**3 as x**2 y and x y**2: SymPy puts together what was written apart."""
        if exponent < 0 or (self.forest.kids[base] and not isinstance(node.base, Call)):
            return
        others: list[tuple[Node, tuple[int, ...]]]
        others = [(word.name, word.values) for word in self.words.symbols]
        if isinstance(node.base, Call):
            others = list(self.words.calls(node.base))
        elif not isinstance(node.base, Name):
            return
        for taken in range(1, min(exponent, 3)):
            left = raised(node.base, exponent - taken)
            for other, worths in others:
                values = tuple(
                    pow(a, exponent - taken, self._p) * pow(b, taken, self._p) % self._p
                    for a, b in zip(self._has(base), worths, strict=True)
                )
                new = Product(node.at, (left, raised(other, taken)))
                cost = TOKEN + HINT * (1 + taken)
                yield self._change(index, new, Mistake.SYMBOL, cost, values)

    def _function(self, index: int, node: Call) -> Iterator[Change]:
        for other in self.words.functions(node):
            values = worth(self.sheets, other)
            if values is not None:
                yield self._change(index, other, Mistake.FUNCTION, TOKEN, values)
        above = self.forest.parent[index]
        if above < 0 or not isinstance(self.forest.nodes[above], Power):
            yield from self._powers(index, node, (2,))

    def _term(self, index: int, node: Node) -> Iterator[Change]:
        """The sign of a term, a factor of it, the term left out."""
        p, has = self._p, self._has(index)
        if not any(has):
            return
        values = tuple(-value % p for value in has)
        side = self.forest.parent[index] < 0 or not self.forest.place[index][1]
        far = 2 * HINT if side and isinstance(node, Name) else 0.0
        yield self._wrapped(index, minus, Mistake.SIGN, TOKEN + far, values)
        if not side or self._other_side(index):
            zero = (0,) * len(has)
            yield self._change(index, None, Mistake.EXTRA, DROPPED, zero)
        yield from self._inserted.of(index, far)

    def _other_side(self, index: int) -> bool:
        """Whether there is another side, so that this one may be zero."""
        return index > 0 and len(self.forest.kids[0]) == 2 and not self.forest.written(0)

    def _factor(self, index: int, node: Node) -> Iterator[Change]:
        """A factor left out."""
        if constant(node) is None:
            ones = (1,) * len(self.sheets)
            yield self._change(index, None, Mistake.FACTOR, TOKEN + SECOND, ones)

    def _summand(self, index: int, node: Sum) -> Iterator[Change]:
        """A symbol added to a sum or taken from it, as in m_1 + m_2."""
        kinds = set()
        for kid in self.forest.kids[index]:
            part = self.forest.nodes[kid]
            word = self.words.word(part) if isinstance(part, Name) else None
            kinds.add(word.kind if word is not None else "")
        yield from self._plus(index, node.terms, kinds)
        above = self.forest.parent[index]
        if above >= 0 and not isinstance(self.forest.nodes[above], Power):
            yield from self._powers(index, node, (2,))

    def _plus(self, index: int, terms: tuple[Node, ...], kinds: set[str]) -> Iterator[Change]:
        present = [self.words.word(term) for term in terms if isinstance(term, Name)]
        for word in self.words.symbols:
            if word.kind not in kinds or not word.kind or word in present:
                continue
            for sign in (1, -1):
                values = tuple(
                    (a + sign * b) % self._p
                    for a, b in zip(self._has(index), word.values, strict=True)
                )
                added = word.name if sign > 0 else minus(word.name)
                cost = TOKEN + SECOND + (HINT if sign < 0 else 0.0)
                yield self._wrapped(index, partial(plus, added), Mistake.MISSING, cost, values)
