"""A term added for each term that differs, to a sum or a side.

slope of a sum * number * term = -wrong        a'' = N / Q:  Q lacks what is wrong, without a''
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from sympy import Expr, Rational, S, Symbol

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import ADDED, Change
from mechanics.blame.search.claim import Claim
from mechanics.blame.search.cover import Piece
from mechanics.blame.search.differing_terms import Wrong, Wrongs
from mechanics.blame.search.edit_effects import steps
from mechanics.blame.search.edits import added
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.residues import rational
from mechanics.blame.search.words import Words
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.tree import Name, Number, Sum

MET = 0.6
"""What a term costs more that stands there already, with another factor."""


@dataclass(frozen=True, eq=False)
class Added:
    """Makes these edits."""

    claim: Claim
    problem: Problem
    wrongs: Wrongs
    words: Words

    def pieces(self) -> list[Piece]:
        """A term added for each wrong."""
        changes = (next(self._added(wrong), None) for wrong in self.wrongs.each)
        return [Piece(1 << i, (c,)) for i, c in enumerate(changes) if c is not None]

    def _added(self, wrong: Wrong) -> Iterator[Change]:
        p, sheets = self.problem.prime, self.problem.sheets
        nodes, places = self.problem.tree.nodes, self._sums_and_sides
        if not self.words.quadratic(wrong.term):  # what m x'' = F lacks is a force
            places = sorted(places, key=lambda place: self.words.accelerates(nodes[place[0]]))
        for index, slopes, divisor in places:
            term = wrong.term / divisor
            values = tuple(sheet.point.value(term) for sheet in sheets)
            grows = [s * v for s, v in zip(slopes, values, strict=True)]
            whole = (grows[0] - (grows[1] if len(grows) > 1 else 0)) % p
            factor = rational(-wrong.share * pow(whole, -1, p), p) if whole else None
            if not factor:
                continue
            try:
                number = Rational(factor.numerator, factor.denominator)
                tree = self.claim.written.tree(number * term)
            except Untreeable:
                return
            cost = ADDED + (MET if wrong.meets else 0.0)
            if (change := added(self.problem, index, tree, cost)) is not None:
                yield change

    @cached_property
    def _sums_and_sides(self) -> list[tuple[int, list[int], Expr]]:
        """Sums and sides, how the residual grows with each, and what a wrong is divided by there.

        Where a'' = N / Q is wrong by a term with a'', Q lacks that without a''.
        """
        tree = self.problem.tree
        found: list[tuple[int, list[int], Expr]] = []
        for index, node in enumerate(tree.nodes):
            if not (tree.side(index) or isinstance(node, Sum)) or isinstance(node, Number):
                continue
            if not tree.plain(index):
                continue
            slopes = self.problem.slopes(index)
            if slopes is not None:
                found.append((index, slopes, S.One))
            elif self._alone is not None and self.wrongs.cleared:
                more = steps(self.problem, self._one_more(index), True)
                found += [(index, [step], self._alone) for step in islice(more, 1, None)]
        return found

    def _one_more(self, index: int) -> Change:
        """A node with one added to it."""
        values = tuple(sheet.has[index] + 1 for sheet in self.problem.sheets)
        return Change(index, None, Mistake.MISSING, ADDED, index, values)

    @cached_property
    def _alone(self) -> Symbol | None:
        """What stands alone on the left."""
        left = self.claim.entries[self.problem.numbers[0]]
        value = self.claim.written.builder()(left) if isinstance(left, Name) else None
        return value if isinstance(value, Symbol) and self.problem.plain else None
