"""Factors in front of a term: numbers where it has none, symbols, roots, their inverses, sines.

k x  ->  2 k x, m k x, k x / m, k x / sqrt(x^2 + y^2), cos(theta) k x, ...
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import HINT, RATIOS, SECOND, TOKEN, Change, size_of, times
from mechanics.blame.search.circular import Circular
from mechanics.blame.search.edits import Maker, worth
from mechanics.blame.search.inverse_evaluation import integer_exponent, scaled
from mechanics.blame.search.syntax_tree import is_root
from mechanics.claims.tree import Call, Node, Number, Power, Product

MOST_ROOTS = 3
"""Roots of a statement that are tried as factors."""


@dataclass(frozen=True, eq=False)
class Inserted:
    """Makes these edits."""

    make: Maker
    circular: tuple[Circular, ...]

    def of(self, index: int, far: float) -> Iterator[Change]:
        """Factors in front of a term: numbers where it has none, symbols and their inverses."""
        if not self._number_below(index):
            for ratio in RATIOS:
                wrap = partial(times, Number(0, ratio))
                cost = TOKEN + far + size_of(ratio)
                yield self.make.wrapped(
                    index, wrap, Mistake.FACTOR, cost, scaled(self.make.sheets, index, ratio)
                )
        yield from self._turned(index, far)
        p, has = self.make.p, self.make.has(index)
        named = [(word.name, word.values) for word in self.make.words.symbols]
        for node, worths in (*named, *self._roots):
            values = tuple(a * b % p for a, b in zip(has, worths, strict=True))
            cost = TOKEN + far + SECOND
            yield self.make.wrapped(index, partial(times, node), Mistake.FACTOR, cost, values)
            if all(worths):
                over = Power(0, node, Number(0, Fraction(-1)))
                values = tuple(a * pow(b, -1, p) % p for a, b in zip(has, worths, strict=True))
                yield self.make.wrapped(index, partial(times, over), Mistake.FACTOR, cost, values)

    @cached_property
    def _roots(self) -> tuple[tuple[Node, tuple[int, ...]], ...]:
        """Roots that were written: a distance by which a force is divided."""
        tree = self.make.tree
        found = {node: self.make.has(k) for k, node in enumerate(tree.nodes) if is_root(node)}
        return tuple(found.items())[:MOST_ROOTS]

    def _turned(self, index: int, far: float) -> Iterator[Change]:
        """Sines, cosines and tangents in front of a term."""
        for call, worths in self._calls:
            values = tuple(
                a * b % self.make.p for a, b in zip(self.make.has(index), worths, strict=True)
            )
            cost = TOKEN + far + SECOND + HINT
            yield self.make.wrapped(index, partial(times, call), Mistake.FACTOR, cost, values)

    @cached_property
    def _calls(self) -> tuple[tuple[Node, tuple[int, ...]], ...]:
        found = [(c.factors[0], c.values) for c in self.circular if len(c.factors) == 1]
        for call, _ in tuple(found):
            if isinstance(call, Call) and call.function == "sin":
                tangent = Call(0, "tan", call.arguments)
                values = worth(self.make.sheets, tangent)
                found += [] if values is None else [(tangent, values)]
        return tuple(found)

    def _number_below(self, index: int) -> bool:
        """Whether a term has a number that can be another one."""
        node = self.make.tree.nodes[index]
        if isinstance(node, Number):
            return node.value not in (-1, 0)
        if isinstance(node, Product):
            return any(self._number_below(kid) for kid in self.make.tree.kids[index])
        if isinstance(node, Power) and integer_exponent(node) in (1, -1):
            return self._number_below(self.make.tree.kids[index][0])
        return False
