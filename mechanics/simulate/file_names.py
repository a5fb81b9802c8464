"""Names of files that are refused before the work is done."""

from pathlib import Path

from mechanics.errors import InputError


def writable(path: str | Path, suffixes: tuple[str, ...]) -> Path:
    """The path, if its suffix is one of these and its folder exists."""
    target = Path(path)
    if target.suffix.lower() not in suffixes:
        raise InputError(
            f"file {target.name}: the suffix {target.suffix or '(none)'} is not supported:"
            f" use {' or '.join(suffixes)}"
        )
    if not target.parent.is_dir():
        raise InputError(f"file {target}: there is no folder {target.parent}: make it first")
    return target
