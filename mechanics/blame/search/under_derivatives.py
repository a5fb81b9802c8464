"""Edits of a term that is differentiated, and what its derivative is worth then.

d/dt (m l theta_dot + ...)  ->  d/dt (m l**2 theta_dot + ...), d/dt (-m l theta_dot + ...), ...
"""

from collections.abc import Iterator
from dataclasses import dataclass

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    DROPPED,
    HINT,
    RATIOS,
    SECOND,
    TOKEN,
    minus,
    one_of_squares,
    raised,
    size_of,
    times,
)
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.function_arguments import Inner, Inside
from mechanics.blame.search.inverse_evaluation import integer_exponent
from mechanics.claims.kinds import angular
from mechanics.claims.tree import Call, Name, Node, Number, Power, Product, Sum, parts

MOST_RATIOS = 12
"""Numbers in front of a term, the simplest of them."""


def differentiated(make: Maker, index: int) -> Iterator[Inner]:
    """Edits of a term below d/dt, and of its parts."""
    return _Term(make).of(index)


@dataclass(frozen=True, eq=False)
class _Term:
    make: Maker

    def of(self, index: int) -> Iterator[Inner]:
        """Edits of a term, of its factors, and of what functions are taken of."""
        node = self.make.tree.nodes[index]
        if isinstance(self.make.around(index), Sum):
            far = HINT if one_of_squares(node, self.make.around(index)) else 0.0
            yield index, minus(node), Mistake.SIGN, TOKEN + far
            yield index, None, Mistake.EXTRA, DROPPED
        for ratio in RATIOS[:MOST_RATIOS]:
            cost = TOKEN + size_of(ratio)
            yield index, times(Number(0, ratio), node), Mistake.FACTOR, cost
        for factor in self._factors():
            yield index, times(factor, node), Mistake.FACTOR, TOKEN + SECOND
        yield from self._below(index)

    def _below(self, index: int) -> Iterator[Inner]:
        node, tree = self.make.tree.nodes[index], self.make.tree
        yield from self._token(index, node)
        if isinstance(node, Call):
            yield from Inside(tree, self.make.words).of(index)
            return
        for kid in tree.kids[index]:
            part = tree.nodes[kid]
            if tree.place[kid][0] != tree.place[index][0]:
                continue  # a definition, which is worth something at other places, too
            yield from Inside(tree, self.make.words).edits(kid, part, node)
            if isinstance(node, Product) and not isinstance(part, Number):
                yield kid, None, Mistake.FACTOR, TOKEN + SECOND
            if not (isinstance(node, Power) and kid == tree.kids[index][1]):
                yield from self._below(kid)

    def _token(self, index: int, node: Node) -> Iterator[Inner]:
        """Another exponent, another function."""
        if isinstance(node, Power):
            exponent = integer_exponent(node)
            for step in (1, -1) if exponent is not None else ():
                if new := (exponent or 0) + step:
                    yield index, raised(node.base, new), Mistake.POWER, TOKEN + HINT
            return
        if isinstance(node, Call):
            for other in self.make.words.functions(node):
                yield index, other, Mistake.FUNCTION, TOKEN
        squared = isinstance(node, Call | Name) and not isinstance(self.make.around(index), Power)
        if squared and not (isinstance(node, Name) and parts(node)):
            yield index, raised(node, 2), Mistake.POWER, TOKEN

    def _factors(self) -> Iterator[Node]:
        """What may be missing in front: symbols that were written, sines and cosines."""
        words, held = self.make.words, set(self.make.words.held)
        angles = angular(words.truth.scene)
        for word in words.symbols:
            if word.symbol in held:
                yield word.name
            if word.symbol in angles:
                yield Call(0, "sin", (word.name,))
                yield Call(0, "cos", (word.name,))
