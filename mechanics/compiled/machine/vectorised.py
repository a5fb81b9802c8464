"""Whether the compiler made vector code of the loop over states, read from its own remarks.

gcc    file.c:LINE:5: optimized: loop vectorized using 64 byte vectors
clang  file.c:LINE:5: remark: vectorized loop (vectorization width: 8, interleaved count: 2)
"""

import functools
import os
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from mechanics.errors import CompilerError
from mechanics.program.c_printer import CALLS
from mechanics.program.routine import Routine

_BYTES = r":{line}:\d+: optimized:.* loop vectorized using (\d+) byte vectors"
_WIDTH = r":{line}:\d+: remark: vectorized loop \(vectorization width: (\d+)"
TELL = {"gcc": "-fopt-info-vec-optimized", "clang": "-Rpass=loop-vectorize"}
"""Settings that make the compilers tell."""
# gcc calls the sines of a long loop unless it is let make them inline, and calls end vectors.
_GROWTH = "--param=large-function-growth=1000000 --param=inline-unit-growth=1000000"
SETTINGS = (
    f"-O3 -march=native -mprefer-vector-width=512 {_GROWTH}",
    "-O3 -march=native -mprefer-vector-width=512",
    "-O3 -march=native",
    "-O3",
)
"""For this machine; the first that the compiler knows is taken."""
INLINE = ("sin", "cos", "sqrt", "fabs")
"""Functions that have a vector form."""


@dataclass(frozen=True)
class Vectorised:
    """What the compiler made of a loop over states.

    Attributes
    ----------
    lanes : int
        States at a time; 1 where the loop was not vectorised.
    sentence : str
        The same in words, and why not.
    """

    lanes: int
    sentence: str


@functools.cache
def family(compiler: str) -> str:
    """``"gcc"`` or ``"clang"``: whose settings the compiler takes."""
    return "clang" if "clang" in _said([compiler, "--version"]).stdout else "gcc"


@functools.cache
def settings(compiler: str) -> str:
    """Optimisation for vectors of this machine, the first of `SETTINGS` that the compiler knows."""
    for known in SETTINGS:
        # Nothing is written: a compiler removes what it could not write, /dev/null among it.
        command = [compiler, *known.split(), "-x", "c", "-fsyntax-only", os.devnull]
        if _said(command).returncode == 0:
            return known
    raise CompilerError(
        f"C compiler {compiler} does not know {SETTINGS[-1]}: set CC to another compiler, or pass"
        " compiler=None to use CasADi's virtual machine"
    )


def _said(command: list[str]) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise CompilerError(f"C compiler {command[0]} cannot be run: {error}") from error


def loop_line(source: str, name: str) -> int:
    """Line of the first loop of a function, from 1."""
    lines = source.splitlines()
    head = next(i for i, line in enumerate(lines) if f" {name}(" in line and "return" not in line)
    return next(i for i, line in enumerate(lines) if i > head and "for (size_t" in line) + 1


def vectorised(remarks: str, compiler: str, line: int, size: int, code: Routine) -> Vectorised:
    """Read the remarks about a loop.

    Parameters
    ----------
    remarks : str
        What the compiler said with `TELL`.
    line : int
        Of the loop.
    size : int
        Bytes of a number.
    code : Routine
        What the loop computes.
    """
    name = Path(compiler).name
    found = [int(n) // size for n in re.findall(_BYTES.format(line=line), remarks)]
    found += [int(n) for n in re.findall(_WIDTH.format(line=line), remarks)]
    lanes = max(found, default=1)
    if lanes > 1:
        return Vectorised(lanes, f"vectorised by {name}: {lanes} states at a time")
    calls = sorted(_calls(code))
    why = f": the loop calls {', '.join(calls)}" if calls else ""
    return Vectorised(1, f"not vectorised by {name}{why}: states are computed one by one")


def _calls(code: Routine) -> set[str]:
    """Functions of the C library that have no vector form here."""
    return {CALLS[code] for code in code.program.operations if code in CALLS} - set(INLINE)
