"""Every small edit at every node, with what the node would be worth.

    names: other symbols, powers      numbers: ratios      powers: other exponents
    functions: sin, cos, tan, other arguments              terms: sign, factor, left out

An edit inside of a function is worth what the function is then.
"""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    DROPPED,
    HINT,
    SECOND,
    TOKEN,
    Change,
    minus,
    one_of_squares,
    plus,
)
from mechanics.blame.search.circular import circular
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.function_arguments import Inner, inside_of, valued
from mechanics.blame.search.inserted_factors import Inserted
from mechanics.blame.search.inverse_evaluation import integer_exponent
from mechanics.blame.search.syntax_tree import is_root
from mechanics.blame.search.tokens import Tokens
from mechanics.blame.search.under_derivatives import differentiated
from mechanics.claims.tree import COMPOSED, Name, Node, Number, Power, Product, Sum, constant

MOST_INSIDE = 400
"""Edits inside of functions, each of which has to be evaluated anew."""

MOST_EVALUATED = 16_000
"""Nodes of these functions together: 400 functions of 40 nodes."""


@dataclass(frozen=True, eq=False)
class Candidates:
    """Makes the edits.

    Attributes
    ----------
    make : Maker
    """

    make: Maker

    def all(self) -> list[Change]:
        """Every edit, once for each node that was written."""
        found: list[Change] = []
        inside: list[tuple[int, Inner]] = []
        tree = self.make.tree
        for index, node in enumerate(tree.nodes):
            copies = tree.copies[tree.place[index]]
            if not tree.written(index) or copies[0] != index or self._hidden(index):
                continue
            if not tree.rates[index]:
                found += self._here(index, node)
            if tree.opaque(index):
                edits = differentiated if tree.rates[index] else inside_of
                inside += [(index, edit) for edit in edits(self.make, index)]
        inside.sort(key=lambda pair: pair[1][-1])  # the cheapest are tried
        return [*found, *valued(self.make, self._evaluated(inside[:MOST_INSIDE]))]

    def _evaluated(self, inside: Sequence[tuple[int, Inner]]) -> Iterator[tuple[int, Inner]]:
        """As many as there is time for: the functions around them are evaluated anew."""
        left = MOST_EVALUATED
        for index, edit in inside:
            left -= self.make.tree.size(index)
            if left < 0:
                return
            yield index, edit

    def _hidden(self, index: int) -> bool:
        """Whether a node stands in a function or exponent, so that its value tells nothing."""
        tree = self.make.tree
        for child, above in itertools.pairwise(tree.ways_up(index)):
            node = tree.nodes[above]
            if tree.opaque(above):
                return True
            if isinstance(node, Power):
                exponent = tree.kids[above][0] != child
                if exponent or not (is_root(node) or integer_exponent(node)):
                    return True
        return False

    def _here(self, index: int, node: Node) -> Iterator[Change]:
        around = self.make.around(index)
        if self.make.tree.term(index) or self._entry(index, node):
            yield from self._term(index, node)
        elif isinstance(around, Product):
            yield from self._factor(index, node)
        elif around is not None and is_root(around):
            yield from self._inserted.of(index, 0.0)
        yield from self._tokens.of(index, node)
        alone = isinstance(node, Name) and not self.make.tree.kids[index]
        if isinstance(node, Sum):
            yield from self._plus(index, node.terms)
        elif alone and not isinstance(self.make.around(index), Sum):
            yield from self._plus(index, (node,))

    def _entry(self, index: int, node: Node) -> bool:
        """Whether a node is an entry of a matrix that is multiplied by something."""
        around = self.make.around(index)
        plain = isinstance(node, Name) and not self.make.tree.kids[index]
        return isinstance(around, Product) and around.at == COMPOSED and not plain

    @cached_property
    def _tokens(self) -> Tokens:
        return Tokens(self.make)

    @cached_property
    def _inserted(self) -> Inserted:
        tree, sheets, words = self.make.tree, self.make.sheets, self.make.words
        return Inserted(self.make, circular(tree, sheets, words))

    def _term(self, index: int, node: Node) -> Iterator[Change]:
        """The sign of a term, a factor of it, the term left out."""
        p, has = self.make.p, self.make.has(index)
        if not any(has):
            return
        values = tuple(-value % p for value in has)
        side = self.make.tree.side(index)
        # A side that is one name is likely so; a whole sum is rarely turned.
        far = 2 * HINT if side and isinstance(node, Name) else 0.0
        far += 4 * HINT if side and isinstance(node, Sum) else 0.0
        far += HINT if one_of_squares(node, self.make.around(index)) else 0.0
        # Of two terms either may be turned: who writes x'' + k x = 0 leads with the one that is
        # right.
        far += HINT if self.make.words.accelerates(node) else 0.0
        yield self.make.wrapped(index, minus, Mistake.SIGN, TOKEN + far, values)
        if not side or self._other_side(index) or isinstance(self.make.tree.place[index][0], str):
            zero = (0,) * len(has)
            # A factor that is left out is one, an entry that is left out is zero.
            left = Number(node.at, Fraction(0)) if self._entry(index, node) else None
            yield self.make.change(index, left, Mistake.EXTRA, DROPPED, zero)
        yield from self._inserted.of(index, far)

    def _other_side(self, index: int) -> bool:
        """Whether there is another side, so that this one may be zero."""
        return index > 0 and len(self.make.tree.kids[0]) == 2 and not self.make.tree.written(0)

    def _factor(self, index: int, node: Node) -> Iterator[Change]:
        """A factor left out."""
        if constant(node) is None:
            ones = (1,) * len(self.make.sheets)
            yield self.make.change(index, None, Mistake.FACTOR, TOKEN + SECOND, ones)

    def _plus(self, index: int, terms: tuple[Node, ...]) -> Iterator[Change]:
        """A symbol of the same kind added to a sum or taken from it, as in m_1 + m_2."""
        present = [self.make.words.word(term) for term in terms if isinstance(term, Name)]
        kinds = {word.kind if word is not None else "" for word in present}
        for word in self.make.words.symbols:
            if word.kind not in kinds or not word.kind or word in present:
                continue
            for sign in (1, -1):
                values = tuple(
                    (a + sign * b) % self.make.p
                    for a, b in zip(self.make.has(index), word.values, strict=True)
                )
                added = word.name if sign > 0 else minus(word.name)
                cost = TOKEN + SECOND + (HINT if sign < 0 else 0.0)
                yield self.make.wrapped(index, partial(plus, added), Mistake.MISSING, cost, values)
