"""Two terms that a sum lacks at once, told apart by how they grow with one quantity s.

    d = t1 + t2,    t1 ~ s**a,    t2 ~ s**b        t1 = (d(2 s) - 2**b d(s)) / (2**a - 2**b)

Each of the two is then a product of its own, with the same question about every other quantity.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from mechanics.blame.search.change import ADDED, Change
from mechanics.blame.search.edits import added
from mechanics.blame.search.factors import Series
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.products import Products
from mechanics.claims.tree import Sum

EXPONENTS = ((1, 0), (0, 1), (2, 0), (0, 2), (2, 1), (1, 2))
MOST_SYMBOLS = 2
"""Quantities that the terms are told apart by."""


@dataclass(frozen=True, eq=False)
class Two:
    """Looks for two missing terms of one sum or side.

    Attributes
    ----------
    homogeneity : Homogeneity
    """

    homogeneity: Homogeneity

    @property
    def _p(self) -> int:
        return self.homogeneity.problem.prime

    @cached_property
    def _products(self) -> Products:
        return Products(self.homogeneity)

    def pairs(self) -> list[tuple[Change, Change]]:
        """Pairs of terms that are added to one sum, the cheapest first."""
        if not self.homogeneity.problem.plain or not self.homogeneity.problems:
            return []
        tree = self.homogeneity.problem.tree
        found: list[tuple[Change, Change]] = []
        for index, node in enumerate(tree.nodes):
            if tree.plain(index) and (isinstance(node, Sum) or tree.side(index)):
                found += self._at(index)
        return sorted(found, key=lambda pair: pair[0].cost + pair[1].cost)

    def _at(self, index: int) -> Iterator[tuple[Change, Change]]:
        whole = self._series(self.homogeneity, index)
        if not whole or not whole[None]:
            return
        inverse = pow(whole[None], -1, self._p)
        mixed = [
            s for s, v in whole.items() if v * inverse % self._p not in self.homogeneity.doubling
        ]
        for symbol in [s for s in mixed if s is not None][:MOST_SYMBOLS]:
            grown = self._series(self.homogeneity.after(symbol), index)
            for a, b in EXPONENTS if grown else ():
                first = self._split(whole, grown, a, b)
                second = {s: (v - first[s]) % self._p for s, v in whole.items()}
                one, two = (self._added(index, series) for series in (first, second))
                if one is not None and two is not None:
                    yield one, two
                    return

    def _series(self, homogeneity: Homogeneity, index: int) -> Series:
        """What a node lacks everywhere; empty where that is not known."""
        found: Series = {}
        for symbol, problem in homogeneity.problems.items():
            need = problem.sheets[0].needs[index]
            if need is None:
                return {}
            found[symbol] = (need - problem.sheets[0].has[index]) % self._p
        return found

    def _split(self, whole: Series, grown: Series, a: int, b: int) -> Series:
        scale = pow(2**a - 2**b, -1, self._p)
        return {s: (grown[s] - 2**b * v) * scale % self._p for s, v in whole.items()}

    def _added(self, index: int, series: Series) -> Change | None:
        """The cheapest product that a series is, added to a node."""
        if not series[None]:
            return None
        found = min(self._products.of(series), key=lambda entry: entry[1], default=None)
        return found and added(self.homogeneity.problem, index, found[0], ADDED + found[1])
