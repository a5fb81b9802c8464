"""Programs as machine code: printed as C, compiled by the system's compiler, called by ctypes.

Batches run in a C loop. Shared libraries live in a folder that vanishes with the process.
"""

import ctypes
import functools
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.source import Entries, function_source, signature
from mechanics.compiled.program import Program
from mechanics.errors import CompilerError

Array = NDArray[np.floating]

# No contraction into fused operations and no reassociation: results are the same everywhere.
FLAGS = ("-std=c99", "-fPIC", "-ffp-contract=off", "-fno-math-errno")

# Register allocation of one straight block grows faster than its length: 30,000 operations take gcc
# 20 s with -O1 or -O2 and 1 s with -O0, for code that is only half as slow again.
LONG = 10_000
# The C library of Linux has a function called step, which would be called in place of ours.
PREFIX = "mechanics_"
OPTIMISED = re.compile(r"-O\w*")


def find_compiler() -> str | None:
    """The C compiler of this machine: $CC, or cc, gcc, clang; None where there is none."""
    for name in (os.environ.get("CC", ""), "cc", "gcc", "clang"):
        if name and (path := shutil.which(name)):
            return path
    return None


def affordable(flags: str, operations: int) -> str:
    """Settings of the compiler without optimisation for a function that is too long for it."""
    return OPTIMISED.sub("-O0", flags) if operations > LONG else flags


class NativeKernel:
    """One program as a C function.

    Parameters
    ----------
    code : Program
    entries : names of the entries of each input
    kind : numpy.float64 or numpy.float32
    compiler : str
    flags : str
        Settings such as ``"-O2"``.

    Raises
    ------
    CompilerError
        If the compiler refuses the code; the message carries its words.
    """

    def __init__(
        self,
        code: Program,
        entries: Entries,
        kind: type[np.floating],
        compiler: str,
        flags: str = "-O2",
    ) -> None:
        self._kind = kind
        self._sizes = [size for _, size in code.inputs]
        self._results = [rows * cols for _, (rows, cols) in code.shapes]
        settings = affordable(flags, code.operations)
        library = load(library_source(code, entries, kind), compiler, settings)
        self._batch = getattr(library, f"{PREFIX}{code.name}_batch")
        self._single = getattr(library, f"{PREFIX}{code.name}")
        self._batch.restype = self._single.restype = None

    def __call__(self, arguments: Sequence[Array], count: int) -> list[Array]:
        """Evaluate at `count` states.

        Parameters
        ----------
        arguments : arrays, count x size, or 1 x size for what all states share; contiguous
        """
        results = [np.empty((count, size), self._kind) for size in self._results]
        given = [a for a, size in zip(arguments, self._sizes, strict=True) if size]
        asked = [r for r, size in zip(results, self._results, strict=True) if size]
        steps = [0 if len(a) == 1 else a.shape[1] for a in given]
        self._batch(
            ctypes.c_longlong(count),
            (ctypes.c_void_p * len(given))(*(a.ctypes.data for a in given)),
            (ctypes.c_longlong * len(given))(*steps),
            (ctypes.c_void_p * len(asked))(*(r.ctypes.data for r in asked)),
        )
        return results

    def bound(self, arguments: Sequence[Array], results: Sequence[Array]) -> functools.partial:
        """A call without arguments that reads and writes these arrays: the least overhead."""
        arrays = [array for array in (*arguments, *results) if array.size]
        return functools.partial(self._single, *(ctypes.c_void_p(a.ctypes.data) for a in arrays))


def library_source(code: Program, entries: Entries, kind: type[np.floating]) -> str:
    """C file with the function and a loop over states around it."""
    real = "float" if kind is np.float32 else "double"
    sizes = [size for _, size in code.inputs if size]
    results = [rows * cols for _, (rows, cols) in code.shapes if rows * cols]
    calls = [f"arg[{i}] + i * stride[{i}]" for i in range(len(sizes))]
    calls += [f"res[{i}] + i * {size}" for i, size in enumerate(results)]
    name = f"{PREFIX}{code.name}"
    head = f"void {name}_batch(long long count, const {real} *const *arg,"
    return "\n".join(
        [
            "#include <math.h>",
            "",
            function_source(code, entries, real, signature(code, real, name)),
            head,
            f"    const long long *stride, {real} *const *res)",
            "{",
            "    for (long long i = 0; i < count; ++i)",
            f"        {name}({', '.join(calls)});",
            "}",
            "",
        ]
    )


@functools.cache
def _folder() -> tempfile.TemporaryDirectory:
    return tempfile.TemporaryDirectory(prefix="mechanics-")


@functools.cache
def load(source: str, compiler: str, flags: str) -> ctypes.CDLL:
    """Compile C source into a shared library and load it; the same source is compiled once.

    Compiled and linked apart: gcc links a library that it compiles with -ffast-math to code that
    flushes subnormal numbers to zero, in every function of the process from then on.

    Raises
    ------
    CompilerError
        If the compiler refuses the code or cannot be run; the message carries its words.
    """
    stem = Path(_folder().name) / sha256(f"{compiler} {flags}\n{source}".encode()).hexdigest()[:16]
    file, object_file, library = (stem.with_suffix(suffix) for suffix in (".c", ".o", ".so"))
    file.write_text(source, encoding="ascii")
    _run([compiler, *FLAGS, *flags.split(), "-c", str(file), "-o", str(object_file)])
    _run([compiler, "-shared", str(object_file), "-o", str(library), "-lm"])
    return ctypes.CDLL(str(library))


def _run(command: list[str]) -> None:
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise CompilerError(f"C compiler {command[0]} cannot be run: {error}") from error
    if done.returncode != 0:
        words = (done.stderr or done.stdout).strip() or f"exit code {done.returncode}, no message"
        raise CompilerError(
            f"C compiler {command[0]} refused the generated code: {words}\nset CC to another"
            " compiler, or pass compiler=None to use CasADi's virtual machine"
        )
