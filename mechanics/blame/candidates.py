"""Right equations that a person may have meant, as terms, each piece by piece.

adj(M) (M u' - f) = det(M) u' - adj(M) f        where one acceleration stands alone
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from sympy import Expr, Matrix, Symbol

from mechanics.blame.nearest import Candidate
from mechanics.blame.pieces import Kind, Origin, Piece, merged
from mechanics.blame.reaction_free import reduced_rows, tied_speeds
from mechanics.blame.rows import Row
from mechanics.blame.terms import terms_of
from mechanics.blame.view import View
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic import collect_linear

LARGEST_SOLVED = 3
"""Number of speeds up to which equations are solved for an acceleration, by Cramer's rule."""

LARGEST_SUMMED = 4
"""Number of speeds up to which sums and differences of two equations are looked at."""


@dataclass(frozen=True, eq=False, repr=False)
class Candidates:
    """Right equations in the speeds of a view; each is made once, when it is first asked for.

    Attributes
    ----------
    view : View
    """

    view: View
    _tied: dict[tuple[int, ...], tuple[Candidate, ...]] = field(default_factory=dict)
    _solved: dict[Symbol, tuple[Candidate, ...]] = field(default_factory=dict)

    def implicit(self) -> Iterator[Candidate]:
        """Equations of the routes, in several accelerations and without eliminated reactions."""
        yield from self._of_speeds
        yield from self._of_parts
        yield from self._of_sums

    @cached_property
    def _rows(self) -> tuple[Row, ...]:
        """Lagrange's equation of each speed."""
        return tuple(map(self._free, self.view.rows))

    @cached_property
    def _of_speeds(self) -> tuple[Candidate, ...]:
        return candidates_of(self._rows)

    @cached_property
    def _of_parts(self) -> tuple[Candidate, ...]:
        moments = self.view.derivation.moving_rows
        return candidates_of(self._free(self._seen(moment.row)) for moment in moments)

    @cached_property
    def _of_sums(self) -> tuple[Candidate, ...]:
        few = len(self.view.speeds) <= LARGEST_SUMMED
        return candidates_of(map(self._free, _sums(self.view.rows))) if few else ()

    @cached_property
    def with_reactions(self) -> tuple[Candidate, ...]:
        """Free-body equations, where reactions stand as symbols."""
        return candidates_of(map(self._seen, self.view.derivation.free_rows))

    def constrained(self, wanted: frozenset[Symbol]) -> tuple[Candidate, ...]:
        """Equations with the constraints put in; none in a scene without constraints."""
        tied = tied_speeds(self.view, wanted) if self.view.scene.constraints else None
        if tied is None:
            return ()
        if tied not in self._tied:
            self._tied[tied] = candidates_of(map(self._free, reduced_rows(self.view, tied)))
        return self._tied[tied]

    def solved(self, unknown: Symbol) -> tuple[Candidate, ...]:
        """The equation solved for one acceleration or reaction.

        Nothing where there are too many, or constraints. A body of one freedom needs no solving
        for its acceleration.
        """
        if self.view.scene.constraints or len(self.view.speeds) > LARGEST_SOLVED:
            return ()
        if unknown not in self._solved:
            of_motion = unknown in self.view.accelerations
            make = self._for_acceleration if of_motion else self._for_reaction
            self._solved[unknown] = make(unknown)
        return self._solved[unknown]

    @cached_property
    def _linear(self) -> list[tuple[list[Expr], Expr]]:
        """M and h of M u' + h = 0, row by row."""
        return [collect_linear(row.value, self.view.accelerations) for row in self._rows]

    @cached_property
    def _mass(self) -> Matrix:
        return Matrix([factors for factors, _ in self._linear])

    def _for_acceleration(self, acceleration: Symbol) -> tuple[Candidate, ...]:
        if len(self._rows) == 1:
            return ()
        index = self.view.accelerations.index(acceleration)
        pieces = merged(
            (cofactor, piece)
            for i, row in enumerate(self._rows)
            for cofactor in [self._mass.cofactor(i, index)]
            for piece in row.pieces
        )
        return candidates_of([Row(f"solved for {acceleration.name}", pieces)])

    def _for_reaction(self, reaction: Symbol) -> tuple[Candidate, ...]:
        """A reaction without accelerations: det(M) (R - value), the accelerations put in.

        M u' + h = 0,   R = c u' + d      ->      det(M) (R - d) + c adj(M) h = 0
        """
        table = dict(self.view.derivation.truth.reactions)
        if reaction not in table:
            return ()
        factors, rest = collect_linear(self.view.seen(table[reaction]), self.view.accelerations)
        value = self._mass.det(method="berkowitz") * (reaction - rest)
        for k, factor in enumerate(factors):
            adjugate = (self._mass.cofactor(i, k) * h for i, (_, h) in enumerate(self._linear))
            value += factor * sum(adjugate)
        origin = Origin(Kind.REACTION, "", reaction.name)
        rows = [Row(f"solved for {reaction.name}", (Piece(origin, value),))]
        return tuple(replace(each, known=False) for each in candidates_of(rows))

    def _free(self, row: Row) -> Row:
        """A row with the reactions that its friction depends on written out."""
        truth = self.view.derivation.truth
        pressing = {
            symbol
            for piece in row.pieces
            if piece.origin.kind is Kind.LOAD
            for symbol in piece.value.free_symbols
        }
        if not pressing & {reaction.symbol for reaction in truth.scene.reactions}:
            return row
        table = dict(truth.reactions)
        return Row(row.words, tuple(Piece(p.origin, p.value.xreplace(table)) for p in row.pieces))

    def _seen(self, row: Row) -> Row:
        """A row in the speeds of the view."""
        pieces = (Piece(p.origin, self.view.seen(p.value)) for p in row.pieces)
        return Row(row.words, tuple(pieces))


def _sums(rows: Sequence[Row]) -> Iterator[Row]:
    """Sums and differences of two equations: those of angles counted otherwise."""
    for i, one in enumerate(rows):
        for two in rows[i + 1 :]:
            for sign, word in ((1, "plus"), (-1, "less")):
                weighted = [(1, piece) for piece in one.pieces]
                weighted += [(sign, piece) for piece in two.pieces]
                yield Row(f"{one.words} {word} {two.words}", merged(weighted))


def candidates_of(rows: Iterable[Row]) -> tuple[Candidate, ...]:
    """Rows as terms, but for those of too many."""
    return tuple(each for row in rows if (each := _candidate(row)) is not None)


def _candidate(row: Row) -> Candidate | None:
    try:
        terms = terms_of([piece.value for piece in row.pieces], cleared=True)
    except TooLarge:
        return None
    pairs = zip((piece.origin for piece in row.pieces), terms, strict=True)
    return Candidate(row.words, tuple((origin, part) for origin, part in pairs if part))
