"""Steps of Taylor series in C, on integers of four 64-bit words.

Python computes the coefficients of order zero, with Arb's sines, and reciprocals of divisors; the
higher orders, which cost the time, follow here from the list of steps. A number that outgrows its
words is reported, and Python's own integers take over: the digits are the same.
"""

import ctypes
import functools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.native import load
from mechanics.errors import CompilerError
from mechanics.program.taylor import Kind, Recurrences
from mechanics.simulate.reference_words import SOURCE

WORDS = 4
BYTES = 8 * WORDS
# Integers are the same with any settings.
FLAGS = "-O3 -march=native -funroll-loops"
# Bits that values may have: sums of a hundred products of them still fit into twice the words.
LARGEST = 64 * WORDS - 8


SLOPE = len(Kind)
"""The operation of C, beside those of steps, that computes the numbers i x_i."""


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
    bits : int
        P.
    constants : sequence of int
        Those of the rules.
    """

    def __init__(
        self, compiler: str | None, bits: int, rules: Recurrences, constants: Sequence[int]
    ) -> None:
        self._library = None if compiler is None else _library(compiler)
        self._bits = bits
        # Constants, reciprocals of those that are divided by, and room for those of what moves.
        numbers = [(value, 0) for value in constants]
        self._divisors: list[int] = []
        slopes: dict[int, int] = {}
        count = len(rules.first.outputs["first"])
        over = sum(step.kind is Kind.OVER for step in rules.steps)
        lines: list[tuple[int, ...]] = []
        for kind, out, a, b, sign in rules.steps:
            number = sign
            if kind is Kind.TIMES:
                number = -1 - b
            elif kind is Kind.OVER:
                number = len(numbers)
                numbers.append(reciprocal(constants[-1 - b], bits))
            elif kind is Kind.QUOTIENT:
                number = len(constants) + over + len(self._divisors)
                self._divisors.append(b)
            elif kind is Kind.CHAIN:
                if a not in slopes:
                    slopes[a] = count + len(slopes)
                    lines.append((SLOPE, slopes[a], a, 0, 0))
                a = slopes[a]
            lines.append((kind, out, a, b, number))
        self._held = [value for value, _ in numbers]
        self._shifts = [shift for _, shift in numbers]
        self._count = count + len(slopes)
        self._lines = np.array(lines, dtype=np.int32).reshape(-1, 5)
        self._state = np.array(list(enumerate(rules.rates)), dtype=np.int32)

    def expand(self, order: int, first: Sequence[int], step: int) -> list[list[int]] | None:
        """Coefficients of the state, or None where C cannot compute them.

        Parameters
        ----------
        first : sequence of int
            Coefficient zero of every series.
        """
        if self._library is None:
            return None
        divisors = [reciprocal(first[place], self._bits) for place in self._divisors]
        numbers = [*self._held, *(value for value, _ in divisors)]
        if max(x.bit_length() for x in (*first, *numbers, step)) >= LARGEST:
            return None
        series = np.zeros((self._count, order + 1, WORDS), dtype=np.uint64)
        series[: len(first), 0] = _words(first)
        known, length = _words(numbers), _words([step])
        turned = np.array([*self._shifts, *(shift for _, shift in divisors)], dtype=np.int32)
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
