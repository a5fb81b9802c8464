r"""LaTeX as people write it: ``read_latex(text, naming) -> lines``.

    \begin{equation*} (M+m) \ddot{x} + 2 k x + ... = 0 \tag{6} \end{equation*}

A text that displays its equations ($$, \[, equation, align) is a document: what is displayed is
read, or what stands between single $ where nothing is; the prose between is not. A line that begins
with = or with a sign goes on from the one before.
"""

import re
from collections.abc import Iterator
from functools import lru_cache

from lark import Token, Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedEOF, UnexpectedInput, UnexpectedToken

from mechanics.reading.latex.fold import Fold
from mechanics.reading.latex.grammar import PARSER
from mechanics.reading.latex.items import Items
from mechanics.reading.lines import Line, Unread
from mechanics.reading.names import Naming
from mechanics.reading.place import Refused, bounded, bounded_mathematics, located, refusal
from mechanics.reading.tree import move

Pieces = list[Tree | Token]

OPENS = re.compile(
    r"\$\$|(?<!\\)\\\[|\\begin\s*\{"
    r"(?P<env>(?:equation|align|gather|multline|eqnarray|flalign|displaymath)\*?)\}"
)
INLINE = re.compile(r"(?<![\\$])\$([^$]+)\$")
TAG = re.compile(r"\{\s*(.*?)\s*\}", re.DOTALL)


def read_latex(text: str, naming: Naming, origin: str = "LaTeX") -> list[Line | Unread]:
    """Lines of a text in LaTeX, in order.

    Parameters
    ----------
    text : str
    naming : Naming
        Settles what can be read in two ways: whether f(t) is a product, ML one name.
    origin : str
        What messages call the text.

    Raises
    ------
    InputError
        When the text is too long.
    """
    bounded(text, origin)
    found: list[Line | Unread] = []
    spans, prose = _blocks(text)
    try:
        bounded_mathematics(sum(end - start for start, end in spans), 0)
    except Refused as reason:
        raise refusal(text, reason, origin) from None
    for start, end in spans:
        try:
            lines = _block(text[start:end], start, naming)
            # What prose mentions in passing is no claim.
            found += [line for line in lines if not prose or _claims(line)]
        except Refused as reason:
            words = located(text, reason.at, reason.words, origin)
            source = " ".join(text[start:end].split())
            found.append(Unread(source, words, start, _tag_of(source)))
    return found


def _claims(line: Line | Unread) -> bool:
    return isinstance(line, Line) and len(line.sides) > 1


def _blocks(text: str) -> tuple[list[tuple[int, int]], bool]:
    """What is displayed in a document, and whether it is part of its prose."""
    spans = _displays(text)
    prose = [match.span(1) for match in INLINE.finditer(text)] if not spans else []
    whole = sum(end - start + 2 for start, end in prose) >= len(text.strip())
    kept = spans or prose or [(0, len(text))]
    return [(a, b) for a, b in kept if text[a:b].strip()], bool(prose) and not whole


def _displays(text: str) -> list[tuple[int, int]]:
    """What stands between the beginning and the end of a display.

    What ends a display is looked for once where it is missing: its time is linear in the text.
    """
    spans: list[tuple[int, int]] = []
    missing: set[str] = set()
    at = 0
    while opens := OPENS.search(text, at):
        at = opens.end()
        ends = _ends(opens)
        if ends in missing:
            continue
        closes = re.compile(ends).search(text, at)
        if closes is None:
            missing.add(ends)
            continue
        spans.append((at, closes.start()))
        at = closes.end()
    return spans


def _ends(opens: re.Match[str]) -> str:
    if opens["env"]:
        return rf"\\end\s*\{{{re.escape(opens['env'])}\}}"
    return r"\$\$" if opens[0] == "$$" else r"(?<!\\)\\\]"


@lru_cache(maxsize=64)
def _tree(text: str) -> Tree:
    """A text is read again when a name in it was guessed."""
    return PARSER.parse(text)


