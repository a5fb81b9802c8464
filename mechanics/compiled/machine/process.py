"""A C compiler as a process: what it starts and writes ends with the block that started it.

A compiler starts others, and keeps its own files in the temporary folder of the machine. Here they
are one group of processes, and their files stand in a folder that the caller removes.
"""

import os
import signal
import subprocess
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

from mechanics.errors import CompilerError

Handler = Callable[[int, FrameType | None], object]

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
    process = None
    try:
        with _signals_after():
            process = _start(command, folder)
        yield process
    finally:
        if process is not None:
            if process.poll() is None:
                _kill(process)
            for pipe in (process.stdout, process.stderr):
                if pipe is not None:
                    pipe.close()


def _start(command: Sequence[str], folder: Path) -> subprocess.Popen[str]:
    try:
        return subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, errors="replace",
            env={**os.environ, **dict.fromkeys(TEMPORARY, str(folder))},
            process_group=0 if os.name == "posix" else None,
        )  # fmt: skip
    except OSError as error:
        raise CompilerError(f"C compiler {command[0]} cannot be run: {error}") from error


@contextmanager
def _signals_after() -> Iterator[None]:
    """Signals that come in the block are handled behind it, until a handler raises.

    A handler that raises while `Popen` starts a process would leave a process that nobody knows.
    Handlers wait, and signals are not blocked: the process would inherit that.
    """
    if threading.current_thread() is not threading.main_thread():
        yield  # Python calls handlers in the main thread only.
        return
    handlers: dict[int, Handler] = {
        n: h for n in signal.valid_signals() if callable(h := signal.getsignal(n))
    }
    pending: list[tuple[int, FrameType | None]] = []
    try:
        _install(dict.fromkeys(handlers, lambda *which: pending.append(which)))
        yield
    finally:
        _install(handlers)
        for number, frame in pending:
            handlers[number](number, frame)


def _install(handlers: Mapping[int, Handler]) -> None:
    """Set handlers, all of them, also where one that was there before raises meanwhile."""
    left = dict(handlers)
    try:
        for number, handler in handlers.items():
            signal.signal(number, handler)
            del left[number]
    finally:
        if left:
            _install(left)


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
