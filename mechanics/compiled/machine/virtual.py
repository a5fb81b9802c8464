"""Programs without a C compiler: CasADi's virtual machine in double, NumPy in single precision."""

import functools
from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.program.routine import Routine, run

Array = NDArray[np.floating]


class VirtualKernel:
    """One CasADi function, evaluated by CasADi itself through its buffers."""

    def __init__(self, function: ca.Function) -> None:
        self._function = function
        self._results = [function.numel_out(i) for i in range(function.n_out())]

    def __call__(self, arguments: Sequence[Array], count: int) -> list[Array]:
        """Evaluate at `count` states: arrays count x size, or 1 x size for what all share."""
        cells = [np.array(a[0], dtype=float) for a in arguments]
        outs = [np.empty(size) for size in self._results]
        results: list[Array] = [np.empty((count, size)) for size in self._results]
        call = self.bound(cells, outs)
        moving = [(cell, a) for cell, a in zip(cells, arguments, strict=True) if len(a) > 1]
        for i in range(count):
            for cell, a in moving:
                cell[:] = a[i]
            call()
            for result, out in zip(results, outs, strict=True):
                result[i] = out
        return results

    def bound(self, arguments: Sequence[Array], results: Sequence[Array]) -> Callable[[], None]:
        """A call without arguments that reads and writes these arrays."""
        buffer, trigger = _buffer(self._function)
        for i, array in enumerate(arguments):
            if array.size:
                buffer.set_arg(i, array.data)
        for i, array in enumerate(results):
            if array.size:
                buffer.set_res(i, array.data)
        # The buffer owns the memory that the trigger uses: keep it alive with the call.
        return functools.partial(_trigger, trigger, buffer)


def _buffer(function: Any) -> Any:
    return function.buffer()


def _trigger(trigger: Callable[[], None], buffer: Any) -> None:
    trigger()


class NumpyKernel:
    """One program in NumPy arithmetic: every operation is rounded to the precision."""

    def __init__(self, code: Routine, kind: type[np.floating]) -> None:
        self._code, self._kind = code, kind

    def __call__(self, arguments: Sequence[Array], count: int) -> list[Array]:
        """Evaluate at `count` states: arrays count x size, or 1 x size for what all share."""
        groups = run(self._code, [list(a.T) for a in arguments], self._kind)
        results = []
        for entries in groups:
            result = np.empty((count, len(entries)), self._kind)
            for i, entry in enumerate(entries):
                result[:, i] = entry
            results.append(result)
        return results

    def bound(self, arguments: Sequence[Array], results: Sequence[Array]) -> Callable[[], None]:
        """A call without arguments that reads and writes these arrays."""

        def call() -> None:
            found = self([a[None, :] for a in arguments], 1)
            for result, values in zip(results, found, strict=True):
                result[:] = values[0]

        return call
