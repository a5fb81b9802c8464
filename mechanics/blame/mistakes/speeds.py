"""Terms with products of speeds left out of the rates of momentum.

m a = m (J u' + J' u)        without J' u:  no Coriolis and centrifugal terms
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache

from sympy import Expr, S, Symbol

from mechanics.blame.mistakes.fault_model import Change, Fault, Part, Right
from mechanics.blame.pieces import Kind, Piece
from mechanics.blame.terms import Terms, terms_of, written

RATES = (Kind.LINEAR, Kind.ANGULAR)


def faults(right: Right) -> Iterator[Fault]:
    """Products of two speeds, squares of one, and both where there are both."""
    speeds = tuple(dict.fromkeys((*right.scene.u, *right.scene.qd)))
    mixed = list(right.fault("Coriolis terms are missing", _without(speeds, False, True)))
    squares = list(right.fault("centrifugal terms are missing", _without(speeds, True, False)))
    yield from (*mixed, *squares)
    if mixed and squares:
        words = "Coriolis and centrifugal terms are missing"
        yield from right.fault(words, _without(speeds, True, True))


def _without(speeds: tuple[Symbol, ...], squares: bool, mixed: bool) -> Change:
    def change(piece: Piece) -> Sequence[Part]:
        own = ((S.One, piece),)
        if piece.origin.kind not in RATES or not piece.value.free_symbols & set(speeds):
            return own
        left = _products(piece.value, speeds, squares, mixed)
        return own if left == 0 else (*own, (-S.One, Piece(piece.origin, left)))

    return change


@lru_cache(maxsize=512)
def _products(value: Expr, speeds: tuple[Symbol, ...], squares: bool, mixed: bool) -> Expr:
    """The terms of an expression that are of second order in the speeds."""
    (terms,) = terms_of([value])
    found = Terms()
    for monomial, factor in terms.items():
        held = [power for atom, power in monomial if atom in speeds]
        if (mixed and len(held) > 1) or (squares and held == [2]):
            found[monomial] = factor
    return written(found)
