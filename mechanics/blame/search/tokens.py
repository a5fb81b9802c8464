"""Other symbols, numbers, exponents and functions at a node, with what it would be worth.

m_1 -> m_2, m_1**2      2 -> 1/2      x**2 -> x**3, x y      sin -> cos      x' -> x''
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

from mechanics.blame.result import Mistake
from mechanics.blame.search.bracket_extent import other_extents
from mechanics.blame.search.change import (
    HINT,
    RATIOS,
    SECOND,
    TOKEN,
    Change,
    is_minus,
    raised,
    size_of,
)
from mechanics.blame.search.edits import Maker, worth
from mechanics.blame.search.inverse_evaluation import integer_exponent, power, scaled
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    constant,
    inverse,
    parts,
    product,
    with_parts,
)
from mechanics.kernel.field import DivisionHere

LONGEST = 60
"""Parts of a sum or product in which another operator is tried: each try takes all of them."""

MOTION = ("coordinate", "speed", "acceleration", "momentum", "input")
"""Kinds of words that nobody writes a number for."""


@dataclass(frozen=True, eq=False)
class Tokens:
    """Makes these edits."""

    make: Maker

    def of(self, index: int, node: Node) -> Iterator[Change]:
        """Every edit of a node alone."""
        if isinstance(node, Name) and not self.make.tree.kids[index]:
            yield from self._name(index, node)
        elif isinstance(node, Name):
            yield from self._defined(index, node)
        elif isinstance(node, Number):
            yield from self._number(index, node)
        elif isinstance(node, Power):
            yield from self._exponent(index, node)
        elif isinstance(node, Call):
            yield from self._function(index, node)
        elif isinstance(node, Rate):
            yield from self._rate(index, node)
        elif isinstance(node, Sum) and not isinstance(self.make.around(index), Power | None):
            yield from self._powers(index, node, (2,))
        if isinstance(node, Sum | Product):
            yield from self._operators(index, node)
            yield from other_extents(self.make, index, node)
        if isinstance(node, Name | Call | Product):
            yield from self._turned_over(index, node)

    def _operators(self, index: int, node: Sum | Product) -> Iterator[Change]:
        """Another operator between two neighbours: a b or a/b for a + b, a + b for a b."""
        inner = parts(node)
        kids = self.make.tree.kids[index]
        if len(kids) != len(inner) or len(inner) > LONGEST or any(map(is_minus, inner)):
            return
        for k, (one, two) in enumerate(pairwise(inner)):
            if not (_short(one) and _short(two)):
                continue
            rest = (*inner[:k], *inner[k + 2 :])
            for other in _operated(node, one, two):
                new = with_parts(node, (*inner[:k], other, *inner[k + 2 :])) if rest else other
                if (values := worth(self.make.sheets, new)) is not None:
                    yield self.make.change(index, new, Mistake.TERM, TOKEN + 4 * HINT, values)

    def _turned_over(self, index: int, node: Node) -> Iterator[Change]:
        """b/a for a/b, and 1/a for a factor a."""
        factors: tuple[Node, ...] = (node,)
        if isinstance(node, Product):
            factors = node.factors
            if not any(map(_divides, factors)) or all(map(_divides, factors)):
                return
        elif not isinstance(self.make.around(index), Product):
            return
        has = self.make.has(index)
        if all(has):
            values = tuple(pow(value, -1, self.make.p) for value in has)
            over = product(node.at, [_turned(factor) for factor in factors])
            yield self.make.change(index, over, Mistake.POWER, TOKEN + SECOND, values)

    def _name(self, index: int, node: Name) -> Iterator[Change]:
        """Other symbols, the same kind first; squares and cubes."""
        own = self.make.words.word(node)
        for word in self.make.words.symbols:
            if own is not None and word.symbol == own.symbol:
                continue
            if not any(word.values):
                continue  # a speed at rest is nothing to exchange a symbol for
            far = 0.0 if own is not None and word.kind == own.kind else HINT
            yield self.make.change(index, word.name, Mistake.SYMBOL, TOKEN + far, word.values)
            if word.kind == "speed":
                squares = tuple(value * value % self.make.p for value in word.values)
                square = raised(word.name, 2)
                yield self.make.change(index, square, Mistake.SYMBOL, TOKEN + SECOND, squares)
        yield from self._definitions(index, node, TOKEN + 2 * HINT)
        if not isinstance(self.make.around(index), Power):
            yield from self._powers(index, node, (2, 3))

    def _defined(self, index: int, node: Name) -> Iterator[Change]:
        """Another definition of the person's, or another function than the one defined."""
        inner = self.make.tree.nodes[self.make.tree.kids[index][0]]
        others: list[tuple[Node, Mistake]] = []
        if isinstance(inner, Call):
            others += [(call, Mistake.FUNCTION) for call in self.make.words.functions(inner)]
        for other, mistake in others:
            values = worth(self.make.sheets, other)
            if values is not None:
                yield self.make.change(index, other, mistake, TOKEN, values)
        yield from self._definitions(index, node, TOKEN)
        for word in self.make.words.symbols:
            if any(word.values):
                cost = TOKEN + 2 * HINT
                yield self.make.change(index, word.name, Mistake.SYMBOL, cost, word.values)
        if not isinstance(self.make.around(index), Power):
            yield from self._powers(index, node, (2,))

    def _definitions(self, index: int, node: Name, cost: float) -> Iterator[Change]:
        """Other definitions of the person's."""
        for name, values in self._worth_of_definitions:
            if name != node.name:
                yield self.make.change(index, Name(node.at, name), Mistake.SYMBOL, cost, values)

    @cached_property
    def _worth_of_definitions(self) -> list[tuple[str, tuple[int, ...]]]:
        pairs = (
            (name, worth(self.make.sheets, Name(0, name))) for name in self.make.tree.definitions
        )
        return [(name, values) for name, values in pairs if values is not None and any(values)]

    def _rate(self, index: int, node: Rate) -> Iterator[Change]:
        """A derivative of another order."""
        for order in (1, 2):
            other = Rate(node.at, node.of, order)
            values = worth(self.make.sheets, other) if order != node.order else None
            if values is not None:
                yield self.make.change(index, other, Mistake.SYMBOL, TOKEN, values)

    def _powers(self, index: int, node: Node, exponents: tuple[int, ...]) -> Iterator[Change]:
        for exponent in exponents:
            values = tuple(pow(value, exponent, self.make.p) for value in self.make.has(index))
            yield self.make.change(
                index, raised(node, exponent), Mistake.POWER, TOKEN + HINT * (exponent - 2), values
            )

    def _number(self, index: int, node: Number) -> Iterator[Change]:
        """Other numbers; minus one is a sign, which is that of its term."""
        if node.value in (-1, 0):
            return
        around = self.make.around(index)
        for ratio in dict.fromkeys((*RATIOS, 1 / node.value**2)):
            value = node.value * ratio
            found = scaled(self.make.sheets, index, ratio)
            number = None if value == 1 and isinstance(around, Product) else Number(node.at, value)
            yield self.make.change(index, number, Mistake.FACTOR, TOKEN + size_of(value), found)
        for word in self.make.words.symbols:
            if word.kind not in MOTION:
                # 9.81 for g
                cost = TOKEN + SECOND
                yield self.make.change(index, word.name, Mistake.SYMBOL, cost, word.values)
        if isinstance(around, Sum):
            for step in (1, -1, 2, -2):
                value = node.value + step
                values = tuple((v + step) % self.make.p for v in self.make.has(index))
                number = Number(node.at, value)
                yield self.make.change(index, number, Mistake.FACTOR, TOKEN + HINT, values)

    def _exponent(self, index: int, node: Power) -> Iterator[Change]:
        """Exponents one and two away, and of the other sign; of a sum, those of its root."""
        if isinstance(node.base, Sum):
            yield from self._of_root(index, node)
        exponent = integer_exponent(node)
        if exponent is None:
            return
        base = self.make.tree.kids[index][0]
        for other in (exponent + 1, exponent - 1, exponent + 2, exponent - 2, -exponent):
            try:
                values = tuple(power(value, other, self.make.p) for value in self.make.has(base))
            except DivisionHere:
                continue
            new = raised(node.base, other) if other else Number(node.at, Fraction(1))
            far = HINT * abs(other - exponent)
            yield self.make.change(index, new, Mistake.POWER, TOKEN + far, values)
        if exponent == 2:  # a resistance turns with the speed
            turning = Product(node.at, (Call(node.at, "abs", (node.base,)), node.base))
            worths = worth(self.make.sheets, turning)
            if worths is not None:
                yield self.make.change(index, turning, Mistake.POWER, TOKEN + SECOND, worths)
        yield from self._split(index, node, base, exponent)

    def _of_root(self, index: int, node: Power) -> Iterator[Change]:
        """(x^2 + y^2)^(3/2) for x^2 + y^2 or its root: the distance with another exponent."""
        exponent = constant(node.exponent)
        if exponent is None:
            return
        for step in (1, -1, 2, -2):
            other = exponent + Fraction(step, 2)
            if {exponent.denominator, other.denominator} <= {1} or not other:
                continue
            new = Power(node.at, node.base, Number(node.at, other))
            worths = worth(self.make.sheets, new)
            if worths is not None:
                cost = TOKEN + HINT * abs(step)
                yield self.make.change(index, new, Mistake.POWER, cost, worths)

    def _split(self, index: int, node: Power, base: int, exponent: int) -> Iterator[Change]:
        """x**3 as x**2 y and x y**2: SymPy puts together what was written apart."""
        if exponent < 0 or (self.make.tree.kids[base] and not isinstance(node.base, Call)):
            return
        others: list[tuple[Node, tuple[int, ...]]]
        others = [(word.name, word.values) for word in self.make.words.symbols]
        if isinstance(node.base, Call):
            others = list(self.make.words.calls(node.base))
        elif not isinstance(node.base, Name):
            return
        for taken in range(1, min(exponent, 3)):
            left = raised(node.base, exponent - taken)
            for other, worths in others:
                values = tuple(
                    pow(a, exponent - taken, self.make.p) * pow(b, taken, self.make.p) % self.make.p
                    for a, b in zip(self.make.has(base), worths, strict=True)
                )
                new = Product(node.at, (left, raised(other, taken)))
                cost = TOKEN + HINT * (1 + taken)
                yield self.make.change(index, new, Mistake.SYMBOL, cost, values)

    def _function(self, index: int, node: Call) -> Iterator[Change]:
        for other in self.make.words.functions(node):
            values = worth(self.make.sheets, other)
            if values is not None:
                yield self.make.change(index, other, Mistake.FUNCTION, TOKEN + HINT, values)
        if not isinstance(self.make.around(index), Power):
            yield from self._powers(index, node, (2,))


def _short(node: Node) -> bool:
    """Whether a node is a name, a number, or a power of one."""
    return isinstance(node.base if isinstance(node, Power) else node, Name | Number)


def _operated(node: Sum | Product, one: Node, two: Node) -> Iterator[Node]:
    if isinstance(node, Product):
        yield Sum(node.at, (one, two))
        return
    yield Product(node.at, (one, two))
    yield Product(node.at, (one, inverse(two)))


def _divides(node: Node) -> bool:
    exponent = constant(node.exponent) if isinstance(node, Power) else None
    return exponent is not None and exponent < 0


def _turned(node: Node) -> Node:
    """One over a factor; a sign stays."""
    if constant(node) == -1:
        return node
    exponent = constant(node.exponent) if isinstance(node, Power) else None
    if not isinstance(node, Power) or exponent is None:
        return inverse(node)
    return node.base if exponent == -1 else Power(node.at, node.base, Number(0, -exponent))
