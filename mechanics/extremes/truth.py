"""The solution of K x = k at a point, enclosed: what every error is measured against.

The precision is raised until each unknown is known to 2^-80 of its value. An unknown that is zero
there would never be: what the normal form proves zero is zero. Where neither comes to an end, 2^-80
of the sum of the magnitudes of its terms, (|K^-1| |k|)_i, has to do.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from flint import arb, arb_mat

from mechanics.equations import Equations
from mechanics.exact import Arithmetic, generic_rank
from mechanics.exact.balls import precision
from mechanics.exact.decide import proved as is_proved
from mechanics.extremes.polynomials import LinearCode, linear_code

BITS = 192
LAST_BITS = 192 * 2**6
PROOF_BITS = 192 * 2**3
ENOUGH = 80
Rows = list[list[arb]]


@dataclass(frozen=True, eq=False)
class Enclosed:
    """The linear system and its solution at one point.

    Attributes
    ----------
    rows, sizes : n rows of n + 1 balls
        K and k; sums of the magnitudes of the terms of each entry.
    solution : tuple of arb, or None where K is singular
    spread : tuple of arb
        (|K^-1| (|K| |x| + |k|))_i: how much a relative change of the terms moves each unknown.
    condition : arb
        |K| |K^-1|, largest row sums, in the SI units of the rows.
    proved_zero : tuple of bool
        Unknowns whose value is zero by the normal form.
    bits : int
        Precision that was needed.
    """

    rows: Rows
    sizes: Rows
    solution: tuple[arb, ...] | None
    spread: tuple[arb, ...]
    condition: arb
    proved_zero: tuple[bool, ...]
    bits: int


@dataclass(frozen=True, eq=False)
class Truth:
    """Encloses the solution of one set of equations at any point.

    Attributes
    ----------
    equations : Equations
    symbols : tuple of Symbol
        In the order of the values of a point.
    code : LinearCode
    """

    equations: Equations
    symbols: tuple[sympy.Symbol, ...]
    code: LinearCode

    def at(self, values: Sequence[float]) -> Enclosed:
        """The system and its solution where the symbols have these values, exactly."""
        bits = BITS
        found = self._at(values, bits)
        zeros: tuple[bool, ...] = (False,) * self.code.size
        while bits < LAST_BITS and not _known(found, zeros):
            if bits == PROOF_BITS:
                if found.solution is None and self._singular(values):
                    return found
                zeros = self._zeros(values, found)
            bits *= 2
            found = self._at(values, bits)
        return _settled(found, zeros)

    def _at(self, values: Sequence[float], bits: int) -> Enclosed:
        with precision(bits):
            rows, sizes = self._system(values)
            n = self.code.size
            left, right = arb_mat([row[:n] for row in rows]), arb_mat([row[n:] for row in rows])
            nothing = (False,) * n
            if not all(entry.is_finite() for row in rows for entry in row):
                return Enclosed(rows, sizes, None, (), arb.nan(), nothing, bits)
            try:
                inverse = left.inv()
            except ZeroDivisionError:
                return Enclosed(rows, sizes, None, (), arb.pos_inf(), nothing, bits)
            x = (inverse * right).entries()
            magnitudes = [
                sum((abs(v) * s for v, s in zip(x, row[:n], strict=True)), row[n]) for row in sizes
            ]
            spread = tuple(
                sum((abs(inverse[i, j]) * magnitudes[j] for j in range(n)), arb(0))
                for i in range(n)
            )
            condition = _norm(left) * _norm(inverse)
            return Enclosed(rows, sizes, tuple(x), spread, condition, nothing, bits)

    def _system(self, values: Sequence[float]) -> tuple[Rows, Rows]:
        n = self.code.size
        rows = [[arb(0)] * (n + 1) for _ in range(n)]
        sizes = [[arb(0)] * (n + 1) for _ in range(n)]
        v = self.code.values([arb(value) for value in values])
        for entry in self.code.entries:
            total, size = arb(0), arb(0)
            for place in entry.terms:
                total += v[place]
                size += abs(v[place])
            rows[entry.row][entry.column], sizes[entry.row][entry.column] = total, size
        return rows, sizes

    def _exactly(self, values: Sequence[float]) -> tuple[sympy.Matrix, sympy.Matrix]:
        """K and k with exact rationals in place of the symbols, angles left open.

        What vanishes at every angle does so at these; equal angles stay equal.
        """
        left, right = self.equations.system
        turning = set().union(
            *(
                f.free_symbols
                for matrix in (left, right)
                for f in matrix.atoms(sympy.sin, sympy.cos)
            )
        )
        table = {}
        for symbol, value in zip(self.symbols, values, strict=True):
            number = sympy.Rational(*value.as_integer_ratio())
            if symbol in turning and number:
                angle = sympy.Symbol(f"angle {abs(value)!r}", real=True)
                number = angle if value > 0 else -angle
            table[symbol] = number
        return left.xreplace(table), right.xreplace(table)

    def _zeros(self, values: Sequence[float], found: Enclosed) -> tuple[bool, ...]:
        """Which unknowns the normal form proves zero."""
        if found.solution is None:
            return found.proved_zero
        left, right = self._exactly(values)

        def proved(i: int) -> bool:
            def experiment(a: Arithmetic) -> list[tuple[Any, Any]]:
                rows = [[a.value(left[r, c]) for c in range(left.cols)] for r in range(left.rows)]
                solution = a.solve(rows, [a.value(entry) for entry in right])
                return [(solution[i], a.rational(0))]

            return is_proved(experiment)

        return tuple(
            not x.is_zero() and bool(x.contains(0)) and proved(i)
            for i, x in enumerate(found.solution)
        )

    def _singular(self, values: Sequence[float]) -> bool:
        left, _ = self._exactly(values)
        return generic_rank(left.tolist()) < left.rows


def truth(equations: Equations, symbols: Sequence[sympy.Symbol]) -> Truth:
    """Enclosures for the linear system of a set of equations.

    Parameters
    ----------
    equations : Equations
    symbols : sequence of Symbol
        Everything that has a value: q, u, inputs, parameters.

    Raises
    ------
    ExpressionError
        If an operation has no enclosure; it is named.
    """
    return Truth(equations, tuple(symbols), linear_code(equations, symbols))


def _known(found: Enclosed, zeros: Sequence[bool]) -> bool:
    if found.solution is None:
        return _surely_singular(found)
    return all(
        zero or x.is_zero() or x.rel_accuracy_bits() >= ENOUGH
        for x, zero in zip(found.solution, zeros, strict=True)
    )


def _surely_singular(found: Enclosed) -> bool:
    """Whether the determinant is zero without any rounding, or entries are not finite."""
    n = len(found.rows)
    left = [row[:n] for row in found.rows]
    if any(not entry.is_finite() for row in left for entry in row):
        return True
    with precision(found.bits):
        return bool(arb_mat(left).det().is_zero())


def _settled(found: Enclosed, zeros: tuple[bool, ...]) -> Enclosed:
    if found.solution is None or not any(zeros):
        return found
    solution = tuple(arb(0) if zero else x for x, zero in zip(found.solution, zeros, strict=True))
    return Enclosed(
        found.rows, found.sizes, solution, found.spread, found.condition, zeros, found.bits
    )


def _norm(matrix: arb_mat) -> arb:
    n, m = matrix.nrows(), matrix.ncols()
    sums = [sum((abs(matrix[i, j]) for j in range(m)), arb(0)) for i in range(n)]
    largest = sums[0]
    for total in sums[1:]:
        largest = largest.max(total)
    return largest
