"""C functions as machine code: the size of each, and how long a call takes.

A call is timed in a loop over states that stand in memory, written in C around the function, so
nothing but the function and its arguments is measured.
"""

import ctypes
import re
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

import numpy as np

from mechanics.compiled.machine.native import FLAGS
from mechanics.errors import CompilerError

STATES = 4096
ARGUMENT = re.compile(r"(const )?double (\w+)\[(\d+)\]")


@dataclass(frozen=True)
class Timed:
    """One function of a library: its size in bytes, and a call that runs it at `STATES` states."""

    name: str
    size: int
    run: Callable[[], float]


def timed(source: str, names: Sequence[str], compiler: str, seed: int = 1) -> tuple[Timed, ...]:
    """Compile C source and prepare some of its functions.

    Parameters
    ----------
    names : sequence of str
        Functions whose arguments are arrays of double.

    Raises
    ------
    CompilerError
        If the compiler refuses the code, or there is no ``nm`` beside it.
    """
    arguments = {name: _arguments(source, name) for name in names}
    text = "\n".join([source, *(_loop(name, arguments[name]) for name in names)])
    # A library that is loaded stays when its file goes.
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        file, objects, library = (Path(folder) / f"code{suffix}" for suffix in (".c", ".o", ".so"))
        file.write_text(text, encoding="ascii")
        _output([compiler, *FLAGS, "-O2", "-c", str(file), "-o", str(objects)])
        _output([compiler, "-shared", str(objects), "-o", str(library), "-lm"])
        listed = [line.split() for line in _output(["nm", "-S", str(objects)]).splitlines()]
        loaded = ctypes.CDLL(str(library))
    sizes = {row[3]: int(row[1], 16) for row in listed if len(row) == 4}
    return tuple(
        Timed(name, sizes[name], _call(loaded, name, arguments[name], seed)) for name in names
    )


def _arguments(source: str, name: str) -> list[tuple[bool, int]]:
    """For each argument whether it is read, and its size."""
    (text,) = re.findall(rf"void {name}\((.*?)\)\s*\{{", source, flags=re.DOTALL)
    return [(bool(const), int(size)) for const, _, size in ARGUMENT.findall(text)]


def _loop(name: str, arguments: Sequence[tuple[bool, int]]) -> str:
    cells = ", ".join(f"a[{i}] + k * {size}" for i, (_, size) in enumerate(arguments))
    return (
        f"void {name}_loop(long n, double *const *a)\n"
        f"{{\n    for (long k = 0; k < n; ++k)\n        {name}({cells});\n}}\n"
    )


def _call(
    library: ctypes.CDLL, name: str, arguments: Sequence[tuple[bool, int]], seed: int
) -> Callable[[], float]:
    """Nanoseconds of one evaluation, over all states."""
    random = np.random.default_rng(seed)
    arrays = [random.uniform(0.5, 1.5, STATES * size) for _, size in arguments]
    pointers = (ctypes.c_void_p * len(arrays))(*(a.ctypes.data for a in arrays))
    loop = library[f"{name}_loop"]
    loop.restype, count = None, ctypes.c_long(STATES)

    def run() -> float:
        start = perf_counter()
        loop(count, pointers)
        return (perf_counter() - start) / STATES * 1e9

    # The arrays live as long as what points at them.
    run.arrays = arrays  # type: ignore[attr-defined]
    return run


def _output(command: Sequence[str]) -> str:
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except OSError as error:
        raise CompilerError(f"{command[0]} cannot be run: {error}") from error
    except subprocess.CalledProcessError as error:
        raise CompilerError(f"{command[0]} failed: {error.stderr.strip()}") from error
    return done.stdout
