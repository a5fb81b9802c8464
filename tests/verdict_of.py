"""The verdict on what a person hands in, also where it is refused."""

from pathlib import Path
from typing import Any

from mechanics import check
from mechanics.errors import InputError

NOT_READ = "not read"


def verdict_of(truth: Any, thing: Any, **options: Any) -> str:
    """Name of the verdict of all of it; `NOT_READ` where it is refused."""
    try:
        return check(truth, thing, blame=False, **options).verdict.name
    except InputError:
        return NOT_READ


def verdict_in(truth: Any, name: str, text: str, folder: Path, **options: Any) -> str:
    """The same of a file with this name and text in a folder."""
    path = folder / name
    path.write_text(text)
    return verdict_of(truth, path, **options)
