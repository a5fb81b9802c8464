"""A C compiler as a process: what it starts and writes ends with the block that started it.

A compiler starts others, and keeps its own files in the temporary folder of the machine. Here they
are one group of processes, and their files stand in a folder that the caller removes.
"""

import os
import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from mechanics.errors import CompilerError

TEMPORARY = ("TMPDIR", "TMP", "TEMP")
"""Variables by which a compiler finds a folder for its own files."""


@contextmanager
def started(command: Sequence[str], folder: Path) -> Iterator[subprocess.Popen[str]]:
    """A compiler that runs; where the block is left before its end, it is killed with its children.

    Parameters
    ----------
    folder : Path
        Where it keeps its own files.

    Raises
    ------
    CompilerError
        If it cannot be run.
    """
    try:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, errors="replace",
            env={**os.environ, **dict.fromkeys(TEMPORARY, str(folder))},
            process_group=0 if os.name == "posix" else None,
        )  # fmt: skip
    except OSError as error:
        raise CompilerError(f"C compiler {command[0]} cannot be run: {error}") from error
    try:
        yield process
    finally:
        if process.poll() is None:
            _kill(process)
        for pipe in (process.stdout, process.stderr):
            if pipe is not None:
                pipe.close()


def write_source(file: Path, text: str) -> None:
    """Write a file for a compiler, the same bytes everywhere.

    Raises
    ------
    OSError
        With the name of the file: where a disk is full, Python's own has none.
    """
    try:
        file.write_bytes(text.encode("utf-8"))
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(file)) from error


def _kill(process: subprocess.Popen[str]) -> None:
    if os.name == "posix":
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def run(command: Sequence[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """What a compiler said, and its exit code; arguments and errors as for `started`."""
    with started(command, folder) as process:
        said, remarks = process.communicate()
    return subprocess.CompletedProcess(command, process.returncode, said, remarks)