def _block(text: str, offset: int, naming: Naming) -> list[Line | Unread]:
    try:
        tree = _tree(text)
    except UnexpectedInput as error:
        raise _unexpected(error, text, offset) from None
    found: list[Line | Unread] = []
    for pieces in _joined(tree):
        try:
            line = _line(pieces, text, offset, naming)
        except Refused as reason:
            raise Refused(offset + reason.at, reason.words) from None
        if line is not None:
            found.append(line)
    return found


def _unexpected(error: UnexpectedInput, text: str, offset: int) -> Refused:
    if isinstance(error, UnexpectedCharacters):
        at = error.pos_in_stream
        return Refused(offset + at, f"{text[at : at + 12].split(chr(10))[0]!r} cannot be read here")
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        at = error.token.start_pos or 0
        return Refused(offset + at, f"{str(error.token)[:20]!r} cannot be read here")
    if isinstance(error, UnexpectedEOF | UnexpectedToken):
        return Refused(offset + len(text.rstrip()), "a bracket or argument is not closed")
    raise error


def _joined(tree: Tree) -> Iterator[Pieces]:
    """Pieces of every equation; lines that go on from the one before belong to it."""
    current: Pieces = []
    broken = True
    for child in tree.children:
        if isinstance(child, Token):
            broken = broken or not child.value.startswith("\\\\")
            continue
        for part in _parts(child.children):
            if not part:
                continue
            first = part[0]
            on = isinstance(first, Token) and (
                first.type == "REL" or (first.type == "SIGN" and not _related(part))
            )
            open_end = (
                bool(current)
                and isinstance(current[-1], Token)
                and current[-1].type in ("REL", "SIGN", "TIMES", "SLASH")
            )
            if current and ((on and not broken) or open_end or _is_rel(first)):
                current += part
            else:
                if current:
                    yield current
                current = part
            broken = False
    if current:
        yield current


def _is_rel(piece: Tree | Token) -> bool:
    return isinstance(piece, Token) and piece.type == "REL"


def _related(part: Pieces) -> bool:
    return any(_is_rel(piece) for piece in part)


def _parts(pieces: Pieces) -> Iterator[Pieces]:
    """A comma or full stop at the outermost level ends an equation."""
    part: Pieces = []
    for piece in pieces:
        if isinstance(piece, Token) and piece.type in ("COMMA", "DOT"):
            yield part
            part = []
        elif not (isinstance(piece, Token) and piece.type == "AMP"):
            part.append(piece)
    yield part


def _line(pieces: Pieces, text: str, offset: int, naming: Naming) -> Line | None:
    tag, kept = "", []
    for piece in pieces:
        if isinstance(piece, Token) and piece.type == "TAG":
            tag = _tag_of(piece.value)
        else:
            kept.append(piece)
    if not kept:
        return None
    notes: list[str] = []
    fold = Fold(naming, notes)
    items = Items(text, naming, fold, notes)
    sides: list[Pieces] = [[]]
    for piece in kept:
        if _is_rel(piece):
            sides.append([])
        else:
            sides[-1].append(piece)
    start, end = _span(kept)
    nodes = tuple(fold(items.of(side), _span(side)[0] if side else end) for side in sides)
    for node in nodes:
        move(node, offset)
    source = " ".join(text[start:end].split())
    return Line(nodes, tag, offset + start, source, tuple(dict.fromkeys(notes)))


def _span(pieces: Pieces) -> tuple[int, int]:
    first, last = pieces[0], pieces[-1]
    start = first.start_pos if isinstance(first, Token) else first.meta.start_pos
    end = last.end_pos if isinstance(last, Token) else last.meta.end_pos
    return int(start or 0), int(end or 0)


def _tag_of(text: str) -> str:
    position = text.find("\\tag")
    match = TAG.search(text, max(position, 0)) if position >= 0 or "eqno" in text else None
    return f"({match[1].strip('()')})" if match else ""
