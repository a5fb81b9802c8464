"""The moment about a moving point with a term of it forgotten.

    sum tau_B = dH_B/dt + v_B x P        without v_B x P
    sum tau_B = sum (dH_C/dt + BC x m a_C),  a_C = a_B + ...        without BC x m a_B

One equation is wrong, not the whole derivation: what is compared is that equation itself.
"""

from collections.abc import Iterator
from functools import lru_cache

from sympy import Add, Expr, Matrix

from mechanics.blame.nearest import Candidate
from mechanics.blame.pieces import Kind, Origin, Piece
from mechanics.blame.rows import moving_rows
from mechanics.blame.terms import terms_of
from mechanics.equations import Equations
from mechanics.kernel.ring import TooLarge
from mechanics.routes.balance import Balance, triple


@lru_cache(maxsize=16)
def wrong_rows(truth: Equations) -> tuple[Candidate, ...]:
    """Each moment equation about a point that moves, with each term forgotten in turn."""
    found: list[Candidate] = []
    for balance, row in moving_rows(truth):
        about = balance.principle.point.name
        if balance.principle.axis == Matrix([0, 0, 0]):
            continue
        moved = tuple(piece for piece in row.pieces if piece.origin.kind is not Kind.MOVING)
        found += _candidate(f"v_B x P is missing in the moment about B = {about}", moved)
        carried = Piece(Origin(Kind.MOVING, ""), -_carried(balance))
        words = f"BC x m a_B is missing in the moment about B = {about}, which accelerates"
        found += _candidate(words, (*row.pieces, carried))
    return tuple(found)


def _carried(balance: Balance) -> Expr:
    """Sum of BC x m a_B along the axis."""
    axis, centre = balance.principle.axis, balance.centre
    return Add(
        *(
            part.motion.body.mass
            * triple(axis, part.motion.centre.position - centre.position, centre.acceleration)
            for part in balance.parts
        )
    )


def _candidate(words: str, pieces: tuple[Piece, ...]) -> Iterator[Candidate]:
    try:
        terms = terms_of([piece.value for piece in pieces], cleared=True)
    except TooLarge:
        return
    origins = (piece.origin for piece in pieces)
    yield Candidate(words, tuple(zip(origins, terms, strict=True)))
