"""Programs over many states at once: the batch text, compiled for this machine, called by ctypes.

Arrays of any strides are taken as they are. The interpreter's lock is released, so chunks run on
several threads.
"""

import ctypes
import functools
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.batch import BLOCK, batch_source
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.c.sine import sine_source
from mechanics.compiled.c.source import Entries, function_source, signature
from mechanics.compiled.c.status import Codes
from mechanics.compiled.c.strided import strided_source
from mechanics.compiled.machine.library import FLAGS, REMARKS, build
from mechanics.compiled.machine.vectorised import TELL, family, loop_line, settings, vectorised
from mechanics.program.routine import Routine

Array = NDArray[np.floating]
PREFIX = "mechanics_"


class BatchKernel:
    """One program as a C function of many states.

    Parameters
    ----------
    entries : names of the entries of each input
    kind : numpy.float64 or numpy.float32
    shared : sequence of str
        Inputs that all states have in common.
    checked : bool
        Whether to look for values that are not finite.

    Attributes
    ----------
    source : str
        The C text.
    vectorised : Vectorised
        What the compiler made of it.

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
        shared: Sequence[str] = SHARED,
        checked: bool = False,
    ) -> None:
        self._kind, name = kind, f"{PREFIX}{code.name}_states"
        self._inputs = [(size, group in shared) for group, size in code.inputs]
        self._outputs = [rows * cols for _, (rows, cols) in code.shapes]
        self.source = library_source(code, entries, kind, shared, checked)
        flags = [*FLAGS, *settings(compiler).split(), TELL[family(compiler)]]
        library = build(self.source, compiler, flags, ["-lm"])
        remarks = library.with_suffix(REMARKS).read_text(encoding="utf-8")
        line = loop_line(self.source, f"{name}_lanes")
        self.vectorised = vectorised(remarks, compiler, line, np.dtype(kind).itemsize, code)
        self._call = getattr(ctypes.CDLL(str(library)), f"{name}_strided")
        self._call.restype = ctypes.c_int

    @property
    def address(self) -> int:
        """Of the C function for arrays of any strides, valid while the kernel lives."""
        return ctypes.cast(self._call, ctypes.c_void_p).value or 0

    def __call__(
        self, arguments: Sequence[Array], results: Sequence[Array], threads: int = 1
    ) -> int:
        """Evaluate; 0, or the sum of what was met of `mechanics.compiled.c.lanes.FAR`, `WILD`.

        Parameters
        ----------
        arguments : arrays
            (batch, size) by input, or (size,) and contiguous for what all states share.
        results : arrays
            (batch, size) by output: written to; they must not overlap with the arguments.
        threads : int
            How many parts are computed at a time.
        """
        given = [(a, s) for a, (size, s) in zip(arguments, self._inputs, strict=True) if size]
        asked = [r for r, size in zip(results, self._outputs, strict=True) if size]
        count = len(results[0])
        part = -(-count // max(threads, 1))
        part = max(-(-part // BLOCK) * BLOCK, BLOCK)
        calls = [
            self._chunk(given, asked, first, min(part, count - first))
            for first in range(0, count, part)
        ]
        if len(calls) < 2:
            return sum(call() for call in calls)
        found = _pool(threads).map(lambda call: call(), calls)
        return functools.reduce(int.__or__, found, 0)

    def _chunk(
        self, given: Sequence[tuple[Array, bool]], asked: Sequence[Array], first: int, count: int
    ) -> Callable[[], int]:
        """A call of the C function for the states from `first` on."""
        size = np.dtype(self._kind).itemsize
        inputs = [a.ctypes.data + (0 if s else first * a.strides[0]) for a, s in given]
        outputs = [a.ctypes.data + first * a.strides[0] for a in asked]
        steps = [
            stride // size
            for a in (*(a for a, _ in given), *asked)
            for stride in (a.strides if a.ndim == 2 else (0, size))
        ]
        return functools.partial(
            self._call,
            ctypes.c_size_t(count),
            (ctypes.c_void_p * len(inputs))(*inputs),
            (ctypes.c_void_p * len(outputs))(*outputs),
            (ctypes.c_ssize_t * len(steps))(*steps),
        )


@functools.cache
def _pool(threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads, thread_name_prefix="mechanics")


def library_source(
    code: Routine,
    entries: Entries,
    kind: type[np.floating],
    shared: Sequence[str] = SHARED,
    checked: bool = False,
) -> str:
    """C file with the function of many states and what it is made of."""
    real = "float" if kind is np.float32 else "double"
    scalar = f"{PREFIX}{code.name}"
    name = f"{scalar}_states"
    codes = Codes("0", "1", "2", "3") if checked else None
    head = signature(code, real, scalar, "int" if checked else "void")
    return "\n".join([
        "#include <math.h>",
        "#include <stddef.h>",
        "#include <stdint.h>",
        "",
        sine_source(real),
        f"static {function_source(code, entries, real, head, codes)}",
        batch_source(code, entries, real, name, scalar=scalar, shared=shared, checked=checked),
        strided_source(code, real, name, shared),
    ])  # fmt: skip
