"""Plain text in SymPy's or MATLAB's notation: ``read_text(text, naming) -> lines``.

    (M + m)*x.diff(t, 2) + 2*k*x = 0        Eq(theta'', -g/L*sin(theta))        xdd = -k*x/m;

A whitelist grammar makes a tree; no text is ever evaluated.
"""

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from lark import Token, Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

from mechanics.claims.brackets import pieces
from mechanics.claims.claim import Trees
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.lines import (
    Entry,
    Line,
    Unread,
    gives_an_input,
    gives_constants,
    is_constant,
    value,
)
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused, bounded, bounded_mathematics, refusal
from mechanics.claims.text.assignments import in_sequence
from mechanics.claims.text.components import in_components, with_values
from mechanics.claims.text.declarations import has_columns, operators, without_effect
from mechanics.claims.text.drawn_fractions import without_drawn
from mechanics.claims.text.grammar import PARSER
from mechanics.claims.text.letters import plain
from mechanics.claims.text.markdown import doubtful_dashes
from mechanics.claims.text.nodes import FIRST, OTHERS, Nodes
from mechanics.claims.text.prepare import prepared
from mechanics.claims.text.side_by_side import letters_of, with_products
from mechanics.claims.text.values_in_words import without_values_in_words
from mechanics.claims.tree import Name, ended

BASE = r"(?:[kcm]?m|k?g|m?s|k?N|J|rad|W|Pa|Hz)(?:\^?-?[1-4]|\*\*-?[1-4])?"
VALUE = re.compile(
    rf"(\w+) ?= ?[-+]?\d[\d.]*(?:[eE][-+]?\d+)? \[?{BASE}(?:[ */.]{{0,3}}{BASE}){{0,5}}\]?"
)
"""The value of a parameter with its unit."""
ARRAYS = re.compile(r"\b(?:as)?array\s*\(")
"""Of NumPy, which multiplies entry by entry."""
TAKEN_APART = re.compile(r"\b\w+[ \t]*=[ \t]*S\(\d\)[ \t]*(?:;|[\r\n])")
"""A state that is called S, which is SymPy's for a number elsewhere."""
ENDS = ("end", "endfunction")
TAG = re.compile(r"(?:[%#]|^[ \t]{2,})\s*(\([\w.']{1,12}\))")


def read_text(text: str, naming: Naming, origin: str = "text") -> list[Entry]:
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
    clean = prepared(without_values_in_words(text, naming))
    lost = [
        Unread(text[at:].strip().split("\n")[0], at, at, words)
        for at, words in (*without_effect(text), *doubtful_dashes(text))
    ]
    rest, drawn = without_drawn(text, clean, lambda part, at: _part(part, text, at, naming))
    if drawn and not rest.strip():
        return [*drawn, *lost]
    return [*_entries(rest, text, naming), *drawn, *lost]


def _part(part: str, text: str, start: int, naming: Naming) -> list[Entry]:
    """Lines of a part of a text; none where it cannot be read."""
    try:
        return _lines(part, text, start, naming)
    except Refused:
        return []


def _entries(clean: str, text: str, naming: Naming) -> list[Entry]:
    try:
        lines = in_components(_lines(clean, text, 0, naming), text)
        return with_values(in_sequence(lines, text, naming), text, naming)
    except Refused as reason:
        whole = reason
    # One line that cannot be read does not spoil the others.
    found: list[Entry] = []
    for part, start in _statements(clean):
        source = " ".join(part.split())
        if (given := VALUE.fullmatch(source)) and is_constant(given[1], naming):
            found.append(value(source, start))
            continue
        try:
            found += _lines(part, text, start, naming)
        except Refused as reason:
            found.append(Unread(source, start, reason.at, reason.words))
    if not any(isinstance(line, Line) for line in found):
        return [Unread(" ".join(text.split())[:200], whole.at, whole.at, whole.words)]
    lines = in_sequence(in_components(found, text), text, naming)
    return with_values(lines, text, naming)


def _statements(clean: str) -> Iterator[tuple[str, int]]:
    """Lines, and what semicolons set apart in them outside of brackets; each with its place."""
    for line in re.finditer(r"[^\n]+", clean):
        for start, part in pieces(line[0], ";"):
            if part.strip():
                yield part, line.start() + start


@lru_cache(maxsize=64)
def _tokens(text: str) -> tuple[Token, ...]:
    """A text is read again when a name in it was guessed."""
    return tuple(PARSER.lex(text))


def _tree(clean: str, text: str, naming: Naming) -> Tree:
    parser = PARSER.parse_interactive()

    def constant(name: str) -> bool:
        return naming.is_function(name) is False

    for token in with_products(_tokens(clean), letters_of(naming, text), constant):
        parser.feed_token(token)
    return parser.feed_eof()


