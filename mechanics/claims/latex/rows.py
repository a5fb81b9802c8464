r"""Rows of a display as equations: what goes on over lines, and what stands side by side.

    a + b \\ &\quad + c = d    ->    a + b + c = d        a = b \quad (6)    ->    a = b, its number
    a &= b & c &= d            ->    a = b    c = d       a = b \quad c = d  ->    a = b    c = d

Where a row can be read in two ways it is in doubt, and never judged.
"""

import re
from collections.abc import Iterator
from dataclasses import replace

from lark import Token, Tree

from mechanics.claims.latex.beside import Row, parts
from mechanics.claims.latex.pieces import OPERATORS, Pieces, is_kind, related

LABEL = re.compile(r"\\(?:q?quad\s*\\)?(?:text|mbox|intertext)")
JOINS = re.compile(r"\{[\s,;.]*(and|or|where|with|so|then|hence|for|if|when|since|thus|from)\b")
WRAPPED = (
    "a line that begins with a factor: write \\cdot before it, or \\\\ if it begins an equation"
)
UNRELATED = (
    "a line without an equals sign: where an equation goes on, begin its next line with + - ="
)


def rows(tree: Tree, text: str, one: bool) -> Iterator[Row]:
    """The equations of a block.

    Parameters
    ----------
    tree : Tree
    text : str
        In which its places count.
    one : bool
        Whether all lines are one equation, as in multline.
    """
    joined: list[Row] = []
    for row in _all(tree, text):
        if joined and _goes_on(joined[-1], row, one):
            before = joined[-1]
            doubt = before.doubt or row.doubt
            joined[-1] = replace(before, pieces=before.pieces + row.pieces, doubt=doubt)
        else:
            joined.append(row)
    yield from _related_or_in_doubt(joined)


def _all(tree: Tree, text: str) -> Iterator[Row]:
    """What stands between the ends of lines, commas and wide spaces."""
    begins = "new"
    for child in tree.children:
        if isinstance(child, Token):
            label = LABEL.match(child.value) is not None and not JOINS.search(child.value)
            if not (label or child.value.startswith("\\\\")):
                begins = "new"
            elif begins != "new":
                begins = "label" if label else "line"
            continue
        for written, doubt in _written_lines(child.children):
            for row in parts(written, text):
                yield replace(row, begins=begins, doubt=row.doubt or doubt)
                begins = "beside"
            begins = "line" if begins == "beside" else begins


def _written_lines(pieces: Pieces) -> Iterator[tuple[Pieces, str]]:
    """Lines of a text that displays nothing: each with a relation of its own is an equation.

    A line without one, that begins with a factor, may go on or begin another: that is a doubt.
    """
    before: Pieces = []
    doubt, complete, blank = "", False, False
    for line in _cut(pieces):
        if not line:
            blank = True
            continue
        goes_on = is_kind(line[0], "REL", "TIMES", "SLASH") or (
            bool(before) and is_kind(before[-1], "REL", *OPERATORS)
        )
        relation = related(line)
        if complete and not goes_on:
            if (relation or blank) and (blank or line[0] != "+"):
                yield before, doubt
                before, doubt, complete = [], "", False
            elif not is_kind(line[0], "SIGN", "TAG"):
                doubt = doubt or WRAPPED
        before += line
        complete, blank = complete or relation, False
    yield before, doubt


def _cut(pieces: Pieces) -> Iterator[Pieces]:
    line: Pieces = []
    for piece in pieces:
        if isinstance(piece, Tree) and piece.data == "end":
            yield line
            line = []
        else:
            line.append(piece)
    yield line


def _goes_on(before: Row, row: Row, one: bool) -> bool:
    """Whether a row belongs to the one before it."""
    first, last = row.pieces[0], before.pieces[-1]
    if all(is_kind(piece, "TAG") for piece in row.pieces):
        return True
    if row.apart:
        return False
    if is_kind(first, "REL") or is_kind(last, "REL", *OPERATORS):
        return True
    if row.begins == "new":
        return False
    if not is_kind(first, *OPERATORS):
        return one and not (related(before.pieces) and related(row.pieces))
    # A label between the terms of an equation does not end it.
    whole = related(row.pieces) and (row.begins != "label" or related(before.pieces))
    unfinished = row.begins == "line" and not related(before.pieces)
    return not whole or unfinished or not is_kind(first, "SIGN")


def _related_or_in_doubt(found: list[Row]) -> Iterator[Row]:
    """The rows; one that may be half an equation is in doubt with its other half."""
    held: Row | None = None
    for row in found:
        if held is not None and row.begins == "line" and _half(held) != _half(row):
            held = replace(held, pieces=held.pieces + row.pieces, doubt=UNRELATED)
            continue
        if held is not None:
            yield held
        held = row
    if held is not None:
        yield held


def _half(row: Row) -> bool:
    """Whether a row of more than a name or matrix has no relation."""
    pieces = [piece for piece in row.pieces if not is_kind(piece, "TAG")]
    return len(pieces) > 1 and not any(is_kind(piece, "REL", "ORDER") for piece in pieces)
