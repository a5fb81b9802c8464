"""Files of an ensemble's folder while they are written, by this process or by a worker."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from uuid import uuid4

from mechanics.errors import InputError

MOTIONS, SAMPLES = "motions", "samples"
"""Folders within the folder."""
FRESH = ".new"
"""Ends the name of a file that is not done."""


def fresh(folder: Path) -> Path:
    """A file that no other process writes; what is left of one that ended is removed."""
    return folder / f"{uuid4().hex}{FRESH}"


@contextmanager
def writable(path: Path) -> Iterator[None]:
    """A disk that is full, or away, is told in one line."""
    try:
        yield
    except OSError as error:
        # pyarrow's words name its file, too.
        words = os.strerror(error.errno) if error.errno else error
        raise InputError(
            f"folder {path}: it cannot be written: {words}: mend that, and the"
            " same call goes on, or name another folder"
        ) from None
