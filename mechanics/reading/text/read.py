"""Plain text in SymPy's or MATLAB's notation: ``read_text(text, naming) -> lines``.

    (M + m)*x.diff(t, 2) + 2*k*x = 0        Eq(theta'', -g/L*sin(theta))        xdd = -k*x/m;

A whitelist grammar makes a tree; no text is ever evaluated.
"""

import re
from functools import lru_cache

from lark import Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

from mechanics.reading.lines import Line, Unread
from mechanics.reading.names import Naming
from mechanics.reading.place import Refused, bounded, bounded_mathematics, located, refusal
from mechanics.reading.text.grammar import PARSER
from mechanics.reading.text.nodes import Nodes
from mechanics.reading.text.prepare import prepared

TAG = re.compile(r"[%#]\s*(\([\w.']{1,12}\))")


def read_text(text: str, naming: Naming, origin: str = "text") -> list[Line | Unread]:
    """Lines of a plain text, in order.

    Parameters
    ----------
    text : str
    naming : Naming
        Settles whether ``M(x + 1)`` is a product.
    origin : str
        What messages call the text.

    Raises
    ------
    InputError
        When the text is too long.
    """
    bounded(text, origin)
    try:
        bounded_mathematics(len(text), 0)
    except Refused as reason:
        raise refusal(text, reason, origin) from None
    clean = prepared(text)
    try:
        return _lines(clean, text, 0, naming)
    except Refused as reason:
        whole = reason
    # One line that cannot be read does not spoil the others.
    found: list[Line | Unread] = []
    for match in re.finditer(r"[^\n]+", clean):
        if not match[0].strip():
            continue
        try:
            found += _lines(match[0], text, match.start(), naming)
        except Refused as reason:
            words = located(text, reason.at, reason.words, origin)
            found.append(Unread(" ".join(match[0].split()), words, match.start()))
    if not any(isinstance(line, Line) for line in found):
        words = located(text, whole.at, whole.words, origin)
        return [Unread(" ".join(text.split())[:200], words, whole.at)]
    return found


@lru_cache(maxsize=64)
def _tree(text: str) -> Tree:
    """A text is read again when a name in it was guessed."""
    return PARSER.parse(text)


def _lines(clean: str, text: str, offset: int, naming: Naming) -> list[Line | Unread]:
    try:
        tree = _tree(clean)
    except UnexpectedInput as error:
        raise _unexpected(error, clean, offset) from None
    found: list[Line | Unread] = []
    for statement in tree.children:
        notes: list[str] = []
        sides = Nodes(naming, offset, notes).sides(statement)
        start, end = offset + statement.meta.start_pos, offset + statement.meta.end_pos
        rest = text[end:].split("\n", 1)[0]
        tag = TAG.search(rest)
        found.append(
            Line(
                sides, tag[1] if tag else "", start, " ".join(text[start:end].split()), tuple(notes)
            )
        )
    return found


def _unexpected(error: UnexpectedInput, text: str, offset: int) -> Refused:
    if isinstance(error, UnexpectedCharacters):
        at = error.pos_in_stream
        return Refused(offset + at, f"{text[at : at + 1]!r} cannot be read here")
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        word = "the end of a line" if error.token.type == "_END" else repr(str(error.token)[:20])
        return Refused(offset + (error.token.start_pos or 0), f"{word} cannot be read here")
    return Refused(offset + len(text.rstrip()), "something is missing at the end")
