r"""``\frac{\partial L}{\partial \dot x}``, and ``\frac{\partial}{\partial x}`` before a term."""

from lark import Token, Tree

from mechanics.claims.latex.item import pieces_of
from mechanics.claims.latex.pieces import Pieces


def partial(above: Tree, below: Tree) -> tuple[Pieces, Pieces] | None:
    r"""What stands behind each ``\partial``; None for any other fraction."""
    up, down = pieces_of(above), pieces_of(below)
    return (up[1:], down[1:]) if _marked(up) and _marked(down) else None


def _marked(pieces: Pieces) -> bool:
    if not pieces or not isinstance(pieces[0], Tree):
        return False
    (first, *scripts) = pieces[0].children
    return isinstance(first, Token) and first.value.strip() == r"\partial" and not scripts
