"""Terms with products of speeds left out of the rates of momentum.

m a = m (J u' + J' u)        without J' u:  no Coriolis and centrifugal terms
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache

from sympy import Add, Expr, Rational, Symbol

from mechanics.blame.mistakes.slip import Change, Right, Slip
from mechanics.blame.pieces import Kind, Piece

RATES = (Kind.LINEAR, Kind.ANGULAR)


def slips(right: Right) -> Iterator[Slip]:
    """All such terms, those with two different speeds, and those with the square of one."""
    speeds = tuple(dict.fromkeys((*right.scene.u, *right.scene.qd)))
    for words, squares, mixed in (
        ("Coriolis and centrifugal terms are missing", True, True),
        ("Coriolis terms (products of two speeds) are missing", False, True),
        ("centrifugal terms (squares of speeds) are missing", True, False),
    ):
        if len(speeds) > 1 or (squares and mixed):
            yield from right.slip(words, _without(speeds, squares, mixed))


def _without(speeds: tuple[Symbol, ...], squares: bool, mixed: bool) -> Change:
    def change(piece: Piece) -> Sequence[Piece]:
        if piece.origin.kind not in RATES or not piece.value.free_symbols & set(speeds):
            return (piece,)
        left = _products(piece.value, speeds, squares, mixed)
        return (piece,) if left == 0 else (piece, Piece(piece.origin, -left))

    return change


@lru_cache(maxsize=512)
def _products(value: Expr, speeds: tuple[Symbol, ...], squares: bool, mixed: bool) -> Expr:
    """The part of an expression that is of second order in the speeds."""
    still = dict.fromkeys(speeds, 0)
    half, found = Rational(1, 2), []
    for i, one in enumerate(speeds):
        slope = value.diff(one)
        for j, two in enumerate(speeds[i:]):
            wanted = squares if j == 0 else mixed
            if wanted:
                factor = slope.diff(two).xreplace(still)
                found.append((half if j == 0 else 1) * factor * one * two)
    return Add(*found)
