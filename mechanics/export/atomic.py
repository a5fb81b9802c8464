"""Files and folders that appear whole or not at all.

    content  -->  a temporary name on the same file system  -->  rename

A folder that is there already keeps its place: it may be a mount, the working directory, or hold
files of others. Its new files are renamed into it one by one, and all of them back if one fails.
Only the end of the process between two of these renames, or of the machine, can leave a mixture;
`mechanics verify` names it.
"""

import errno
import os
import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from uuid import uuid4

from mechanics.errors import InputError


def named(target: str | Path) -> Path:
    """The path of a file or folder to write.

    Raises
    ------
    InputError
        For an empty text, which Python takes for the current folder.
    """
    if isinstance(target, str) and not target.strip():
        raise InputError("the name of what to write is empty: write '.' for the current folder")
    return Path(target)


@contextmanager
def replaced_file(target: Path) -> Iterator[Path]:
    """Give a temporary path to write to; it becomes the target when the block ends.

    Where the block raises, the target is as it was. A link keeps its place: what it leads to is
    replaced, with its permissions. What is no file, a pipe or a terminal, is written to at once.

    Raises
    ------
    OSError
    """
    if target.exists() and not target.is_file():
        yield target
        return
    target = _led_to(target)
    held = target.exists()
    if held and not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, "the file is read-only", str(target))
    fresh = target.with_name(_temporary() + target.suffix)
    try:
        yield fresh
        if held:
            shutil.copymode(target, fresh)
        fresh.replace(target)
    except BaseException:
        fresh.unlink(missing_ok=True)
        raise


def replace_in_folder(target: Path, files: Mapping[str, bytes], gone: Iterable[str] = ()) -> None:
    """Put files into a folder, which is made if it is not there, and remove others: all or nothing.

    Parameters
    ----------
    files : mapping of file name to content
        The last one is put last.
    gone : iterable of str
        Names of files to remove.

    Raises
    ------
    OSError
    """
    target = _led_to(target)
    missing = [folder for folder in (target.parent, *target.parent.parents) if not folder.exists()]
    try:
        if target.exists():
            _exchanged(target, files, gone)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            _made(target, files)
    except BaseException:
        for folder in missing:
            with suppress(OSError):
                folder.rmdir()
        raise


def _led_to(target: Path) -> Path:
    """Where links lead; one that leads into itself is an error of the first call that uses it."""
    return Path(os.path.realpath(target))


def _temporary() -> str:
    return f".mechanics-{uuid4().hex[:12]}"


def _made(target: Path, files: Mapping[str, bytes]) -> None:
    fresh = target.with_name(_temporary())
    try:
        fresh.mkdir()
        for name, content in files.items():
            (fresh / name).write_bytes(content)
        fresh.rename(target)
    except BaseException:
        shutil.rmtree(fresh, ignore_errors=True)
        raise


def _exchanged(target: Path, files: Mapping[str, bytes], gone: Iterable[str]) -> None:
    # Within the folder: the one above may be another file system, or closed to us.
    fresh = target / _temporary()
    new, old = fresh / "new", fresh / "old"
    moves: list[tuple[Path, Path]] = []
    try:
        fresh.mkdir()
        new.mkdir()
        old.mkdir()
        for name, content in files.items():
            (new / name).write_bytes(content)
        for name in (*gone, *files):
            if os.path.lexists(target / name):
                moves.append((target / name, old / name))
                os.rename(*moves[-1])
            if name in files:
                moves.append((new / name, target / name))
                os.rename(*moves[-1])
    except BaseException:
        for before, after in reversed(moves):
            if os.path.lexists(after) and not os.path.lexists(before):
                os.rename(after, before)
        shutil.rmtree(fresh, ignore_errors=True)
        raise
    shutil.rmtree(fresh, ignore_errors=True)
