"""Files that commands write; ``-`` is the screen, None no file at all."""

import os
import sys
from pathlib import Path
from typing import Annotated

import typer

from mechanics.errors import InputError

SCREEN = "-"
JsonOption = Annotated[
    str | None, typer.Option("--json", metavar="FILE|-", help="Write JSON; - for the screen.")
]


def refuse_unwritable(*files: Path | str | None) -> None:
    """Refuse files that cannot be written, before the work is done.

    Raises
    ------
    InputError
        For a folder, or a file in a folder that is not there or not open to us.
    """
    for path in (Path(file) for file in files if file not in (None, SCREEN)):
        if not path.parent.is_dir():
            raise InputError(f"file {path}: there is no folder {path.parent}: make it first")
        if path.is_dir():
            raise InputError(f"file {path}: it is a folder: name a file in it")
        if not os.access(path if path.exists() else path.parent, os.W_OK):
            raise InputError(f"file {path}: it cannot be written: choose another place")


def write(text: str, file: str) -> None:
    """Write a text and the end of its last line."""
    if file == SCREEN:
        sys.stdout.write(f"{text}\n")
    else:
        write_file(f"{text}\n", Path(file))


def write_file(text: str, file: Path) -> None:
    """Write a text to a file: whole, or not at all."""
    # Exports are slow to import, and most commands write to the screen.
    from mechanics.export.atomic import replaced_file

    with replaced_file(file) as fresh:
        fresh.write_text(text, encoding="utf-8")
