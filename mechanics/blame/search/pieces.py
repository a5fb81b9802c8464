"""Edits that each undo some of the terms that differ: exactly these, and nothing else.

step of an edit = -(sum of some wrongs)

    single edits                     looked up
    another number in a term         step = (1 - ratio) * step without the term
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from math import prod

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    HINT,
    RATIOS,
    TOKEN,
    Change,
    minus,
    size_of,
)
from mechanics.blame.search.cover import Piece
from mechanics.blame.search.differing_terms import Wrongs
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.residues import rational
from mechanics.claims.tree import Node, Number, Power, Product, constant

ALIKE = 3
"""Pieces that are kept of those that undo the same."""


@dataclass(frozen=True, eq=False)
class Pieces:
    """Makes them.

    Attributes
    ----------
    steps : sequence of (Change, sequence of int)
        Single edits, none of which is enough, and what they add to the residual.
    """

    problem: Problem
    steps: Sequence[tuple[Change, Sequence[int]]]
    wrongs: Wrongs

    def all(self) -> list[Piece]:
        """All of them, the cheapest of those that undo the same."""
        depth = [node.depth for node in self.problem.tree.nodes]
        alike: dict[int, list[Piece]] = defaultdict(list)
        found = [*self._single(), *self._numbers()]
        for piece in sorted(found, key=lambda one: (one.cost, depth[one.changes[0].index])):
            if len(alike[piece.undone]) < ALIKE:
                alike[piece.undone].append(piece)
        return [piece for some in alike.values() for piece in some]

    @property
    def _p(self) -> int:
        return self.problem.prime

    @cached_property
    def _sums(self) -> dict[int, int]:
        """The bits of wrongs by the step that undoes them."""
        found = [(0, 0)]
        for i, wrong in enumerate(self.wrongs.each):
            found += [((step - wrong.share) % self._p, bits | 1 << i) for step, bits in found]
        return dict(found[1:])

    def _single(self) -> Iterator[Piece]:
        for change, found in self.steps:
            for step in found:
                if undone := self._sums.get(step):
                    yield Piece(undone, (change,))

    def _numbers(self) -> Iterator[Piece]:
        """Numbers that are not among the simple ones."""
        tree = self.problem.tree
        for change, found in self.steps:
            if change.node is not None or change.at != change.index:
                continue
            if change.mistake is not Mistake.EXTRA or not tree.single(change.index):
                continue
            for step in filter(None, found):  # a term that is zero mends nothing by its number
                inverse = pow(step, -1, self._p)
                for undone, wanted in self._likely.items():
                    less = rational(wanted * inverse % self._p, self._p)
                    if less and (ratio := 1 - less) not in RATIOS and abs(ratio) not in (0, 1):
                        yield Piece(undone, (self._numbered(change.index, ratio),))

    @cached_property
    def _likely(self) -> dict[int, int]:
        """The steps that undo one wrong, or all with the same speeds and accelerations."""
        groups: dict[frozenset, list[int]] = defaultdict(list)
        for i, wrong in enumerate(self.wrongs.each):
            groups[wrong.moving].append(i)
        chosen = [[i] for i in range(len(self.wrongs.each))]
        chosen += [some for some in groups.values() if len(some) > 1]
        return {
            sum(1 << i for i in some): -sum(self.wrongs.each[i].share for i in some) % self._p
            for some in chosen
        }

    def _numbered(self, index: int, ratio: Fraction) -> Change:
        """A term with another number in it."""
        factor = ratio.numerator * pow(ratio.denominator, -1, self._p)
        values = tuple(sheet.has[index] * factor % self._p for sheet in self.problem.sheets)
        wrap = partial(_scaled, ratio)
        node = wrap(self.problem.tree.nodes[index])
        cost = TOKEN + 2 * HINT + size_of(ratio) + (TOKEN - HINT if ratio < 0 else 0.0)
        return Change(index, node, Mistake.FACTOR, cost, index, values, wrap)


def _scaled(ratio: Fraction, node: Node) -> Node:
    """A term times a number, as one number above a line and one below it."""
    factors = list(_factors(node))
    values = [constant(factor) for factor in factors]
    number = prod((value for value in values if value is not None), start=ratio)
    new = [factor for factor, value in zip(factors, values, strict=True) if value is None]
    if abs(number.numerator) != 1 or not new:
        new.insert(0, Number(0, Fraction(abs(number.numerator))))
    if number.denominator != 1:
        new.append(Power(0, Number(0, Fraction(number.denominator)), Number(0, Fraction(-1))))
    whole = new[0] if len(new) == 1 else Product(node.at, tuple(new))
    return minus(whole) if number < 0 else whole


def _factors(node: Node) -> Iterator[Node]:
    """Factors of a product, and of products in it."""
    if isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor)
    else:
        yield node
