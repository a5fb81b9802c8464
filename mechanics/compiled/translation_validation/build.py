"""C texts compiled by every compiler of this machine, into libraries that vanish afterwards."""

import ctypes
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from mechanics.compiled.machine.process import started, write_source

COMPILERS = ("gcc", "clang")
STRICT = ("-std=c99", "-fPIC", "-shared", "-ffp-contract=off", "-w")
"""No contraction: a binary is what the text says, and `mechanics_fma` fuses where that says so."""
SETTINGS = (("-O2",), ("-O3", "-march=native"))
"""What a library is mostly built with, and what functions of many states are."""
LONGEST = 1_000_000
"""Characters of C; longer texts are compiled without optimisation, which would take minutes."""
SECONDS = 300


@dataclass(frozen=True)
class Built:
    """A library, or why there is none.

    Attributes
    ----------
    compiler : str
        First line of what it says about itself.
    refusal : str
        Words of the compiler; empty where there is a library.
    """

    compiler: str
    flags: str
    library: ctypes.CDLL | None
    refusal: str = ""

    @property
    def words(self) -> str:
        """Compiler and settings."""
        return f"{self.compiler} {self.flags}"


def compilers() -> tuple[str, ...]:
    """Paths of the compilers of this machine: $CC, gcc, clang; cc where none of these is."""
    names = [os.environ.get("CC", ""), *COMPILERS]
    found = dict.fromkeys(path for name in names if name and (path := shutil.which(name)))
    if not found and (path := shutil.which("cc")):
        return (path,)
    return tuple(found)


@contextmanager
def building(
    texts: Mapping[str, str],
    files: Sequence[str],
    paths: Sequence[str],
    settings: Sequence[Sequence[str]] = SETTINGS,
) -> Iterator[Callable[[], tuple[Built, ...]]]:
    """Begin to compile, by every compiler and setting at once; what is given waits for the ends.

    Parameters
    ----------
    texts : mapping of str to str
        C files and headers by name.
    files : sequence of str
        Those to compile and link.
    paths : sequence of str
        Of the compilers.
    settings : sequence of sequence of str
        What each of them is called with.
    """
    with TemporaryDirectory(prefix="mechanics-") as folder, ExitStack() as processes:
        at = Path(folder)
        for name, text in texts.items():
            write_source(at / name, text)
        long = sum(len(texts.get(file, "")) for file in files) > LONGEST
        running = []
        for number, path in enumerate(paths):
            for place, setting in enumerate((("-O0",),) if long else settings):
                out = at / f"library{number}_{place}.so"
                flags = (*STRICT, *setting)
                command = [path, *flags, *(str(at / file) for file in files), "-o", str(out), "-lm"]
                process = processes.enter_context(started(command, at))
                running.append((path, setting, out, process))
        yield lambda: tuple(_done(*one) for one in running)


def _done(path: str, setting: Sequence[str], out: Path, process: subprocess.Popen[str]) -> Built:
    title, flags = _title(path), " ".join(setting)
    try:
        _, words = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return Built(title, flags, None, f"no end after {SECONDS} s")
    if process.returncode != 0:
        lines = [line for line in words.splitlines() if "error" in line] or words.splitlines()
        return Built(title, flags, None, (lines or ["no message"])[0].strip())
    return Built(title, flags, ctypes.CDLL(str(out)))


def _title(path: str) -> str:
    done = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
    return (done.stdout.splitlines() or [path])[0].strip()