@lru_cache(maxsize=64)
def _dialect(text: str) -> tuple[bool, bool, Mapping[str, int], bool]:
    """How brackets and names of a text are read; each of its lines asks for that of all."""
    arrays, state = ARRAYS.search(text) is not None, TAKEN_APART.search(text) is not None
    return arrays, state, operators(text), has_columns(text)


def _lines(clean: str, text: str, offset: int, naming: Naming) -> list[Entry]:
    try:
        tree = _tree(clean, text, naming)
    except UnexpectedInput as error:
        raise _unexpected(error, clean, offset) from None
    how = _dialect(text)
    found: list[Entry] = []
    for statement in tree.children:
        if text[offset + statement.meta.start_pos : offset + statement.meta.end_pos] in ENDS:
            at = offset + statement.meta.start_pos
            words = "the end of a MATLAB function: keep its equations only, one a line"
            found.append(Unread("end", at, at, words))
            continue
        if statement.children[0].data == "unpacked":
            found += _unpacked(statement.children[0], text, offset, naming)
            continue
        notes: list[str] = []
        nodes = Nodes(naming, offset, notes, FIRST, *how)
        sides = nodes.sides(statement)
        others = tuple(_otherwise(statement, naming, offset, how) if nodes.slash else ())
        start, end = offset + statement.meta.start_pos, offset + statement.meta.end_pos
        rest = text[end:].split("\n", 1)[0]
        tag = TAG.search(rest)
        source = " ".join(text[start:end].split())
        line = Line(sides, tag[1] if tag else "", start, source, tuple(notes), others)
        told = VALUE.fullmatch(source)
        given = is_constant(told[1], naming) if told else gives_constants(line, naming)
        given = given or (rest.startswith(";") and gives_an_input(line, naming))
        found.append(value(source, start) if given else line)
    return found


def _otherwise(
    statement: Tree, naming: Naming, offset: int, how: tuple[Any, ...]
) -> Iterator[tuple[str, Trees]]:
    """The sides with more or less below a slash, and in words what stands below it."""
    for below in OTHERS:
        nodes = Nodes(naming, offset, [], below, *how)
        sides = nodes.sides(statement)
        yield f"{nodes.slash}: write the brackets", sides


def _unpacked(tree: Tree, text: str, offset: int, naming: Naming) -> list[Entry]:
    """``a, v = u`` or ``s, c = sincos(x)``: each name an entry; of parameters it says nothing."""
    at, end = offset + int(tree.meta.start_pos), offset + int(tree.meta.end_pos)
    source = " ".join(text[at:end].split())
    parts = [part for part in tree.children if isinstance(part, Token)]
    right = [part for part in tree.children if isinstance(part, Tree)]
    values = Nodes(naming, offset, []).values(right)
    if values is not None and len(values) != len(parts):
        raise Refused(at, f"{len(parts)} names and {len(values)} values")
    array = plain(str(right[0].children[0]))[0] if right[0].data == "name" else ""
    if values is None and not array:
        raise Refused(at, "what the names are given is no array by name: write one a line")
    if values is None and all(is_constant(plain(part)[0], naming) for part in parts):
        return [value(source, at)]
    found: list[Entry] = []
    for i, part in enumerate(parts):
        start = offset + int(part.start_pos or 0)
        name, given = Name(start, *plain(part)), values[i] if values is not None else None
        entry = (
            given if given is not None else Name(int(right[0].meta.start_pos), f"{array}[{i + 1}]")
        )
        ended(name, offset + int(part.end_pos or 0))
        found.append(Line((name, entry), "", at, source))
    return found


def _unexpected(error: UnexpectedInput, text: str, offset: int) -> Refused:
    if isinstance(error, UnexpectedCharacters):
        at, found = error.pos_in_stream, text[error.pos_in_stream : error.pos_in_stream + 1]
        return Refused(offset + at, f"{found!r} cannot be read{_advice(text, at, found)}")
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        at, found = error.token.start_pos or 0, str(error.token)[:20]
        word = "the end of a line" if error.token.type == "_END" else repr(found)
        return Refused(offset + at, f"{word} cannot be read{_advice(text, at, found)}")
    return Refused(offset + len(text.rstrip()), "something is missing at the end")


def _advice(text: str, at: int, found: str) -> str:
    """What to write instead where two operands stand side by side."""
    before = text[max(0, text.rfind("\n", 0, at) + 1) : at].rstrip()[-60:]
    if re.match(r"\s*function\b", before):
        return ": a MATLAB function: keep its equations only, one a line, without function and end"
    last = re.search(r"[\w'\u0307\u0308]+$|[)\]]$", before)
    if last is None or not re.match(r"[\w(]", found):
        return ""
    if last[0] in FUNCTIONS:
        return f": write {last[0]}({found})"
    return ": write * between factors"
