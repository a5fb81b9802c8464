"""What goes wrong inside a program: the first value that is no number, and lost digits.

    overflow     a result is infinite or no number, its operands are numbers
    division     the same, and the divisor is zero
    underflow    a product or quotient of numbers that are not zero is below the smallest normal one

Evaluated by NumPy with every operation rounded to the precision, as the machine code does. Sums are
exact where they are subnormal, so they lose nothing there.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.program.operations import DIVIDE, INPUT, MULTIPLY
from mechanics.program.routine import Node, Routine, every_value

CHUNK = 4096


@dataclass(frozen=True, eq=False)
class Events:
    """What happened at N points; node -1 stands for nothing.

    Attributes
    ----------
    broken : array of int
        First node that is infinite or no number though its operands are numbers.
    by_zero : array of bool
        Whether that node divides by zero.
    underflow : array of int
        First node that lost digits below the smallest normal number.
    """

    broken: NDArray[np.int64]
    by_zero: NDArray[np.bool_]
    underflow: NDArray[np.int64]

    @property
    def normal(self) -> NDArray[np.bool_]:
        """Whether every value is zero or a normal number."""
        clean: NDArray[np.bool_] = (self.broken < 0) & (self.underflow < 0)
        return clean


def trace(code: Routine, points: NDArray[np.float64], kind: type[np.floating]) -> Events:
    """Events of a program of q, u, inputs and p.

    Parameters
    ----------
    points : array, N x entries
        The entries of all inputs side by side.
    kind : numpy.float64 or numpy.float32
    """
    broken = np.full(len(points), -1, dtype=np.int64)
    by_zero = np.zeros(len(points), dtype=bool)
    underflow = broken.copy()
    for start in range(0, len(points), CHUNK):
        part = slice(start, start + CHUNK)
        with np.errstate(all="ignore"):
            values = every_value(code, [list(points[part].T)], kind)
            _walk(code, values, kind, broken[part], by_zero[part], underflow[part])
    return Events(broken, by_zero, underflow)


def _walk(
    code: Routine,
    values: Sequence[NDArray[np.floating]],
    kind: type[np.floating],
    broken: NDArray[np.int64],
    by_zero: NDArray[np.bool_],
    underflow: NDArray[np.int64],
) -> None:
    tiny = np.finfo(kind).tiny
    for k, (node, value) in enumerate(zip(code.nodes, values, strict=True)):
        operands = [values[i] for i in code.operands(k)]
        numbers = np.isfinite(value)
        if not np.all(numbers):
            born = ~numbers & (broken < 0)
            for operand in operands:
                born &= np.isfinite(operand)
            broken[born] = k
            if node.operation == DIVIDE:
                by_zero |= born & (operands[-1] == 0)
        small = np.abs(value) < tiny
        if np.any(small) and (lost := _lost(node, value, operands)) is not None:
            underflow[small & lost & (underflow < 0)] = k


def _lost(
    node: Node, value: NDArray[np.floating], operands: Sequence[NDArray[np.floating]]
) -> NDArray[np.bool_] | None:
    """Where a small value is not exact; None for operations that lose nothing there."""
    if node.operation == INPUT:
        return np.asarray(value != 0)
    if node.operation == MULTIPLY:
        return np.asarray((operands[0] != 0) & (operands[1] != 0))
    if node.operation == DIVIDE:
        return np.asarray((operands[0] != 0) & np.isfinite(operands[1]))
    return None
