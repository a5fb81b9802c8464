"""A problem at the points where one quantity is doubled, the motion solved anew.

value(2 s) / value(s) = 2**e        ->  s**e divides the value
"""

from dataclasses import dataclass, replace
from functools import cached_property

from sympy import Symbol

from mechanics.blame.search.claim import ALONG, Claim, posed
from mechanics.blame.search.factors import Factor, factors
from mechanics.blame.search.inverse_evaluation import Sheet, sheet_of
from mechanics.blame.search.point import Point
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.words import Words
from mechanics.claims.kinds import angular
from mechanics.claims.place import Refused
from mechanics.kernel.field import Inadmissible

MOST_EXPONENT = 4


@dataclass(frozen=True, eq=False)
class Homogeneity:
    """How a problem grows with every quantity."""

    claim: Claim
    problem: Problem
    words: Words

    @cached_property
    def problems(self) -> dict[Symbol | None, Problem]:
        """The problem, by None, and as it is where a symbol is doubled; empty without points."""
        found: dict[Symbol | None, Problem] = {None: self.problem}
        for symbol in self.symbols:
            doubled = self._doubled(symbol)
            if doubled is None:
                return {}
            found[symbol] = doubled
        return found

    @property
    def symbols(self) -> list[Symbol]:
        """What is doubled."""
        fixed = {*angular(self.claim.truth.scene), *self._following}
        words = (w for w in self.words.symbols if w.kind != "momentum")
        return [word.symbol for word in words if word.symbol not in fixed]

    @property
    def _moving(self) -> bool:
        return isinstance(self.claim.row.quantity, ALONG)

    def _doubled(self, symbol: Symbol) -> Problem | None:
        target, tree = self.problem.target, self.problem.tree
        sheets = []
        for sheet in self.problem.sheets:
            before = sheet.point.family
            family = replace(before, doubled=(*before.doubled, symbol))
            try:
                point = self.claim.reference.points.like(sheet.point, family)
                sheets.append(sheet_of(tree, point, sheet.builder, target(point)))
            except Inadmissible:
                return None
        return Problem(tree, self.problem.numbers, tuple(sheets), target)

    @cached_property
    def factors(self) -> tuple[Factor, ...]:
        """What a term may hold that does not grow as a power, nothing first."""
        return factors(self.problems, self.words, self._following)

    @cached_property
    def _following(self) -> set[Symbol]:
        """What cannot be doubled, as it follows from the rest: definitions, accelerations, ..."""
        scene, family = self.claim.truth.scene, self.problem.sheets[0].point.family
        held = () if family.free else self.claim.reference.points.dependent
        return {*scene.definitions, *held, *(scene.ud if self._moving else ())}

    @cached_property
    def doubling(self) -> dict[int, int]:
        """Exponents by the residues of the powers of two."""
        p = self.problem.prime
        return {pow(2, e, p): e for e in range(-MOST_EXPONENT, MOST_EXPONENT + 1)}

    def after(self, symbol: Symbol) -> "Homogeneity":
        """How the problem grows from where a symbol is doubled already."""
        problem = self.problems[symbol]
        return Homogeneity(self.claim, problem, words_at(self.words, problem))

    def edited(self, claim: Claim) -> "Homogeneity | None":
        """The same for a claim with an edit in it; None where it has no value."""
        families = [sheet.point.family for sheet in self.problem.sheets]
        try:
            problem = posed(claim, self.problem.numbers, self.problem.target, families)
        except (Inadmissible, Refused):
            return None
        return Homogeneity(claim, problem, words_at(self.words, problem))


def growing(claim: Claim, problem: Problem, words: Words) -> Problem:
    """The problem at points that have a value where any one quantity is doubled, too.

    A root of 1 + 4 a^2 x^2 has one in a field at half of all points.
    """
    homogeneity = Homogeneity(claim, problem, words)
    if homogeneity.problems:
        return problem
    families = [sheet.point.family for sheet in problem.sheets]
    doubled = [replace(f, doubled=(*f.doubled, s)) for f in families for s in homogeneity.symbols]
    builder = problem.sheets[0].builder

    def sheets(points: list[Point]) -> tuple[Sheet, ...]:
        kept = points[: len(families)]
        return tuple(sheet_of(problem.tree, p, builder, problem.target(p)) for p in kept)

    try:
        found = claim.reference.points.together([*families, *doubled], sheets)
    except Inadmissible:
        return problem
    return replace(problem, sheets=found)


def words_at(words: Words, problem: Problem) -> Words:
    """The words of a scene with their values at the points of a problem."""
    return Words(words.truth, words.written, problem.sheets, words.held)
