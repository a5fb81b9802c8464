"""Right equations that a person may have meant, as terms, each piece by piece.

adj(M) (M u' - f) = det(M) u' - adj(M) f        where one acceleration stands alone
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache

from sympy import Matrix, Symbol

from mechanics.blame.nearest import Candidate
from mechanics.blame.pieces import Kind, Origin, Piece, merged
from mechanics.blame.reduced import reduced_rows, tied_speeds, view_rows
from mechanics.blame.rows import Row, free_rows, moving_rows
from mechanics.blame.terms import terms_of
from mechanics.blame.view import View
from mechanics.equations import Equations
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic import collect_linear

LARGEST_SOLVED = 3
"""Number of speeds up to which equations are solved for an acceleration, by Cramer's rule."""

LARGEST_SUMMED = 4
"""Number of speeds up to which sums and differences of two equations are looked at."""


def implicit(view: View) -> Iterator[Candidate]:
    """Equations of the routes, in several accelerations and without eliminated reactions."""
    for make in (_of_speeds, _of_parts, _of_sums):
        yield from make(view)


@lru_cache(maxsize=16)
def _of_speeds(view: View) -> tuple[Candidate, ...]:
    return _candidates(_free(row, view.truth) for row in view_rows(view))


@lru_cache(maxsize=16)
def _of_parts(view: View) -> tuple[Candidate, ...]:
    rows = (_seen(moment.row, view) for moment in moving_rows(view.truth))
    return _candidates(_free(row, view.truth) for row in rows)


@lru_cache(maxsize=16)
def _of_sums(view: View) -> tuple[Candidate, ...]:
    if len(view.speeds) > LARGEST_SUMMED:
        return ()
    return _candidates(_free(row, view.truth) for row in _sums(view_rows(view)))


def constrained(view: View, wanted: frozenset[Symbol]) -> tuple[Candidate, ...]:
    """Equations with the constraints put in; none in a scene without constraints."""
    tied = tied_speeds(view, wanted) if view.scene.constraints else None
    return () if tied is None else _with_constraints(view, tied)


@lru_cache(maxsize=32)
def _with_constraints(view: View, tied: tuple[int, ...]) -> tuple[Candidate, ...]:
    return _candidates(_free(row, view.truth) for row in reduced_rows(view, tied))


@lru_cache(maxsize=16)
def with_reactions(view: View) -> tuple[Candidate, ...]:
    """Free-body equations, where reactions stand as symbols."""
    return _candidates(_seen(row, view) for row in free_rows(view.scene))


@lru_cache(maxsize=64)
def solved(view: View, acceleration: Symbol) -> tuple[Candidate, ...]:
    """The equation solved for one acceleration; nothing where there are too many, or constraints.

    A body of one freedom needs no solving.
    """
    size = len(view.speeds)
    if view.scene.constraints or not 1 < size <= LARGEST_SOLVED:
        return ()
    rows = [_free(row, view.truth) for row in view_rows(view)]
    mass = Matrix([collect_linear(row.value, view.accelerations)[0] for row in rows])
    index = view.accelerations.index(acceleration)
    cofactors = [mass.cofactor(i, index) for i in range(size)]
    pieces = merged((cofactors[i], piece) for i, row in enumerate(rows) for piece in row.pieces)
    return _candidates([Row(f"solved for {acceleration.name}", pieces)])


@lru_cache(maxsize=64)
def solved_reaction(view: View, reaction: Symbol) -> tuple[Candidate, ...]:
    """A reaction without accelerations: det(M) (R - value), the accelerations put in.

    M u' + h = 0,   R = c u' + d      ->      det(M) (R - d) + c adj(M) h = 0
    """
    size, table = len(view.speeds), dict(view.truth.reactions)
    if view.scene.constraints or size > LARGEST_SOLVED or reaction not in table:
        return ()
    rows = [_free(row, view.truth).value for row in view_rows(view)]
    split = [collect_linear(row, view.accelerations) for row in rows]
    mass = Matrix([factors for factors, _ in split])
    factors, rest = collect_linear(view.seen(table[reaction]), view.accelerations)
    value = mass.det(method="berkowitz") * (reaction - rest)
    for k, factor in enumerate(factors):
        value += factor * sum(mass.cofactor(i, k) * h for i, (_, h) in enumerate(split))
    origin = Origin(Kind.REACTION, "", reaction.name)
    found = _candidates([Row(f"solved for {reaction.name}", (Piece(origin, value),))])
    return tuple(replace(each, known=False) for each in found)


def _sums(rows: tuple[Row, ...]) -> Iterator[Row]:
    """Sums and differences of two equations: those of angles counted otherwise."""
    for i, one in enumerate(rows):
        for two in rows[i + 1 :]:
            for sign, word in ((1, "plus"), (-1, "less")):
                weighted = [(1, piece) for piece in one.pieces]
                weighted += [(sign, piece) for piece in two.pieces]
                yield Row(f"{one.words} {word} {two.words}", merged(weighted))


def _free(row: Row, truth: Equations) -> Row:
    """A row with the reactions that its friction depends on written out."""
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


def _seen(row: Row, view: View) -> Row:
    """A row in the speeds of a view."""
    return Row(row.words, tuple(Piece(p.origin, view.seen(p.value)) for p in row.pieces))


def _candidates(rows: Iterable[Row]) -> tuple[Candidate, ...]:
    return tuple(found for row in rows if (found := _candidate(row)) is not None)


def _candidate(row: Row) -> Candidate | None:
    try:
        terms = terms_of([piece.value for piece in row.pieces], cleared=True)
    except TooLarge:
        return None
    pairs = zip((piece.origin for piece in row.pieces), terms, strict=True)
    return Candidate(row.words, tuple((origin, part) for origin, part in pairs if part))
