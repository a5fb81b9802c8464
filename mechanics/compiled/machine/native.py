"""Programs as machine code: printed as C, compiled by the system's compiler, and called.

Batches run in a C loop, called by ctypes. One state at a time is called by the extension of
`mechanics.compiled.machine.direct`, or by ctypes where that cannot be compiled.
"""

import ctypes
import functools
import re
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.source import Entries, function_source, signature
from mechanics.compiled.machine.direct import direct_calls
from mechanics.compiled.machine.library import FLAGS, find_compiler, load
from mechanics.program.routine import Routine

Array = NDArray[np.floating]

__all__ = ["FLAGS", "NativeKernel", "affordable", "find_compiler", "library_source", "load"]

# Register allocation of one straight block grows faster than its length: 30,000 operations take gcc
# 20 s with -O1 or -O2 and 1 s with -O0, for code that is only half as slow again.
LONG = 10_000
# The C library of Linux has a function called step, which would be called in place of ours.
PREFIX = "mechanics_"
OPTIMISED = re.compile(r"-O\w*")


def affordable(flags: str, operations: int) -> str:
    """Settings of the compiler without optimisation for a function that is too long for it."""
    return OPTIMISED.sub("-O0", flags) if operations > LONG else flags


class NativeKernel:
    """One program as a C function.

    Parameters
    ----------
    entries : names of the entries of each input
    kind : numpy.float64 or numpy.float32
    flags : str
        Settings such as ``"-O2"``.

    Raises
    ------
    CompilerError
        If the compiler refuses the code; the message carries its words.
    """

    def __init__(
        self,
        code: Routine,
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
        self._at = getattr(library, f"{PREFIX}{code.name}_at")
        self._batch.restype = self._single.restype = self._at.restype = None
        self._compiler = compiler

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

    @property
    def extension(self) -> Any:
        """The module that calls it without ctypes, None where there is none."""
        return direct_calls(self._compiler).module

    @property
    def address(self) -> int:
        """Of ``void f(const real *const *arg, real *const *res)``, valid while the kernel lives."""
        return ctypes.cast(self._at, ctypes.c_void_p).value or 0

    def bound(self, arguments: Sequence[Array], results: Sequence[Array]) -> Callable[[], None]:
        """A call without arguments that reads and writes these arrays: the least overhead."""
        ins, outs = ([a for a in arrays if a.size] for arrays in (arguments, results))
        if self.extension is None:
            places = (ctypes.c_void_p(a.ctypes.data) for a in (*ins, *outs))
            return functools.partial(self._single, *places)
        addresses = (tuple(a.ctypes.data for a in arrays) for arrays in (ins, outs))
        return self.extension.Bound(self.address, *addresses, (self._at, ins, outs))


def library_source(code: Routine, entries: Entries, kind: type[np.floating]) -> str:
    """C file with the function and a loop over states around it."""
    real = "float" if kind is np.float32 else "double"
    sizes = [size for _, size in code.inputs if size]
    results = [rows * cols for _, (rows, cols) in code.shapes if rows * cols]
    calls = [f"arg[{i}] + i * stride[{i}]" for i in range(len(sizes))]
    calls += [f"res[{i}] + i * {size}" for i, size in enumerate(results)]
    cells = [f"arg[{i}]" for i in range(len(sizes))] + [f"res[{i}]" for i in range(len(results))]
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
            f"void {name}_at(const {real} *const *arg, {real} *const *res)",
            "{",
            f"    {name}({', '.join(cells)});",
            "}",
            "",
        ]
    )
