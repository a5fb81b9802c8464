r"""A source on a terminal, with a line under what is wrong.

M \frac{L^{2}}{12} \ddot{\theta}+M g \frac{L}{2} \cos \theta=0
           ^^                               ^^^^
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderResult
from rich.text import Text

from mechanics.report.answer.lines import INDENT, NARROWEST
from mechanics.report.answer.marks import Piece, printable

WRONG = "bold red"
SIGNS = "+-=\\&"
Cell = tuple[str, bool]
"""A character, and whether it is wrong."""


@dataclass(frozen=True)
class Source:
    """Pieces of a source, to be printed."""

    pieces: Sequence[Piece]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        width = max(options.max_width - INDENT, NARROWEST)
        for row in _rows(_cells(self.pieces), width):
            yield _text(row)
            if any(wrong for _, wrong in row):
                yield Text.assemble(" " * INDENT, ("".join(_under(row)).rstrip(), WRONG))


def _cells(pieces: Sequence[Piece]) -> list[Cell]:
    """Characters; a missing term is marked at the character that it stands before."""
    found: list[Cell] = []
    missing = False
    for piece in pieces:
        wrong = piece.edit is not None
        text = printable(piece.text)
        missing = missing or (wrong and not text)
        for character in text:
            found.append((character, wrong or missing))
            missing = False
    if missing:
        found.append((" ", True))
    return found


def _rows(cells: list[Cell], width: int) -> Iterator[list[Cell]]:
    """Rows of at most so many columns, broken before an operator or after a space."""
    while cells:
        end = _fitting(cells, width)
        if end < len(cells):
            end = _break(cells, end)
        yield cells[:end]
        cells = cells[end:]
        while cells and cells[0] == (" ", False):
            cells = cells[1:]


def _fitting(cells: list[Cell], width: int) -> int:
    used = 0
    for k, (character, _) in enumerate(cells):
        used += cell_len(character)
        if used > width:
            return max(k, 1)
    return len(cells)


def _break(cells: list[Cell], end: int) -> int:
    """Where a row ends that may have so many cells: after a space rather than at a sign."""
    inside = range(end, end // 3, -1)
    after_space = (k for k in inside if cells[k - 1][0] == " ")
    before_sign = (k for k in inside if _parts(cells[k - 1][0], cells[k][0]))
    return next(after_space, next(before_sign, end))


def _parts(before: str, after: str) -> bool:
    """Whether a sign or command parts a row, and is none of an exponent."""
    return after in SIGNS and before not in "\\*^_{("


def _text(row: list[Cell]) -> Text:
    text = Text(" " * INDENT, no_wrap=True, overflow="ignore")
    for character, wrong in row:
        text.append(character, style=f"{WRONG} underline" if wrong else "")
    text.rstrip()
    return text


def _under(row: list[Cell]) -> Iterator[str]:
    for character, wrong in row:
        yield ("^" if wrong else " ") * cell_len(character)
