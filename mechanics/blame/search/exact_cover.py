"""Several independent errors: edits that each undo some of the terms that differ.

    step of an edit = -(sum of some wrongs)        so that it undoes just these
    edits that undo every wrong, and none twice    ->  all of them together

Every edit is looked up among the sums, so that three errors are no harder to find than two. Where
two edits meet in one term they undo nothing alone: the others are put in, and a pair looked for.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from mechanics.blame.search.added_terms import Added
from mechanics.blame.search.change import DROPPED, Change
from mechanics.blame.search.cover import Piece, covers
from mechanics.blame.search.differing_terms import Wrongs, wrongs
from mechanics.blame.search.edit_effects import steps
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.pieces import Pieces
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.second_edit import completed
from mechanics.blame.search.squares import borrowed
from mechanics.errors import ExpressionError
from mechanics.kernel.field import Inadmissible
from mechanics.kernel.ring import TooLarge

SHOWN = 6
"""Sets that are told."""

LOOKED_AT = (5, 2, 1, 1)
"""Sets of edits for which what they leave is looked for, for each right equation."""

MOST_CHANGES = 20_000
"""Single edits; with more a statement is too long for this search."""

MOST_LEFT = 12
"""Wrongs that they may leave."""


@dataclass(frozen=True, eq=False)
class Option:
    """What is known for one right equation.

    Attributes
    ----------
    size : int
        Number of wrongs.
    found : list of tuple of Change
        Sets of edits that undo every wrong one at a time, the cheapest first.
    """

    size: int
    pieces: list[Piece]
    found: list[tuple[Change, ...]]


@dataclass(frozen=True, eq=False)
class Several:
    """Looks for these sets.

    Attributes
    ----------
    changes : sequence of Change
        Single edits.
    """

    homogeneity: Homogeneity
    changes: Sequence[Change]

    def pairs(self) -> list[tuple[Change, ...]]:
        """Two edits in two terms, with numbers that are not among the simple ones."""
        found = (each for option in self._options for each in option.found)
        return [each for each in found if len(each) == 2 and _simple(each)]

    def all(self) -> list[tuple[Change, ...]]:
        """Sets of edits that make a statement right, the cheapest first."""
        found: dict[frozenset[int], tuple[Change, ...]] = {}
        for option, looked_at in zip(self._options, LOOKED_AT, strict=False):
            for each in self._against(option, looked_at):
                found.setdefault(frozenset(map(id, each)), each)
            if any(_simple(each) for each in found.values()):
                break
        return sorted(found.values(), key=cost_of)[:SHOWN]

    @property
    def _problem(self) -> Problem:
        return self.homogeneity.problem

    @cached_property
    def _known(self) -> list[Wrongs]:
        if len(self.changes) > MOST_CHANGES:
            return []
        try:
            return wrongs(self.homogeneity.claim, self._problem)
        except (ExpressionError, TooLarge, Inadmissible):
            return []

    @cached_property
    def _open(self) -> list[Change]:
        """What would mend it alone has been tried: a side that is left out, and the like."""
        problem = self._problem
        more = (*self.changes, *borrowed(problem))
        return [c for c in more if not (_drops_a_side(problem, c) or problem.mends(c))]

    @cached_property
    def _steps(self) -> list[tuple[Change, list[int]]]:
        """What each edit adds to the residual."""
        cleared = any(known.cleared for known in self._known)
        return [(c, list(steps(self._problem, c, cleared))) for c in self._open]

    @cached_property
    def _options(self) -> list[Option]:
        """What is known for each right equation that may be meant."""
        return [self._option(known) for known in self._known]

    def _option(self, known: Wrongs) -> Option:
        problem, size = self._problem, len(known.each)
        pieces = Pieces(problem, self._steps, known).all()
        added = Added(self.homogeneity.claim, problem, known, self.homogeneity.words).pieces()
        found = covers(problem.tree, [*pieces, *added], size, 0)
        return Option(size, pieces, [cover.changes for cover in islice(found, SHOWN)])

    def _against(self, option: Option, looked_at: int) -> Iterator[tuple[Change, ...]]:
        """Edits that undo every wrong, some of them one at a time, and the rest together."""
        yield from option.found
        if any(map(_simple, option.found)):
            return
        partly = covers(self._problem.tree, option.pieces, option.size, MOST_LEFT)
        for cover in islice(partly, looked_at):
            if cover.left and cover.pieces:
                more = list(completed(self._problem, cover.changes, self._open))
                yield from more
                if any(map(_simple, more)):
                    return


def cost_of(changes: Sequence[Change]) -> float:
    """Sum of the costs."""
    return sum(change.cost for change in changes)


def _simple(changes: Sequence[Change]) -> bool:
    """Whether nothing is left out, added or replaced: no other edits are likelier."""
    return all(change.cost < DROPPED for change in changes)


def _drops_a_side(problem: Problem, change: Change) -> bool:
    return change.node is None and problem.tree.side(change.index)
