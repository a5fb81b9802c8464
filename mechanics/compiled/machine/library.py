"""C source into a shared library of this process: written, compiled, linked, loaded.

Files live in a folder that vanishes with the process.
"""

import ctypes
import functools
import os
import shutil
import tempfile
import threading
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from mechanics.compiled.machine.process import run, write_source
from mechanics.errors import CompilerError

# No contraction into fused operations and no reassociation: results are the same everywhere.
FLAGS = ("-std=c99", "-fPIC", "-ffp-contract=off", "-fno-math-errno")
# Threads that need the same library at the same time would write the same files.
_BUILDING: dict[str, threading.Lock] = {}
# A cached function called by two threads at once runs twice, and the loser's folder is deleted.
_MAKING = threading.Lock()
REMARKS = ".txt"
"""Ends the name of the file with what the compiler said, in place of the library's ending."""


def find_compiler() -> str | None:
    """The C compiler of this machine: $CC, or cc, gcc, clang; None where there is none."""
    for name in (os.environ.get("CC", ""), "cc", "gcc", "clang"):
        if name and (path := shutil.which(name)):
            return path
    return None


@functools.cache
def _folder() -> tempfile.TemporaryDirectory:
    return tempfile.TemporaryDirectory(prefix="mechanics-")


@functools.cache
def load(source: str, compiler: str, flags: str) -> ctypes.CDLL:
    """Compile C source into a shared library and load it; the same source is compiled once.

    Raises
    ------
    CompilerError
        If the compiler refuses the code or cannot be run; the message carries its words.
    """
    return ctypes.CDLL(str(build(source, compiler, [*FLAGS, *flags.split()], ["-lm"])))


def build(source: str, compiler: str, flags: Sequence[str], linked: Sequence[str] = ()) -> Path:
    """Compile C source into a shared library; what the compiler said is beside it.

    Compiled and linked apart: gcc links a library that it compiles with -ffast-math to code that
    flushes subnormal numbers to zero, in every function of the process from then on.

    Parameters
    ----------
    flags, linked : sequences of str
        Settings of the compiler and of the linker.

    Raises
    ------
    CompilerError
        If the compiler refuses the code or cannot be run; the message carries its words.
    """
    name = sha256(f"{compiler} {flags} {linked}\n{source}".encode()).hexdigest()[:16]
    with _MAKING:
        stem = Path(_folder().name) / name
    file, object_file, library = (stem.with_suffix(suffix) for suffix in (".c", ".o", ".so"))
    with _BUILDING.setdefault(name, threading.Lock()):
        if not library.exists():
            write_source(file, source)
            remarks = _run([compiler, *flags, "-c", str(file), "-o", str(object_file)], stem.parent)
            write_source(stem.with_suffix(REMARKS), remarks)
            _run([compiler, "-shared", str(object_file), "-o", str(library), *linked], stem.parent)
    return library


def _run(command: list[str], folder: Path) -> str:
    done = run(command, folder)
    if done.returncode != 0:
        words = (done.stderr or done.stdout).strip() or f"exit code {done.returncode}, no message"
        raise CompilerError(
            f"C compiler {command[0]} refused the generated code: {words}\nset CC to another"
            " compiler, or pass compiler=None to use CasADi's virtual machine"
        )
    return done.stderr
