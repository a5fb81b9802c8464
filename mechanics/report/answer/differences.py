"""Differences term by term as a small table, or one below the other where the screen is narrow.

group      written    right      comes from
gravity    M g L/3    M g L/2    load gravity
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderResult
from rich.text import Text

from mechanics.blame.result import Difference
from mechanics.report.answer.lines import INDENT, Hanging, below, column
from mechanics.report.answer.marks import printable

HEAD = ("group", "written", "right", "comes from")
STYLES = ("", "red", "green", "dim")
GAP = 2


@dataclass(frozen=True)
class Differences:
    """Differences, to be printed."""

    rows: Sequence[Difference]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        rows = [cells(row) for row in self.rows]
        widths = [max(map(cell_len, entries)) for entries in zip(HEAD, *rows, strict=True)]
        if INDENT + sum(widths) + GAP * (len(HEAD) - 1) <= options.max_width:
            yield _row(HEAD, widths, ("dim",) * len(HEAD))
            yield from (_row(row, widths, STYLES) for row in rows)
        else:
            for row in rows:
                yield from _stacked(row)


def cells(row: Difference) -> tuple[str, str, str, str]:
    """The four texts of a row."""
    origin = "; ".join(row.origin)
    group, written, right, origin = map(printable, (row.group, row.written, row.right, origin))
    return group, written or "none", right or "none", origin


def _row(texts: Sequence[str], widths: Sequence[int], styles: Sequence[str]) -> Text:
    found = Text(" " * INDENT, no_wrap=True)
    for text, width, style in zip(texts, widths, styles, strict=True):
        found.append(column(text, width + GAP), style)
    found.rstrip()
    return found


def _stacked(row: Sequence[str]) -> Iterator[Hanging]:
    group, *texts = row
    yield below(Text(group))
    width = max(map(cell_len, HEAD)) + GAP
    for head, style, text in zip(HEAD[1:], STYLES[1:], texts, strict=True):
        if text:
            entry = Text.assemble((column(head, width), "dim"), (text, style))
            yield Hanging(entry, INDENT + GAP)
