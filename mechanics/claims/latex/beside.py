r"""What stands side by side in one row, set apart by commas, columns and wide spaces.

a = b, c = d        a &= b & c &= d        a = b \quad c = d        a = b \quad (6)
"""

import re
from bisect import bisect
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from lark import Token, Tree

from mechanics.claims.latex.item import letter_of
from mechanics.claims.latex.pieces import (
    OPERATORS,
    Pieces,
    inside,
    is_gap,
    is_kind,
    opened,
    related,
    text_of,
)
from mechanics.claims.names import GREEK

NUMBER = re.compile(
    r"\(\s*(?:(?:[A-Z]\.?)?\d{1,3}(?:\.\d{1,3}){0,2}\s*[a-z]?'?|\*{1,3}|\\(?:ast|star))\s*\)"
)
WIDE = re.compile(r"(?:\s{2}|\t)$")
LABELS = 3
"""Pieces before a colon that may be the name of an equation."""

FACTOR = "a wide space: write \\cdot before a factor, a comma before another equation"
SEVERAL = "several equations in one line: write a comma or \\\\ between them"


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


def parts(pieces: Pieces, text: str) -> Iterator[Row]:
    """A comma or full stop at the outermost level ends an equation."""
    columns: dict[int, int] = {}
    count = 0
    part: Pieces = []
    for piece in [*opened(pieces), Token("COMMA", ",")]:
        if is_kind(piece, "COMMA", "DOT"):
            part, aside = _aside(part)
            yield from _side_by_side(_numbered(part, text), columns)
            for row in parts(aside, text) if aside else ():
                yield replace(row, apart=True)
            part = []
            continue
        if is_kind(piece, "COLON") and all(map(_names, part)) and len(part) <= LABELS:
            part = []  # cart: (m + M) x'' = F
            continue
        if is_kind(piece, "AMP", "REL"):
            count += str(piece).count("&")
            columns[id(piece)] = count
        if inside(piece, "braces") != []:  # {} only holds a place
            part.append(piece)


def _names(piece: Tree | Token) -> bool:
    """Whether a piece may name an equation: a word, a number, a letter, one in a bracket."""
    if isinstance(piece, Token) or piece.data != "scripted":
        return is_gap(piece)
    base = piece.children[0]
    if isinstance(base, Token):
        return base.type != "COMMAND" or letter_of(base.value[1:]) in GREEK
    return base.data == "leftright" and all(map(_names, inside(piece, "leftright") or ()))


def _aside(part: Pieces) -> tuple[Pieces, Pieces]:
    """The part without an equation in brackets behind a wide space, and that equation."""
    kept = [piece for piece in part if not is_gap(piece)]
    inner = inside(kept[-1], "leftright") if kept else None
    if inner is None or not related(inner):
        return part, []
    at = part.index(kept[-1])
    return (part[:at], inner) if at == 0 or is_gap(part[at - 1]) else (part, [])


def _numbered(part: Pieces, text: str) -> Pieces:
    """The part, with a number behind or before a wide space as its tag."""
    kept = [piece for piece in part if not is_gap(piece)]
    if not kept:
        return part
    for piece, beside in ((kept[-1], -1), (kept[0], 1)):
        if not isinstance(piece, Tree) or not NUMBER.fullmatch(text_of(piece, text)):
            continue
        at = part.index(piece)
        neighbours = part[at + 1 :] if beside > 0 else part[:at]
        wide = beside < 0 and WIDE.search(text[: piece.meta.start_pos])
        if neighbours and not (is_gap(neighbours[0 if beside > 0 else -1]) or wide):
            continue
        if not neighbours and beside > 0:
            continue
        words = f"\\tag{{{text_of(piece, text)[1:-1].strip()}}}"
        start, end = piece.meta.start_pos, piece.meta.end_pos
        tag = Token("TAG", words, start_pos=start, end_pos=end)
        return [tag if other is piece else other for other in part]
    return part


def _side_by_side(part: Pieces, columns: dict[int, int]) -> Iterator[Row]:
    """Equations that wide spaces or columns set apart."""
    relations = [i for i, piece in enumerate(part) if is_kind(piece, "REL")]
    cuts, doubt = [0], ""
    runs = _runs(part)
    starts = [start for start, _ in runs]
    for left, right in pairwise(relations):
        # No run goes over a relation.
        inside = runs[bisect(starts, left) : bisect(starts, right)]
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
        pieces = [piece for piece in part[start:end] if not is_gap(piece)]
        if pieces:
            yield Row(pieces, "", start > 0, doubt)


def _factor(part: Pieces, columns: dict[int, int]) -> str:
    """Doubt whether what stands behind a wide space is a factor."""
    first = next((i for i, piece in enumerate(part) if is_kind(piece, "REL")), len(part))
    for start, end in _runs(part):
        around = [*part[max(start - 1, 0) : start], *part[end + 1 : end + 2]]
        if len(around) < 2 or any(
            is_kind(piece, "REL", "TAG", "ORDER", *OPERATORS) for piece in around
        ):
            continue
        behind = first < start and _column(part, (start, end), columns)
        if behind or _wide(part[start : end + 1]):
            return FACTOR
    return ""


def _runs(part: Pieces) -> list[tuple[int, int]]:
    """First and last place of what sets apart, side by side."""
    found: list[tuple[int, int]] = []
    for i, piece in enumerate(part):
        if is_gap(piece):
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
