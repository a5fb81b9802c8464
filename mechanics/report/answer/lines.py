"""Lines of the answer on a terminal: indented, further lines of one set back, no blanks at ends.

at L=211/64, M=185/64,
  theta=31/32
"""

from dataclasses import dataclass

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderResult
from rich.text import Text

from mechanics.report.answer.marks import printable

INDENT = 4
HANG = 2
NARROWEST = 16
"""Columns that are used in any case, however narrow a screen says it is."""


@dataclass(frozen=True)
class Hanging:
    """A text whose further lines are set back."""

    text: Text
    indent: int = 0

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        width = max(options.max_width - self.indent - HANG, NARROWEST)
        for n, part in enumerate(self.text.wrap(console, width, overflow="fold")):
            part.rstrip()
            yield Text(" " * (self.indent + (HANG if n else 0))).append_text(part)


def line(text: str, style: str = "", lead: str = "") -> Text:
    """A text from elsewhere, after a word of ours; the style is that of the word, or of all."""
    if lead:
        return Text.assemble((lead, style), printable(text))
    return Text(printable(text), style=style)


def below(text: Text) -> Hanging:
    """A line that belongs to the statement above it."""
    return Hanging(text, INDENT)


def column(text: str, width: int) -> str:
    """A text filled up to so many columns of the screen."""
    return text + " " * max(0, width - cell_len(text))
