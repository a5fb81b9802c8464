"""Notebooks, run by IPython: by the tests, and for the pages of the site. No outputs are kept."""

import contextlib
import io
import json
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from IPython.core.displayhook import DisplayHook
from IPython.core.interactiveshell import InteractiveShell

from mechanics.notebook import register


class Cell(NamedTuple):
    """A cell: its kind and text, what it prints, and what it shows by type of medium."""

    kind: str
    source: str
    printed: str = ""
    shown: Mapping[str, str] = MappingProxyType({})


class _Kept(DisplayHook):
    """What a cell ends with is kept, and not printed."""

    def __call__(self, result: Any = None) -> None:
        if result is not None and not self.quiet():
            self.fill_exec_result(result)


def run(path: Path) -> list[Cell]:
    """The cells of a notebook, in order, in a shell of their own.

    Raises whatever a cell raises.
    """
    shell = InteractiveShell.instance(displayhook_class=_Kept)
    register()
    try:
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        return [_run(shell, cell["cell_type"], "".join(cell["source"])) for cell in cells]
    finally:
        InteractiveShell.clear_instance()


def _run(shell: InteractiveShell, kind: str, source: str) -> Cell:
    if kind != "code":
        return Cell(kind, source)
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        outcome = shell.run_cell(source)
    outcome.raise_error()
    shown = {} if outcome.result is None else shell.display_formatter.format(outcome.result)[0]
    return Cell(kind, source, printed.getvalue(), shown)


def page(path: Path) -> str:
    """A notebook as Markdown: text, code, and what it prints and shows."""
    parts = []
    file = f"{{download}}`a notebook <{path.name}>`"
    last = f"This page is {file}, which was run when the page was made."
    for cell in [*run(path), Cell("markdown", last)]:
        if cell.kind != "code":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        if cell.printed:
            parts.append(f"```text\n{cell.printed}```")
        if "text/html" in cell.shown:
            parts.append(f"``````{{raw}} html\n{cell.shown['text/html']}\n``````")
        elif "text/plain" in cell.shown:
            parts.append(f"```text\n{cell.shown['text/plain']}\n```")
    return "\n\n".join(parts) + "\n"
