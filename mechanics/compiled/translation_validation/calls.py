"""Calls of a compiled function at many states: one by one, or as the lanes of a batch."""

import ctypes
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.translation_validation.states import TYPES
from mechanics.compiled.translation_validation.truth import Truth

LANES = 300
"""Of a call of many states: more than a block, and no multiple of a vector."""
PAD = 3
MARK = 12345
"""What stands where nothing may be written."""

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Odd:
    """What a call of many lanes does that it must not: words, what is expected, what it does."""

    words: str
    wanted: Any
    found: Any


def _pointer(array: Array, offset: int = 0) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data + offset * array.itemsize)


def one_by_one(known: Truth, function: Any) -> tuple[Array, Any, Odd | None]:
    """Values and statuses, a call a state."""
    text, count = known.text, len(known.given.stratum)
    kind = TYPES[text.kernel.kind]
    outs = [np.zeros((count, size), kind) for _, size in text.outputs]
    ins = [np.ascontiguousarray(known.given.columns[name]) for name, _ in text.groups]
    function.restype = ctypes.c_int if text.status is not None else None
    statuses = np.zeros(count, dtype=np.int64)
    for i in range(count):
        given = [_pointer(array, i * array.shape[1]) for array in (*ins, *outs)]
        result = function(*given)
        statuses[i] = result if result is not None else 0
    values = np.concatenate(outs, axis=1) if outs else np.zeros((count, 0))
    return values, statuses if text.status is not None else None, None


def lanes(known: Truth, function: Any) -> tuple[Array, Any, Odd | None]:
    """Values by one call: unaligned, in several blocks; equal lanes have to be equal."""
    text, count = known.text, len(known.given.stratum)
    kind, stride = TYPES[text.kernel.kind], LANES + PAD
    order = np.arange(LANES) % count
    arguments: list[Any] = [ctypes.c_size_t(LANES), ctypes.c_size_t(stride)]
    kept = []
    for name, size in text.groups:
        column = known.given.columns[name]
        if name in (text.kernel.shared or ()):
            array = np.ascontiguousarray(column[0])
            arguments.append(_pointer(array))
        else:
            array = np.zeros(1 + size * stride, kind)
            array[1:].reshape(size, stride)[:, :LANES] = column[order].T
            arguments.append(_pointer(array, 1))
        kept.append(array)
    outs = [np.full(1 + size * stride, MARK, kind) for _, size in text.outputs]
    arguments += [_pointer(array, 1) for array in outs]
    function.restype = ctypes.c_int
    flags = function(*arguments)
    tables = [array[1:].reshape(-1, stride) for array in outs]
    edges = np.concatenate([*(t[:, LANES:].ravel() for t in tables), *(a[:1] for a in outs)])
    if len(beyond := edges[edges != MARK]):
        return np.zeros((0, 0)), None, Odd("it writes beyond its lanes", MARK, float(beyond[0]))
    table = np.concatenate([t[:, :LANES] for t in tables]).T
    first = table[:count]
    if not np.array_equal(table, first[order], equal_nan=True):
        words = "a lane has another value where it stands elsewhere in the batch"
        both = [tuple(values.ravel().tolist()) for values in (first[order], table)]
        return table, None, Odd(words, *both)
    if known.statuses is not None and text.status is not None:
        wanted = int(np.bitwise_or.reduce(known.statuses))
        if flags != wanted:
            words = f"it returns {flags}, the text says {wanted}"
            return table, None, Odd(words, wanted, int(flags))
    return first, None, None
