"""What refuted statements are compared with: the truth, in the words and symbols of a person.

truth  ->  its derivation in pieces  ->  right equations, in u or q'  ->  known mistakes
"""

from dataclasses import dataclass, field
from functools import cached_property

from sympy import Expr, Symbol

from mechanics.blame.abbreviations import folded, kept_symbols
from mechanics.blame.candidates import Candidates, candidates_of
from mechanics.blame.derivation import Derivation
from mechanics.blame.groups import second_rates
from mechanics.blame.mistakes.catalogue import Mistakes
from mechanics.blame.mistakes.fault_model import right
from mechanics.blame.mistakes.moving_point import wrong_rows
from mechanics.blame.nearest import Candidate
from mechanics.blame.search.point import Points
from mechanics.blame.view import View
from mechanics.checks.ledger_compare import definitions_in_full
from mechanics.equations import Equations


@dataclass(frozen=True, eq=False, repr=False)
class Reference:
    """What the statements of a text are compared with; each is derived once, when asked for.

    Attributes
    ----------
    truth : Equations
        Derived, with reactions.
    """

    truth: Equations
    _folded: dict[frozenset[Symbol], tuple["Reference", dict[Symbol, Expr]]] = field(
        default_factory=dict
    )

    @cached_property
    def points(self) -> Points:
        """Of a field."""
        return Points(self.truth)

    @cached_property
    def derivation(self) -> Derivation:
        """The truth, piece by piece."""
        return Derivation(self.truth)

    @cached_property
    def in_speeds(self) -> Candidates:
        """Right equations in u and u'."""
        return Candidates(View(self.derivation, in_rates=False))

    @cached_property
    def in_rates(self) -> Candidates:
        """Right equations in q' and q''."""
        return Candidates(View(self.derivation, in_rates=True))

    @cached_property
    def mistakes(self) -> Mistakes:
        """Of Lagrange's equations, or of free bodies where friction is."""
        return Mistakes(right(self.derivation, with_reactions=False))

    @cached_property
    def mistakes_of_free_bodies(self) -> Mistakes:
        """Where reactions are asked for."""
        return Mistakes(right(self.derivation, with_reactions=True))

    @cached_property
    def wrong_moments(self) -> tuple[Candidate, ...]:
        """Moment equations about points that move, with each term forgotten in turn."""
        return candidates_of(wrong_rows(self.derivation.moving_rows))

    def candidates(self, expression: Expr) -> Candidates:
        """Right equations in the speeds in which an expression is written."""
        scene = self.truth.scene
        rates = {*scene.qd, *second_rates(scene)} - {*scene.u, *scene.ud}
        return self.in_rates if expression.free_symbols & rates else self.in_speeds

    def folded(self, expression: Expr) -> tuple["Reference", Expr]:
        """A reference and an expression in the same symbols, as few written out as possible."""
        scene = self.truth.scene
        if not scene.definitions:
            return self, expression
        kept = kept_symbols(scene, expression)
        if kept not in self._folded:
            truth, used = folded(self.truth, kept)
            other = self if truth is self.truth else Reference(truth)
            self._folded[kept] = other, definitions_in_full(scene, used)
        other, table = self._folded[kept]
        return other, expression.xreplace(table)
