"""The answer as a piece of HTML for a notebook: the lines of the terminal in their colours."""

from io import StringIO

from rich.console import Console, RenderableType
from rich.terminal_theme import TerminalTheme

THEME = TerminalTheme(
    (255, 255, 255),
    (27, 34, 44),
    [(27, 34, 44), (190, 50, 40), (30, 130, 70), (150, 105, 0),
     (45, 100, 180), (125, 75, 160), (20, 125, 140), (110, 118, 128)],
)  # fmt: skip
"""Colours that are read on white and on black."""

FORMAT = '<pre style="white-space:pre;line-height:1.35;overflow-x:auto">{code}</pre>'
WIDTH = 100


def notebook(answer: RenderableType) -> str:
    """An answer as one element of HTML, with no more than inline styles."""
    console = Console(record=True, file=StringIO(), width=WIDTH, highlight=False, emoji=False)
    console.print(answer)
    return console.export_html(theme=THEME, code_format=FORMAT, inline_styles=True)
