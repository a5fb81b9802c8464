"""The terms of a typed equation: how large its residual is against what is added up.

    lhs - rhs = t_1 + ... + t_n          ratio = |t_1 + ... + t_n| / (eps (|t_1| + ... + |t_n|))

Products over sums are multiplied out on each side; terms of the two sides are not merged. The terms
are one program, interpreted in Arb balls at one state, and in extended precision at many.
"""

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
import sympy
from flint import arb
from numpy.typing import NDArray
from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.kernel.balls import Balls
from mechanics.program import Builder, Program, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.running_error_domain import enclose
from mechanics.program.sympy_reader import read

UNIT = np.finfo(np.longdouble).eps
CHUNK = 8192
"""States at once, so that values stay near the processor."""

BITS = 160
"""Working precision in Arb: enough for terms that cancel to the last bit of a double."""


def typed_terms(left: Expr, right: Expr) -> tuple[Expr, ...]:
    """Terms of left - right, products over sums multiplied out on each side."""
    sides = sympy.expand(left), sympy.expand(-right)
    return tuple(t for side in sides for t in sympy.Add.make_args(side) if t != 0)


@dataclass(frozen=True)
class Terms:
    """Terms as a program.

    Attributes
    ----------
    program : Program
        Of an input for each symbol, by its place among the symbols.
    """

    program: Program

    def ratio(self, values: Sequence[float], epsilon: float) -> arb:
        """Enclosure of the ratio, not finite where a value is not; precision is the caller's."""
        inputs = {name: arb(values[int(name)]) for name in self.program.inputs}
        total, size = arb(0), arb(0)
        for term in interpret(self.program, Balls(), inputs, release=False)["terms"]:
            total += term
            size += abs(term)
        return total if total.is_zero() else abs(total) / (size * epsilon)

    def bounds(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> tuple[NDArray[np.longdouble], NDArray[np.longdouble]]:
        """What the ratios at many states are not below, and not above."""
        parts = range(0, len(columns[0]), CHUNK)
        with ThreadPoolExecutor(os.cpu_count()) as pool:  # NumPy computes on all cores
            found = pool.map(
                lambda i: self._bounds([c[i : i + CHUNK] for c in columns], epsilon), parts
            )
        low, high = zip(*found, strict=True)
        return np.concatenate(low), np.concatenate(high)

    def _bounds(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> tuple[NDArray[np.longdouble], NDArray[np.longdouble]]:
        terms = enclose(self.program, self._inputs(columns))["terms"]
        filler = np.zeros(columns[0].shape, dtype=np.longdouble)
        with np.errstate(all="ignore"):
            size = sum((np.abs(term.value) for term in terms), filler)
            residual = np.abs(sum((term.value for term in terms), filler))
            # Higham, section 4.2: the roundings of a sum of n terms.
            relative = max(term.relative for term in terms) + len(terms) * UNIT
            error = relative * size + sum(t.error for t in terms if t.error is not None)
            low = np.maximum(residual - error, 0) / ((size + error) * epsilon) * (1 - 8 * UNIT)
            room = (size - error) * epsilon
            high = np.where(room > 0, (residual + error) / room * (1 + 8 * UNIT), np.inf)
        return np.where(np.isfinite(low), low, 0), high

    def ratios(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> NDArray[np.longdouble]:
        """Ratios at many states; infinite where a value is not finite."""
        inputs = {name: c.astype(np.longdouble) for name, c in self._inputs(columns).items()}
        with np.errstate(all="ignore"):
            terms = interpret(self.program, Arrays(np.longdouble), inputs)["terms"]
            total = np.abs(sum(terms))
            size = sum(np.abs(term) for term in terms)
            ratios = np.where(total == 0, np.longdouble(0), total / (size * epsilon))
        return np.where(np.isfinite(ratios), ratios, np.inf)

    def _inputs(self, columns: Sequence[NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
        return {name: columns[int(name)] for name in self.program.inputs}


def read_terms(terms: Sequence[Expr], symbols: Sequence[Symbol]) -> Terms:
    """Terms as a program; every shared part once.

    Raises
    ------
    ExpressionError
        If a term holds an operation that is not known, or a symbol that is not given.
    """
    builder = Builder()
    places = {symbol: builder.input(str(k)) for k, symbol in enumerate(symbols)}
    unknown = set().union(*(term.free_symbols for term in terms)) - set(places)
    if unknown:
        raise ExpressionError(f"symbol {min(map(str, unknown))} in terms has no place")
    return Terms(builder.program({"terms": read(builder, terms, places)}))
