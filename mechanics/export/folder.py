"""Writing a folder without harm to what is in it already.

What an earlier call wrote is listed in its manifest, and may be replaced. Files of others stay;
where one of them stands in the way, nothing is written.
"""

import json
import os
from collections.abc import Iterable, Mapping
from hashlib import sha256
from pathlib import Path

from mechanics.errors import InputError
from mechanics.export.atomic import replace_in_folder

MANIFEST = "manifest.json"


def write_folder(target: Path, name: str, files: Mapping[str, str]) -> tuple[Path, ...]:
    """Write files of text, and remove what an earlier call wrote and this one does not.

    All of it is done, or nothing.

    Parameters
    ----------
    target : Path
        Made if it does not exist.
    name : str
        Of the library that the folder holds.
    files : mapping of file name to text

    Raises
    ------
    InputError
        If the folder is a file or cannot be written, holds another library, or holds a file of one
        of these names that was not generated.
    """
    held = check_folder(target, name, files)
    # The same bytes everywhere, whatever the machine takes for an end of line.
    contents = {file: text.encode("utf-8") for file, text in files.items()}
    try:
        inside = list(target.iterdir()) if target.exists() else []
        gone = [
            p.name for p in inside if p.name not in files and _digest(p) == held.get(p.name, "")
        ]
        replace_in_folder(target, contents, gone)
    except OSError as error:
        raise InputError(
            f"{target} cannot be written: {error.strerror}: name a folder that can be"
        ) from error
    return tuple(target / file for file in files)


def check_folder(target: Path, name: str, files: Iterable[str]) -> dict[str, str]:
    """SHA-256 of what an earlier call wrote, by file; raises as `write_folder` does."""
    if target.exists() and not target.is_dir():
        raise InputError(f"{target} is a file: name a folder to write the C files into")
    nearest = next(folder for folder in (target, *target.absolute().parents) if folder.exists())
    if not nearest.is_dir() or not os.access(nearest, os.W_OK):
        why = "is read-only" if nearest.is_dir() else "is a file"
        raise InputError(f"{target} cannot be written: {nearest} {why}: name another folder")
    before = _manifest(target)
    held: dict[str, str] = before.get("files", {})
    if before and before["prefix"] != name:
        raise InputError(
            f"{target} holds {before['prefix']!r} already: name another folder for {name!r}"
        )
    for file in files:
        if (
            os.path.lexists(target / file)
            and file not in held
            and not (before and file == MANIFEST)
        ):
            raise InputError(
                f"{target / file} stands there and was not generated: name another folder"
            )
    return held


def _manifest(target: Path) -> dict:
    """The manifest of an earlier call; empty where there is none of ours."""
    path = target / MANIFEST
    if not path.is_file():
        return {}
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        # Not ours: it is in the way, and named as such.
        return {}
    ours = isinstance(found, dict) and isinstance(found.get("files"), dict) and "prefix" in found
    return found if ours else {}


def _digest(path: Path) -> str | None:
    return sha256(path.read_bytes()).hexdigest() if path.is_file() else None
