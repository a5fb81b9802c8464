"""Libraries that the processes of one user on one machine share: each is compiled once.

The first process that needs a library holds the lock of its file and compiles; the others wait for
it. The folder lies where temporary files lie, is the user's own, and closed to others.
"""

import ctypes
import os
import shutil
import tempfile
from functools import cache
from hashlib import sha256
from pathlib import Path

from mechanics.compiled.machine.library import FLAGS, build
from mechanics.errors import CompilerError

try:
    import fcntl
except ImportError:  # Windows: each process compiles for itself.
    fcntl = None  # type: ignore[assignment]


@cache
def load_shared(source: str, compiler: str, flags: str) -> ctypes.CDLL:
    """Compile C source, if no process of this user on this machine has, and load it.

    Parameters
    ----------
    source, compiler, flags : str
        As `mechanics.compiled.machine.library.load` takes them.

    Raises
    ------
    CompilerError
        If the compiler refuses the code, or the folder belongs to somebody else.
    """
    settings = [*FLAGS, *flags.split()]
    if fcntl is None:
        return ctypes.CDLL(str(build(source, compiler, settings, ["-lm"])))
    changed = os.stat(compiler).st_mtime_ns
    name = sha256(f"{compiler} {changed} {settings}\n{source}".encode()).hexdigest()
    library = _folder() / f"{name}.so"
    with library.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not library.exists():
            built, fresh = build(source, compiler, settings, ["-lm"]), library.with_suffix(".new")
            shutil.copyfile(built, fresh)
            os.replace(fresh, library)
    return ctypes.CDLL(str(library))


def _folder() -> Path:
    """Of this user alone."""
    path = Path(tempfile.gettempdir()) / f"mechanics-{os.getuid()}"
    path.mkdir(mode=0o700, exist_ok=True)
    status = path.lstat()
    if path.is_symlink() or status.st_uid != os.getuid() or status.st_mode & 0o077:
        raise CompilerError(
            f"folder {path}: it is not yours alone, and libraries are loaded from it: remove it,"
            " or set TMPDIR to another folder"
        )
    return path
