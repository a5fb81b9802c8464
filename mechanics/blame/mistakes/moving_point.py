"""The moment about a moving point with a term of it forgotten.

    sum tau_B = dH_B/dt + v_B x P        without v_B x P
    sum tau_B = sum (dH_C/dt + BC x m a_C),  a_C = a_B + ...        without BC x m a_B

One equation is wrong, not the whole derivation: what is compared is that equation itself.
"""

from collections.abc import Iterator, Sequence

from mechanics.blame.nearest import Candidate
from mechanics.blame.pieces import Kind, Origin, Piece
from mechanics.blame.rows import Moment
from mechanics.blame.terms import terms_of
from mechanics.kernel.ring import TooLarge


def wrong_rows(moments: Sequence[Moment]) -> tuple[Candidate, ...]:
    """Each moment equation about a point that moves, with each term forgotten in turn."""
    candidates: list[Candidate] = []
    for moment in moments:
        about = moment.about
        if not about:
            continue
        moved = tuple(piece for piece in moment.row.pieces if piece.origin.kind is not Kind.MOVING)
        candidates += _candidate(f"v_B x P is missing in the moment about B = {about}", moved)
        carried = Piece(Origin(Kind.MOVING, ""), -moment.carried)
        words = f"BC x m a_B is missing in the moment about B = {about}, which accelerates"
        candidates += _candidate(words, (*moment.row.pieces, carried))
    return tuple(candidates)


def _candidate(words: str, pieces: tuple[Piece, ...]) -> Iterator[Candidate]:
    try:
        terms = terms_of([piece.value for piece in pieces], cleared=True)
    except TooLarge:
        return
    origins = (piece.origin for piece in pieces)
    yield Candidate(words, tuple(zip(origins, terms, strict=True)))
