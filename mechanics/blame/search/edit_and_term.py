"""One edit and one missing term at once.

    d = needed - has with the edit          d(2 s) / d(s) = 2**e for a few quantities s at first

What passes is looked at in full: the edit is put in, and the missing term looked for.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain

from sympy import Symbol

from mechanics.blame.result import Mistake
from mechanics.blame.search.candidates import Candidates
from mechanics.blame.search.change import ADDED, Change
from mechanics.blame.search.claim import edited_claim
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.inverse_evaluation import InsideHere, Sheet
from mechanics.blame.search.missing import Missing
from mechanics.blame.search.words import Words
from mechanics.claims.tree import Sum
from mechanics.kernel.field import DivisionHere

TESTS = 3
"""Quantities that are doubled at first."""

FULL = 6
"""Edits that are looked at in full."""


@dataclass(frozen=True, eq=False)
class Both:
    """Looks for an edit and a missing term.

    Attributes
    ----------
    homogeneity : Homogeneity
        Of the statement without an edit.
    """

    homogeneity: Homogeneity

    @property
    def _p(self) -> int:
        return self.homogeneity.problem.prime

    def pairs(self) -> list[tuple[Change, Change]]:
        """Edits with a missing term each, the cheapest first."""
        grown = self.homogeneity.problems
        if not self.homogeneity.problem.plain or len(grown) < 2:
            return []
        problems = [grown[None], *(grown[symbol] for symbol in self._tests)]
        sheets = tuple(problem.sheets[0] for problem in problems)
        words = self.homogeneity.words
        words = Words(words.truth, words.written, sheets, words.held)
        changes = Candidates(Maker(self.homogeneity.problem.tree, sheets, words)).all()
        hopeful = sorted(self._hopeful(sheets, changes), key=lambda change: change.cost)
        found: list[tuple[Change, Change]] = []
        for change in hopeful[:FULL]:
            found += self._completed(change)
        return sorted(found, key=lambda pair: pair[0].cost + pair[1].cost)

    @cached_property
    def _tests(self) -> list[Symbol]:
        """Parameters that stand in most terms: what is left tells most when these are doubled."""
        scene, grown = self.homogeneity.claim.truth.scene, self.homogeneity.problems
        held = [s for s in grown if s is not None and s in scene.parameters]
        return (held or [s for s in grown if s is not None])[:TESTS]

    def _hopeful(self, sheets: Sequence[Sheet], changes: Sequence[Change]) -> Iterator[Change]:
        tree = self.homogeneity.problem.tree
        for change in changes:
            if not tree.single(change.at):
                continue
            for index in tree.ways_up(change.at):
                top = isinstance(tree.nodes[index], Sum) or tree.side(index)
                plain = tree.written(index) and not tree.rates[index]
                if top and plain and self._grows(sheets, change, index):
                    yield change
                    break

    def _grows(self, sheets: Sequence[Sheet], change: Change, index: int) -> bool:
        """Whether what a sum lacks with an edit in it may be a product."""
        lacks = []
        for k, sheet in enumerate(sheets):
            need = sheet.needs[index]
            if need is None:
                return False
            start = (change.at, change.values[k])
            try:
                way = chain([start], sheet.climb(*start))
                value = next(value for above, value in way if above == index)
            except (DivisionHere, InsideHere):
                return False
            lacks.append((need - value) % self._p)
        if not lacks[0]:
            return False
        inverse = pow(lacks[0], -1, self._p)
        return all(
            lack * inverse % self._p in ratios
            for lack, ratios in zip(lacks[1:], self._ratios, strict=True)
        )

    @cached_property
    def _ratios(self) -> list[set[int]]:
        """How a product may grow with each quantity that is doubled: with what it may hold."""
        p, found = self._p, []
        for symbol in self._tests:
            steps = [
                f.inverse[None] * pow(f.inverse[symbol], -1, p) for f in self.homogeneity.factors
            ]
            found.append(
                {step * power % p for step in steps for power in self.homogeneity.doubling}
            )
        return found

    def _completed(self, change: Change) -> Iterator[tuple[Change, Change]]:
        """An edit with the term that is missing beside it."""
        tree = self.homogeneity.problem.tree
        homogeneity = self.homogeneity.edited(
            edited_claim(self.homogeneity.claim, [(tree, change)])
        )
        if homogeneity is None:
            return
        for added in Missing(homogeneity).changes():
            place = homogeneity.problem.tree.place[added.index]
            indices = tree.copies.get(place, [])
            if added.mistake is Mistake.MISSING and indices and added.cost < 2 * ADDED:
                yield change, replace(added, index=indices[0], at=indices[0])
