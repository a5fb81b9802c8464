"""Which edits undo every difference, each difference once: exact covers, the cheapest first.

cost of a choice so far + what the differences that are left cost at least  ->  the next one
"""

import heapq
import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import Change
from mechanics.blame.search.syntax_tree import SyntaxTree

MOST_PIECES = 6
"""Pieces of a cover."""

MOST_CHOICES = 5000
"""Choices that are looked at."""

LEFT = 0.9
"""What a difference costs that is left for two edits together."""


@dataclass(frozen=True, eq=False)
class Piece:
    """Edits of one term, and the differences that they undo.

    Attributes
    ----------
    undone : int
        A bit for each difference.
    """

    undone: int
    changes: tuple[Change, ...]

    @property
    def cost(self) -> float:
        """Sum of the costs."""
        return sum(change.cost for change in self.changes)


@dataclass(frozen=True)
class Cover:
    """Pieces that undo nothing twice.

    Attributes
    ----------
    left : int
        Bits of the differences that none of them undoes.
    """

    left: int
    pieces: tuple[Piece, ...]

    @property
    def changes(self) -> tuple[Change, ...]:
        """All edits."""
        return tuple(change for piece in self.pieces for change in piece.changes)


def covers(
    tree: SyntaxTree, pieces: Sequence[Piece], count: int, most_left: int
) -> Iterator[Cover]:
    """Pieces at places apart that undo differences, the cheapest first; some may be left."""
    by_first: dict[int, list[Piece]] = {}
    for piece in pieces:
        by_first.setdefault(piece.undone & -piece.undone, []).append(piece)
    each = min([LEFT, *(piece.cost / piece.undone.bit_count() for piece in pieces)])
    order = itertools.count()
    # What is open, what is left for good, and the pieces; the cost is that beyond the least one.
    heap: list[tuple[float, int, int, Cover]] = [(0.0, 0, (1 << count) - 1, Cover(0, ()))]
    for _ in range(MOST_CHOICES):
        if not heap:
            return
        bound, _, open_, cover = heapq.heappop(heap)
        if not open_:
            yield cover
            continue
        first = open_ & -open_
        if cover.left.bit_count() < most_left:
            more = Cover(cover.left | first, cover.pieces)
            heapq.heappush(heap, (bound + LEFT - each, next(order), open_ & ~first, more))
        if len(cover.pieces) == MOST_PIECES:
            continue
        for piece in by_first.get(first, ()):
            if piece.undone & ~open_ or not all(apart(tree, piece, p) for p in cover.pieces):
                continue
            more = Cover(cover.left, (*cover.pieces, piece))
            cost = bound + piece.cost - each * piece.undone.bit_count()
            heapq.heappush(heap, (cost, next(order), open_ & ~piece.undone, more))


def apart(tree: SyntaxTree, one: Piece, two: Piece) -> bool:
    """Whether no edit of one stands in an edit of the other, but for a term that is added there."""
    return all(_under(tree, a, b) and _under(tree, b, a) for a in one.changes for b in two.changes)


def _under(tree: SyntaxTree, outer: Change, inner: Change) -> bool:
    """Whether an edit may go together with another one that may stand in it."""
    return adds(outer) or outer.at not in tree.ways_up(inner.at)


def adds(change: Change) -> bool:
    """Whether a change leaves what stands there, and adds something to it."""
    return change.mistake is Mistake.MISSING and change.wrap is not None
