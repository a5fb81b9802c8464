"""The recurrences of `reference_series` in C, on integers of four 64-bit words.

Python computes the coefficients of order zero, with Arb's sines, and reciprocals of divisors; the
higher orders, which cost the time, follow here from a list of rules. A number that outgrows its
words is reported, and Python's own integers take over: the digits are the same.
"""

import ctypes
import functools
from collections.abc import Sequence
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.native import load
from mechanics.errors import CompilerError
from mechanics.simulate.reference_words import SOURCE

WORDS = 4
BYTES = 8 * WORDS
# Integers are the same with any settings.
FLAGS = "-O3 -march=native -funroll-loops"
# Bits that values may have: sums of a hundred products of them still fit into twice the words.
LARGEST = 64 * WORDS - 8


class Op(IntEnum):
    """What a rule does at an order above zero."""

    COPY, SUM, DIFFERENCE, SCALED, TIMES, PRODUCT, OVER, QUOTIENT, SLOPE, CHAIN, CHAIN_CONSTANT = (
        range(11)
    )


class Line(NamedTuple):
    """One rule: places of series, and a small integer or the place of a number."""

    op: Op
    out: int
    a: int = 0
    b: int = 0
    number: int = 0


def reciprocal(divisor: int, bits: int) -> tuple[int, int]:
    """(r, s) with x / divisor = x r 2^-s but for rounding, r of `bits` digits."""
    shift = abs(divisor).bit_length()
    return (1 << (bits + shift)) // divisor, shift


@functools.cache
def _library(compiler: str) -> ctypes.CDLL | None:
    """The C, compiled once; None for a compiler without integers of 128 bits or these settings."""
    try:
        library = load(SOURCE.replace("@WORDS", str(WORDS)), compiler, FLAGS)
    except CompilerError:
        return None
    library.mechanics_expand.restype = ctypes.c_int
    return library


class Recurrence:
    """Rules that C carries out.

    Parameters
    ----------
    compiler : str or None
    bits : int
        P.
    lines : sequence of Line
    state : sequence of (int, int)
        Places of the series of each entry of the state and of its rate; -1 - k where the rate is
        the number k.
    count : int
        Number of series.
    """

    def __init__(
        self,
        compiler: str | None,
        bits: int,
        lines: Sequence[Line],
        state: Sequence[tuple[int, int]],
        count: int,
    ) -> None:
        self._library = None if compiler is None else _library(compiler)
        self._bits, self._count = bits, count
        self._lines = np.array([tuple(line) for line in lines], dtype=np.int32).reshape(-1, 5)
        self._state = np.array(state, dtype=np.int32)

    def expand(
        self,
        order: int,
        first: Sequence[int],
        numbers: Sequence[int],
        shifts: Sequence[int],
        step: int,
    ) -> list[list[int]] | None:
        """Coefficients of the state, or None where C cannot compute them.

        Parameters
        ----------
        first : sequence of int
            Coefficient zero of every series.
        numbers, shifts : sequence of int
            What the rules refer to: constants, and reciprocals of divisors with their shifts.
        """
        if self._library is None:
            return None
        everything = (*first, *numbers, step)
        if max(x.bit_length() for x in everything) >= LARGEST:
            return None
        series = np.zeros((self._count, order + 1, WORDS), dtype=np.uint64)
        series[:, 0] = _words(first)
        known, length = _words(numbers), _words([step])
        turned = np.array(shifts, dtype=np.int32)
        failed = self._library.mechanics_expand(
            order, self._bits, len(self._lines), _at(self._lines), len(self._state),
            _at(self._state), _at(series), _at(known), _at(turned), _at(length),
        )  # fmt: skip
        if failed:
            return None
        return [_integers(series[place]) for place in self._state[:, 0]]


def _words(values: Sequence[int]) -> NDArray[np.uint64]:
    raw = b"".join(value.to_bytes(BYTES, "little", signed=True) for value in values)
    return np.frombuffer(raw, dtype="<u8").reshape(-1, WORDS).astype(np.uint64)


def _integers(series: NDArray[np.uint64]) -> list[int]:
    raw = series.astype("<u8").tobytes()
    return [
        int.from_bytes(raw[at : at + BYTES], "little", signed=True)
        for at in range(0, len(raw), BYTES)
    ]


def _at(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
