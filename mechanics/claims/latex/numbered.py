r"""Names with a number behind a letter, as programs spell them: ``k x1^2`` for k x_1^2.

They are read where the scene has x1, and no x that could be multiplied by a number behind it.
"""

from lark import Token, Tree
from lark.tree import Meta

from mechanics.claims.latex.item import letter_of
from mechanics.claims.names import Naming


def numbered(pieces: list[Tree | Token], naming: Naming) -> list[Tree | Token]:
    """Pieces side by side; a letter with a number directly behind it is one name."""
    found: list[Tree | Token] = []
    for piece in pieces:
        word, number = _alone(found[-1]) if found else None, _first(piece)
        if word is None or number is None or word.end_pos != number.start_pos:
            found.append(piece)
            continue
        spelled = word.type == "WORD"
        letter = word.value[-1] if spelled else letter_of(word.value[1:])
        if naming.knows(letter) or not naming.knows(f"{letter}_{number.value}"):
            found.append(piece)
            continue
        found.pop()
        at = int(word.end_pos or 1) - 1 if spelled else int(word.start_pos or 0)
        if spelled and len(word.value) > 1:
            rest = Token(word.type, word.value[:-1], start_pos=word.start_pos, end_pos=at)
            found.append(Tree("scripted", [rest], _place(rest)))
        last = letter if spelled else word.value
        base = Token(word.type, last, start_pos=at, end_pos=word.end_pos)
        index = Token("SUB", f"_{number.value}", start_pos=word.end_pos, end_pos=number.end_pos)
        assert isinstance(piece, Tree)
        whole = Token(word.type, letter, start_pos=at, end_pos=int(piece.meta.end_pos))
        found.append(Tree("scripted", [base, index, *piece.children[1:]], _place(whole)))
    return found


def _place(token: Token) -> Meta:
    """The place of a token, as that of a tree."""
    meta = Meta()
    meta.empty = False
    meta.start_pos, meta.end_pos = token.start_pos, token.end_pos
    return meta


def _alone(piece: Tree | Token) -> Token | None:
    """The letters of a piece that are nothing else."""
    if not isinstance(piece, Tree) or piece.data != "scripted" or len(piece.children) != 1:
        return None
    word = piece.children[0]
    return word if isinstance(word, Token) and word.type in ("WORD", "COMMAND") else None


def _first(piece: Tree | Token) -> Token | None:
    """The whole number that a piece begins with."""
    if not isinstance(piece, Tree) or piece.data != "scripted":
        return None
    number = piece.children[0]
    plain = isinstance(number, Token) and number.type == "NUMBER" and number.value.isdigit()
    return number if plain and isinstance(number, Token) else None
