r"""Rows of a display as equations: what goes on over lines, and what stands side by side.

    a + b \\ &\quad + c = d    ->    a + b + c = d        a = b \quad (6)    ->    a = b, its number
    a &= b & c &= d            ->    a = b    c = d       a = b \quad c = d  ->    a = b    c = d

Where a row can be read in two ways it is in doubt, and never judged.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from lark import Token, Tree

Pieces = list[Tree | Token]

LABEL = re.compile(r"\\(?:q?quad\s*\\)?(?:text|mbox|intertext)")
JOINS = re.compile(r"\{[\s,;.]*(and|or|where|with|so|then|hence|for|if|when|since|thus|from)\b")
NUMBER = re.compile(r"\(\s*(?:[A-Z]\.?)?\d{1,3}(?:\.\d{1,3}){0,2}\s*[a-z]?'?\s*\)")
WIDE = re.compile(r"(?:\s{2}|\t)$")
OPERATORS = ("SIGN", "TIMES", "SLASH")

FACTOR = "a wide space: write \\cdot if a factor stands behind it, a comma if not"
SEVERAL = "several equations in one line: write a comma or \\\\ between them"
UNRELATED = (
    "a line without an equals sign: where an equation goes on, begin its next line with + - ="
)


@dataclass(frozen=True)
class Row:
    r"""One equation or expression.

    Attributes
    ----------
    pieces : list
        Without what only sets them apart.
    begins : str
        ``"line"`` behind ``\\``, ``"label"`` behind words, ``"new"`` where nothing goes on,
        ``"beside"`` behind a comma or wide space.
    apart : bool
        Whether it stands beside another equation, of which it is no part.
    doubt : str
        Why it cannot be read in one way only.
    """

    pieces: Pieces
    begins: str
    apart: bool = False
    doubt: str = ""


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
        for row in _parts(child.children, text):
            yield replace(row, begins=begins)
            begins = "beside"


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
        return one and not (_related(before.pieces) and _related(row.pieces))
    # A label between the terms of an equation does not end it.
    whole = _related(row.pieces) and (row.begins != "label" or _related(before.pieces))
    unfinished = row.begins == "line" and not _related(before.pieces)
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


def _parts(pieces: Pieces, text: str) -> Iterator[Row]:
    """A comma or full stop at the outermost level ends an equation."""
    columns: dict[int, int] = {}
    count = 0
    part: Pieces = []
    for piece in [*_opened(pieces), Token("COMMA", ",")]:
        if is_kind(piece, "COMMA", "DOT"):
            part, aside = _aside(part)
            yield from _side_by_side(_numbered(part, text), columns)
            for row in _parts(aside, text) if aside else ():
                yield replace(row, apart=True)
            part = []
            continue
        if is_kind(piece, "AMP", "REL"):
            count += str(piece).count("&")
            columns[id(piece)] = count
        if _inside(piece, "braces") != []:  # {} only holds a place
            part.append(piece)


def _opened(pieces: Pieces) -> Iterator[Tree | Token]:
    r"""The pieces, and those of an equation that stands in braces: ``{\displaystyle a = b}``."""
    for piece in pieces:
        inner = _inside(piece, "braces")
        if inner is not None and _related(inner):
            yield from _opened(inner)
        else:
            yield piece


def _inside(piece: Tree | Token, kind: str) -> Pieces | None:
    """What stands in a bracket of a kind without scripts."""
    if not isinstance(piece, Tree) or piece.data != "scripted" or len(piece.children) != 1:
        return None
    base = piece.children[0]
    if not isinstance(base, Tree) or base.data != kind:
        return None
    return next((list(c.children) for c in base.children if isinstance(c, Tree)), [])


def _aside(part: Pieces) -> tuple[Pieces, Pieces]:
    """The part without an equation in brackets behind a wide space, and that equation."""
    kept = [piece for piece in part if not _is_gap(piece)]
    inner = _inside(kept[-1], "leftright") if kept else None
    if inner is None or not _related(inner):
        return part, []
    at = part.index(kept[-1])
    return (part[:at], inner) if at == 0 or _is_gap(part[at - 1]) else (part, [])


def _numbered(part: Pieces, text: str) -> Pieces:
    """The part, with a number behind or before a wide space as its tag."""
    kept = [piece for piece in part if not _is_gap(piece)]
    if not kept:
        return part
    for piece, beside in ((kept[-1], -1), (kept[0], 1)):
        if not isinstance(piece, Tree) or not NUMBER.fullmatch(_text(piece, text)):
            continue
        at = part.index(piece)
        neighbours = part[at + 1 :] if beside > 0 else part[:at]
        wide = beside < 0 and WIDE.search(text[: piece.meta.start_pos])
        if neighbours and not (_is_gap(neighbours[0 if beside > 0 else -1]) or wide):
            continue
        if not neighbours and beside > 0:
            continue
        words = f"\\tag{{{_text(piece, text)[1:-1].strip()}}}"
        start, end = piece.meta.start_pos, piece.meta.end_pos
        tag = Token("TAG", words, start_pos=start, end_pos=end)
        return [tag if other is piece else other for other in part]
    return part


def _side_by_side(part: Pieces, columns: dict[int, int]) -> Iterator[Row]:
    """Equations that wide spaces or columns set apart."""
    relations = [i for i, piece in enumerate(part) if is_kind(piece, "REL")]
    cuts, doubt = [0], ""
    for left, right in pairwise(relations):
        inside = [run for run in _runs(part) if left < run[0] and run[1] < right]
        between = [run for run in inside if run[0] - 1 > left and run[1] + 1 < right]
        if len(between) > 1:
            between = [run for run in between if _column(part, run, columns)] or between
        if len(between) > 1:
            doubt = SEVERAL
        for start, end in between[:1]:
            if is_kind(part[start - 1], *OPERATORS):
                continue
            behind = part[end + 1]
            minus = is_kind(behind, "SIGN") and behind != "+" and _wide(part[start : end + 1])
            if not is_kind(behind, *OPERATORS) or minus or _column(part, (start, end), columns):
                cuts.append(end + 1)
            elif is_kind(behind, "SIGN"):
                doubt = SEVERAL
    for start, end in pairwise([*cuts, len(part)]):
        doubt = doubt or _factor(part[start:end], columns)
        pieces = [piece for piece in part[start:end] if not _is_gap(piece)]
        if pieces:
            yield Row(pieces, "", start > 0, doubt)


def _factor(part: Pieces, columns: dict[int, int]) -> str:
    """Doubt whether what stands behind a wide space is a factor."""
    for start, end in _runs(part):
        around = [*part[max(start - 1, 0) : start], *part[end + 1 : end + 2]]
        if len(around) < 2 or any(
            is_kind(piece, "REL", "TAG", "ORDER", *OPERATORS) for piece in around
        ):
            continue
        if _wide(part[start : end + 1]) or _column(part, (start, end), columns):
            return FACTOR
    return ""


def _runs(part: Pieces) -> list[tuple[int, int]]:
    """First and last place of what sets apart, side by side."""
    found: list[tuple[int, int]] = []
    for i, piece in enumerate(part):
        if _is_gap(piece):
            start = found.pop()[0] if found and found[-1][1] == i - 1 else i
            found.append((start, i))
    return found


def _wide(run: Pieces) -> bool:
    """Whether there is a wide space in a run."""
    return any(isinstance(piece, Tree) for piece in run)


def _column(part: Pieces, run: tuple[int, int], columns: dict[int, int]) -> bool:
    """Whether a pair of columns ends in a run: behind every second mark."""
    marks = [columns[id(piece)] for piece in part[run[0] : run[1] + 1] if is_kind(piece, "AMP")]
    return any(mark % 2 == 0 for mark in marks)


def is_kind(piece: Tree | Token, *kinds: str) -> bool:
    """Whether a piece is a token of one of some kinds."""
    return isinstance(piece, Token) and piece.type in kinds


def _is_gap(piece: Tree | Token) -> bool:
    return piece.data == "gap" if isinstance(piece, Tree) else piece.type == "AMP"


def _related(pieces: Pieces) -> bool:
    return any(is_kind(piece, "REL") for piece in pieces)


def _text(piece: Tree, text: str) -> str:
    return "" if piece.meta.empty else text[piece.meta.start_pos : piece.meta.end_pos]
