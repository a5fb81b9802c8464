"""Edits of what a function is taken of, or of what is differentiated, and what it is worth then.

sin(theta_1 - theta_2)  ->  sin(theta_1 + theta_2), sin(theta_1), sin(theta_1 - theta_3), ...
"""

from collections.abc import Iterator, Sequence
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
    size_of,
    times,
)
from mechanics.blame.search.forest import Forest, edited
from mechanics.blame.search.sheet import Sheet
from mechanics.blame.search.words import Words
from mechanics.errors import MechanicsError
from mechanics.reading.place import Refused
from mechanics.reading.tree import Call, Name, Node, Number, Rate, Sum, parts

Inner = tuple[int, Node | None, Mistake, float]


def worth(sheets: Sequence[Sheet], node: Node) -> tuple[int, ...] | None:
    """What a node is worth at each point; None where it has no value."""
    try:
        return tuple(sheet.opaque(node) for sheet in sheets)
    except (MechanicsError, Refused):
        return None


def inside_of(
    forest: Forest, sheets: Sequence[Sheet], words: Words, index: int
) -> Iterator[Change]:
    """Edits below a function or a derivative."""
    node = forest.nodes[index]
    depth = len(forest.place[index][1])
    for below, other, mistake, cost in _Inside(forest, words).of(index):
        new = edited(node, [(forest.place[below][1][depth:], other)])
        values = None if new == node else worth(sheets, new)
        if values is not None:
            yield Change(below, other, mistake, cost, index, values)


@dataclass(frozen=True)
class _Inside:
    forest: Forest
    words: Words

    def of(self, index: int) -> Iterator[Inner]:
        """Edits of the parts of a node, and of theirs."""
        node = self.forest.nodes[index]
        for kid in self.forest.kids[index]:
            part = self.forest.nodes[kid]
            if self.forest.place[kid][0] != self.forest.place[index][0]:
                continue  # a definition, which is worth something at other places, too
            if isinstance(part, Name) and not self.forest.kids[kid]:
                yield from self._symbols(kid, part)
            if isinstance(part, Number) and part.value not in (-1, 0):
                for ratio in RATIOS[:8]:
                    value = part.value * ratio
                    number = Number(part.at, value)
                    yield kid, number, Mistake.FACTOR, TOKEN + size_of(value)
            if isinstance(node, Sum):
                yield kid, minus(part), Mistake.SIGN, TOKEN
                yield kid, None, Mistake.EXTRA, DROPPED
            elif isinstance(node, Call | Rate) and not isinstance(part, Number):
                for ratio in (Fraction(2), Fraction(1, 2)):
                    scaled = times(Number(0, ratio), part)
                    yield kid, scaled, Mistake.FACTOR, TOKEN + SECOND
            if parts(part):
                yield from self.of(kid)

    def _symbols(self, kid: int, part: Name) -> Iterator[Inner]:
        own = self.words.word(part)
        for word in self.words.symbols:
            alike = own is not None and word.kind == own.kind
            if word != own:
                yield kid, word.name, Mistake.SYMBOL, TOKEN if alike else TOKEN + HINT
