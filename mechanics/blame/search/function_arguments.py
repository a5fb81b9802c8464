"""Edits of what a function is taken of, and what it is worth then.

sin(theta_1 - theta_2)  ->  sin(theta_1 + theta_2), sin(theta_1), sin(theta_1 - theta_3), ...
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    DROPPED,
    HINT,
    RATIOS,
    SECOND,
    TOKEN,
    Change,
    minus,
    one_of_squares,
    plus,
    size_of,
    times,
)
from mechanics.blame.search.edits import Maker, worth
from mechanics.blame.search.syntax_tree import SyntaxTree, edited
from mechanics.blame.search.words import Words
from mechanics.claims.dimension import NONE, dimension
from mechanics.claims.kinds import angular
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Product,
    Sum,
    inverse,
    names,
    parts,
    product,
    with_parts,
)

Inner = tuple[int, Node | None, Mistake, float]
"""Where, what in its place, which mistake, and its cost."""


def inside_of(make: Maker, index: int) -> Iterator[Inner]:
    """Edits below a function."""
    return Inside(make.tree, make.words).of(index)


def valued(make: Maker, edits: Iterable[tuple[int, Inner]]) -> Iterator[Change]:
    """Edits at or below nodes that are known as a whole only, with what these are worth then."""
    tree = make.tree
    for index, (below, other, mistake, cost) in edits:
        node, depth = tree.nodes[index], len(tree.place[index][1])
        if below == index:
            new = other
        else:
            new = edited(node, [(tree.place[below][1][depth:], other)])
        if new is None:
            yield Change(below, None, mistake, cost, index, (0,) * len(make.sheets))
            continue
        values = None if new == node else worth(make.sheets, tree.as_told(index, new))
        if values is not None:
            yield Change(below, other, mistake, cost, index, values)


@dataclass(frozen=True)
class Inside:
    """Edits of what a function is taken of."""

    tree: SyntaxTree
    words: Words

    def of(self, index: int) -> Iterator[Inner]:
        """Edits of the parts of a node, and of theirs."""
        node = self.tree.nodes[index]
        for kid in self.tree.kids[index]:
            if self.tree.place[kid][0] != self.tree.place[index][0]:
                continue  # a definition, which is worth something at other places, too
            part = self.tree.nodes[kid]
            yield from self.edits(kid, part, node)
            if parts(part):
                yield from self.of(kid)

    def edits(self, index: int, part: Node, around: Node) -> Iterator[Inner]:
        """Edits of one part."""
        if isinstance(part, Name) and not self.tree.kids[index]:
            yield from self._symbols(index, part)
        if isinstance(part, Number) and part.value not in (-1, 0):
            for ratio in RATIOS[:8]:
                value = part.value * ratio
                number = Number(part.at, value)
                yield index, number, Mistake.FACTOR, TOKEN + size_of(value)
        if isinstance(around, Sum):
            # Nobody wrote a sign before the first of several terms.
            first = 2 * HINT if part is around.terms[0] else 0.0
            first += HINT if one_of_squares(part, around) else 0.0
            yield index, minus(part), Mistake.SIGN, TOKEN + first
            yield index, None, Mistake.EXTRA, DROPPED
        if isinstance(around, Call | Sum) and not isinstance(part, Number):
            for ratio in (Fraction(2), Fraction(1, 2)):
                scaled = times(Number(0, ratio), part)
                yield index, scaled, Mistake.FACTOR, TOKEN + SECOND
        if isinstance(around, Call):
            for other in (_without_constants(part), self._lowered(part)):
                if other is not None:
                    yield index, other, Mistake.FACTOR, TOKEN + SECOND
        if isinstance(around, Call) and not isinstance(part, Number):
            yield from self._lacking(index, part)

    def _lacking(self, index: int, part: Node) -> Iterator[Inner]:
        """What an argument may lack: the time in cos(omega), an angle in cos(theta_2), a radius."""
        held = {word for name in names(part) if (word := self.words.word(name)) is not None}
        if isinstance(part, Name):
            yield from self._over_a_length(index, part)
        turned = "coordinate" in {word.kind for word in held}
        for word in self.words.symbols:
            if word.kind == "time":
                yield index, times(part, word.name), Mistake.FACTOR, TOKEN + SECOND
            if turned and word.kind == "coordinate" and word not in held:
                yield index, plus(word.name, part), Mistake.MISSING, TOKEN + SECOND
                yield index, plus(minus(word.name), part), Mistake.MISSING, TOKEN + SECOND + HINT

    def _over_a_length(self, index: int, part: Name) -> Iterator[Inner]:
        """What has a unit is no angle: s/l for an arc s."""
        naming, parameters = self.words.written.naming, self.words.truth.scene.parameters
        unit = dimension(naming, part)
        for other in self.words.symbols if unit not in (None, NONE) else ():
            if other.symbol in parameters and dimension(naming, other.name) == unit:
                over = times(part, inverse(other.name))
                yield index, over, Mistake.FACTOR, TOKEN + SECOND

    def _lowered(self, node: Node) -> Node | None:
        """theta_2 - theta_1 for the difference of their rates."""
        scene, held = self.words.truth.scene, names(node)
        table = dict(zip(scene.qd, scene.q, strict=True))
        table |= {} if scene.speeds else dict(zip(scene.u, scene.q, strict=True))
        of = {
            name: self.words.by_symbol[table[word.symbol]].name
            for name in held
            if (word := self.words.word(name)) is not None and word.symbol in table
        }

        def put(part: Node) -> Node:
            if isinstance(part, Name):
                return of[part]
            return with_parts(part, tuple(map(put, parts(part))))

        return put(node) if held and len(of) == len({*held}) else None

    def _symbols(self, kid: int, part: Name) -> Iterator[Inner]:
        own, angles = self.words.word(part), angular(self.words.truth.scene)
        for word in self.words.symbols:
            alike = word.symbol in angles or (own is not None and word.kind == own.kind)
            if word != own:
                yield kid, word.name, Mistake.SYMBOL, TOKEN if alike else TOKEN + HINT


def _without_constants(node: Node) -> Node | None:
    """theta for theta*pi/180."""
    factors = node.factors if isinstance(node, Product) else ()
    rest = [factor for factor in factors if names(factor)]
    return product(node.at, rest) if 0 < len(rest) < len(factors) else None
