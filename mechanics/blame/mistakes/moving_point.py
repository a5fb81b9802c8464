"""The moment about a moving point with a term of it forgotten.

    sum tau_B = dH_B/dt + v_B x P        without v_B x P
    sum tau_B = sum (dH_C/dt + BC x m a_C),  a_C = a_B + ...        without BC x m a_B

One equation is wrong, not the whole derivation: what is compared is that equation itself.
"""

from collections.abc import Iterator, Sequence

from mechanics.blame.pieces import Kind, Origin, Piece
from mechanics.blame.rows import Moment, Row


def wrong_rows(moments: Sequence[Moment]) -> Iterator[Row]:
    """Each moment equation about a point that moves, with each term forgotten in turn."""
    for moment in moments:
        about, pieces = moment.about, moment.row.pieces
        if not about:
            continue
        moved = tuple(piece for piece in pieces if piece.origin.kind is not Kind.MOVING)
        yield Row(f"v_B x P is missing in the moment about B = {about}", moved)
        carried = Piece(Origin(Kind.MOVING, ""), -moment.carried)
        words = f"BC x m a_B is missing in the moment about B = {about}, which accelerates"
        yield Row(words, (*pieces, carried))
