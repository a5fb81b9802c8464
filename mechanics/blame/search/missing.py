"""The term that a sum lacks: what it needs less what it has, where that is one product.

needed - has = m l theta_dot**2 sin(theta)
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import ADDED, HINT, Change
from mechanics.blame.search.edits import added
from mechanics.blame.search.factors import Series
from mechanics.blame.search.homogeneity_test import Homogeneity
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.products import Products
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Sum,
    constant,
    names,
    parts,
)


@dataclass(frozen=True, eq=False)
class Missing:
    """Looks for the missing term of a sum.

    Attributes
    ----------
    homogeneity : Homogeneity
        The problem, and how it is where quantities are doubled.
    """

    homogeneity: Homogeneity

    @property
    def problem(self) -> Problem:
        """The equality that does not hold."""
        return self.homogeneity.problem

    @property
    def _p(self) -> int:
        return self.problem.prime

    @cached_property
    def _products(self) -> Products:
        return Products(self.homogeneity)

    def changes(self) -> list[Change]:
        """A term added to each sum or side that lacks one product."""
        if not self.homogeneity.problems:
            return []
        count = len(self.problem.tree.nodes)
        return [change for index in range(count) for change in self._at(index)]

    def _lacks(self, problem: Problem, index: int) -> list[int]:
        """What a node lacks, at two states the difference of it; one of two below a square."""
        if not problem.plain:
            slopes = problem.slopes(index)
            if slopes is None or not slopes[0] or slopes[0] != slopes[1]:
                return []
            return [-problem.residual * pow(slopes[0], -1, self._p) % self._p]
        (sheet,) = problem.sheets
        return [(need - sheet.has[index]) % self._p for need in sheet.needed(index)]

    def _series(self, index: int) -> Iterator[Series]:
        """What a node lacks at every point; of two roots the one that tells an exponent."""
        options = {
            symbol: self._lacks(problem, index)
            for symbol, problem in self.homogeneity.problems.items()
        }
        if not all(options.values()):
            return
        for first in options[None]:
            found: Series = {None: first}
            inverse = pow(first, -1, self._p) if first else 0
            for symbol, values in options.items():
                if symbol is not None:
                    known = [
                        v for v in values if v * inverse % self._p in self.homogeneity.doubling
                    ]
                    found[symbol] = (known or values)[0]
            if first:
                yield found

    def _at(self, index: int) -> Iterator[Change]:
        """The likeliest term; beside it the likeliest with a sign(v), which is 1 or -1 anywhere."""
        if not self._open(index):
            return
        likeliest: dict[bool, tuple[Node, float]] = {}
        inside = isinstance(self._around(index), Product | Power)
        for series in self._series(index):
            for term, cost in self._products.of(series):
                held = (term, *parts(term))
                if inside and any(isinstance(p, Power) and isinstance(p.base, Call) for p in held):
                    continue  # what stands around it would cancel the sine below the line
                kind = any(isinstance(part, Call) and part.function == "sign" for part in held)
                if kind not in likeliest or cost < likeliest[kind][1]:
                    likeliest[kind] = term, cost
        tree = self.problem.tree
        side = tree.side(index)
        # Beside a side is plainer than in a bracket around a factor: + c x', not k (x + c x'/k).
        far = 0.0 if isinstance(tree.nodes[index], Sum) else (5 if side else 10) * HINT
        words = self.homogeneity.words
        inertial = side and words.accelerates(tree.nodes[index])
        for term, cost in likeliest.values():
            # What m x'' = F lacks is a force, on the right.
            force = inertial and not words.quadratic(self.problem.sheets[0].builder(term))
            yield from self._added(index, term, ADDED + far + cost + (HINT / 2 if force else 0.0))

    def _around(self, index: int) -> Node | None:
        above = self.problem.tree.parent[index]
        return self.problem.tree.nodes[above] if above >= 0 else None

    def _open(self, index: int) -> bool:
        """Whether a term may be missing at a node: a sum, a side, a factor, a divisor, a base."""
        tree = self.problem.tree
        node, around = tree.nodes[index], self._around(index)
        factor = isinstance(node, Product | Name) and isinstance(around, Product)
        below = isinstance(around, Power)
        # Nothing is missing in 1/2; a number alone is another one.
        inside = (factor or below) and constant(node) is None
        return (isinstance(node, Sum) or tree.side(index) or inside) and tree.plain(index)

    def _added(self, index: int, term: Node, cost: float) -> Iterator[Change]:
        node = self.problem.tree.nodes[index]
        change = added(self.problem, index, term, cost)
        if change is not None and isinstance(node, Number) and node.value == 0:
            change = replace(change, mistake=Mistake.TERM, wrap=None)  # it stands in place of that
        elif change is not None and isinstance(self._around(index), Product):
            change = self._collected(change, change.node)
        yield from () if change is None else (change,)

    def _collected(self, change: Change, node: Node | None) -> Change:
        """A factor with what is added to it, collected where that is shorter: of names alone.

        x - y for 2 x - (x + y)
        """
        own = self.homogeneity.claim.definitions
        if node is None or any(name.name in own for name in names(node)):
            return change
        whole = self.problem.sheets[0].builder(node).expand()
        try:
            other = self.homogeneity.claim.written.tree(whole)
        except Untreeable:  # a maximum, which nobody wrote expanded
            return change
        if len(names(other)) < len(names(node)):
            return replace(change, node=other, wrap=None)
        return change
