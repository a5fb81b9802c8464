"""Pieces of a row: tokens, and trees of what has brackets, arguments or scripts."""

from collections.abc import Iterator

from lark import Token, Tree

Pieces = list[Tree | Token]

OPERATORS = ("SIGN", "TIMES", "SLASH")


def is_kind(piece: Tree | Token, *kinds: str) -> bool:
    """Whether a piece is a token of one of some kinds."""
    return isinstance(piece, Token) and piece.type in kinds


def is_gap(piece: Tree | Token) -> bool:
    """Whether a piece is a wide space or the end of a column."""
    return piece.data == "gap" if isinstance(piece, Tree) else piece.type == "AMP"


def opened(pieces: Pieces) -> Iterator[Tree | Token]:
    r"""The pieces, and those of an equation that stands in braces: ``{\displaystyle a = b}``."""
    for piece in pieces:
        inner = inside(piece, "braces")
        if inner is not None and related(inner):
            yield from opened(inner)
        else:
            yield piece


def inside(piece: Tree | Token, kind: str) -> Pieces | None:
    """What stands in a bracket of a kind without scripts."""
    if not isinstance(piece, Tree) or piece.data != "scripted" or len(piece.children) != 1:
        return None
    base = piece.children[0]
    if not isinstance(base, Tree) or base.data != kind:
        return None
    return next((list(c.children) for c in base.children if isinstance(c, Tree)), [])


def related(pieces: Pieces) -> bool:
    """Whether there is a relation among pieces."""
    return any(is_kind(piece, "REL") for piece in pieces)


def text_of(piece: Tree, text: str) -> str:
    """What a piece was read from."""
    return "" if piece.meta.empty else text[piece.meta.start_pos : piece.meta.end_pos]
